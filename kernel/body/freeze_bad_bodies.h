// SPDX-License-Identifier: MIT
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// Takes bodies out of the motion that a stage has marked `bad`: legal input drove them to a value that is not finite.
///
/// Such a body keeps its last good pose, loses its motion, and is immovable from now on; its mark stays until it is
/// removed. Stages never store a value that is not finite, so no other body has met it.
/// Returns: the number of bodies frozen by this call.
int freeze_bad_bodies(const BodyView& bodies);

/// True when a body is marked: freeze_bad_bodies may have something to do.
inline bool any_bad_bodies(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        if (bodies.rotation[tile_i].bad != 0) return true;
        if (bodies.translation != nullptr && bodies.translation[tile_i].bad != 0) return true;
    }
    return false;
}

/// True while the body of the slot is frozen.
bool is_frozen(const BodyView& bodies, int slot);

/// Makes the lane of a slot the identity body: immovable, at the origin, at rest, unmarked.
void set_identity_body(const BodyView& bodies, int slot);

} }  // namespace ingot
