// SPDX-License-Identifier: MIT
// A manifold within a step, whose bodies have moved and turned far since it was found.
//
// A point is where the surfaces of two cores are: a core is a point that is fixed to its body, and the surface lies around it.
//
//     corner, and what is fixed to the body       P = core
//     ball, end of a capsule                      P = core + radius out
//     rim or side of a cylinder with axis a       P = core + radius (out - a (a . out)) / |out - a (a . out)|
//
// out: unit, out of the body, along the normal. The normal belongs to the body whose face it is of, and turns with it; between two balls it goes from
// core to core. Edges across each other keep their normal.
#pragma once

#include "../narrow_phase/manifold.h"
#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body of a manifold: its shape as the manifold was found, and what it has done since.
struct MovedBody {
    PlacedShape shape;
    Vector r_begin, shift;  ///< m, centre of mass then, and by how much it has moved
    Matrix turn;            ///< from then to now, in world axes

    /// How far a point of it has moved, m. P: where it was.
    Vector displaced(const Vector& P) const {
        const Vector arm = P - r_begin;
        return shift + (turn * arm - arm);
    }
};

/// The manifold as it is now: its points, normal and separations. `found` is as it was found, with the normal from B to A.
/// Cost: about 150 flops a point, and a square root where it is on something round.
Manifold moved_manifold(const Manifold& found, const MovedBody& A, const MovedBody& B);

} }  // namespace ingot
