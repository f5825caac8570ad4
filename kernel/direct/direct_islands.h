// SPDX-License-Identifier: MIT
// `using solver = ...;` of a scene: who solves its contacts, and in what memory.
#pragma once

#include "solve_directly.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using solver = ingot::Sweeps;`, for many bodies of like masses. No memory of its own.
struct Sweeps {
    template <int max_bodies, int max_manifolds>
    struct Memory {
        template <bool notes_impulses>
        void solve_contacts(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes,
                            StepReport& report) {
            solve_manifolds<notes_impulses>(solver, bodies, gravity, h, notes, report);
        }
    };
};

/// `using solver = ingot::DirectIslands<>;`: sweeps, and a direct solve in double for islands of up to max_island manifolds
/// that sweeps do not serve: heavy bodies on light ones, tall towers. entries_of_row: of the matrix, on average; 10 are a
/// tower, 12 times max_island / 2 is full. RAM: about max_island (1.5 KB + 48 entries_of_row bytes).
template <int max_island = 48, int entries_of_row = 24>
struct DirectIslands {
    template <int max_bodies, int max_manifolds>
    struct Memory {
        static constexpr unsigned island = static_cast<unsigned>(max_island < max_manifolds ? max_island : max_manifolds);
        static constexpr unsigned rows = 6 * island, full = rows * (rows - 1) / 2;
        static constexpr unsigned thin = rows * static_cast<unsigned>(entries_of_row), entries = full < thin ? full : thin;
        static constexpr unsigned body_capacity = static_cast<unsigned>(max_bodies) + 1;
        static_assert(INGOT_COMPUTES_DOUBLES, "the direct solver needs a core that computes doubles: name Sweeps");
        static_assert(max_island >= 1 && max_island <= 1024,
                      "the direct solver takes islands of 1 to 1024 manifolds: DirectIslands<max_island>");

        double entry[entries] = {};
        DirectRow row[direct_rows * island] = {};
        DirectActive active[rows] = {};
        DirectManifold manifold[island] = {};
        DirectBody body[island + 2] = {};
        FreeMotion free_motion[body_capacity] = {};
        uint16_t root[body_capacity] = {}, size[body_capacity] = {}, begin[body_capacity] = {}, local[body_capacity] = {};
        IslandFate fate[body_capacity] = {};
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
                    fate,
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
        template <bool notes_impulses>
        void solve_contacts(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes,
                            StepReport& report) {
            DirectView direct = direct_view();
            solve_directly<notes_impulses>(solver, direct, bodies, gravity, h, notes, report);
        }
    };
};

/// What a scene has that names none: direct where the core computes doubles, sweeps elsewhere.
#if INGOT_COMPUTES_DOUBLES
using ChosenSolver = DirectIslands<>;
#else
using ChosenSolver = Sweeps;
#endif

} }  // namespace ingot
