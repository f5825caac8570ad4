// SPDX-License-Identifier: MIT
// Everything the many-body solver works on, without its capacities.
#pragma once

#include "../base/effort.h"
#include "../base/figure_limits.h"
#include "../base/work_budget.h"
#include "../narrow_phase/manifold_record.h"
#include "../base/contact_lengths.h"
#include "../shape/body_shapes.h"
#include "contact_block.h"

namespace ingot { inline namespace INGOT_ABI {

/// How the step of an island is cut and swept, in the order of the batches. A steady island that turns out to accelerate begins again with the plan
/// that follows.
enum class SweepPlan : uint8_t {
    small_steady,  ///< limits::steady_substeps; few contacts, swept upwards until they are settled
    small,         ///< Effort::substeps
    small_twice,   ///< twice and four times as many, where something spins fast
    small_four_times,
    large_steady,  ///< limits::steady_substeps; a few sweeps, up and down the levels in turn
    large,         ///< Effort::substeps
    jointed,       ///< the same, of an island with joints; and twice and four times as many, where they are under tension
    jointed_twice,
    jointed_four_times,
    jointed_eight_times,
    solved,        ///< nothing is left to do
};
inline constexpr int sweep_plans = 6;          ///< where no body has joints
inline constexpr int sweep_plans_of_jointed = sweep_plans + 1 + limits::doublings_max;
/// Whether islands of a plan are swept until they are settled, and something in them accelerates.
inline bool is_small_moving(SweepPlan plan) { return plan >= SweepPlan::small && plan <= SweepPlan::small_four_times; }
/// Whether islands of a plan have bodies with joints.
inline bool is_of_joints(SweepPlan plan) { return plan >= SweepPlan::jointed && plan <= SweepPlan::jointed_eight_times; }

/// Bodies that touch, directly or through others that can move: what one of them does depends on these alone. All that the solver decides,
/// it decides for an island.
struct Island {
    static constexpr int sum_count = 8;

    Index manifold_count, new_count, steady_count;  ///< manifolds; those younger than four steps; those that were steady
    Index face_count;     ///< manifolds of three points or four
    Index body_count, moving_count;  ///< where there is a large stack: bodies; those that are faster than their forces make them in a substep
    Index central_count;  ///< manifolds whose normals go through both centres of mass
    Index level_count;    ///< the longest way to the ground, in contacts
    Index member_begin, member_count;  ///< of its manifolds in SolverView::members
    Index group, in_group;             ///< for its sums: the colour at hand, and how many of it came before
    SweepPlan plan;
    bool in_batch;    ///< solved in the batch at hand
    bool begins_again;
    bool steady;      ///< nothing in it has accelerated in this step
    bool has_chains;  ///< impacts may cause impacts
    bool sweeps_on;   ///< not settled yet in this substep
    bool at_bound;    ///< its sweeps ended at their bound
    bool carries;     ///< a body of it carries more than limits::direct_mass_ratio times its mass; only the direct solver asks
    int sweeps_max, sweeps;  ///< of a substep; of the step so far
    scalar fastest_sq;       ///< m^2/s^2, of its bodies in this substep
    scalar settled;          ///< m/s; a sweep that corrects no speed by more is its last
    scalar residuals[lanes], residual;  ///< m/s, that the last sweep corrected; the largest of its lanes
    scalar size, size_before, beta;  ///< J, of a sweep; conjugate gradients
    scalar sums[sum_count];          ///< size is their sum: it does not depend on lanes
};
inline constexpr Index no_island = index_max;

/// Lanes of one block that are solved together: they share no body that can move.
struct Visit {
    Index block;
    uint16_t lane_bits;
    Index island;  ///< of all its lanes, where these are the whole block and begin a row of sums, as one lane does; else no_island
};
/// Whether the lanes of a visit are of one island, which it names.
INGOT_INLINE bool has_one_island(const Visit& visit) { return lanes == 1 || visit.island != no_island; }

struct SolverView {
    static constexpr bool is_pointwise = false;
    static constexpr bool rolls = false, has_belts = false;  ///< see material_view.h
    static constexpr bool articulates = false, has_joint_rows = false, has_drives = false;  ///< see jointed_view.h
    static constexpr bool locks_axes = false;                ///< see locked_view.h
    static constexpr int points_max = block_rows;            ///< of a manifold

    const BodyPair* pairs;     ///< that touch, sorted by slots
    ManifoldRecord* records;   ///< of the pairs
    Vector* friction_references;  ///< by record: N s, world; the slow mean of j_friction
    int manifold_count;
    BodyShapes shapes = {};
    const BodyPair* shape_pairs = nullptr;  ///< as pairs, by the slots of shapes
    scalar step_h = 0;         ///< s, of the step
    scalar unit = 1;           ///< m; of lengths and speeds in limits.h: see base/contact_lengths.h
    Effort effort = {};
    int sweeps_of_step = no_budget;  ///< that each island may have
    bool side_by_side = false;  ///< a part of a step: it marks no body in tiles, which others share. See solver_parts.h

    SolverBody* bodies;        ///< [0] stands for all that cannot move and for spare lanes
    SolverBodyHistory* histories;
    Index* slot_of;         ///< by solver body
    Index* local_of;        ///< by slot of a body that touches; 0: immovable, or gone bad and of no figure. Others: see takes_part
    Index* level_of_body;   ///< by solver body
    uint32_t* colours_of_body; ///< by solver body, within the level at hand
    Index* island_of;       ///< by solver body
    int body_count;            ///< solver bodies in use, [0] included
    Index *island_at, *level;  ///< by manifold: its island, or no_island; its distance from the ground, in contacts
    Island* islands;           ///< room for one of each body that can move
    int island_count;

    // Of the batch at hand: islands with one plan.
    ContactBlock* blocks;      ///< room for manifold capacity / lanes, rounded up
    Visit *visits, *some_visits;  ///< room for manifold capacity + blocks
    const Visit* live;            ///< those whose islands are not settled yet: visits, or some of them
    Index *members, *sorted;  ///< manifolds: island by island, as positions in the blocks; for sorting
    uint8_t* colour;             ///< by manifold
    Index* batch_bodies;    ///< solver bodies
    int visit_count, live_count, block_count, batch_body_count;
    int lane_count, lane_capacity;  ///< of all blocks
    SweepPlan plan;
    int substeps;              ///< of the step
    int substeps_left = 1;     ///< with the one at hand
    bool some_hit;             ///< a body was hit in the substep before
    bool some_turn;            ///< a body turns far: see refresh_blocks
    bool some_bounce;          ///< a manifold has restitution
};

/// Where all that moves is balls, every manifold has one point: rows of four, and torsion, are not compiled in.
struct BallView : SolverView {
    static constexpr int points_max = 1;
};

/// What lengths of the contacts of a block are measured by, m.
INGOT_INLINE lane scale_of(const SolverView& solver, const ContactBlock& block) {
    scalar scale[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i) scale[lane_i] = scale_of(solver.unit, block.halvings[lane_i]);
    return load(scale);
}

/// Whether a block of the view has one row: then its manifolds have one point.
template <class View>
INGOT_INLINE bool has_one_row([[maybe_unused]] const View& solver, const ContactBlock& block) {
    return View::points_max == 1 || block.rows == 1;
}
/// How many rows such a block is visited with. Where axes are locked no block has one row: the others do the same, to the bit, in no more flash.
template <class View>
inline constexpr int fewest_rows = View::locks_axes ? View::points_max : 1;

/// Impulses are kept as those of one of Effort::substeps substeps. A longer substep has this many times as much.
inline scalar shares_of_substep(const SolverView& solver) {
    return static_cast<scalar>(solver.effort.substeps) / static_cast<scalar>(solver.substeps);
}

/// Whether the body of a slot is one of the solver's. local_of alone does not tell: its entries for other slots are of earlier steps.
inline bool takes_part(const SolverView& solver, int slot) {
    const Index body_i = solver.local_of[slot];
    return body_i != 0 && body_i < solver.body_count && solver.slot_of[body_i] == slot;
}

/// A manifold's body that can move; 0: none can.
inline Index dynamic_body(const SolverView& solver, int manifold_i) {
    const Index A = solver.local_of[solver.pairs[manifold_i].body_A];
    return A != 0 ? A : solver.local_of[solver.pairs[manifold_i].body_B];
}

/// The manifold at a position in the blocks.
inline Index manifold_at(const SolverView& solver, int position) { return solver.blocks[position / lanes].manifold[position % lanes]; }

/// Calls each(body_i) for the bodies of the batch.
template <class Each>
INGOT_INLINE void for_bodies(const SolverView& solver, const Each& each) {
    for (int i = 0; i < solver.batch_body_count; ++i) each(static_cast<int>(solver.batch_bodies[i]));  // bound: max_bodies + 1
}

} }  // namespace ingot
