// SPDX-License-Identifier: MIT
#pragma once

#include "../shape/surface.h"
#include "../island/rest_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a scene calls slow: see Scene::sleep_speed and Scene::sleep_time.
struct SleepLimits {
    scalar speed;  ///< m/s
    scalar time;   ///< s
};

/// Lets islands fall asleep all of whose bodies have been at rest for long enough: v_CM = L = 0, and A and r_CM as they are. Immovable bodies come to
/// rest.
///
/// A body is at rest while no point of it moves faster than the limit, and nothing but limits::balance of gravity is left to accelerate it: a body
/// at the top of its flight, at the end of a swing, or that begins to slide is slow for as long as gravity is weak, and not at rest.
/// In a force field, pull_sq says by slot what takes the place of gravity, see note_pulls. Where there is neither, nothing presses bodies
/// together: there only a body whose v_CM and L are zero is at rest.
///
/// Needs:  F_T as write_contact_motion leaves it, the mean force of the step; islands of the step.
/// Error:  what sleeps loses at most M speed^2 of energy, half for v_CM and half for L, since no moment is larger than M R^2.
/// Cost:   about 60 flops a body that is awake.
void fall_asleep(const BodyView& bodies, const SurfaceView& surfaces, const Vector& gravity, scalar h, const SleepLimits& limits,
                 const RestView& rest, const scalar* pull_sq = nullptr);

/// In a force field: how strongly gravity and forces pull at the bodies that are awake, |gravity| + |F_T| / M, in m s^-2, squared, by slot. What
/// balances them is measured by that, as what balances gravity is where there is no field. Needs: F_T before contacts are solved.
void note_pulls(const BodyView& bodies, const RestView& rest, const Vector& gravity, scalar* pull_sq);

} }  // namespace ingot
