// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/plane_between.h"

namespace ingot { inline namespace INGOT_ABI {

/// A plane that parts two shapes, apart or in each other: `gap` is how far they are apart along n, and negative where they overlap. They are no
/// deeper in each other than -gap: moved by so much along n, they are apart.
struct PartingPlane {
    PlaneBetween plane;
    bool found;  ///< false where even the middle of A is inside B
};

/// Where they overlap, A loses a skin, the thinnest of three that parts them, and n is that of the nearest points of B and of what is left of A;
/// where none does, of a ball about the middle of A. It is the shortest way out for faces, and near it for edges.
/// Needs:   an A that is no half space; what closest_points says of the two.
/// Cost:    one search for nearest points where they overlap by a quarter of A's least half extent or less, up to four where deeper.
PartingPlane parting_plane(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest);

} }  // namespace ingot
