// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// After the forces: what is taken over of the impulses of the substep before, and given to the bodies.
///
/// An impact is not taken over: impulses of a body that was hit are cut to twice what they were, and what gravity explains. Friction follows
/// a slow mean of itself, which quietens its ringing.
template <class View>
void warm_start(const View& solver, scalar h);

} }  // namespace ingot
