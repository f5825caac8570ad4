// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../narrow_phase/manifold_record.h"
#include "body_path.h"

namespace ingot { inline namespace INGOT_ABI {

/// Pairs with a body that is too fast for the step, as the search for manifolds asks for them.
struct FastPairs {
    BodyView bodies;
    SurfaceView surfaces;
    const BodyPath* paths;
    scalar h;

    bool has(const BodyPair& pair) const { return paths[pair.body_A].fast || paths[pair.body_B].fast; }
    /// Touching bodies that would get through each other's skin in the step, or turn their faces away: what they do is over in a moment of
    /// it. Others slide or rest, or a slow body among others is hit: these are solved together.
    bool meets_hard(const BodyPair& pair, const Manifold& manifold) const;
};

} }  // namespace ingot
