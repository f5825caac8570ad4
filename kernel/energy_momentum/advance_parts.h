// SPDX-License-Identifier: MIT
// advance_figures, for the files that compile it: see advance_figure.h.
#pragma once

#include "../base/figure_limits.h"
#include "../figure/factor_figures.h"
#include "../figure/row_motion.h"
#include "advance_figure.h"
#include "at_node.h"
#include "fit_to_joints.h"
#include "note_part.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Of a step: one, or Suzuki's five, p = 1 / (4 - 4^(1/3)) twice, 1 - 4 p, p twice.
constexpr scalar suzuki = scalar(0.41449077179437573714), suzuki_back = scalar(-0.65796308717750294857);
constexpr scalar parts_of_order_2[] = {1}, parts_of_order_4[] = {suzuki, suzuki, suzuki_back, suzuki, suzuki};

/// How far a group has come in its step.
template <unsigned width_of_rows>
struct Progress {
    static constexpr unsigned width = width_of_rows;
    using T = typename AllLanes<width>::T;

    FigureView& view;
    const EnergyMomentumView& scheme;
    FigureRows<width> figures;
    unsigned good;           ///< a bit a lane: figures whose passes have found an end so far
    int passes_max[width];   ///< of one part, that may be
    int passes[width];       ///< so far, in all parts
    int most_passes[width];  ///< so far, in one part
    T most_turn_sq;          ///< rad^2, so far, of one body in one part

    NewtonRow<width>& newton(int row_i) const { return newton_row(figures, scheme.rows, row_i); }
};

template <unsigned width>
void begin_progress(Progress<width>& at) {
    using T = typename AllLanes<width>::T;
    T least = at.figures.all.get(at.figures[0].M), most = least;
    for (int row_i = 1; row_i < at.figures.count(); ++row_i) {  // bound: max_bodies
        least = min(least, at.figures.all.get(at.figures[row_i].M));
        most = max(most, at.figures.all.get(at.figures[row_i].M));
    }
    scalar ratio[width];
    at.figures.all.put(ratio, most / least);
    for (unsigned lane_i = 0; lane_i < width; ++lane_i) {  // bound: lanes
        at.passes_max[lane_i] = ratio[lane_i] > limits::newton_steep_ratio ? limits::newton_steep_passes_max : limits::newton_passes_max;
        at.passes[lane_i] = at.most_passes[lane_i] = 0;
    }
}

/// What a look at the end of a figure means.
struct Verdict {
    bool moves;    ///< once more
    bool goes_on;  ///< and is looked at again
    bool fails;    ///< passes find no end
};
/// Newton's method squares what is off, but for a factor, and the look before has shown the factor. A move that leaves no more than roundings by that
/// is the last, and is not looked at. misfit, before: squares, of this look and the one before.
[[maybe_unused]] Verdict verdict_on(scalar misfit, scalar before, int pass_i, int passes_max) {
    constexpr scalar settled = limits::newton_settled * limits::newton_settled, close = limits::newton_close * limits::newton_close;
    if (misfit <= settled) return {false, false, false};
    if (!(misfit < scalar_max)) return {false, false, true};
    const scalar ratio = misfit / before;
    if (misfit <= close || (pass_i > 0 && misfit * ratio * ratio <= settled)) return {true, false, false};
    const bool is_last = pass_i + 1 == passes_max;
    return {!is_last, !is_last, is_last};
}

/// Passes, for each figure until its moves would be roundings.
template <unsigned width>
void solve(Progress<width>& at, const NewtonStep<width>& step) {
    begin_passes(step);
    scalar before[width], misfit[width];
    for (scalar& of_lane : before) of_lane = scalar_max;
    unsigned active = at.good;
    for (int pass_i = 0; pass_i < limits::newton_steep_passes_max && active != 0; ++pass_i) {
        look_at_end(step, misfit);
        unsigned moving = 0;
        for (unsigned lane_i = 0; lane_i < width; ++lane_i) {  // bound: lanes
            const unsigned bit = 1u << lane_i;
            if ((active & bit) == 0) continue;
            const Verdict verdict = verdict_on(misfit[lane_i], before[lane_i], pass_i, at.passes_max[lane_i]);
            before[lane_i] = misfit[lane_i];
            ++at.passes[lane_i];
            if (pass_i + 1 > at.most_passes[lane_i]) at.most_passes[lane_i] = pass_i + 1;
            if (verdict.moves) moving |= bit;
            if (!verdict.goes_on) active &= ~bit;
            if (verdict.fails) at.good &= ~bit;
        }
        if (moving != 0) move_end(step, moving);
    }
}

/// Takes the rows to the end of the part that has been solved.
template <unsigned width>
void take_end(Progress<width>& at, const NewtonStep<width>& step) {
    using T = typename AllLanes<width>::T;
    const T twice_rate = splat<T>(2 / step.h);
    for (int row_i = 0; row_i < step.figures.count(); ++row_i) {  // bound: max_bodies
        const AtNode<width> of(step, row_i);
        FigureRow<width>& row = step.figures[row_i];
        const Vec3<T> theta = read(of.all, of.newton.theta), dr = read(of.all, of.newton.dr);
        const Mat3<T> turn = turn_of(theta);
        Mat3<T> A = read(of.all, row.A);
        A = A + turn * A;
        A = A + polar_correction(A);
        write(of.all, row.L, momentum_after(of, read(of.all, of.newton.I_0), turn, twice_rate));
        write(of.all, row.v, dr * twice_rate - read(of.all, row.v));
        write(of.all, row.r, read(of.all, row.r) + dr);
        write(of.all, row.A, A);
        write(of.all, row.j, read(of.all, row.j) + read(of.all, of.newton.f).v);
        at.most_turn_sq = max(at.most_turn_sq, length_sq(theta));
    }
    set_spins(step.figures);
}

/// NewtonRow::f, as forces, N and N m: what joints pushed with in the last step.
template <unsigned width>
void recall_forces(const Progress<width>& at) {
    using T = typename AllLanes<width>::T;
    const scalar rate = static_cast<scalar>(at.scheme.substeps) / at.view.h;
    for (int row_i = 0; row_i < at.figures.count(); ++row_i) {  // bound: max_bodies
        Spatial<T> f{};
        if (at.figures.node(row_i).kind != JointKind::none) {
            f.w = at.figures.gathered(row_i, [&](const FigureNode& node) { return at.scheme.of_body[node.slot].torque; });
            f.v = at.figures.gathered(row_i, [&](const FigureNode& node) {
                return at.view.lists.joints[node.joint].j * (static_cast<scalar>(node.is_A ? -1 : 1) * rate);
            });
        }
        write(at.figures.all, at.newton(row_i).f, f);
        write(at.figures.all, at.figures[row_i].j, Vec3<T>{});
    }
}
/// NewtonRow::f from forces to impulses, and back.
template <unsigned width>
void scale_impulses(const Progress<width>& at, scalar s) {
    using T = typename AllLanes<width>::T;
    for (int row_i = 0; row_i < at.figures.count(); ++row_i) {  // bound: max_bodies
        SpatialRows<width>& f = at.newton(row_i).f;
        write(at.figures.all, f, read(at.figures.all, f) * splat<T>(s));
    }
}

template <unsigned width, class Reactions>
void advance_part(Progress<width>& at, Reactions reactions, scalar h) {
    place_joints(at.view);
    NewtonStep<width> step = {at.figures, at.scheme.rows, h, ground_of(at.figures, at.figures.all), {}, {}};
    at.view.elapsed += h;
    const auto ground_after = ground_of(at.figures, at.figures.all);
    step.ground_way = ground_after.r - step.ground.r;
    step.ground_turn = (ground_after.A - step.ground.A) * transposed(step.ground.A);
    scale_impulses(at, h);
    solve(at, step);
    note_part(step, reactions);
    take_end(at, step);
    scale_impulses(at, 1 / h);
}

}  // namespace

template <unsigned width, class Reactions>
void advance_figures(FigureView& view, const EnergyMomentumView& scheme, Reactions reactions, bool was_seen, int halvings,
                     FigureAdvance (&advances)[width]) {
    Progress<width> at = {view, scheme, {view, view.groups[0]}, (1u << width) - 1u, {}, {}, {}, {}};
    view.elapsed = 0;
    set_spins(at.figures);
    const unsigned fits = was_seen ? at.good : fit_to_joints(view, at.figures);
    at.good &= fits;
    begin_progress(at);
    recall_forces(at);
    begin_reactions(view, NoLoops{}, reactions);
    const scalar h = view.h / static_cast<scalar>(1 << halvings);
    const scalar* const parts = scheme.order == 2 ? parts_of_order_2 : parts_of_order_4;
    const int part_count = scheme.order == 2 ? 1 : 5;
    for (int i = 0; i < (1 << halvings) * part_count && at.good != 0; ++i)  // bound: 2^limits::newton_halvings_max, five parts
        advance_part(at, reactions, h * parts[i % part_count]);
    take_up_roundings(at.figures);
    take_hidden_energy(view, at.figures, scheme.snap);
    constexpr scalar turn_sq_max = limits::newton_turn * limits::newton_turn;
    scalar turn_sq[width];
    at.figures.all.put(turn_sq, at.most_turn_sq);
    for (unsigned lane_i = 0; lane_i < width; ++lane_i) {  // bound: lanes
        const bool is_far = turn_sq[lane_i] > turn_sq_max && halvings < limits::newton_halvings_max;
        const bool is_easy = halvings > 0 && at.most_passes[lane_i] <= limits::newton_easy_passes && 4 * turn_sq[lane_i] <= turn_sq_max;
        const bool is_good = (at.good >> lane_i & 1u) != 0;
        advances[lane_i] = {(fits >> lane_i & 1u) != 0, is_good && !is_far, at.passes[lane_i], is_easy ? halvings - 1 : halvings};
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop
