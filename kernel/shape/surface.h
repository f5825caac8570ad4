// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "../base/contact_lengths.h"
#include "shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// Shape and material of each body slot, or of each shape slot (see compound.h); kind `none` where no body lives.
struct Surface {
    Shape shape;
    scalar bounding_radius;  ///< m, about the centre of mass of the body; 0 for a half space
    scalar e;                ///< restitution 0 .. 1; of a pair the larger counts
    scalar mu;               ///< coefficient of friction; of a pair the geometric mean counts
    uint8_t halvings = 0;    ///< of the lengths of its contacts; of a pair the more count: see base/contact_lengths.h
};

/// The surfaces of all slots, without their capacity.
struct SurfaceView {
    const Surface* surfaces;
    int slot_count;
    scalar unit = 1;  ///< m; of lengths and speeds in limits.h
    scalar fall = 0;  ///< m, that gravity moves a body from rest within the step, at most

    /// Of a pair.
    unsigned halvings(int slot_A, int slot_B) const {
        const unsigned A = surfaces[slot_A].halvings, B = surfaces[slot_B].halvings;
        return A < B ? B : A;
    }
};

/// How much nearer two bodies come to each other within a step, at most. As it is here: they are looked at where they stand.
struct Ways {
    scalar h = 0;     ///< s, of the step
    scalar fall = 0;  ///< m, by forces alone
    scalar most = 0;  ///< m, in all, any two
};

/// The first slot from `from` on whose body may touch the body of slot_A; slot_count if there is none.
///
/// Two bodies cannot touch when neither moves, one has no shape, or the spheres that hold the shapes (the sphere and the half space) are
/// apart by more than limits::flatness and than they come nearer. Most pairs are told apart by their first coordinate. Asked slot after slot: so A is
/// looked up once for many B, which saved 40 % of the step of 64 balls on a Cortex-M4F.
int next_touchable(const BodyView& bodies, const SurfaceView& surfaces, const Ways& ways, int slot_A, int from);

} }  // namespace ingot
