# SPDX-License-Identifier: MIT
# The floors of HOUSE, kept by its #include lines: a room of kernel/ includes itself and the rooms named here; kernel/ includes
# no library but freestanding C headers; platform/ and kernel/ do not know each other; stages do not include each other.
cmake_minimum_required(VERSION 3.25)

set(base_may)
set(math_may base)
set(body_may base math)
set(level_may base math)
set(shape_may base math body)
set(motion_may base math body)
set(broad_phase_may base math body shape)
set(narrow_phase_may base math level body shape broad_phase)
set(query_may base math level body shape broad_phase narrow_phase)
set(mover_may base math level body shape broad_phase narrow_phase query)
set(draw_may base math body shape)
set(impulse_may base math body shape)
set(joint_may base math body)
set(figure_may base math body joint)
set(energy_momentum_may base math body joint figure)
set(constraint_may base math body shape broad_phase narrow_phase joint figure)
set(island_may base math body broad_phase narrow_phase)
set(sleep_may base math body shape broad_phase narrow_phase constraint island)
set(solver_may base math body constraint)
set(solver_sweeps_may base math body narrow_phase joint figure constraint island solver)
set(solver_direct_may ${solver_sweeps_may} solver/sweeps)
set(solver_sequential_may base math body narrow_phase constraint solver)
set(events_may base math body broad_phase narrow_phase constraint)
set(continuous_may base math body shape motion broad_phase narrow_phase joint figure constraint island solver solver/sweeps solver/sequential)
set(world_features_may base math level body shape motion broad_phase narrow_phase impulse joint figure energy_momentum constraint island sleep solver/sweeps solver/direct
  solver/sequential events continuous world)
set(world_may world/features base math level body shape motion broad_phase narrow_phase query mover draw impulse joint figure energy_momentum constraint island sleep solver solver/sweeps solver/direct solver/sequential
  events continuous)
set(freestanding "stdint\\.h|stddef\\.h|float\\.h|limits\\.h")
# Freestanding C++17 has it, a C compiler has not: of compilers without GNU's words alone, see base/compiler.h.
set(standard_of_kernel/base/compiler.h "limits")

# A stage is a .h/.cpp pair of these rooms; what it may include of its own room is shared vocabulary, not another stage.
# integrate_r is there for forced_flight, which is made of stages.
set(motion_shares acceleration flight_clock turn moser_veselov moser_veselov_series moser_veselov_stage force_field forced_tile elliptic_functions integrate_r)
set(shape_shares shapes surface convex_hull placed_shape compound)
set(broad_phase_shares hold_shapes near_shapes body_bounds body_pairs bound_shape all_pairs search_view sorted_tree tree_walk)
set(level_shares level_table level_walk height_walk mesh_walk height_grid lattice lattice_steps level_checksum height_field_of mesh_builder)
set(narrow_phase_shares find_level_manifolds collide_kinds inner_edges level_cone level_patches collide_level triangle_hull manifold manifold_points box_axes contact_geometry contact_patch collide_pairs nearest_points plane_between manifold_record
  manifold_anchors find_manifolds normal_cone)
set(query_shares level_queries cast_shape candidates shapes_of_tree query_filter ray_on_shapes cast_ray)
set(mover_shares mover axis_touch half_spaces mover_space)
set(impulse_shares contact collide_shapes contact_rows impulse impact_step impact_times find_contacts solve_impacts)
set(joint_shares joints joint_record joint_lists limit_record drives reactions tie_record target_record gear_record)
set(figure_shares spatial figure_row figure_view ground tree_passes joint_sides row_motion displace_rows cursor_moves joint_row measure_joint row_compliance reached_bodies torque_of_ball
  dynamics read_joint build_figures factor_figures keep_figures move_figures respond_figures cursor joint_motions joint_rows joint_drives driven_motion
  push_rows hold_targets three_energies universal_joints loop_view find_loops factor_loops close_loops note_reactions swing_figures swing_in_substeps push_machines machine_pushes limit_pushes loop_sides moving_joint target_rows gear_rows step_poles)
set(energy_momentum_shares energy_momentum tangent at_node newton_row newton_pass fit_to_joints advance_figure advance_parts free_figures note_part swing_freely)
set(constraint_shares belts collect_blocks prepare_block prepare_blocks moved_manifold turning_body without_joints jointed_response jointed_view locked_view prepare_responses block_bodies block_rows block_solve contact contact_block flight friction impact_note kinematic_levers kinematic_motion_at kinematic_view laws
  material_view normals response rolling
  row_flight row_pair rows solver_body solver_view surface_materials torsion visit)
set(island_shares active_tiles awake_tiles disjoint_sets rest_view)
set(sleep_shares wake)
set(events_shares contact_events pair_rules)
set(continuous_shares body_path level_on_path fast_pairs parting_plane time_of_impact pair_sub_world pair_contacts continuous_collision find_pair_contacts locked_pair solve_pair
  lay_paths next_impact resolve_impact figures_on_paths contacts_of_figures close_figure wait_with_figure)
# swept_contacts has the stages of a substep, for block_sweeps and hybrid_islands to conduct; plan_islands begins a batch.
set(solver_sweeps_shares block_sweeps swept_contacts conduct_sweeps jointed_contacts jointed_reactions jointed_visits conjugate_gradients diverged_islands figure_shares gaining_figures gaining_islands kinematic_contacts move_bodies note_impulses order_manifolds
  passive_bounces plan_islands predict_contacts pushed_figures sequence_impacts slip_reversals solve_velocities sweep_joint_rows sweep_positions sweep_velocities turning_bodies visit_positions
  warm_start
  work_together)
# solve_sequentially conducts the stages of its substeps, and sequential_impulses names it to scenes.
set(solver_sequential_shares kinematic_points point_view point_visit point_visits point_reversals point_rows sequential_contacts move_point_bodies sweep_points solve_sequentially)
# hybrid_islands conducts the stages, and calls the others of its room.
set(solver_direct_shares carried_loads direct_view hybrid_contacts hold_energy hold_speeds impact_of_island misfit island_rows choose_islands normal_set sliding factor_rows solve_island solve_directly)

set(broken "")
file(GLOB_RECURSE files RELATIVE ${HOUSE} ${HOUSE}/kernel/*.h ${HOUSE}/kernel/*.cpp ${HOUSE}/platform/*.h ${HOUSE}/platform/*.cpp)
list(FILTER files EXCLUDE REGEX "^platform/packages/")  # users of both
if(NOT files)
  message(FATAL_ERROR "no house at ${HOUSE}")
endif()
foreach(file IN LISTS files)
  get_filename_component(dir ${file} DIRECTORY)
  get_filename_component(stage ${file} NAME_WE)
  string(REGEX REPLACE "^kernel/?" "" room "${dir}")
  string(REPLACE "/" "_" key "${room}")
  file(STRINGS ${HOUSE}/${file} includes REGEX "^ *# *include")
  foreach(line IN LISTS includes)
    if(line MATCHES "<(.+)>")
      set(target ${CMAKE_MATCH_1})
      if(file MATCHES "^kernel/" AND NOT target MATCHES "^(${freestanding})$"
         AND NOT target MATCHES "^(${standard_of_${file}})$")
        list(APPEND broken "${file} may not include <${target}>")
      elseif(file MATCHES "^platform/" AND target MATCHES "^ingot/" AND NOT target MATCHES "^ingot/platform/")
        list(APPEND broken "${file} may not include <${target}>")
      endif()
    elseif(line MATCHES "\"(.+)\"")
      set(target ${CMAKE_MATCH_1})
      if(file MATCHES "^platform/")
        if(target MATCHES "kernel|ingot\\.h")
          list(APPEND broken "${file} may not include ${target}")
        endif()
        continue()
      endif()
      if(room STREQUAL "")
        continue()  # ingot.h includes every room
      endif()
      get_filename_component(target ${target} ABSOLUTE BASE_DIR /${room})
      get_filename_component(target_room ${target} DIRECTORY)
      string(SUBSTRING ${target_room} 1 -1 target_room)
      if(NOT target_room STREQUAL room)
        if(NOT target_room IN_LIST ${key}_may)
          list(APPEND broken "${file} may not include ${target}")
        endif()
      elseif(DEFINED ${key}_shares)
        get_filename_component(other ${target} NAME_WE)
        if(NOT other STREQUAL stage AND NOT other IN_LIST ${key}_shares)
          list(APPEND broken "${file} may not include ${target}, another stage")
        endif()
      endif()
    endif()
  endforeach()
endforeach()
if(broken)
  string(REPLACE ";" "\n  " broken "${broken}")
  message(FATAL_ERROR "floors: ${broken}")
endif()
