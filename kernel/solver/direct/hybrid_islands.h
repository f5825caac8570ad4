// SPDX-License-Identifier: MIT
// `using solver = ingot::HybridIslands<>;` of a scene: a solver that picks itself, and its memory.
#pragma once

#include "../sweeps/block_sweeps.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// As solve_by_sweeps, but islands that sweeps do not serve are solved directly: see choose_islands and solve_island. Where the direct solve finds no
/// solution, the island is swept.
template <bool notes_impulses, bool bounces, class View>
void solve_hybrid(View& view, const DirectViewOf<View::rolls>& direct, const ContactStep& step, StepReport& report);

/// `using solver = ingot::HybridIslands<>;`: sweeps or a direct solve in double, chosen island by island. The direct solve is for islands of up to
/// max_island manifolds that sweeps do not serve: heavy bodies on light ones, bodies that carry many times their own mass, tall towers, and islands
/// that sweeps have not settled for limits::unsettled_steps steps (see choose_islands). It carries 2e11 times the mass of the lightest body at any
/// rate; beyond that, or where it finds no solution, StepReport::sweeps_unfinished says so. entries_of_row: of the matrix, on average; a tower has
/// 10, a full matrix 3 max_island. Islands without room are swept, and StepReport::direct says so.
///
/// RAM of the world: max_island (1.4 KB + 48 entries_of_row bytes), and 27 bytes a body, 1 a manifold of the scene:
/// HybridIslands<4> 9 KB, HybridIslands<20, 10> 39 KB, HybridIslands<> 121 KB; never more islands than max_manifolds.
/// With rolling resistance 0.35 KB more for each manifold of max_island.
/// Flash: 38 KB on a Cortex-M4F.
/// Time: a factor, rows times the square of entries_of_row, for each substep whose set of contacts is new, none while it stays.
/// Bound: 3 limits::direct_work_max multiplications in factors an island and substep; attempts that would take more are swept. Doubles are
/// software where the core has none, to the same bits, at some 100 instructions an operation: a heavy cube on a light one takes a
/// Cortex-M4F 1.6 million instructions a step, twenty cubes in a column 22 million.
template <int max_island = 48, int entries_of_row = 24>
struct HybridIslands : BlockSolver {
    static constexpr const char* name = "hybrid_islands";
    static constexpr bool is_direct = true;
    static constexpr int island_capacity = max_island, entries_per_row = entries_of_row;

    template <int max_bodies, int max_manifolds, bool rolls = false, bool = true>
    struct Memory {
        static constexpr unsigned island = static_cast<unsigned>(max_island < max_manifolds ? max_island : max_manifolds);
        static constexpr unsigned rows = active_rows_of<rolls> * island, full = rows * (rows - 1) / 2;
        static constexpr unsigned thin = rows * static_cast<unsigned>(entries_of_row), entries = full < thin ? full : thin;
        static constexpr unsigned body_capacity = static_cast<unsigned>(max_bodies) + 1;
        static_assert(max_island >= 1 && max_island <= 1024,
                      "the direct solver takes islands of 1 to 1024 manifolds: HybridIslands<max_island>");

        wide_scalar entry[entries] = {};
        DirectRow row[direct_rows_of<rolls> * island] = {};
        DirectActive active[rows] = {};
        DirectManifoldOf<rolls> manifold[island] = {};
        DirectBody body[island + 2] = {};
        FreeMotion free_motion[body_capacity] = {};
        Index local[body_capacity] = {};
        IslandState state[body_capacity] = {};
        uint8_t unsettled[static_cast<unsigned>(max_manifolds)] = {};

        DirectViewOf<rolls> direct_view() {
            constexpr int manifolds = static_cast<int>(island), room = static_cast<int>(entries);
            return {manifold, row, active, body, entry, manifolds, room, free_motion, state, local, unsettled,
                    0, 0, 0, 0, -1, false, false, false, false, false, false, 0, 1};
        }
        template <bool notes_impulses, bool bounces, class View>
        void solve_contacts(View& solver, const ContactStep& step, StepReport& report) {
            solve_hybrid<notes_impulses, bounces>(solver, direct_view(), step, report);
        }
    };
};

} }  // namespace ingot
