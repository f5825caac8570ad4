// SPDX-License-Identifier: MIT
// Pairs that may not touch: those that the filters keep apart, and those of a sensor, which only notes who is in it.
#pragma once

#include "../base/report.h"
#include "../broad_phase/body_filter.h"
#include "../broad_phase/body_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

/// Two bodies by their slots and generations: a body that comes later into the slot of one of them is another one.
struct PairOfBodies {
    Index body_A, body_B;
    uint32_t generation_A, generation_B;
    bool hit;  ///< they met fast in this step: see emit_hits

    /// The order of lists: by the lower slot, then by the higher.
    PairKey key() const {
        return body_A < body_B ? key_of(body_A, body_B) : key_of(body_B, body_A);
    }
    bool same_bodies(const PairOfBodies& other) const {
        return body_A == other.body_A && body_B == other.body_B && generation_A == other.generation_A && generation_B == other.generation_B;
    }
};

/// Copies member by member: a pair has a gap, whose bytes would come from the stack and make equal worlds differ.
INGOT_INLINE void write_pair(PairOfBodies& to, const PairOfBodies& pair) {
    to.body_A = pair.body_A;
    to.body_B = pair.body_B;
    to.generation_A = pair.generation_A;
    to.generation_B = pair.generation_B;
    to.hit = pair.hit;
}

/// A list of such pairs, sorted by key, without its capacity.
struct PairOfBodiesList {
    PairOfBodies* pairs;
    Index* count;
    int capacity;
};

/// The sensors of a scene that names some, and who is in them.
struct SensorView {
    const uint8_t* is_sensor;    ///< by slot
    const uint32_t* generation;  ///< by slot
    PairOfBodiesList overlaps;   ///< of this step; A is the sensor
    Index* lost;              ///< no room

    /// True for a pair with a sensor. `overlap()` says whether the shapes do; it is noted then. Sensors do not note each other.
    template <class Overlap>
    bool take(const BodyPair& pair, const Overlap& overlap) const {
        const bool A = is_sensor[pair.body_A] != 0, B = is_sensor[pair.body_B] != 0;
        if (!A && !B) return false;
        if (A != B && overlap()) note(A ? pair.body_A : pair.body_B, A ? pair.body_B : pair.body_A);
        return true;
    }
    bool has(const BodyPair& pair) const { return is_sensor[pair.body_A] != 0 || is_sensor[pair.body_B] != 0; }
    void note(Index sensor, Index visitor) const {
        if (*overlaps.count < overlaps.capacity)
            write_pair(overlaps.pairs[(*overlaps.count)++], {sensor, visitor, generation[sensor], generation[visitor], false});
        else
            count(*lost);
    }
};

/// Who passes through sensors within a step, in flight: it comes to those that are in one, once. Where there is no room the last have none, in the
/// order of keys, in which the step itself has noted those that it found. Needs overlaps in that order.
template <class Filters>
struct PassedSensors {
    static constexpr bool some = true;
    Filters filters;
    SensorView sensors;

    /// True for a sensor and another that is none.
    bool has(int shape_A, int shape_B) const {
        return (sensors.is_sensor[shape_A] != 0) != (sensors.is_sensor[shape_B] != 0) && filters.let_meet(shape_A, shape_B);
    }
    void note(int shape_A, int shape_B) const {
        const bool first = sensors.is_sensor[shape_A] != 0;
        const auto sensor = static_cast<Index>(first ? shape_A : shape_B), visitor = static_cast<Index>(first ? shape_B : shape_A);
        const PairOfBodies passing = {sensor, visitor, sensors.generation[sensor], sensors.generation[visitor], false};
        const PairOfBodiesList& list = sensors.overlaps;
        int place = *list.count;
        // bound: max_overlaps
        while (place > 0 && list.pairs[place - 1].key() > passing.key()) --place;
        if (place > 0 && list.pairs[place - 1].key() == passing.key()) return;
        const bool full = *list.count == list.capacity;
        if (full) count(*sensors.lost);
        if (place == list.capacity) return;
        if (!full) ++*list.count;
        // bound: max_overlaps
        for (int i = *list.count - 1; i > place; --i) write_pair(list.pairs[i], list.pairs[i - 1]);
        write_pair(list.pairs[place], passing);
    }
};
/// Of scenes without sensors.
struct NoPassedSensors {
    static constexpr bool some = false;
};

struct NoSensors {
    template <class Overlap>
    static constexpr bool take(const BodyPair&, const Overlap&) {
        return false;
    }
    static constexpr bool has(const BodyPair&) { return false; }
};

/// What a scene asks of a pair before it may touch.
template <class Filters, class Sensors>
struct PairRules {
    Filters filters;
    Sensors sensors;

    template <class Overlap>
    bool may_touch(const BodyPair& pair, const Overlap& overlap) const {
        return filters.let_meet(pair.body_A, pair.body_B) && !sensors.take(pair, overlap);
    }
    /// True for a pair that may touch, and of which no sensor is to be told.
    bool tells_nobody(const BodyPair& pair) const { return filters.let_meet(pair.body_A, pair.body_B) && !sensors.has(pair); }
    /// True where nothing can have changed since the step before: in scenes whose bodies sleep.
    static constexpr bool keeps(const BodyPair&) { return false; }
};

} }  // namespace ingot
