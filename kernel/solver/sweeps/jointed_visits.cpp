// SPDX-License-Identifier: MIT
#include "jointed_visits.h"

#include "../../figure/close_loops.h"
#include "../../figure/cursor.h"
#include "../../figure/factor_figures.h"
#include "../../figure/factor_loops.h"
#include "../../figure/respond_figures.h"
#include "../../figure/move_figures.h"
#include "../../figure/row_motion.h"
#include "../../figure/tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

void put_three(scalar (&to)[4], const Vector& value) {
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
}

/// Calls each(body_i, node) for the bodies of a visit that have joints, A first.
template <class Each>
void for_jointed(const JointedBodies& jointed, const ContactBlock& block, uint16_t lane_bits, const Each& each) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((lane_bits >> lane_i & 1u) == 0 || is_spare(block.manifold[lane_i])) continue;
        const Index both_bodies[] = {block.body_A[lane_i], block.body_B[lane_i]};
        for (const Index body_i : both_bodies)
            if (body_i != 0 && jointed.has_joints(body_i)) each(body_i, jointed.node_of[body_i]);
    }
}

/// The change of a body's twist by the solve, at its centre of mass.
template <class Loops, class At>
Spatial<scalar> change_with_loops(const JointedBodies& jointed, [[maybe_unused]] const Loops& loops, const At& at, const FigureRow<At::width>& row,
                                  [[maybe_unused]] Index node) {
    Spatial<scalar> u = read(at, row.change);
    if constexpr (Loops::closes) u = u + twist_of_loops(jointed.figures, loops, node);
    return twist_at(u, read(at, row.c));
}

template <class Loops>
void write_velocity(const JointedBodies& jointed, const Loops& loops, SolverBody& body, Index node) {
    at_node(jointed.figures, node, [&](const auto& rows, const auto& at, int row_i) {
        const auto& row = rows[row_i];
        const Spatial<scalar> u = change_with_loops(jointed, loops, at, row, node);
        put_three(body.v_CM, read(at, row.v) + u.v);
        put_three(body.L, read(at, row.L) + momentum_of_spin(at, row, u.w));
    });
}

template <class Loops>
void write_displacement(const JointedBodies& jointed, const Loops& loops, const BodyView& bodies, SolverBody& body, Index node) {
    const Vector begin = r_CM_of(bodies, jointed.figures.nodes[node].slot);
    at_node(jointed.figures, node, [&](const auto& rows, const auto& at, int row_i) {
        const auto& row = rows[row_i];
        const Spatial<scalar> u = change_with_loops(jointed, loops, at, row, node);
        put_three(body.dp, (read(at, row.r) - begin) + u.v);
        put_three(body.dth, read(at, row.turned) + u.w);
    });
}

/// Calls each(body_i, node) for all bodies of figures of the batch.
template <class Each>
void for_figure_bodies(const SolverView& solver, const JointedBodies& jointed, const Each& each) {
    for_bodies(solver, [&](int body_i) {
        if (jointed.has_joints(static_cast<Index>(body_i))) each(body_i, jointed.node_of[body_i]);
    });
}

}  // namespace

template <class Loops>
void factor_jointed(const SolverView& solver, JointedBodies& jointed, const Loops& loops) {
    place_joints(jointed.figures);
    if constexpr (Loops::closes) place_loops(jointed.figures, loops);
    factor_figures(jointed.figures, loops, jointed.figures.h / static_cast<scalar>(solver.substeps));
    respond_figures(jointed.figures, jointed.responses);
    if constexpr (Loops::closes) factor_loops(jointed.figures, loops);
}

template <class Loops>
void bring_velocities(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const ContactBlock& block, uint16_t lane_bits) {
    for_jointed(jointed, block, lane_bits, [&](Index body_i, Index node) {
        bring_cursor(jointed.figures, jointed.responses, node);
        write_velocity(jointed, loops, solver.bodies[body_i], node);
    });
}

template <class Loops>
void bring_displacements(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const ContactBlock& block, uint16_t lane_bits) {
    for_jointed(jointed, block, lane_bits, [&](Index body_i, Index node) {
        bring_cursor(jointed.figures, jointed.responses, node);
        write_displacement(jointed, loops, jointed.figures.bodies, solver.bodies[body_i], node);
    });
}

template <class Loops>
void give_wrenches(const JointedBodies& jointed, [[maybe_unused]] const Loops& loops, const ContactBlock& block, uint16_t lane_bits,
                   const GivenWrenches& given) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((lane_bits >> lane_i & 1u) == 0) continue;
        const auto give = [&](Index body_i, const Vector& F, const Vector& T) {
            if (body_i == 0 || !jointed.has_joints(body_i)) return;
            const Index node = jointed.node_of[body_i];
            bring_cursor(jointed.figures, jointed.responses, node);
            give_at_cursor(jointed.figures, jointed.responses, node, F, T);
            if constexpr (Loops::closes) feel_impulse(jointed.figures, loops, node, F, T);
        };
        give(block.body_A[lane_i], lane_of(given.F_A, lane_i), lane_of(given.T_A, lane_i));
        give(block.body_B[lane_i], lane_of(given.F_B, lane_i), lane_of(given.T_B, lane_i));
    }
}

void write_displacements(const SolverView& solver, const JointedBodies& jointed, const BodyView& bodies) {
    for_figure_bodies(solver, jointed, [&](int body_i, Index node) {
        at_node(jointed.figures, node, [&](const auto& rows, const auto& at, int row_i) {
            const auto& row = rows[row_i];
            SolverBody& body = solver.bodies[body_i];
            const Place place = place_of(solver.slot_of[body_i]);
            const Vector I = read(at, row.I_body);
            put_three(body.dp, read(at, row.r) - lane_of(bodies.translation[place.tile].r_CM, place.lane));
            put_three(body.dth, read(at, row.turned));
            set_lane(bodies.translation[place.tile].inv_I_world, place.lane,
                     rotated_diagonal(read(at, row.A), Vector{1 / I.x, 1 / I.y, 1 / I.z}));
        });
    });
}

void write_velocities(const SolverView& solver, const JointedBodies& jointed) {
    for_figure_bodies(solver, jointed, [&](int body_i, Index node) {
        at_node(jointed.figures, node, [&](const auto& rows, const auto& at, int row_i) {
            put_three(solver.bodies[body_i].v_CM, read(at, rows[row_i].v));
            put_three(solver.bodies[body_i].L, read(at, rows[row_i].L));
        });
    });
}

void read_velocities(const SolverView& solver, const JointedBodies& jointed) {
    for_figure_bodies(solver, jointed, [&](int body_i, Index node) {
        at_node(jointed.figures, node, [&](const auto& rows, const auto& at, int row_i) {
            write(at, rows[row_i].v, three_of(solver.bodies[body_i].v_CM));
            write(at, rows[row_i].L, three_of(solver.bodies[body_i].L));
        });
    });
}

void end_jointed_sweeps(const SolverView& solver, const JointedBodies& jointed) {
    for_figure_bodies(solver, jointed, [&](int body_i, Index node) { write_velocity(jointed, NoLoops{}, solver.bodies[body_i], node); });
}

namespace {

template <class Loops>
void pass_up_and_down(const FigureView& figures, const Loops& loops, Passes passes) {
    if (passes == Passes::to_all)
        pass_impulses(figures);
    else
        pass_to_roots(figures, loops, passes == Passes::again);
}
void pass_all_impulses(const FigureView& figures, const NoLoops& loops, Passes passes) { pass_up_and_down(figures, loops, passes); }
void pass_all_impulses(const FigureView& figures, const LoopView& loops, Passes passes) {
    add_loop_impulses(figures, loops);
    pass_up_and_down(figures, loops, passes);
    for_looped_figures(figures, loops, [&](const LoopFigure& of) {
        if (!of.stands) find_lacks(figures, loops, of, true);
    });
}

}  // namespace

template <class View>
void pass_contact_impulses(const View& solver, Passes passes) {
    const JointedBodies& jointed = solver.jointed;
    if constexpr (decltype(solver.loops)::closes) keep_lacks(jointed.figures, solver.loops);
    begin_passing(jointed.figures);
    for (int block_i = jointed.first_block; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds
        const ContactBlock& block = solver.blocks[block_i];
        JointedPairLanes pair(BodyPairLanes{}, jointed.blocks[block_i - jointed.first_block]);
        ContactConstraint<View>::Given::for_rows(solver, block_i, [&](const SeenRow& row) {
            const lane j = load(row.j);
            if (row.levers == nullptr) {
                add_torsion(pair, load(row.d), j, lane{}, lane{});
            } else {
                add_linear(pair, load(row.d) * j, lane{}, lane{});
                add_angular(pair, *row.levers, j);
            }
        });
        note_due(pair);
        const GivenWrenches given = given_to(pair);
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (is_spare(block.manifold[lane_i])) continue;
            const auto give = [&](Index body_i, const Vector& F, const Vector& T) {
                if (body_i != 0 && jointed.has_joints(body_i)) add_impulse(jointed.figures, jointed.node_of[body_i], F, T);
            };
            give(block.body_A[lane_i], lane_of(given.F_A, lane_i), lane_of(given.T_A, lane_i));
            give(block.body_B[lane_i], lane_of(given.F_B, lane_i), lane_of(given.T_B, lane_i));
        }
    }
    pass_all_impulses(jointed.figures, solver.loops, passes);
}

template <class View>
void end_passing(const View& solver) {
    const JointedBodies& jointed = solver.jointed;
    if constexpr (decltype(solver.loops)::closes) {
        for_looped_figures(jointed.figures, solver.loops, [](LoopFigure& of) { of.stands = !of.in_solve; });
        pass_contact_impulses(solver, Passes::to_all);
        close_all_loops(jointed.figures, solver.loops);
    } else {
        take_cursors_away(jointed.figures, jointed.responses);
    }
}

// The linker takes the one that the scene calls.
#define INGOT_LOOPS(Loops)                                                                                                                    \
    template void factor_jointed(const SolverView&, JointedBodies&, const Loops&);                                                            \
    template void bring_velocities(const SolverView&, const JointedBodies&, const Loops&, const ContactBlock&, uint16_t);                     \
    template void bring_displacements(const SolverView&, const JointedBodies&, const Loops&, const ContactBlock&, uint16_t);                  \
    template void give_wrenches(const JointedBodies&, const Loops&, const ContactBlock&, uint16_t, const GivenWrenches&)
INGOT_LOOPS(NoLoops);
INGOT_LOOPS(LoopView);
#undef INGOT_LOOPS
#define INGOT_VIEW(View)                                      \
    template void pass_contact_impulses(const View&, Passes); \
    template void end_passing(const View&)
INGOT_VIEW(JointedView);
INGOT_VIEW(JointedMaterialView);
INGOT_VIEW(LoopedView);
INGOT_VIEW(LoopedMaterialView);
#undef INGOT_VIEW

} }  // namespace ingot

#pragma GCC diagnostic pop
