// SPDX-License-Identifier: MIT
// What a scene pays for contacts with friction: see Scene::effort.
#pragma once

#include "limits.h"

namespace ingot { inline namespace INGOT_ABI {

/// How much work a step does for contacts: more of it is nearer to the exact motion. The report has the curve of error against time.
///
/// Piles that shake cost in proportion to it. A wall or a tower may cost less with more: what is solved well comes to rest, and rest costs little.
struct Effort {
    /// Of a step, in each of which contacts are solved and bodies displaced: 2, 4, 8 or 16. Normals, levers and overlaps are right to first order in
    /// the length of one. An island in which nothing accelerates has limits::steady_substeps.
    int substeps = limits::substeps;
    /// Over the contacts of an island, in each substep: 1 .. 16. One of up to limits::small_island manifolds, a wall that stands (at most
    /// limits::sweeps_of_stack times), SequentialImpulses and HybridIslands sweep, or solve, until they have settled, whatever it says.
    int sweeps = limits::sweeps;

    static constexpr int substeps_max = 16, sweeps_max = 16;  ///< the most there may be
};

/// The least with which walls of 465 cubes and random piles are less wrong than in the best engine for games.
inline constexpr Effort low_effort = {2, 3};
/// For scenes that have to be right to parts of a millimetre.
inline constexpr Effort high_effort = {8, 6};

/// While more than a quarter of the contacts are younger than four steps.
constexpr int sweeps_of_new(const Effort& effort) { return 4 * effort.sweeps; }
constexpr int new_until(const Effort& effort) { return 4 * effort.substeps; }  ///< substeps that a contact has lived

/// In a heap of balls: where more than three quarters of the normals go through both centres. Balls hold up no tilt, so nothing leans while
/// loads find their way. A stack of boxes would shift twice as far.
constexpr int sweeps_of_balls(const Effort& effort) { return effort.sweeps - effort.sweeps / 3; }

/// At most, in each substep of an island that is steady: as many in a step as of another.
constexpr int steady_sweeps(const Effort& effort) { return effort.sweeps * effort.substeps / limits::steady_substeps; }

/// Sweeps go up and down the levels in turn, and end as they began. Where their number is even they would not: then all of a substep go one way, and
/// those of the next the other. With up and down in turn a heap of dice, swept twice, gets into itself by centimetres and finds no rest.
constexpr bool goes_up(const Effort& effort, int sweep_i, int substeps_left) {
    return (effort.sweeps % 2 == 0 ? substeps_left : sweep_i) % 2 != 0;
}

/// Whether a step of a steady island is cut into fewer substeps at all.
constexpr bool spares_substeps(const Effort& effort) { return effort.substeps > limits::steady_substeps; }

} }  // namespace ingot
