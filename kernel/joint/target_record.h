// SPDX-License-Identifier: MIT
// What draws a body to a target, and what a world keeps of it.
#pragma once

#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// How a target joint draws: as a spring and a damper that swing so with the body by itself; what hangs on it makes it slower. The poles of a substep
/// are those of the exact motion, so nothing rings or gains energy at any hertz; above a quarter of a turn a substep it swings no faster.
struct TargetDrive {
    scalar hertz = 5;               ///< 0 to limits::drive_hertz_max; 0: it does not draw
    scalar damping_ratio = 1;       ///< 0 to limits::damping_ratio_max
    scalar max_force = unlimited;   ///< N, 0 or more
    scalar max_torque = unlimited;  ///< N m, 0 or more; 0: the body turns as it likes, as by a mouse
};

/// Where the target is stands in the frame of A, the world.
struct TargetRecord {
    scalar hertz{}, damping_ratio{}, max_force{}, max_torque{};  ///< see TargetDrive
    Vector velocity{}, spin{};  ///< m/s, rad/s, world: of the target, which goes on with them
    Vector force{}, torque{};   ///< N, N m, world, on the body: mean of the last step

    TargetDrive drive() const { return {hertz, damping_ratio, max_force, max_torque}; }
    void set(const TargetDrive& drive) {
        hertz = drive.hertz;
        damping_ratio = drive.damping_ratio;
        max_force = drive.max_force;
        max_torque = drive.max_torque;
    }
};

} }  // namespace ingot
