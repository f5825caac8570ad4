// SPDX-License-Identifier: MIT
// Impacts of fast bodies within a step, which no manifold of the step knows: what events tell of them.
#pragma once

#include "../base/report.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

struct FlightImpact {
    Index shape_A, shape_B;  ///< shape slots, A the lower
    Vector P;                   ///< m, world, of the point that met fastest, when it did
    Vector n;                   ///< unit, from B to A
    scalar speed;               ///< m/s, at which they approached each other there

    /// The order of lists, as of BodyPair.
    PairKey key() const { return key_of(shape_A, shape_B); }
};

/// Those of a step, sorted by key; of a pair that meets several times the fastest.
struct FlightImpactList {
    FlightImpact* impacts;
    Index* count;
    int capacity;
    Index* lost;  ///< no room

    /// By members, as write_pair of events: an impact has gaps.
    static void write(FlightImpact& to, const FlightImpact& impact) {
        to.shape_A = impact.shape_A;
        to.shape_B = impact.shape_B;
        to.P = impact.P;
        to.n = impact.n;
        to.speed = impact.speed;
    }
    /// The place of the first that is not before the key.
    int place_of_key(PairKey key) const {
        int place = 0;
        // bound: limits::flight_impacts_max
        while (place < *count && impacts[place].key() < key) ++place;
        return place;
    }
    /// Null where the pair met nobody in flight.
    const FlightImpact* find(PairKey key) const {
        const int place = place_of_key(key);
        return place < *count && impacts[place].key() == key ? impacts + place : nullptr;
    }
    void note(const FlightImpact& impact) const {
        const int place = place_of_key(impact.key());
        if (place < *count && impacts[place].key() == impact.key()) {
            if (impact.speed > impacts[place].speed) write(impacts[place], impact);
            return;
        }
        if (*count == capacity) return ingot::count(*lost);
        // bound: limits::flight_impacts_max
        for (int i = *count; i > place; --i) write(impacts[i], impacts[i - 1]);
        ++*count;
        write(impacts[place], impact);
    }
};

/// Of a scene that follows no fast bodies.
struct NoFlightImpacts {
    static constexpr const FlightImpact* find(PairKey) { return nullptr; }
};

} }  // namespace ingot
