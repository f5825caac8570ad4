// SPDX-License-Identifier: MIT
// What targets of a substep would make of the energy of a figure, and which of them it may have.
#pragma once

#include "../base/figure_limits.h"
#include "close_loops.h"
#include "displace_rows.h"
#include "measure_joint.h"
#include "three_energies.h"
#include "universal_joints.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

template <unsigned width>
using T_of_width = typename AllLanes<width>::T;

/// J; of the bodies of a figure, with what `change` would make of it.
template <class T>
struct FigureEnergies {
    T before, after;
};
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
FigureEnergies<T> figure_energies_of(const FigureRows<width, Kinds>& rows) {
    FigureEnergies<T> sum{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = rows[row_i];
        const Mat3<T> A = read(rows.all, row.A);
        const Vec3<T> I = read(rows.all, row.I_body), v = read(rows.all, row.v), w = transpose_times(A, read(rows.all, row.w));
        const Spatial<T> u = change_of_centre(rows.all, row);
        const Vec3<T> w_after = w + transpose_times(A, u.w);
        const T M = rows.all.get(row.M), half = splat<T>(scalar(0.5));
        sum.before = sum.before + (M * length_sq(v) + dot(scaled(I, w), w)) * half;
        sum.after = sum.after + (M * length_sq(v + u.v) + dot(scaled(I, w_after), w_after)) * half;
    }
    return sum;
}

template <unsigned width, class Kinds>
T_of_width<width> mass_of(const FigureRows<width, Kinds>& rows) {
    T_of_width<width> M{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) M = M + rows.all.get(rows[row_i].M);  // bound: max_bodies
    return M;
}

/// J, that a figure may have with its targets: `gain` times what it has, and what it takes to close a gap in a substep.
template <unsigned width, class Kinds, class T = T_of_width<width>>
T allowed_energy(const FigureRows<width, Kinds>& rows, T before, T M, scalar h, scalar gain) {
    const scalar gap_speed = limits::joint_gap * rows.view.unit / h;
    return before * splat<T>(gain) + M * splat<T>(gap_speed * gap_speed);
}
template <unsigned width, class Kinds, class T = T_of_width<width>>
auto gaining_lanes(const FigureRows<width, Kinds>& rows, const FigureEnergies<T>& energies, T M, scalar h, scalar gain = limits::target_gain) {
    return energies.after > allowed_energy(rows, energies.before, M, h, gain);
}

/// They are left as they move; where that is far, they get velocities that fit their joints as they are: on what does not, any impulse would work.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
void leave_out_biases(const FigureRows<width, Kinds>& rows, M gains, M is_far) {
    const Vec3<T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const JointKind kind = rows.kind(row_i);
        if (kind == JointKind::none) continue;
        const Spatial<T> bias = read(rows.all, row.bias);
        Spatial<T> off{};
        if (any(is_far)) off = locked_part(rows.all, row, kind, twist_of_joint(rows, rows.all, row_i));
        write(rows.all, row.bias,
              Spatial<T>{select(gains, select(is_far, -off.w, none), bias.w), select(gains, select(is_far, -off.v, none), bias.v)});
    }
}

/// Of lanes that are flagged.
template <unsigned width, class Kinds>
void fit_biases(const FigureRows<width, Kinds>& rows, const scalar (&flags)[lanes]) {
    scalar of_rows[width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) of_rows[lane_i] = flags[lane_i];  // bound: lanes
    const auto fits = rows.all.get(of_rows) > T_of_width<width>{};
    if (any(fits)) leave_out_biases(rows, fits, fits);
}

template <unsigned width, class Kinds>
void pass_alone(const FigureRows<width, Kinds>& rows) {
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
}

/// Lanes whose figures turn by more than limits::far_turn in the substep, or whose joints would be off by more than limits::far_off: arms go on
/// chords, and targets of second order ask for what is no motion any more, whatever the substep before was like.
template <unsigned width, class Kinds>
auto far_lanes(const FigureRows<width, Kinds>& rows, scalar h) {
    using T = T_of_width<width>;
    const T of_turn = splat<T>(1 / (limits::far_turn * limits::far_turn)), of_off = splat<T>(h * h / (limits::far_off * limits::far_off));
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        most = max(most, length_sq(read(rows.all, rows[row_i].turn)) * of_turn);
        if (rows.node(row_i).kind != JointKind::none) most = max(most, length_sq(read(rows.all, rows[row_i].bias).w) * of_off);
    }
    return most > splat<T>(1);
}

/// Lanes that were found to be parted: see find_parted.
template <unsigned width, class Kinds>
auto parted_lanes(const FigureRows<width, Kinds>& rows) {
    scalar flags[width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) flags[lane_i] = rows.figure(lane_i).parted;  // bound: lanes
    return rows.all.get(flags) > T_of_width<width>{};
}

/// Figure::parted of a figure that is looked at, or goes on to be.
inline void note_parted(const FigureView& view, Figure& figure, bool is_apart) {
    const bool asks = view.elapsed == 0 || figure.parted > 0;
    if (is_apart && asks)
        figure.parted = 2;
    else if (figure.parted > 0)
        --figure.parted;
}

/// Finds figures that are apart: bodies were put to where they are, and no velocity has to take them back. Looked at as a step begins, and then until
/// they are together; and in the substep after that, as figures with loops were placed before the push. Before the joints are aimed.
template <unsigned width, class Kinds>
void find_parted(const FigureRows<width, Kinds>& rows) {
    bool asks = rows.view.elapsed == 0;
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) asks = asks || rows.figure(lane_i).parted > 0;  // bound: lanes
    if (!asks) return;
    const unsigned apart = bits(apart_lanes(rows));
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i)  // bound: lanes
        note_parted(rows.view, rows.figure(lane_i), (apart >> lane_i & 1u) != 0);
}

/// The same of scenes with loops: what is tied to each other is parted together.
inline void find_parted(const FigureView& view, const LoopView& loops) {
    for_groups(view, [](const auto& rows) { find_parted(rows); });
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        uint8_t parted = 0;
        for (int i = of.figure; i < of.figure + of.figure_count; ++i)  // bound: max_bodies
            if (view.figures[i].parted > parted) parted = view.figures[i].parted;
        const bool asks = parted > 0 || view.elapsed == 0;
        if (asks && aim_pushes(view, loops, of) > limits::parted_gap * limits::parted_gap) parted = 2;
        for (int i = of.figure; i < of.figure + of.figure_count; ++i) view.figures[i].parted = parted;
    });
}

/// Targets of what is not resolved may ask for what cannot be, where joints come near to where they lock: light bodies would get any speed. Where a
/// figure would have more than limits::target_gain times its energy they are left out: velocities then fit the joints, which takes energy, and
/// pushes take back the gaps. So they do where bodies were put apart.
template <unsigned width, class Kinds, class M>
void hold_back_targets(const FigureRows<width, Kinds>& rows, scalar h, M is_exact) {
    const auto is_parted = parted_lanes(rows), is_far = either(far_lanes(rows, h), is_parted);
    const auto doubtful = either(opposite(is_exact), is_far);
    if (!any(doubtful)) return;
    pass_alone(rows);
    const auto gains = either(is_parted, both(doubtful, gaining_lanes(rows, figure_energies_of(rows), mass_of(rows), h)));
    if (any(gains)) leave_out_biases(rows, gains, is_far);
}

/// Lanes whose targets are doubtful where some have loops: these are, as their rows may come near to saying the same.
template <unsigned width, class Kinds>
auto doubtful_lanes(const FigureRows<width, Kinds>& rows, const LoopView& loops, scalar h) {
    using T = T_of_width<width>;
    scalar flags[width];
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) flags[lane_i] = rows.figure(lane_i).resolved ? 0 : 1;  // bound: lanes
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) { flags[lane_i] = of.row_count > 0 ? 1 : flags[lane_i]; });
    return either(either(rows.all.get(flags) > T{}, parted_lanes(rows)), far_lanes(rows, h));
}

/// Lanes whose figures are no machines.
template <unsigned width, class Kinds>
auto lanes_of_trees(const FigureRows<width, Kinds>& rows, const LoopView& loops) {
    scalar flags[width];
    for (scalar& flag : flags) flag = 1;
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) { flags[lane_i] = of.row_count > 0 ? 0 : 1; });
    return rows.all.get(flags) > T_of_width<width>{};
}

/// The energies of a figure, and its mass, stand in FigureRow::drive of its root until the solve begins: a machine gains or not as a whole.
template <unsigned width, class Kinds>
void note_energies(const FigureRows<width, Kinds>& rows) {
    const FigureEnergies<T_of_width<width>> energies = figure_energies_of(rows);
    write(rows.all, rows[0].drive, Vec3<T_of_width<width>>{energies.before, energies.after, mass_of(rows)});
}
inline void share_energies(const FigureView& view, const LoopFigure& of) {
    if (of.figure_count == 1) return;
    Vector sum{};
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { sum = sum + read(at, rows[0].drive); });
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { write(at, rows[0].drive, sum); });
}

/// What drives a machine from outside, that moves or is reeled, may give it its speed: this adds to what it has.
inline void allow_driven_speed(const FigureView& view, const LoopFigure& of, scalar speed) {
    for_figures_of(view, of, [&](const auto& rows, const auto& at) {
        const Vector energies = read(at, rows[0].drive);
        write(at, rows[0].drive, Vector{energies.x + energies.z * (speed * speed), energies.y, energies.z});
    });
}

/// What targets make of the energies of all that is doubtful, by a way up and down.
inline void measure_targets(const FigureView& view, const LoopView& loops, scalar h) {
    for_groups(view, [&](const auto& rows) {
        if (any(doubtful_lanes(rows, loops, h))) pass_alone(rows);
    });
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        find_lacks(view, loops, of, false);
        close_loops(view, loops, of);
    });
    for_groups(view, [&](const auto& rows) {
        if (any(doubtful_lanes(rows, loops, h))) note_energies(rows);
    });
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        if (of.row_count == 0) return;  // servos alone: its figures are by themselves
        share_energies(view, of);
        if (loops.ties != nullptr) allow_driven_speed(view, of, driven_speed(view, loops, of));
        for_figures_of(view, of, [](const auto& rows, const auto& at) { rows[0].drive[2][at.lane_i] = 0; });  // no gap is closed by a target
    });
}
template <unsigned width, class Kinds>
auto gaining_lanes(const FigureRows<width, Kinds>& rows, const LoopView& loops, scalar h, scalar gain) {
    const auto of = read(rows.all, rows[0].drive);
    const auto gains = both(doubtful_lanes(rows, loops, h), gaining_lanes(rows, {of.x, of.y}, of.z, h, gain));
    return either(gains, both(parted_lanes(rows), lanes_of_trees(rows, loops)));
}

/// Machines near a dead point, as a chain is that is drawn taut, have a second way to where targets of second order want them: through it, to its
/// mirror image. And there the rounding of a gap, over a substep, is a speed that takes a large impulse. So these get velocities that fit their
/// joints as they are, which takes energy alone, and pushes take back the gaps; and so do machines of which targets would take more energy than
/// there is. True where there is one. After measure_targets.
inline bool fit_taut_machines(const FigureView& view, const LoopView& loops, scalar h, scalar gain) {
    const auto is_taut = [&](const LoopFigure& of, const Vector& energies) {
        const bool is_parted = view.figures[of.figure].parted > 0;
        return of.row_count > 0 && (is_parted || of.least < limits::taut_compliance || energies.y > energies.x * gain);
    };
    bool some = false;
    for_groups(view, [&](const auto& rows) {
        scalar flags[lanes]{};
        for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) {
            flags[lane_i] = is_taut(of, read(rows.one(lane_i), rows[0].drive)) ? 1 : 0;
            some = some || flags[lane_i] > 0;
        });
        fit_biases(rows, flags);
    });
    if (!some) return false;
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const auto energies = [](const auto& rows, const auto& at, int) { return read(at, rows[0].drive); };
        if (is_taut(of, at_node(view, of.first_node, energies))) fit_loops(view, loops, of, h);
    });
    return true;
}

/// The same as hold_back_targets of trees, of scenes with loops. After measure_targets.
inline void hold_back_targets(const FigureView& view, const LoopView& loops, scalar h, scalar gain) {
    for_groups(view, [&](const auto& rows) {
        const auto gains = gaining_lanes(rows, loops, h, gain);
        if (!any(gains)) return;
        leave_out_biases(rows, gains, either(far_lanes(rows, h), parted_lanes(rows)));
        for_looped(rows, loops, [&](const LoopFigure& of_loops, int lane_i) {
            if ((bits(gains) >> lane_i & 1u) != 0) leave_out_targets(loops, of_loops);
        });
    });
}

// A universal joint locks what turns about its two axes do not reach. What hangs on it and swings past one of these, its pole, has to turn about
// it as fast as it can: for some substeps the locked direction turns along, and velocities change by a good part of themselves. Targets are right
// to the third order of that change. Past a pole a body of 11 kg gained 10 of its 220 J at 60 Hz, all by them; others lost half of theirs, and came
// apart by decimetres. So such figures ask for substeps by that change, and get no more of their targets than gives no energy.
//
// The roads not taken. Targets by the velocities that they lead to, until nothing changes: no more is gained in all, but four times as much in a
// step. Substeps alone: 2 of 4000 pendulums still gained more than a hundredth in a step. Shares alone: as long as the last substep of a step is
// calm nobody asks for more, and what has come apart is lifted as it is pushed back.

/// J, of each lane: changes of velocities times the velocities after them. A turn by a small angle has its square times the energy; what comes to
/// rest along its joints, as what hangs still under its weight does in every substep, has nothing.
template <unsigned width, class Kinds, class T = T_of_width<width>>
T turned_energy_of(const FigureRows<width, Kinds>& rows) {
    T sum{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureRow<width>& row = rows[row_i];
        const Mat3<T> A = read(rows.all, row.A);
        const Spatial<T> u = change_of_centre(rows.all, row);
        const Vec3<T> u_w = transpose_times(A, u.w), w_after = transpose_times(A, read(rows.all, row.w)) + u_w;
        sum = sum + (rows.all.get(row.M) * dot(u.v, read(rows.all, row.v) + u.v) + dot(scaled(read(rows.all, row.I_body), u_w), w_after));
    }
    return sum;
}

/// How often a substep that is whole has to be halved for what turns by the square root of turned / energy in it.
inline uint8_t doublings_for_turn(scalar turned, scalar energy) {
    uint8_t doublings = 0;
    for (int i = 0; i < limits::doublings_max; ++i) {
        const scalar turn = limits::turn_of_doublings[i];
        if (turned > turn * turn * energy) doublings = static_cast<uint8_t>(i + 1);
    }
    return doublings;
}

/// Until the step ends the records of universal joints keep how often its substeps should have been halved: see ask_for_doublings. turned: J.
template <unsigned width, class Kinds, class T = T_of_width<width>>
void note_doublings(const FigureRows<width, Kinds>& rows, T turned, T energy) {
    scalar of_turned[width], of_energy[width];
    rows.all.put(of_turned, turned);
    rows.all.put(of_energy, energy);
    const bool is_first = rows.view.elapsed == 0;
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
        const auto whole = static_cast<scalar>(1 << 2 * rows.figure(lane_i).doublings);  // a whole substep turns by so much more, squared
        const uint8_t doublings = doublings_for_turn(of_turned[lane_i] * whole, of_energy[lane_i]);
        for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
            if (rows.kind(row_i) != JointKind::universal) continue;
            uint8_t& noted = rows.view.lists.joints[rows.node(row_i, lane_i).joint].doublings;
            if (is_first || doublings > noted) noted = doublings;
        }
    }
}

/// Lanes that get a share of their targets, and for the rest come to rest along what their joints lock, which takes energy.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
void take_share(const FigureRows<width, Kinds>& rows, M of, T share) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const JointKind kind = rows.kind(row_i);
        if (kind == JointKind::none) continue;
        const Spatial<T> bias = read(rows.all, row.bias), off = locked_part(rows.all, row, kind, twist_of_joint(rows, rows.all, row_i));
        write(rows.all, row.bias,
              Spatial<T>{select(of, (bias.w + off.w) * share - off.w, bias.w), select(of, (bias.v + off.v) * share - off.v, bias.v)});
    }
}

/// J, with a half of their targets, which is what is left of these.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
T energy_of_half(const FigureRows<width, Kinds>& rows, M of) {
    take_share(rows, of, splat<T>(scalar(0.5)));
    pass_alone(rows);
    return figure_energies_of(rows).after;
}

/// Of lanes that gain, the largest share of their targets with which they have no more than `most`, J.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
void share_up_to(const FigureRows<width, Kinds>& rows, M gains, T energy, T most) {
    scalar all[width], half[width], fourth[width], allowed[width], shares[width];
    rows.all.put(all, energy);
    rows.all.put(allowed, most);
    rows.all.put(half, energy_of_half(rows, gains));
    rows.all.put(fourth, energy_of_half(rows, gains));
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i)  // bound: lanes
        shares[lane_i] = 4 * ThreeEnergies{all[lane_i], half[lane_i], fourth[lane_i]}.share_up_to(allowed[lane_i]);
    take_share(rows, gains, rows.all.get(shares));
}

/// Of figures with universal joints; alone: lanes without loops and ties. Before hold_back_targets. h: s, of the substep.
/// Cost: a way up and down; three where one gains.
template <unsigned width, class Kinds, class M, class T = T_of_width<width>>
void share_targets(const FigureRows<width, Kinds>& rows, scalar h, M alone) {
    pass_alone(rows);
    const FigureEnergies<T> energies = figure_energies_of(rows);
    const T mass = mass_of(rows), closing = allowed_energy(rows, T{}, mass, h, 1);  // what closes gaps is no turn
    note_doublings(rows, select(alone, turned_energy_of(rows) - closing, T{}), energies.before);
    const T most = allowed_energy(rows, energies.before, mass, h, 1 + limits::figure_gain_allowed);
    const auto gains = both(alone, energies.after > most);
    if (any(gains)) share_up_to(rows, gains, energies.after, most);
}

/// The same of scenes with loops. Machines have limits::target_gain_of_machines alone.
inline void share_targets(const FigureView& view, const LoopView& loops, scalar h) {
    for_groups(view, [&](const auto& rows) {
        if (has_universal_joint(rows)) share_targets(rows, h, lanes_of_trees(rows, loops));
    });
}

} }  // namespace ingot

#pragma GCC diagnostic pop
