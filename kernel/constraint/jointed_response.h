// SPDX-License-Identifier: MIT
// What two bodies answer to the rows of a contact, where one of them or both have joints.
#pragma once

#include "jointed_view.h"
#include "visit.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A change of velocity and spin.
struct LaneTwist {
    Vec3<lane> v, w;
};
/// A force and a moment about the centre of mass, times time.
struct LaneWrench {
    Vec3<lane> F, T;
};

INGOT_INLINE LaneTwist answer_of(const SideResponse& side, const LaneWrench& f) {
    const Mat3<lane> wv = load(side.wv);
    return {load(side.vv) * f.F + transpose_times(wv, f.T), wv * f.F + load(side.ww) * f.T};
}
/// Of A to what acts on B.
INGOT_INLINE LaneTwist answer_across(const JointedBlock& block, const LaneWrench& on_B) {
    return {load(block.vv) * on_B.F + load(block.vw) * on_B.T, load(block.wv) * on_B.F + load(block.ww) * on_B.T};
}
/// Of B to what acts on A: the answer is symmetric.
INGOT_INLINE LaneTwist answer_back(const JointedBlock& block, const LaneWrench& on_A) {
    return {transpose_times(load(block.vv), on_A.F) + transpose_times(load(block.wv), on_A.T),
            transpose_times(load(block.vw), on_A.F) + transpose_times(load(block.ww), on_A.T)};
}

/// As ResponseOf, with sums of compliance through the figures.
///
/// Joints may leave a point no way to go along a row, and sums of roundings in the place of its compliance. So a row counts as compliant by a share
/// of what its bodies would answer without joints, at least: SideResponse::joined.
struct JointedResponse : Response {
    const JointedBlock* block;

    INGOT_INLINE lane compliance(const Levers& row, const Vec3<lane>& d, const Levers& other, const Vec3<lane>& d_other, lane linear) const {
        const lane K = compliance_of({d, load(row.J_A)}, {-d, load(row.J_B)}, {d_other, load(other.J_A)}, {-d_other, load(other.J_B)});
        return &row == &other ? max(K, rounding() * Response::compliance(row, d, other, d_other, linear)) : K;
    }
    INGOT_INLINE lane turn_compliance(const Vec3<lane>& k_A, const Vec3<lane>& k_B, const Vec3<lane>& axis, const Vec3<lane>& other) const {
        return max(turn_coupling(k_A, k_B, axis, other), rounding() * Response::turn_compliance(k_A, k_B, axis, other));
    }
    INGOT_INLINE lane turn_coupling(const Vec3<lane>&, const Vec3<lane>&, const Vec3<lane>& axis, const Vec3<lane>& other) const {
        const Vec3<lane> none{};
        return compliance_of({none, axis}, {none, -axis}, {none, other}, {none, -other});
    }
    /// Lanes of bodies whose joints let them not part along d at P: there is nothing to solve.
    INGOT_INLINE mask held_fast(const Vec3<lane>& P, const Vec3<lane>& d) const {
        const LaneWrench on_A = {d, cross(P - A.r_CM, d)}, on_B = {-d, cross(d, P - B.r_CM)};
        const lane free = inv_M + dot(A.spin_of(on_A.T), on_A.T) + dot(B.spin_of(on_B.T), on_B.T);
        return compliance_of(on_A, on_B, on_A, on_B) < rounding() * free;
    }

private:
    INGOT_INLINE lane rounding() const { return max(load(block->A.joined), load(block->B.joined)); }
    INGOT_INLINE lane compliance_of(const LaneWrench& on_A, const LaneWrench& on_B, const LaneWrench& other_A, const LaneWrench& other_B) const {
        LaneTwist of_A = answer_of(block->A, other_A), of_B = answer_of(block->B, other_B);
        if (block->some_across) {
            const LaneTwist across = answer_across(*block, other_B), back = answer_back(*block, other_A);
            of_A = {of_A.v + across.v, of_A.w + across.w};
            of_B = {of_B.v + back.v, of_B.w + back.w};
        }
        return dot(on_A.F, of_A.v) + dot(on_A.T, of_A.w) + dot(on_B.F, of_B.v) + dot(on_B.T, of_B.w);
    }
};

using JointedLaneContacts = LaneContactsOf<JointedResponse>;

/// As BodyPairLanes, in a visit of which a body has joints: impulses are collected, and given to the bodies when a part of the contact is through.
struct JointedPairLanes : BodyPairLanes {
    const JointedBlock& block;
    LaneWrench due_A, due_B;  ///< not given yet
    LaneWrench sum_A, sum_B;  ///< of the visit

    JointedPairLanes(const BodyPairLanes& pair, const JointedBlock& of) : BodyPairLanes(pair), block(of), due_A{}, due_B{}, sum_A{}, sum_B{} {}
};
INGOT_INLINE void add_linear(JointedPairLanes& pair, const Vec3<lane>& impulse, lane, lane) {
    pair.due_A.F += impulse;
    pair.due_B.F -= impulse;
}
INGOT_INLINE void add_angular(JointedPairLanes& pair, const Levers& row, lane j) {
    pair.due_A.T += load(row.J_A) * j;
    pair.due_B.T += load(row.J_B) * j;
}
/// Pushes act as impulses do.
INGOT_INLINE void turn_by_push(JointedPairLanes& pair, const Levers& row, lane q) { add_angular(pair, row, q); }
INGOT_INLINE void add_torsion(JointedPairLanes& pair, const Vec3<lane>& n, lane torsion, lane, lane) {
    pair.due_A.T += n * torsion;
    pair.due_B.T -= n * torsion;
}

/// Changes of both bodies by what is due.
struct PairAnswer {
    LaneTwist A, B;
};
INGOT_INLINE PairAnswer take_due(JointedPairLanes& pair) {
    PairAnswer answer = {answer_of(pair.block.A, pair.due_A), answer_of(pair.block.B, pair.due_B)};
    if (pair.block.some_across) {
        const LaneTwist across = answer_across(pair.block, pair.due_B), back = answer_back(pair.block, pair.due_A);
        answer.A = {answer.A.v + across.v, answer.A.w + across.w};
        answer.B = {answer.B.v + back.v, answer.B.w + back.w};
    }
    return answer;
}
INGOT_INLINE void note_due(JointedPairLanes& pair) {
    const Vec3<lane> none{};
    pair.sum_A = {pair.sum_A.F + pair.due_A.F, pair.sum_A.T + pair.due_A.T};
    pair.sum_B = {pair.sum_B.F + pair.due_B.F, pair.sum_B.T + pair.due_B.T};
    pair.due_A = pair.due_B = {none, none};
}
/// Velocities v_CM and L of the two. A free body keeps what it gets to the bit.
INGOT_INLINE void settle(JointedPairLanes& pair) {
    const PairAnswer answer = take_due(pair);
    const auto change_of_L = [](const SideResponse& side, const LaneTwist& twist, const LaneWrench& f) {
        return select(load(side.joined) > lane{}, load(side.I) * twist.w, f.T);
    };
    pair.linear_A += answer.A.v;
    pair.linear_B += answer.B.v;
    pair.angular_A += change_of_L(pair.block.A, answer.A, pair.due_A);
    pair.angular_B += change_of_L(pair.block.B, answer.B, pair.due_B);
    note_due(pair);
}
/// Displacements dp and dth of the two.
INGOT_INLINE void settle_push(JointedPairLanes& pair) {
    const PairAnswer answer = take_due(pair);
    pair.linear_A += answer.A.v;
    pair.linear_B += answer.B.v;
    pair.angular_A += answer.A.w;
    pair.angular_B += answer.B.w;
    note_due(pair);
}
/// The same only for bodies without joints: figures get theirs in another way.
INGOT_INLINE void settle_free(JointedPairLanes& pair, lane inv_M_A, lane inv_M_B) {
    const Vec3<lane> none{};
    const mask free_A = both(inv_M_A > lane{}, opposite(load(pair.block.A.joined) > lane{}));
    const mask free_B = both(inv_M_B > lane{}, opposite(load(pair.block.B.joined) > lane{}));
    pair.linear_A += select(free_A, pair.due_A.F * inv_M_A, none);
    pair.linear_B += select(free_B, pair.due_B.F * inv_M_B, none);
    pair.angular_A += select(free_A, pair.due_A.T, none);
    pair.angular_B += select(free_B, pair.due_B.T, none);
    note_due(pair);
}
} }  // namespace ingot

#pragma GCC diagnostic pop
