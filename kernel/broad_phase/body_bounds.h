// SPDX-License-Identifier: MIT
#pragma once

#include "../shape/surface.h"

namespace ingot { inline namespace INGOT_ABI {

/// Boxes along the world axes that hold `lanes` bodies, wherever they get within the step. A lane without a shape holds the empty box, which
/// overlaps nothing. The box of a half space ends at its face if the face lies along two of the axes; else it is the whole world.
struct alignas(tile_alignment) BoundsTile {
    scalar low[3][lanes], high[3][lanes];            ///< m, in this step
    scalar fat_low[3][lanes], fat_high[3][lanes];  ///< m, with a skin around; pairs are searched for by these
    scalar spin_reach[lanes];                        ///< m, that spin can add to a point of the body in this step
};

/// Bounds of every body, enlarged by half of limits::contact_margin and by the way that velocity and spin allow within h. So two bodies whose boxes
/// are apart do not touch in this step. Needs omega. Cost: about 40 flops a body.
///
/// Returns: whether a body has left its fat AABBs. If so, all fat AABBs are new, and pairs must be searched for again; if not, the pairs of the
/// last search still hold all that may touch. bounded: those of this step are there already, see bound_shapes.
/// only_balls: besides half spaces, there are no other shapes.
template <bool only_balls = false>
bool refresh_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BoundsTile* bounds, bool bounded = false);

/// Fat AABBs without their skin: a search by these finds the pairs that may touch in this step, and no more.
void shrink_bounds(const BodyView& bodies, BoundsTile* bounds);

/// True for a tile of zeros: storage begins so, and a snapshot leaves it so. refresh_bounds never writes one, since bounds have an extent.
INGOT_INLINE bool is_blank(const BoundsTile& tile) { return tile.low[0][0] == 0 && tile.high[0][0] == 0; }

/// The next body in this slot leaves its fat AABBs, whatever it is.
void invalidate_bounds(BoundsTile* bounds, int slot);

/// True where the bounds of this step overlap.
INGOT_INLINE bool bounds_overlap(const BoundsTile* bounds, int slot_A, int slot_B) {
    const Place A = place_of(slot_A), B = place_of(slot_B);
    bool overlap = true;
    for (int axis = 0; axis < 3; ++axis)
        overlap = overlap && bounds[A.tile].low[axis][A.lane] <= bounds[B.tile].high[axis][B.lane] &&
                  bounds[B.tile].low[axis][B.lane] <= bounds[A.tile].high[axis][A.lane];
    return overlap;
}

} }  // namespace ingot
