// SPDX-License-Identifier: MIT
#pragma once

#include "bounds.h"

namespace ingot { inline namespace INGOT_ABI {

/// Boxes along the world axes that hold `lanes` bodies, wherever they get within the step. A lane without a shape holds the empty box, which
/// overlaps nothing; a half space holds the whole world.
struct alignas(tile_alignment) BoundsTile {
    scalar low[3][lanes], high[3][lanes];  ///< m
};

/// Bounds of every body, enlarged by half of limits::contact_margin and by what velocity and spin can add within h: two bodies whose
/// boxes are apart do not touch in this step. Needs omega. Cost: about 40 flops a body.
void refresh_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BoundsTile* bounds);

} }  // namespace ingot
