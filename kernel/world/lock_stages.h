// SPDX-License-Identifier: MIT
// The adaptors of stages.h and schemes.h that are of bodies with locks: empty in scenes without.
#pragma once

#include "../body/kinematics.h"
#include "step_context.h"

namespace ingot { inline namespace INGOT_ABI {

/// In the tiles, after refresh_inv_I_world.
template <class S>
INGOT_INLINE void restrict_inertia([[maybe_unused]] Step<S>& now) {
    if constexpr (S::axis_locks)
        features::LockedAxes::for_locked(now.storage, [&now](int slot, unsigned locks) {
            const Place at = place_of(slot);
            const Matrix A = lane_of(now.bodies.rotation[at.tile].A, at.lane);
            set_lane(now.bodies.translation[at.tile].inv_I_world, at.lane, locked_inertia_of(now.bodies, slot, locks).inverse_world(A));
        });
}

/// Bodies whose turns are locked are at rest to the scene's rotation: what it would do with them is not reported.
template <class S>
INGOT_INLINE void stop_locked_turns([[maybe_unused]] Step<S>& now) {
    if constexpr (S::axis_locks)
        features::LockedAxes::for_held(now.storage, [&now](int slot, unsigned locks, features::HeldPlace& held) {
            if (rotations_locked(locks) == 0) return;
            const int lane_i = place_of(slot).lane;
            RotationTile& tile = now.bodies.rotation[place_of(slot).tile];
            held.L = lane_of(tile.L, lane_i);
            held.L_mean = held.L - lane_of(tile.tau_T, lane_i) * (now.h / 2);
            set_lane(tile.L, lane_i, Vector{});
            set_lane(tile.tau_T, lane_i, Vector{});
        });
}

/// In its place: from where they were, by the mean of L over the step.
template <class S>
INGOT_INLINE void turn_with_locks([[maybe_unused]] Step<S>& now) {
    if constexpr (S::axis_locks)
        features::LockedAxes::for_held(now.storage, [&now](int slot, unsigned locks, const features::HeldPlace& held) {
            if (rotations_locked(locks) == 0) return;
            const Place at = place_of(slot);
            RotationTile& tile = now.bodies.rotation[at.tile];
            const LockedInertia inertia = locked_inertia_of(now.bodies, slot, locks);
            const Matrix A = turned_with_locks(held.A, inertia, held.L_mean, now.h);
            set_lane(tile.L, at.lane, held.L);
            if (now.bodies.compensation != nullptr) set_lane(now.bodies.compensation[at.tile].A_low, at.lane, Matrix{});
            if (now.bodies.energy != nullptr) now.bodies.energy[at.tile].E_0[at.lane] = 0;
            if (!is_finite(A) || !is_within_runaway(inertia.spin(A, held.L))) return mark_lane_bad(tile.bad, at.lane);
            set_lane(tile.A, at.lane, A);
        });
}

/// Coordinates that are locked have their bits, and what moves along locked axes is gone.
template <class S>
void hold_locks([[maybe_unused]] Step<S>& now) {
    if constexpr (S::axis_locks)
        features::LockedAxes::for_locked(now.storage, [&now](int slot, unsigned locks) {
            const Place at = place_of(slot);
            const features::HeldPlace& held = now.storage.held_places[slot];
            if (held.of_step != now.storage.steps + 1) return hold_motion(now.bodies, slot, locks);  // it was woken in this step
            if (rotations_locked(locks) != 0) {
                RotationTile& tile = now.bodies.rotation[at.tile];
                set_lane(tile.A, at.lane, hold_attitude(held.A, lane_of(tile.A, at.lane), rotations_locked(locks)));
            }
            if constexpr (S::translates) {
                TranslationTile& tile = now.bodies.translation[at.tile];
                set_lane(tile.r_CM, at.lane, free_part_or(lane_of(tile.r_CM, at.lane), held.r_CM, translations_locked(locks)));
            }
            hold_motion(now.bodies, slot, locks);
        });
}

} }  // namespace ingot
