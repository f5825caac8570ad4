// SPDX-License-Identifier: MIT
#include "prepare_responses.h"

#include "../base/figure_limits.h"
#include "../figure/respond_figures.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

scalar share_of_rounding(const FigureView&, const NoLoops&, Index) { return limits::held_compliance; }
/// What loops take from a response is a square of X, whose rounding grows as the root of the least pivot falls.
scalar share_of_rounding(const FigureView& view, const LoopView& loops, Index node_i) {
    const LoopFigure* const of = loops.of_node(view, node_i);
    return of == nullptr ? limits::held_compliance : max(limits::held_compliance, limits::looped_compliance / sqrt(of->least));
}

/// Of the body of one lane, from its tile or its figure.
template <class Loops>
void write_side(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const BodyView& bodies, SideResponse& side, int lane_i,
                Index body_i) {
    Spatial6<scalar> answer{};
    SymmetricMatrix I{};
    const bool joined = body_i != 0 && jointed.has_joints(body_i);
    if (joined) {
        answer = response_of_centre(jointed.figures, loops, jointed.responses, jointed.node_of[body_i]);
        I = inertia_of_node(jointed.figures, jointed.node_of[body_i]);
    } else if (body_i != 0 && body_i < jointed.body_count) {
        const Place at = place_of(solver.slot_of[body_i]);
        const TranslationTile& tile = bodies.translation[at.tile];
        const scalar inv_M = tile.inv_M[at.lane];
        answer = {lane_of(tile.inv_I_world, at.lane), {}, {inv_M, inv_M, inv_M, 0, 0, 0}};
    }
    set_lane(side.ww, lane_i, answer.A);
    set_lane(side.wv, lane_i, answer.B);
    set_lane(side.vv, lane_i, answer.C);
    set_lane(side.I, lane_i, I);
    side.joined[lane_i] = joined ? share_of_rounding(jointed.figures, loops, jointed.node_of[body_i]) : 0;
}

void write_across(JointedBlock& block, int lane_i, const Across& across) {
    set_lane(block.ww, lane_i, across.ww);
    set_lane(block.wv, lane_i, across.wv);
    set_lane(block.vw, lane_i, across.vw);
    set_lane(block.vv, lane_i, across.vv);
}

}  // namespace

template <class Loops>
void prepare_responses(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const BodyView& bodies, int block_i) {
    const ContactBlock& contacts = solver.blocks[block_i];
    JointedBlock& block = jointed.blocks[block_i - jointed.first_block];
    block.some_across = false;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const Index A = contacts.body_A[lane_i], B = contacts.body_B[lane_i];
        write_side(solver, jointed, loops, bodies, block.A, lane_i, A);
        write_side(solver, jointed, loops, bodies, block.B, lane_i, B);
        const bool one_figure = A != 0 && B != 0 && jointed.has_joints(A) && jointed.has_joints(B) && jointed.leader_of[A] == jointed.leader_of[B];
        const Across across =
            one_figure ? response_across(jointed.figures, loops, jointed.responses, jointed.node_of[A], jointed.node_of[B]) : Across{};
        write_across(block, lane_i, across);
        block.some_across = block.some_across || one_figure;
    }
}

// The linker takes the one that the scene calls.
template void prepare_responses(const SolverView&, const JointedBodies&, const NoLoops&, const BodyView&, int);
template void prepare_responses(const SolverView&, const JointedBodies&, const LoopView&, const BodyView&, int);

} }  // namespace ingot
