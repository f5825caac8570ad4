// SPDX-License-Identifier: MIT
// Visits to manifolds whose bodies have joints: the bodies are brought up to date before, and what they got goes to their figures after.
#pragma once

#include "../../base/figure_limits.h"
#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_response.h"
#include "../../figure/find_loops.h"
#include "../../figure/reached_bodies.h"
#include "../../math/sqrt.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Figures of the batch as they are now: joints, inertia, responses. Loops: LoopView, or NoLoops.
template <class Loops>
void factor_jointed(const SolverView& solver, JointedBodies& jointed, const Loops& loops);
/// The same as a batch begins.
template <class View>
INGOT_INLINE void begin_jointed_batch(View& solver) {
    [[maybe_unused]] const scalar h = solver.jointed.figures.h / static_cast<scalar>(solver.substeps);
    if constexpr (decltype(solver.loops)::closes) load_loops(solver.jointed.figures, solver.loops, h);
    reach_all(solver.jointed.figures, 0);  // it is known once there are blocks
    factor_jointed(solver, solver.jointed, solver.loops);
    solver.jointed.is_fresh = true;
}

/// Who knows of impulses that pass through the figures: the cursors, at the roots, which take them along; or all bodies. again: after a sweep, where
/// bodies that nothing reaches have nothing new to hand on.
enum class Passes : uint8_t { to_roots, again, to_all };
/// The impulses of all contacts of the batch, as they stand, pass through the figures. Needs: begin_solve.
template <class View>
void pass_contact_impulses(const View& solver, Passes passes = Passes::to_roots);

/// Which bodies contacts and loops reach in the batch: see reached_bodies.h.
template <class View>
INGOT_INLINE void reach_contacts(const View& solver) {
    const JointedBodies& jointed = solver.jointed;
    reach_all(jointed.figures, not_reached);
    reach_loops(jointed.figures, solver.loops);
    for (int block_i = jointed.first_block; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (is_spare(block.manifold[lane_i])) continue;
            const Index both_bodies[] = {block.body_A[lane_i], block.body_B[lane_i]};
            for (const Index body_i : both_bodies)
                if (body_i != 0 && jointed.has_joints(body_i)) reach(jointed.figures, jointed.node_of[body_i]);
        }
    }
}

/// What sweeps at their bound may do wrong is known of islands without joints alone: those with some are not swept again. Of those of the batch: what
/// the others have been found to be is no matter of a solve that they are not in.
template <class View>
void excuse_jointed(View& solver) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        if (solver.islands[island_i].in_batch && solver.jointed.doublings_of[island_i] != 0) solver.islands[island_i].at_bound = false;
}

/// Sweeps of islands with joints that move end sooner: at limits::jointed_settled_share of what gravity gives in a substep of h seconds, or of what
/// they have beyond that, if it is less. What comes to rest, whose fastest body has no more than what gravity has just given, settles as others do.
template <class View>
void settle_jointed_sooner(View& solver, scalar h) {
    const scalar fall = h * sqrt(length_sq(solver.jointed.figures.gravity));
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (solver.jointed.doublings_of[island_i] == 0) continue;
        island.settled = max(island.settled, limits::jointed_settled_share * min(fall, sqrt(island.fastest_sq) - fall));
    }
}

/// That of the body of a node.
template <class View>
Island& island_of_node(const View& solver, Index node) {
    return solver.islands[solver.island_of[solver.local_of[solver.jointed.figures.nodes[node].slot]]];
}

/// Figures with loops stand where is_on(island) is false of theirs: an island does not know how long others are swept. begins: so do the sweeps.
template <class View, class IsOn>
INGOT_INLINE void stand_unless([[maybe_unused]] const View& solver, [[maybe_unused]] bool begins, [[maybe_unused]] const IsOn& is_on) {
    if constexpr (decltype(solver.loops)::closes)
        for_looped_figures(solver.jointed.figures, solver.loops, [&](LoopFigure& of) {
            of.stands = !is_on(island_of_node(solver, of.first_node));
            if (begins) of.in_solve = !of.stands;
        });
}

/// After the last sweep: changes of all bodies are those of all impulses, and of closed loops. What these lack for it stays beside their impulses,
/// until the island is swept again, or end_loops.
template <class View>
void end_passing(const View& solver);
/// Bodies of figures have the velocities of the solve in SolverView::bodies too. Needs: changes of all bodies.
void end_jointed_sweeps(const SolverView& solver, const JointedBodies& jointed);

/// v_CM and L of the bodies of a visit are those that all impulses so far give them.
template <class Loops>
void bring_velocities(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const ContactBlock& block, uint16_t lane_bits);
/// And dp and dth, of pushes.
template <class Loops>
void bring_displacements(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const ContactBlock& block, uint16_t lane_bits);

/// What the bodies of a visit got, by lane.
struct GivenWrenches {
    scalar F_A[3][lanes], T_A[3][lanes], F_B[3][lanes], T_B[3][lanes];
};
template <class Loops>
void give_wrenches(const JointedBodies& jointed, const Loops& loops, const ContactBlock& block, uint16_t lane_bits, const GivenWrenches& given);

INGOT_INLINE GivenWrenches given_to(const JointedPairLanes& pair) {
    GivenWrenches given;
    store(given.F_A, pair.sum_A.F);
    store(given.T_A, pair.sum_A.T);
    store(given.F_B, pair.sum_B.F);
    store(given.T_B, pair.sum_B.T);
    return given;
}

/// Bodies of figures are where their figures are: dp and dth, and the inertia that contacts see.
void write_displacements(const SolverView& solver, const JointedBodies& jointed, const BodyView& bodies);

/// Velocities of figures come to the solver's bodies.
void write_velocities(const SolverView& solver, const JointedBodies& jointed);
/// Velocities of the begin of a solve come into the figures.
void read_velocities(const SolverView& solver, const JointedBodies& jointed);

} }  // namespace ingot

#pragma GCC diagnostic pop
