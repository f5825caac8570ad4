// SPDX-License-Identifier: MIT
#include "listing1_euler.h"

#include "../body/kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

void integrate_A_listing1(const BodyView& bodies, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        const Mat3<lane> A = load(tile.A);
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        const Vec3<lane> omega = spin_of(A, inv_I_body, load(tile.L));
        const Mat3<lane> moved = A + orientation_rate(omega, A) * splat<lane>(h);
        const Mat3<lane> A_next = reorthogonalized(moved);
        // A length that overflows would make its column zero, which is finite and no rotation.
        const mask lengths_good = is_finite(length_sq(moved.c0) + length_sq(moved.c1));
        const mask good = both(both(is_finite(A_next), lengths_good), is_within_runaway(omega));
        const mask movable = load(tile.inv_I_scale) > lane{};  // an immovable body keeps its A to the bit
        store(tile.A, select(both(good, movable), A_next, A));
        mark_bad(tile.bad, good);
    }
}

} }  // namespace ingot
