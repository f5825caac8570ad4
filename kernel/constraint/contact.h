// SPDX-License-Identifier: MIT
// A contact of two bodies as a constraint: which parts it is made of, and in which order.
//
// A constraint is a type. It has a record, kept between steps and saved (ManifoldRecord, RollingRecord), rows of this substep, `lanes`
// constraints at once (ContactBlock), and verbs:
//
//     prepare     rows from geometry and from what the bodies answer to an impulse (response.h); recall fills in the impulses on record
//     warm_start  gives the impulses of the substep before again, as far as they are still right
//     solve       makes the velocities right for the moment
//     push        the same for displacements
//     remember    writes the impulses to the record
//     for_rows    shows the rows to code that does not know the kind of constraint
//
// and a composition has the same verbs as its parts. To add one: a header like torsion.h, and its name in ContactConstraint.
// Source: ITwoBodyConstraintFunctions of Bepu, with its rows named by the article's symbols.
#pragma once

#include "../base/if.h"
#include "material_view.h"
#include "visit.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Each verb is that of every part, one after the other.
template <class... Parts>
struct Compose {
    template <class View, class Contacts>
    static INGOT_INLINE void prepare([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] Contacts& contacts) {
        (Parts::prepare(solver, block_i, contacts), ...);
    }
    template <class View, class Kept>
    static INGOT_INLINE void recall([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] int lane_i,
                                    [[maybe_unused]] const Kept& kept) {
        (Parts::recall(solver, block_i, lane_i, kept), ...);
    }
    template <class View>
    static INGOT_INLINE void remember([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] int lane_i,
                                      [[maybe_unused]] int record_i, [[maybe_unused]] scalar part) {
        (Parts::remember(solver, block_i, lane_i, record_i, part), ...);
    }
    template <class Visit, class Pair>
    static INGOT_INLINE void warm_start([[maybe_unused]] Visit& at, [[maybe_unused]] Pair& pair, [[maybe_unused]] scalar h) {
        (Parts::warm_start(at, pair, h), ...);
    }
    /// Each part sees what the one before has done.
    template <class Visit, class Pair>
    static INGOT_INLINE void solve([[maybe_unused]] Visit& at, [[maybe_unused]] Pair& pair, [[maybe_unused]] Change& change) {
        ((Parts::solve(at, pair, change), settle(pair)), ...);
    }
    template <class View, class Each>
    static INGOT_INLINE void for_rows([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] const Each& each) {
        (Parts::for_rows(solver, block_i, each), ...);
    }
};

/// The contact of a view. It is solved with friction last, so that no other part moves a contact that friction has just stopped. It is warm started,
/// numbered and shown in this order: normals 0 .. 3, friction 4 and 5, torsion 6, rolling 7 and 8.
template <class View>
struct ContactConstraint {
    using Rubs = Friction<If<View::has_belts, MovingSurfaces, StillSurfaces>>;
    using Twists = If<(View::points_max > 1), Torsion, Compose<>>;
    using Rolls = If<View::rolls, Rolling, Compose<>>;
    using Solved = Compose<Normals, Twists, Rolls, Rubs>;
    using BesideNormals = Compose<Rubs, Twists, Rolls>;
    using Given = Compose<Normals, BesideNormals>;
};
inline constexpr int friction_row = 4, torsion_row = Torsion::number, rolling_row = Rolling::number;
static_assert(friction_row == Friction<StillSurfaces>::number && friction_row == block_rows);

} }  // namespace ingot

#pragma GCC diagnostic pop
