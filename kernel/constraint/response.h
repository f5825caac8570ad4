// SPDX-License-Identifier: MIT
// What a unit impulse does to a body: the one question that constraints ask of bodies as they are prepared.
#pragma once

#include "../body/body_tiles.h"
#include "rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A free body answers by itself: a unit impulse along d at P changes v_CM by inv_M d and, with J = r x d, its spin by
///
///     k = I^-1 J                                       (Hecker 1997, Eqs. 17 and 20: L changes by J, and omega = I^-1 L)
///
/// T: lane in the blocks of the sweeps, wide_scalar in the direct solver, scalar in the sequential one.
/// A body that hangs on others by joints will answer with the inverse inertia of its figure as felt at it, and with parts that couple linear
/// and angular; then sums of compliance ask it for those as well.
template <class T>
struct FreeBodyOf {
    Vec3<T> r_CM;         ///< m
    T inv_M;              ///< kg^-1; 0: cannot move
    Sym3<T> inv_I_world;  ///< kg^-1 m^-2

    /// J: kg m^2/s that a unit impulse along d at P gives.
    INGOT_INLINE Vec3<T> lever_of(const Vec3<T>& P, const Vec3<T>& d) const { return cross(P - r_CM, d); }
    /// Of the body that gets the opposite impulse.
    INGOT_INLINE Vec3<T> opposite_lever_of(const Vec3<T>& P, const Vec3<T>& d) const { return cross(d, P - r_CM); }
    /// k: rad/s that an impulse with this J gives.
    INGOT_INLINE Vec3<T> spin_of(const Vec3<T>& J) const { return inv_I_world * J; }
    /// m/s that an impulse gives the centre of mass.
    INGOT_INLINE Vec3<T> velocity_of(const Vec3<T>& impulse) const { return impulse * inv_M; }
    /// The part of a row's compliance that turning has: J . k.
    INGOT_INLINE T turning_compliance(const Vec3<T>& J) const { return dot(J, spin_of(J)); }
    /// Of rows that only turn, the sum over three directions across each other.
    INGOT_INLINE T turning_compliances() const { return inv_I_world.xx + inv_I_world.yy + inv_I_world.zz; }
};

/// The bodies of `lanes` constraints; what cannot move is all 0.
struct FreeBody : FreeBodyOf<lane> {
    mask moves;
};

/// Of the two bodies of a constraint.
template <class Body>
struct ResponseOf {
    Body A, B;
    lane inv_M;  ///< of both

    /// A row along d at P; no lever on what cannot move, or where there is no point.
    INGOT_SHARED void prepare_levers(Levers& levers, const Vec3<lane>& P, const Vec3<lane>& d, mask there) const {
        prepare_lever(levers.J_A, levers.k_A, A, A.lever_of(P, d), there);
        prepare_lever(levers.J_B, levers.k_B, B, B.opposite_lever_of(P, d), there);
    }
    /// A row that only turns about an axis: k of A and B. B gets the opposite.
    INGOT_INLINE Vec3<lane> spin_of_A(const Vec3<lane>& axis) const { return select(A.moves, A.spin_of(axis), Vec3<lane>{}); }
    INGOT_INLINE Vec3<lane> spin_of_B(const Vec3<lane>& axis) const { return select(B.moves, B.spin_of(-axis), Vec3<lane>{}); }

    /// The speed along the one row that a unit impulse along the other gives. linear: inv_M times the cosine between their directions, which bodies
    /// with joints ask for themselves: see jointed_response.h.
    static INGOT_INLINE lane compliance(const Levers& row, const Vec3<lane>&, const Levers& other, const Vec3<lane>&, lane linear) {
        return linear + dot(load(row.k_A), load(other.J_A)) + dot(load(row.k_B), load(other.J_B));
    }
    /// The same of rows that only turn; k of the one. A row with itself, and two rows.
    static INGOT_INLINE lane turn_compliance(const Vec3<lane>& k_A, const Vec3<lane>& k_B, const Vec3<lane>&, const Vec3<lane>& other) {
        return dot(k_A, other) - dot(k_B, other);
    }
    static INGOT_INLINE lane turn_coupling(const Vec3<lane>& k_A, const Vec3<lane>& k_B, const Vec3<lane>& axis, const Vec3<lane>& other) {
        return turn_compliance(k_A, k_B, axis, other);
    }

private:
    static INGOT_INLINE void prepare_lever(LaneRow (&to_J)[3], LaneRow (&to_k)[3], const Body& body, const Vec3<lane>& lever, mask there) {
        const Vec3<lane> J = select(both(there, body.moves), lever, Vec3<lane>{});
        store(to_J, J);
        store(to_k, body.spin_of(J));
    }
};
using Response = ResponseOf<FreeBody>;
// There once, as prepare_blocks.cpp has it: the linker would else take that of any file, and some are compiled for size.
extern template void ResponseOf<FreeBody>::prepare_levers(Levers&, const Vec3<lane>&, const Vec3<lane>&, mask) const;

/// Numbers that are collected lane by lane, before vectors work on them.
struct CollectedBodies {
    scalar r_CM[3][lanes], inv_I_world[6][lanes], inv_M[lanes];

    void put(int lane_i, const BodyView& bodies, int slot) {
        const Place at = place_of(slot);
        set_lane(r_CM, lane_i, lane_of(bodies.translation[at.tile].r_CM, at.lane));
        set_lane(inv_I_world, lane_i, lane_of(bodies.translation[at.tile].inv_I_world, at.lane));
        inv_M[lane_i] = bodies.translation[at.tile].inv_M[at.lane];
    }
    FreeBody loaded() const {
        const lane inverse_mass = load(inv_M);
        return {{load(r_CM), inverse_mass, load(inv_I_world)}, inverse_mass > lane{}};
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
