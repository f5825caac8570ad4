// SPDX-License-Identifier: MIT
// Surfaces that move by themselves: friction brings surfaces to rest upon each other, not bodies.
#pragma once

#include "../body/body_tiles.h"
#include "rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// m/s, along t_1 and t_2: by so much the surface of A goes faster than A does, relative to that of B. Known from the geometry, so it has no memory.
struct BeltRows {
    LaneRow speed[2];
};

/// What friction adds to its slip, in scenes with surface_velocities and in others.
struct MovingSurfaces {
    template <class View, class Kept>
    static void recall(const View& solver, int block_i, int lane_i, const Kept& kept) {
        const auto& block = solver.blocks[block_i];
        const Vector v = kept.record_i < 0 ? Vector{} : solver.belt_velocities[kept.record_i];
        solver.belts[block_i].speed[0][lane_i] = dot(v, lane_of(block.t_1, lane_i));
        solver.belts[block_i].speed[1][lane_i] = dot(v, lane_of(block.t_2, lane_i));
    }
    template <class Visit>
    static INGOT_INLINE void add(const Visit& at, lane& u_1, lane& u_2) {
        const BeltRows& belt = at.solver.belts[at.block_i];
        u_1 = u_1 + load(belt.speed[0]);
        u_2 = u_2 + load(belt.speed[1]);
    }
};
struct StillSurfaces {
    template <class View, class Kept>
    static void recall(const View&, int, int, const Kept&) {}
    template <class Visit>
    static INGOT_INLINE void add(const Visit&, lane&, lane&) {}
};

} }  // namespace ingot

#pragma GCC diagnostic pop
