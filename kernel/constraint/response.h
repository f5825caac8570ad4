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
/// A body that hangs on others by joints will answer with the inverse inertia of its figure as felt at it, and with parts that couple linear
/// and angular; then sums of compliance ask it for those as well.
struct FreeBody {
    Vec3<lane> r_CM;
    Sym3<lane> inv_I_world;  ///< kg^-1 m^-2
    lane inv_M;              ///< kg^-1; 0: cannot move, and all of it is 0
    mask moves;

    /// rad/s that a unit impulse with this J gives.
    INGOT_INLINE Vec3<lane> spin_of(const Vec3<lane>& J) const { return inv_I_world * J; }
};

/// Of the two bodies of a constraint.
template <class Body>
struct ResponseOf {
    Body A, B;
    lane inv_M;  ///< of both

    /// A row along d at P; no lever on what cannot move, or where there is no point.
    INGOT_SHARED void prepare_levers(Levers& levers, const Vec3<lane>& P, const Vec3<lane>& d, mask there) const {
        prepare_lever(levers.J_A, levers.k_A, A, cross(P - A.r_CM, d), there);
        prepare_lever(levers.J_B, levers.k_B, B, cross(d, P - B.r_CM), there);
    }
    /// A row that only turns about an axis: k of A and B. B gets the opposite.
    INGOT_INLINE Vec3<lane> spin_of_A(const Vec3<lane>& axis) const { return select(A.moves, A.spin_of(axis), Vec3<lane>{}); }
    INGOT_INLINE Vec3<lane> spin_of_B(const Vec3<lane>& axis) const { return select(B.moves, B.spin_of(-axis), Vec3<lane>{}); }

    /// The speed along the one row that a unit impulse along the other gives. linear: inv_M times the cosine between them.
    static INGOT_INLINE lane compliance(const Levers& row, const Levers& other, lane linear) {
        return linear + dot(load(row.k_A), load(other.J_A)) + dot(load(row.k_B), load(other.J_B));
    }

private:
    static INGOT_INLINE void prepare_lever(scalar (&to_J)[3][lanes], scalar (&to_k)[3][lanes], const Body& body, const Vec3<lane>& lever,
                                           mask there) {
        const Vec3<lane> J = select(both(there, body.moves), lever, Vec3<lane>{});
        store(to_J, J);
        store(to_k, body.spin_of(J));
    }
};
using Response = ResponseOf<FreeBody>;

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
        return {load(r_CM),
                {load(inv_I_world[0]), load(inv_I_world[1]), load(inv_I_world[2]), load(inv_I_world[3]), load(inv_I_world[4]), load(inv_I_world[5])},
                inverse_mass,
                inverse_mass > lane{}};
    }
};

} }  // namespace ingot

#pragma GCC diagnostic pop
