// SPDX-License-Identifier: MIT
// Locks of the bodies of a sub-world, see body/axis_locks.h: as a step holds them, for a while of it. Empty in scenes without.
#pragma once

#include "../body/axis_locks.h"
#include "../body/kinematics.h"
#include "continuous_collision.h"

namespace ingot { inline namespace INGOT_ABI {

template <class Collision>
class LockedPair {
public:
    static constexpr bool locks_axes = Collision::SceneTraits::View::locks_axes;

    /// Where they are now is where they are held.
    explicit LockedPair(PairRoom<Collision>& room) : room_(room) {
        if constexpr (locks_axes)
            for (int which = 0; which < room.two.count; ++which) before_[which] = room.two.state(which);  // bound: PairSubWorld::movers_max
    }
    /// After refresh_inv_I_world.
    void restrict_inertia() const {
        over_locked([this](int which, unsigned locks) {
            const Place at = place_of(which);
            set_lane(room_.two.translation[at.tile].inv_I_world, at.lane,
                     locked_inertia_of(room_.two.bodies(), which, locks).inverse_world(room_.two.state(which).A));
        });
    }
    void hold_motions() const {
        over_locked([this](int which, unsigned locks) { hold_motion(room_.two.bodies(), which, locks); });
    }
    /// What the scene's rotation has done in h seconds is done anew.
    void turn(scalar h) const {
        over_locked([this, h](int which, unsigned locks) {
            if (rotations_locked(locks) == 0) return;
            const Place at = place_of(which);
            RotationTile& tile = room_.two.rotation[at.tile];
            const Vector L_mean = lane_of(tile.L, at.lane) - lane_of(tile.tau_T, at.lane) * (h / 2);
            const Matrix A = turned_with_locks(before_[which].A, locked_inertia_of(room_.two.bodies(), which, locks), L_mean, h);
            if (!is_finite(A)) return mark_lane_bad(tile.bad, at.lane);
            set_lane(tile.A, at.lane, A);
            set_lane(room_.two.compensation[at.tile].A_low, at.lane, Matrix{});
        });
    }
    /// Once they are where they go.
    void hold_places() const {
        over_locked([this](int which, unsigned locks) {
            const Place at = place_of(which);
            RotationTile& rotation = room_.two.rotation[at.tile];
            TranslationTile& translation = room_.two.translation[at.tile];
            if (rotations_locked(locks) != 0)
                set_lane(rotation.A, at.lane, hold_attitude(before_[which].A, lane_of(rotation.A, at.lane), rotations_locked(locks)));
            set_lane(translation.r_CM, at.lane, free_part_or(lane_of(translation.r_CM, at.lane), before_[which].r_CM, translations_locked(locks)));
            hold_motion(room_.two.bodies(), which, locks);
        });
    }

private:
    template <class Each>
    void over_locked([[maybe_unused]] const Each& each) const {
        if constexpr (locks_axes)
            for (int which = 0; which < room_.two.count; ++which)  // bound: PairSubWorld::movers_max
                if (room_.contacts.locks[which] != 0) each(which, static_cast<unsigned>(room_.contacts.locks[which]));
    }

    PairRoom<Collision>& room_;
    FlightState before_[locks_axes ? 2 : 1];
};

} }  // namespace ingot
