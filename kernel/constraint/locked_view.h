// SPDX-License-Identifier: MIT
// What the solver works on in scenes whose bodies may have locks, see body/axis_locks.h.
//
// Locks on turning are in inv_I_world of the tiles: no row knows more of them. Along locked axes the inverse mass of a body is 0, so it is three
// numbers here and not one: in what a row is prepared from, and where impulses and pushes are given. A body that never moves along an axis needs
// none where rows are read. Bodies without locks get the same bits as without this view.
#pragma once

#include "material_view.h"
#include "visit.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// One for all such scenes, for what is compiled for it is compiled in every kernel: surfaces that roll freely and stand still are materials of it.
struct LockedView : RollingBeltView {
    static constexpr bool locks_axes = true;
    const uint8_t* locks;  ///< by slot: AxisLocks
    bool surfaces_move;    ///< the scene has belts
};

/// The view for stages to which locks are nothing: those that give no impulse and no push.
template <class View>
INGOT_INLINE const If<View::locks_axes, RollingBeltView, View>& without_locks(const View& solver) {
    return solver;
}
/// And for those to which nothing else matters.
template <class View>
INGOT_INLINE If<View::locks_axes, LockedView, SolverView>& with_locks(View& solver) {
    return solver;
}
/// Whether contacts may give energy, as belts do.
template <class View>
INGOT_INLINE bool gives_energy([[maybe_unused]] const View& solver) {
    if constexpr (View::locks_axes)
        return solver.surfaces_move;
    else
        return View::has_belts;
}

/// Bodies that stand for kinematic ones have none, and no mass.
INGOT_INLINE unsigned locks_of(const LockedView& solver, Index body_i) {
    return body_i != 0 && body_i < solver.body_count ? solver.locks[solver.slot_of[body_i]] : 0u;
}

/// 1/M along each axis of one body of each lane.
INGOT_INLINE Vec3<lane> inverse_masses(const LockedView& solver, const Index (&bodies)[lanes], lane inv_M) {
    scalar free[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const unsigned locks = locks_of(solver, bodies[lane_i]);
        for (int axis = 0; axis < 3; ++axis) free[axis][lane_i] = (locks >> axis & 1u) != 0 ? scalar(0) : scalar(1);
    }
    return load(free) * inv_M;
}

/// As ResponseOf, where an impulse moves a body along free axes alone.
struct LockedResponse : Response {
    Vec3<lane> inv_M_of_axes;  ///< of both bodies
    mask some_locked;

    INGOT_INLINE lane compliance(const Levers& row, const Vec3<lane>& d, const Levers& other, const Vec3<lane>& d_other, lane linear) const {
        const lane held = select(some_locked, dot(scaled(inv_M_of_axes, d), d_other), linear);
        const lane K = Response::compliance(row, d, other, d_other, held);
        return &row == &other ? max(K, least()) : K;
    }
    INGOT_INLINE lane turn_compliance(const Vec3<lane>& k_A, const Vec3<lane>& k_B, const Vec3<lane>& axis, const Vec3<lane>& other) const {
        const lane K = Response::turn_compliance(k_A, k_B, axis, other);
        return select(some_locked, max(K, splat<lane>(limits::held_compliance) * (A.turning_compliances() + B.turning_compliances())), K);
    }
    /// Lanes of bodies that cannot part along d at P, by what is locked: there is nothing to solve.
    INGOT_INLINE mask held_fast(const Vec3<lane>& P, const Vec3<lane>& d) const {
        const Vec3<lane> J_A = A.lever_of(P, d), J_B = B.opposite_lever_of(P, d);
        const lane turning = select(A.moves, A.turning_compliance(J_A), lane{}) + select(B.moves, B.turning_compliance(J_B), lane{});
        return both(some_locked, dot(scaled(inv_M_of_axes, d), d) + turning < least());
    }

private:
    /// Where locks leave a point no way to go there are roundings in the place of its compliance: it counts as so compliant at least.
    INGOT_INLINE lane least() const { return select(some_locked, splat<lane>(limits::held_compliance) * inv_M, lane{}); }
};
using LockedLaneContacts = LaneContactsOf<LockedResponse>;

/// What rows of free bodies are prepared from.
template <class View>
using LaneContactsOfView = If<View::locks_axes, LockedLaneContacts, LaneContacts>;

/// Fills in what is locked. Manifolds of which no point can part have no points.
INGOT_INLINE void see_locks(const SolverView&, const ContactBlock&, const LaneContacts&) {}
INGOT_INLINE void see_locks(const LockedView& solver, const ContactBlock& block, LockedLaneContacts& contacts) {
    LockedResponse& response = contacts.response;
    scalar locked[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        locked[lane_i] = static_cast<scalar>(locks_of(solver, block.body_A[lane_i]) | locks_of(solver, block.body_B[lane_i]));
    response.some_locked = load(locked) > lane{};
    response.inv_M_of_axes =
        inverse_masses(solver, block.body_A, response.A.inv_M) + inverse_masses(solver, block.body_B, response.B.inv_M);
    const lane none{}, one = splat<lane>(1);
    mask held = response.some_locked;
    for (int row = 0; row < block.rows; ++row)  // bound: 4: block_rows
        held = both(held, either(opposite(contacts.used[row] > none), response.held_fast(contacts.P[row], contacts.n)));
    const lane left = select(held, none, one);
    for (int row = 0; row < block.rows; ++row) contacts.used[row] = contacts.used[row] * left;
}

/// The two bodies of each lane, in a visit of which one may have locks.
struct LockedPairLanes : BodyPairLanes {
    Vec3<lane> inv_M_A, inv_M_B;
};
INGOT_INLINE void add_linear(LockedPairLanes& pair, const Vec3<lane>& impulse, lane, lane) {
    pair.linear_A += scaled(impulse, pair.inv_M_A);
    pair.linear_B -= scaled(impulse, pair.inv_M_B);
}

/// As impulses and pushes are given to them.
template <class View>
INGOT_INLINE auto held_pair([[maybe_unused]] const View& solver, [[maybe_unused]] const ContactBlock& block, const BodyPairLanes& pair) {
    if constexpr (View::locks_axes)
        return LockedPairLanes{pair, inverse_masses(solver, block.body_A, load(block.inv_M_A)),
                               inverse_masses(solver, block.body_B, load(block.inv_M_B))};
    else
        return pair;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
