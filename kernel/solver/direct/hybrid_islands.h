// SPDX-License-Identifier: MIT
// `using solver = ...;` of a scene: who solves its contacts, and in what memory.
#pragma once

#include "solve_directly.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using solver = ingot::BlockSweeps;`, for many bodies of like masses. No memory of its own. What it did not settle is in
/// StepReport::residual: some 1e-6 m/s where contacts rest; 0.1 and more where a heavy body crushes a light one.
struct BlockSweeps {
    static constexpr const char* name = "block_sweeps";
    static constexpr bool is_direct = false, is_pointwise = false;

    template <int max_bodies, int max_manifolds>
    struct Memory {
        template <bool notes_impulses, bool bounces, class View>
        void solve_contacts(View& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes,
                            StepReport& report) {
            solve_manifolds<notes_impulses, bounces>(solver, bodies, gravity, h, notes, report);
        }
    };
};

/// `using solver = ingot::HybridIslands<>;`: a solver that picks itself, island by island. Sweeps, and a direct solve in double
/// for islands of up to max_island manifolds that sweeps do not serve: heavy bodies on light ones, tall towers, and whatever
/// sweeps at their bound leave uneven for limits::unsettled_steps steps (see choose_islands). entries_of_row: of the matrix, on
/// average; 10 are a tower, 3 max_island is full. Islands without room are swept, and StepReport::direct says so.
///
/// RAM of the world: max_island (1.4 KB + 48 entries_of_row bytes), and 33 bytes a body, 13 a manifold of the scene:
/// HybridIslands<4> 9 KB, HybridIslands<20, 10> 38 KB, HybridIslands<> 121 KB; never more islands than max_manifolds.
/// Flash: 38 KB on a Cortex-M4F.
/// Time: a factor, rows times the square of entries_of_row, for each substep whose set of contacts is new, none while it stays.
/// Bound: 3 limits::direct_work_max multiplications in factors a substep, however many islands there are; attempts that would
/// take more are swept. Doubles are software where the core has none, to the same bits, at some 100 instructions an operation:
/// a heavy cube on a light one takes a Cortex-M4F 1.6 million instructions a step, twenty cubes in a column 22 million.
template <int max_island = 48, int entries_of_row = 24>
struct HybridIslands {
    static constexpr const char* name = "hybrid_islands";
    static constexpr bool is_direct = true, is_pointwise = false;
    static constexpr int island_capacity = max_island, entries_per_row = entries_of_row;

    template <int max_bodies, int max_manifolds>
    struct Memory {
        static constexpr unsigned island = static_cast<unsigned>(max_island < max_manifolds ? max_island : max_manifolds);
        static constexpr unsigned rows = 6 * island, full = rows * (rows - 1) / 2;
        static constexpr unsigned thin = rows * static_cast<unsigned>(entries_of_row), entries = full < thin ? full : thin;
        static constexpr unsigned body_capacity = static_cast<unsigned>(max_bodies) + 1;
        static_assert(max_island >= 1 && max_island <= 1024,
                      "the direct solver takes islands of 1 to 1024 manifolds: HybridIslands<max_island>");

        wide_scalar entry[entries] = {};
        DirectRow row[direct_rows * island] = {};
        DirectActive active[rows] = {};
        DirectManifold manifold[island] = {};
        DirectBody body[island + 2] = {};
        FreeMotion free_motion[body_capacity] = {};
        uint16_t root[body_capacity] = {}, size[body_capacity] = {}, begin[body_capacity] = {}, local[body_capacity] = {};
        IslandState state[body_capacity] = {};
        uint16_t members[static_cast<unsigned>(max_manifolds)] = {};
        uint8_t unsettled[static_cast<unsigned>(max_manifolds)] = {};
        Visit left[static_cast<unsigned>(max_manifolds) * 2 + static_cast<unsigned>(max_manifolds) / 2 + 3] = {};

        DirectView direct_view() {
            return {manifold,
                    row,
                    active,
                    body,
                    entry,
                    static_cast<int>(island),
                    static_cast<int>(entries),
                    free_motion,
                    root,
                    size,
                    begin,
                    state,
                    local,
                    members,
                    unsettled,
                    left,
                    0,
                    0,
                    0,
                    0,
                    0,
                    false,
                    false,
                    false,
                    0};
        }
        template <bool notes_impulses, bool>
        void solve_contacts(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes,
                            StepReport& report) {
            DirectView direct = direct_view();
            solve_directly<notes_impulses>(solver, direct, bodies, gravity, h, notes, report);
        }
    };
};

/// The choice of islands, with room for most scenes: `using solver = ingot::HybridIslands<>;`.
using ChosenSolver = HybridIslands<>;

} }  // namespace ingot
