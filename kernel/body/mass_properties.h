// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

/// Mass, centre of mass and inertia of a solid, all in the frame its user models it in.
struct MassDistribution {
    scalar M;                ///< kg
    Vector r_CM;             ///< m, centre of mass in the user's frame
    SymmetricMatrix I;       ///< kg m^2, about the centre of mass, along the user's axes
};

/// The same in the body frame of the kernel: origin at the centre of mass, axes along the principal axes.
struct MassProperties {
    scalar M;            ///< kg
    Vector I_body;       ///< kg m^2, principal moments
    Vector r_CM;         ///< m, centre of mass in the user's frame: keeps that frame reachable
    Matrix A_principal;  ///< columns are the principal axes in the user's frame; a rotation
};

} }  // namespace ingot
