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

/// An island falls asleep when all of its bodies have been at rest for long enough: v_CM = L = 0, and A and r_CM stay as they are. Immovable bodies
/// come to rest.
///
/// A body is at rest while no point of it moves faster than the limit, and no more than limits::balance of gravity accelerates it. Speed alone would
/// not do: under weak gravity a body is slow for long at the top of its flight, at the end of a swing, or when it begins to slide.
/// In a force field pull_sq stands for gravity, by slot: see note_pulls. Without gravity and field nothing presses bodies together: only a body whose
/// v_CM and L are zero is at rest there.
///
/// Needs:  F_T as write_contact_motion leaves it, the mean force of the step; islands of the step.
/// Error:  what sleeps loses at most M speed^2 of energy, half for v_CM and half for L, since no moment is larger than M R^2.
/// Cost:   about 60 flops a body that is awake.
void fall_asleep(const BodyView& bodies, const SurfaceView& surfaces, const Vector& gravity, scalar h, const SleepLimits& limits,
                 const RestView& rest, const scalar* pull_sq = nullptr);

/// In a force field: how strongly gravity and forces pull at the bodies that are awake, |gravity| + |F_T| / M, in m s^-2, squared, by slot. The
/// acceleration of a body at rest is compared with that, as it is with gravity where there is no field. Needs: F_T before contacts are solved.
void note_pulls(const BodyView& bodies, const RestView& rest, const Vector& gravity, scalar* pull_sq);

} }  // namespace ingot
