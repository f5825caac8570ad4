// SPDX-License-Identifier: MIT
// What drives the bodies of one tile at a state within a step. For driven flights only.
#pragma once

#include "force_field.h"
#include "turn.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A field, and what drives bodies beside it.
template <class Field>
struct Forcing {
    const Field& field;
    Vector gravity;  ///< m s^-2
    scalar t;        ///< s, of the begin of the step
};

/// The primary state of a tile's bodies.
struct TileState {
    Vec3<lane> r_CM, v_CM;
    Mat3<lane> A;
    Vec3<lane> L;
};

/// Rates of v_CM and L: a = (F_T + F) / M + gravity (Hecker 1997, Eq. 14), tau = tau_T + tau of the field (Eq. 16).
struct Kick {
    Vec3<lane> a, tau;
};

/// What stays the same for a tile over the step.
struct ForcedTile {
    RotationTile& rotation;
    TranslationTile* translation;  ///< null where the scene does not translate
    Vec3<lane> inv_I_body, F_T, tau_T;
    lane inv_M;
    mask movable;
    int first_slot;

    INGOT_INLINE ForcedTile(const BodyView& bodies, int tile_i)
        : rotation(bodies.rotation[tile_i]), translation(bodies.translation != nullptr ? &bodies.translation[tile_i] : nullptr),
          inv_I_body(load(rotation.inv_I_ratio) * load(rotation.inv_I_scale)), F_T{}, tau_T(load(rotation.tau_T)), inv_M{},
          movable(load(rotation.inv_I_scale) > lane{}), first_slot(tile_i * lanes) {
        if (translation == nullptr) return;
        F_T = load(translation->F_T);
        inv_M = load(translation->inv_M);
    }

    INGOT_INLINE TileState state() const {
        TileState state{{}, {}, load(rotation.A), load(rotation.L)};
        if (translation != nullptr) {
            state.r_CM = load(translation->r_CM);
            state.v_CM = load(translation->v_CM);
        }
        return state;
    }

    /// The field alone at a state and t seconds into the step, zero for what cannot move.
    template <class Field>
    INGOT_INLINE Wrench wrench_at(const TileState& at, scalar t, const Forcing<Field>& forcing) const {
        const Vec3<lane> body_J = select(movable, inv_I_body, Vec3<lane>{});
        BodyMotion body{at.r_CM, at.v_CM, at.A, {}, body_J, inv_M, forcing.t + t, first_slot};
        if constexpr (Field::depends_on_velocity) body.omega = spin_of(at.A, inv_I_body, at.L);
        const Wrench wrench = forcing.field(body);
        return {select(movable, wrench.F, Vec3<lane>{}), select(movable, wrench.tau, Vec3<lane>{})};
    }

    template <class Field>
    INGOT_INLINE Kick kick_at(const TileState& at, scalar t, const Forcing<Field>& forcing) const {
        const Wrench wrench = wrench_at(at, t, forcing);
        const Vec3<lane> g = select(movable, splat(forcing.gravity), Vec3<lane>{});
        return {(F_T + wrench.F) * inv_M + g, tau_T + wrench.tau};
    }

    /// Stores what a kick of h seconds makes of a state's velocities.
    INGOT_INLINE void store_velocities(const TileState& from, const Kick& kick, scalar h) const {
        const lane step = splat<lane>(h);
        if (translation != nullptr)
            store_if_within(limits::speed_runaway, translation->v_CM, from.v_CM + kick.a * step, translation->bad);
        const mask kicked = abs(kick.tau.x) + abs(kick.tau.y) + abs(kick.tau.z) > lane{};
        store_if_within(scalar_max, rotation.L, from.L + kick.tau * step, rotation.bad);
        rotation.kicked = static_cast<uint16_t>(rotation.kicked | bits(kicked));
    }
};

/// u where it is a turn that rodrigues() takes, else 2 rad about it.
INGOT_INLINE Vec3<lane> within_half_turn(const Vec3<lane>& u) {
    const lane angle_sq = length_sq(u), most = splat<lane>(2);
    const mask wide = angle_sq > most * most;
    return u * select(wide, most / sqrt(select(wide, angle_sq, splat<lane>(1))), splat<lane>(1));
}

/// Where a state will be t seconds ahead, to first order. For the middle of a step.
INGOT_INLINE TileState predicted(const TileState& from, const Kick& kick, const Vec3<lane>& inv_I_body, scalar t) {
    const lane step = splat<lane>(t);
    const Vec3<lane> angle = within_half_turn(spin_of(from.A, inv_I_body, from.L) * step);
    return {from.r_CM + from.v_CM * step, from.v_CM + kick.a * step, from.A + world_turn(from.A, rodrigues(angle)),
            from.L + kick.tau * step};
}

} }  // namespace ingot

#pragma GCC diagnostic pop
