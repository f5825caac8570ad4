// SPDX-License-Identifier: MIT
// swing_freely, for the files that compile it: see swing_freely.h.
#pragma once

#include "../base/figure_limits.h"
#include "../body/auxiliary.h"
#include "../figure/build_figures.h"
#include "../figure/keep_figures.h"
#include "../math/sqrt.h"
#include "advance_figure.h"
#include "newton_pass.h"
#include "swing_freely.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

[[maybe_unused]] bool has_bit(const uint16_t* of_tiles, Place at) { return (of_tiles[at.tile] >> at.lane & 1u) != 0; }

/// A hash of the motion of a figure: FNV-1a, a word at a time. One world compares its own, so the order of bytes does not matter, and a fourth of the
/// multiplications of state_hash do. A change of one word changes it; of other changes one in 2^32 is missed.
class MotionHash {
public:
    void operator()(const Vector& v) {
        (*this)(v.x);
        (*this)(v.y);
        (*this)(v.z);
    }
    void operator()(const Matrix& A) {
        (*this)(A.c0);
        (*this)(A.c1);
        (*this)(A.c2);
    }
    /// Never 0: see FigureMemory::seen.
    uint32_t number() const { return number_ == 0 ? 1 : number_; }

private:
    void operator()(scalar x) {
        If<INGOT_DOUBLE != 0, uint64_t, uint32_t> bits;
        INGOT_COPY_BYTES(&bits, &x, sizeof x);
        for (unsigned shift = 0; shift < 8 * sizeof bits; shift += 32)  // bound: 64
            number_ = (number_ ^ static_cast<uint32_t>(bits >> shift)) * 0x01000193u;
    }
    uint32_t number_ = 0x811c9dc5u;
};

/// The figures of a step: each is tried in as few parts as may do, those of one form together, and again in twice as many where it finds no end.
/// Reactions: ReactionView, or NoReactions, which takes no room.
template <class Reactions>
class FreeFigures : Reactions {
public:
    FreeFigures(FigureView& of_view, const EnergyMomentumView& of_scheme, Reactions of_joints, StepReport& of_step)
        : Reactions(of_joints), view_(of_view), scheme_(of_scheme), report_(of_step) {}

    void swing() {
        for (int figure_i = 0; figure_i < view_.figure_count; ++figure_i) choose(view_.figures[figure_i]);  // bound: max_joints
        for (int halvings = 0; halvings <= limits::newton_halvings_max; ++halvings) {
            try_all(halvings, false);
            try_all(halvings, true);
        }
    }

private:
    FigureView& view_;
    const EnergyMomentumView& scheme_;
    StepReport& report_;

    /// Figure::doublings of those to be tried now, by which group_figures finds them. was_seen: they are where their last step by this scheme left
    /// them.
    static int key_of(int halvings, bool was_seen) { return 2 * halvings + (was_seen ? 1 : 0); }
    static constexpr uint8_t no_key = 255;  ///< of those that have been moved, or are left to the substeps

    Reactions reactions() const { return *this; }
    FigureMemory& memory_of(const Figure& figure) const { return scheme_.of_body[view_.nodes[figure.first_node].slot]; }

    template <class Each>
    void for_bodies(const Figure& figure, const Each& each) const {
        for (int i = 0; i < figure.node_count; ++i) each(view_.nodes[figure.first_node + i]);  // bound: max_bodies
    }

    void choose(Figure& figure) {
        figure.doublings = no_key;
        if (touches(figure)) return;
        if (!is_tree(figure)) return note_figures(report_, FigureBits::left_to_substeps);
        const FigureMemory& memory = memory_of(figure);
        const bool was_seen = is_at_rest(figure.ground) && memory.seen == seen(figure);
        figure.doublings = static_cast<uint8_t>(key_of(was_seen ? memory.halvings : halvings_for_turns(figure), was_seen));
    }
    bool touches(const Figure& figure) const {
        bool some = false;
        if (scheme_.touching == nullptr) return some;
        for_bodies(figure, [&](const FigureNode& node) { some = some || has_bit(scheme_.touching, place_of(node.slot)); });
        return some;
    }
    /// All of its joints are of the tree, and of kinds that the passes know.
    bool is_tree(const Figure& figure) const {
        bool tree = true;
        for_bodies(figure, [&](const FigureNode& node) {
            tree = tree && has_rows_for(node.kind);
            view_.lists.for_ends(node.slot, [&](int end) {
                const Index other = view_.lists.partner_of(end), joint_i = static_cast<Index>(end / 2);
                tree = tree && (node.joint == joint_i || (other != no_body && view_.node_of[other] != no_node && is_of_child(other, joint_i)));
            });
        });
        return tree;
    }
    bool is_of_child(Index slot, Index joint_i) const {
        const FigureNode& node = view_.nodes[view_.node_of[slot]];
        return node.slot == slot && node.joint == joint_i;
    }
    /// Ground that moves is elsewhere in every step.
    bool is_at_rest(Index ground) const {
        if (ground == no_body) return true;
        const Place at = place_of(ground);
        const Vector v = lane_of(view_.bodies.translation[at.tile].v_CM, at.lane), L = lane_of(view_.bodies.rotation[at.tile].L, at.lane);
        return length_sq(v) + length_sq(L) == 0;
    }
    /// As many as keep the turn of each body in a part of the step within limits::newton_turn, if the most there are do.
    int halvings_for_turns(const Figure& figure) const {
        scalar most = 0;
        for_bodies(figure, [&](const FigureNode& node) { most = max(most, length_sq(omega_of(view_.bodies, node.slot))); });
        scalar turn = sqrt(most) * view_.h;
        int halvings = 0;
        // bound: limits::newton_halvings_max: each counts
        for (; halvings < limits::newton_halvings_max && turn > limits::newton_turn; ++halvings) turn = turn * scalar(0.5);
        return halvings;
    }
    uint32_t seen(const Figure& figure) const {
        MotionHash hash;
        const auto add = [&](Index slot) {
            const Place at = place_of(slot);
            const RotationTile& rotation = view_.bodies.rotation[at.tile];
            const TranslationTile& translation = view_.bodies.translation[at.tile];
            hash(lane_of(translation.r_CM, at.lane));
            hash(lane_of(translation.v_CM, at.lane));
            hash(lane_of(rotation.A, at.lane));
            hash(lane_of(rotation.L, at.lane));
        };
        for_bodies(figure, [&](const FigureNode& node) { add(node.slot); });
        if (figure.ground != no_body) add(figure.ground);
        return hash.number();
    }

    void try_all(int halvings, bool was_seen) {
        group_figures(view_, key_of(halvings, was_seen));
        for (int group_i = 0; group_i < view_.group_count; ++group_i) {  // bound: max_joints
            FigureView alone = view_;
            alone.groups = view_.groups + group_i;
            alone.group_count = 1;
            for_groups(alone, [&](const auto& rows) { try_group(alone, rows, halvings, was_seen); });
        }
    }
    template <unsigned width>
    void try_group(FigureView& alone, const FigureRows<width>& rows, int halvings, bool was_seen) {
        FigureAdvance advances[width];
        advance_figures(alone, scheme_, reactions(), was_seen, halvings, advances);
        write_impulses(rows);
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
            rows.figure(lane_i).doublings = advances[lane_i].solved ? 0 : 1;
            rows.figure(lane_i).resolved = false;  // substeps that take it begin to first order
        }
        keep_reactions(alone, NoLoops{}, reactions(), 0);
        keep_figures(alone, 0);
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) note(rows.figure(lane_i), advances[lane_i], halvings, was_seen);
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)
            if (advances[lane_i].solved) keep(rows, lane_i);
    }
    /// Joints show the impulses of a substep, whoever has moved them.
    template <unsigned width>
    void write_impulses(const FigureRows<width>& rows) const {
        const auto share = splat<typename AllLanes<width>::T>(1 / static_cast<scalar>(scheme_.substeps));
        for (int row_i = 0; row_i < rows.count(); ++row_i)  // bound: max_bodies
            write(rows.all, rows[row_i].j, read(rows.all, rows[row_i].j) * share);
    }
    void note(Figure& figure, const FigureAdvance& advance, int halvings, bool was_seen) {
        memory_of(figure).halvings = static_cast<uint8_t>(advance.solved ? advance.halvings_to_begin_with : halvings);
        const int passes = advance.passes < 255 ? advance.passes : 255;
        if (passes > report_.figure_passes) report_.figure_passes = static_cast<uint8_t>(passes);
        if (halvings > 0) note_figures(report_, FigureBits::halved);
        figure.doublings = no_key;
        if (advance.solved) return;
        if (!advance.fits) return note_figures(report_, FigureBits::left_to_substeps);
        if (halvings < limits::newton_halvings_max) {
            figure.doublings = static_cast<uint8_t>(key_of(halvings + 1, was_seen));
            return;
        }
        note_figures(report_, FigureBits::unsolved);
        count(report_.sweeps_unfinished);
    }
    template <unsigned width>
    void keep(const FigureRows<width>& rows, int lane_i) const {
        for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
            const FigureNode& node = rows.node(row_i, lane_i);
            const Place at = place_of(node.slot);
            scheme_.moved[at.tile] = static_cast<uint16_t>(scheme_.moved[at.tile] | 1u << at.lane);
            scheme_.left[at.tile] = static_cast<uint16_t>(scheme_.left[at.tile] & ~(1u << at.lane));
            scheme_.of_body[node.slot].torque = read(OneLane<width>{lane_i}, newton_row(rows, scheme_.rows, row_i).f.w);
            scheme_.of_body[node.slot].seen = 0;
        }
        memory_of(rows.figure(lane_i)).seen = seen(rows.figure(lane_i));
    }
};

}  // namespace

template <class Reactions>
void swing_freely(FigureView& view, const EnergyMomentumView& scheme, Reactions reactions, StepReport& report) {
    FreeFigures<Reactions> figures(view, scheme, reactions, report);
    figures.swing();
}

} }  // namespace ingot
