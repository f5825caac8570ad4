// SPDX-License-Identifier: MIT
// What a step leaves out where bodies are at rest.
#pragma once

#include "../constraint/impact_note.h"
#include "../narrow_phase/manifold_record.h"
#include "../broad_phase/search_view.h"
#include "../island/awake_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// The rules of the scene for pairs, and one more: two shapes at rest get no manifold. A step sees such pairs only where one is a sensor.
template <class Rules>
struct RulesOfRest : Rules {
    RestView rest;

    bool keeps(const BodyPair& pair) const { return !rest.is_active(rest.body_of(pair.body_A)) && !rest.is_active(rest.body_of(pair.body_B)); }
};

/// Sensors of a scene that has some, by shape slot: they note in every step who is in them, so their pairs are always looked at.
using SensorMarks = const uint8_t*;

/// Bounds of all shapes, for the first step after a world began or was loaded: those of active bodies and sensors are searched for.
void make_all_bounds(const SearchView& search, const RestView& rest, SensorMarks is_sensor, scalar h);

/// Bounds of the shapes of active bodies; the others keep theirs. A shape that left its fat AABB, or that the step before did not search for, gets a
/// new fat AABB and is due: the search finds its pairs anew. They are due[0 .. count), where due is not null.
/// bounded: they have been, by bound_active_shapes.
/// Returns: how many. Cost: about 40 flops a shape of an active body.
int refresh_active_bounds(const SearchView& search, const RestView& rest, scalar h, uint32_t* due, bool bounded);
/// Bounds in this step of the shapes of active bodies, of some tiles of bodies, beside others.
void bound_active_shapes(const SearchView& search, const RestView& rest, scalar h, const TaskRange& tiles);

/// Bodies that were settling are at rest now, unless they woke again: their shapes are searched for no more.
/// True when there were some.
bool end_settling(const SearchView& search, const RestView& rest, SensorMarks is_sensor);

/// Pairs that are searched for no more leave the list.
void drop_resting_pairs(const SearchView& search, const PairList& pairs);

/// The manifolds of bodies that rest are put aside, to come back when their island wakes. told(pair) hears of each, in their order.
/// Cost: a walk along the manifolds of the step.
template <class Told>
void put_manifolds_aside(const BodyView& bodies, const RestView& rest, const ManifoldView& manifolds, const Told& told) {
    int kept = 0;
    // bound: max_manifolds
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair pair = manifolds.pairs[manifold_i];
        const int A = rest.body_of(pair.body_A), B = rest.body_of(pair.body_B), body = is_dynamic(bodies, A) ? A : B;
        if (rest.is_active(A) || rest.is_active(B) || !is_dynamic(bodies, body)) {
            manifolds.pairs[kept++] = pair;
            continue;
        }
        told(pair);
        const int root = rest.root(body), first = rest.aside[root];
        const Index here = static_cast<Index>(pair.record + 1);
        BodyPair& aside = rest.pairs_aside[pair.record];
        aside = {pair.body_A, pair.body_B, here};
        if (first == 0) {
            rest.aside[root] = here;
        } else {
            aside.record = rest.pairs_aside[first - 1].record;
            rest.pairs_aside[first - 1].record = here;
        }
        ++*rest.aside_count;
    }
    *manifolds.count = static_cast<Index>(kept);
}

/// Moves the notes of the pairs that a step has solved to their places among all manifolds. The other manifolds get empty notes.
void spread_notes(const ManifoldView& manifolds, const BodyPair* awake_pairs, int awake_count, ImpactNote* notes);

} }  // namespace ingot
