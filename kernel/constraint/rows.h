// SPDX-License-Identifier: MIT
// Rows of two bodies, `lanes` at once: how they are read, how they are applied, and how they are shown to code that does not know their kind.
//
// A row says how fast A and B move against each other in one direction. With J, what a unit impulse along it does to angular momentum, and
// k, what that does to the spin (response.h), symmetric inertia gives n.(omega x r) = L.k:
//
//     speed         u = d . (v_A - v_B) + L_A . k_A + L_B . k_B
//     impulse j     v_A += d j / M_A ;  v_B -= d j / M_B ;  L += J j            (velocities)
//     displacement  s = d . (dp_A - dp_B) + dth_A . J_A + dth_B . J_B
//     push q        dp_A += d q / M_A ; dp_B -= d q / M_B ; dth += k q          (positions, the mirror image)
//     compliance    K = (1/M_A + 1/M_B) d.d' + k_A . J'_A + k_B . J'_B          speed along the one row that a unit impulse along the other gives
//
// d: direction, a unit vector, or 0 of a row that only turns; J = (r_AP x d, -(r_BP x d)), or (d, -d) of one that only turns.
// Source: Hecker 1997, Fig. 4, with L in the place of omega.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/vec3.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int block_rows = 4;  ///< normals of a manifold

/// Where a row takes hold of the two bodies. B gets the opposite impulse: its levers carry the minus sign, J_B = -(r_BP x n).
struct Levers {
    LaneRow J_A[3], J_B[3];  ///< m
    LaneRow k_A[3], k_B[3];  ///< inv_I_world J
};

/// The two bodies of each lane while a block is visited: v_CM and L of the velocity sweep, dp and dth of its mirror image.
/// `last` keeps the fourth numbers of their quads.
struct BodyPairLanes {
    Vec3<lane> linear_A, angular_A, linear_B, angular_B;
    lane last[4];
};

/// Speed along a row: direction . (v_A - v_B) + L_A.k_A + L_B.k_B.
INGOT_INLINE lane row_speed(const Levers& row, lane linear_speed, const BodyPairLanes& pair) {
    return linear_speed + dot(pair.angular_A, load(row.k_A)) + dot(pair.angular_B, load(row.k_B));
}
/// Displacement along a row: direction . (dp_A - dp_B) + dth_A.J_A + dth_B.J_B.
INGOT_INLINE lane row_displacement(const Levers& row, lane linear_displacement, const BodyPairLanes& pair) {
    return linear_displacement + dot(pair.angular_A, load(row.J_A)) + dot(pair.angular_B, load(row.J_B));
}

/// A pair has what it gets at once; one with joints, when a part of a contact is through: see jointed_response.h.
INGOT_INLINE void settle(BodyPairLanes&) {}

INGOT_INLINE void add_linear(BodyPairLanes& pair, const Vec3<lane>& impulse, lane inv_M_A, lane inv_M_B) {
    pair.linear_A += impulse * inv_M_A;
    pair.linear_B -= impulse * inv_M_B;
}
/// An impulse j along a row changes angular momenta by J j.
INGOT_INLINE void add_angular(BodyPairLanes& pair, const Levers& row, lane j) {
    pair.angular_A += load(row.J_A) * j;
    pair.angular_B += load(row.J_B) * j;
}
/// A push q along a row turns bodies by k q.
INGOT_INLINE void turn_by_push(BodyPairLanes& pair, const Levers& row, lane q) {
    pair.angular_A += load(row.k_A) * q;
    pair.angular_B += load(row.k_B) * q;
}
/// An angular impulse about n; what cannot move takes none.
INGOT_INLINE void add_torsion(BodyPairLanes& pair, const Vec3<lane>& n, lane torsion, lane inv_M_A, lane inv_M_B) {
    pair.angular_A += n * select(inv_M_A > lane{}, torsion, lane{});
    pair.angular_B -= n * select(inv_M_B > lane{}, torsion, lane{});
}

/// Stores where active; `whole`: everywhere.
template <bool whole>
INGOT_INLINE void store_if(LaneRow& to, mask active, lane value) {
    store(to, whole ? value : select(active, value, load(to)));
}

/// What a visit changes: impulses squared times compliance, and the largest speed, of each lane.
struct Change {
    lane size, fastest;  ///< J, m/s

    INGOT_INLINE void add(lane d, lane K) {
        const lane speed = d * K;
        size = size + d * speed;
        fastest = max(fastest, abs(speed));
    }
};

/// A row of a block without its kind: conjugate directions, impacts and the direct solver work on these.
struct SeenRow {
    int number;             ///< of the constraint's rows: see contact.h
    const LaneRow (&d)[3];  ///< direction; or axis, where it only turns
    const Levers* levers;   ///< null: it only turns, J_A = d and J_B = -d, on what can move
    const LaneRow (&k_A)[3];
    const LaneRow (&k_B)[3];
    LaneRow& j;          ///< N s, or N m s
    LaneRow& j_sweep;    ///< before the sweep
    LaneRow& direction;  ///< of conjugate gradients so far
};

/// What a push along a seen row does to displacements.
template <class Pair>
INGOT_INLINE void push_along(Pair& displaced, const SeenRow& row, lane q, lane inv_M_A, lane inv_M_B) {
    if (row.levers != nullptr) add_linear(displaced, load(row.d) * q, inv_M_A, inv_M_B);
    displaced.angular_A += load(row.k_A) * q;
    displaced.angular_B += load(row.k_B) * q;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
