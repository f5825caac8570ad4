// SPDX-License-Identifier: MIT
// Who is in a sensor, who touches whom, and what a step tells of it.
#pragma once

#include "../../events/contact_events.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Two bodies of a list, by their shapes.
struct SavedPair : NoNumbers {
    Index body_A, body_B;
    uint32_t generation_A, generation_B;
    uint8_t hit;

    template <class Each>
    constexpr void numbers(Each& each, uint32_t) {
        each("slot_A", body_A);
        each("slot_B", body_B);
        each("generation_A", generation_A);
        each("generation_B", generation_B);
        each("hit", hit);
    }
    void take_pair(const PairOfBodies& pair) {
        body_A = pair.body_A;
        body_B = pair.body_B;
        generation_A = pair.generation_A;
        generation_B = pair.generation_B;
        hit = pair.hit ? 1 : 0;
    }
    PairOfBodies pair() const { return {body_A, body_B, generation_A, generation_B, hit != 0}; }
    /// Pairs stand in the order of their keys. A body of them may have left: its generation is that of one that lived.
    template <class S>
    bool is_valid(EntryContext& context) const {
        const PairKey key = pair().key();
        const bool lived = (generation_A & generation_B & 1u) != 0, in_order = body_A != body_B && key > context.key_before;
        context.key_before = key;
        const auto is_in_use = [&context](Index slot) { return static_cast<uint32_t>(slot) < context.shape_slots; };
        return lived && in_order && is_in_use(body_A) && is_in_use(body_B) && hit <= 1;
    }
};

struct Sensors : Feature {
    static constexpr uint32_t part = 512;
    template <class S>
    static constexpr bool named = has_sensors<S>;

    template <class S, bool present>
    struct Memory {
        uint8_t is_sensor[static_cast<unsigned>(shape_capacity<S>)] = {};
        PairOfBodies overlaps[static_cast<unsigned>(S::max_overlaps)] = {};
        Index overlap_count = 0;

        PairOfBodiesList overlap_list() { return {overlaps, &overlap_count, S::max_overlaps}; }
        /// With an empty list of overlaps, for a step to fill.
        SensorView sensor_view(const uint32_t* generation, StepReport& report) {
            overlap_count = 0;
            return sensor_view_so_far(generation, report);
        }
        /// With those that the step has noted.
        SensorView sensor_view_so_far(const uint32_t* generation, StepReport& report) {
            return {is_sensor, generation, overlap_list(), &report.overlaps_lost};
        }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr NoSensors sensor_view(const uint32_t*, StepReport&) { return {}; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_overlaps);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_overlaps >= 0 && S::max_overlaps <= index_max, "a scene notes 0 to 65535 overlaps with sensors: set max_overlaps");
        static_assert(!has_sensors<S> || stacks<S>, "sensors are for scenes of contacts with friction: set max_manifolds, or max_overlaps = 0");
        return true;
    }
    static constexpr bool checks_definitions = true;
    template <class S>
    static Status check_def(const BodyDef& def) {
        return has_shapes<S> && !has_sensors<S> && def.sensor ? Status::not_in_scene : Status::ok;
    }
    template <class S>
    static void begin_shape(Storage<S>& storage, int shape_slot, const BodyDef& def, const ShapePlace&) {
        storage.is_sensor[shape_slot] = def.sensor ? 1 : 0;
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        storage.is_sensor[shape_slot] = 0;
    }

    struct OfShape : NoNumbers {
        uint8_t sensor;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("sensor", sensor);
        }
        template <class S>
        void take(const Storage<S>& storage, int shape_slot) {
            sensor = storage.is_sensor[shape_slot];
        }
        template <class S>
        void put(Storage<S>& storage, int shape_slot) const {
            storage.is_sensor[shape_slot] = sensor;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return sensor <= 1;
        }
    };
    /// Who is in one, as of the begin of the last step, or passed it in flight.
    struct OfEntry : SavedPair {
        template <class S>
        void take(const Storage<S>& storage, int overlap_i) {
            take_pair(storage.overlaps[overlap_i]);
        }
        template <class S>
        void put(Storage<S>& storage, int overlap_i) const {
            write_pair(storage.overlaps[overlap_i], pair());
        }
    };
    static constexpr bool has_entries = true;
    template <class S>
    static constexpr int entry_capacity = S::max_overlaps;
    template <class S>
    static Index entry_count(const Storage<S>& storage) {
        return storage.overlap_count;
    }
    template <class S>
    static void set_entry_count(Storage<S>& storage, Index count) {
        storage.overlap_count = count;
    }
};

struct Events : Feature {
    static constexpr uint32_t part = 32768;
    template <class S>
    static constexpr bool named = has_events<S>;

    template <class S, bool present>
    struct SensorMemory {
        PairOfBodies overlaps_before[static_cast<unsigned>(S::max_overlaps)] = {};
        Index overlap_count_before = 0;

        PairOfBodiesList overlap_list_before() { return {overlaps_before, &overlap_count_before, S::max_overlaps}; }
    };
    template <class S>
    struct SensorMemory<S, false> {};

    template <class S, bool present>
    struct FlightMemory {
        FlightImpact flight_impacts[static_cast<unsigned>(limits::flight_impacts_max)] = {};
        Index flight_impact_count = 0;

        FlightImpactList flights(StepReport& report) {
            return {flight_impacts, &flight_impact_count, limits::flight_impacts_max, &report.events_lost};
        }
    };
    template <class S>
    struct FlightMemory<S, false> {};

    /// Pairs that touch have a manifold, or met in flight.
    template <class S>
    static constexpr int most_touching = S::max_manifolds + (S::continuous ? limits::flight_impacts_max : 0);
    /// As far as 16 bits count them.
    template <class S>
    static constexpr int touching_capacity_of = most_touching<S> < index_max ? most_touching<S> : index_max;

    template <class S, bool present>
    struct Memory : SensorMemory<S, has_sensors<S>>, FlightMemory<S, S::continuous> {
        static constexpr unsigned touching_capacity = static_cast<unsigned>(touching_capacity_of<S>);
        Event events[static_cast<unsigned>(S::max_events)] = {};
        ImpactNote notes[static_cast<unsigned>(S::max_manifolds)] = {};
        PairOfBodies touching[touching_capacity] = {}, touching_before[touching_capacity] = {};
        Index event_count = 0, touching_count = 0, touching_count_before = 0;

        ImpactNote* impact_notes() { return notes; }
        PairOfBodiesList touching_list() { return {touching, &touching_count, touching_capacity_of<S>}; }
        PairOfBodiesList touching_list_before() { return {touching_before, &touching_count_before, touching_capacity_of<S>}; }
        /// Empty, for a step to fill.
        EventList begin_events(StepReport& report) {
            event_count = 0;
            return {events, &event_count, S::max_events, &report.events_lost};
        }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr ImpactNote* impact_notes() { return nullptr; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_events);
        each(scalar(S::hit_speed));
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_events >= 0 && S::max_events <= index_max, "a scene tells 0 to 65535 events in a step: set max_events");
        static_assert(!has_events<S> || stacks<S>, "events are of contacts with friction: set max_manifolds, or max_events = 0");
        static_assert(S::hit_speed >= 0 && S::hit_speed <= limits::speed_runaway, "hits are told from a speed of 0 or more on: set hit_speed");
        return true;
    }

    /// Who touches whom: the next step tells what has changed since.
    struct OfEntry : SavedPair {
        template <class S>
        void take(const Storage<S>& storage, int pair_i) {
            take_pair(storage.touching[pair_i]);
        }
        template <class S>
        void put(Storage<S>& storage, int pair_i) const {
            write_pair(storage.touching[pair_i], pair());
        }
    };
    static constexpr bool has_entries = true;
    template <class S>
    static constexpr int entry_capacity = touching_capacity_of<S>;
    template <class S>
    static Index entry_count(const Storage<S>& storage) {
        return storage.touching_count;
    }
    template <class S>
    static void set_entry_count(Storage<S>& storage, Index count) {
        storage.touching_count = count;
    }
};

/// What the last step told. Ids are of the world, so their tag is its tag.
struct ToldEvents : Feature {
    static constexpr uint32_t part = 65536;
    template <class S>
    static constexpr bool named = has_events<S>;
    template <class S, bool>
    struct Memory {};

    struct OfEntry : NoNumbers {
        uint8_t kind;
        Event event;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("event.kind", kind);
            each("event.shape_A", event.shape_A);
            each("event.shape_B", event.shape_B);
            each("event.A.slot", event.A.slot);
            each("event.A.generation", event.A.generation);
            each("event.B.slot", event.B.slot);
            each("event.B.generation", event.B.generation);
            each("event.P", event.P);
            each("event.n", event.n);
            each("event.speed", event.speed);
        }
        template <class S>
        void take(const Storage<S>& storage, int event_i) {
            event = storage.events[event_i];
            kind = static_cast<uint8_t>(event.kind);
        }
        template <class S>
        void put(Storage<S>& storage, int event_i) const {
            Event told = event;
            told.kind = static_cast<EventKind>(kind);
            told.A.world_tag = told.B.world_tag = storage.world_tag;
            write_event(storage.events[event_i], told);
        }
        template <class S>
        bool is_valid(const EntryContext& context) const {
            const uint32_t slots = context.shape_slots / S::max_shapes_of_body;
            if (static_cast<uint32_t>(event.A.slot) >= slots || static_cast<uint32_t>(event.B.slot) >= slots) return false;
            if (kind > static_cast<uint8_t>(EventKind::leave)) return false;
            if (event.shape_A >= S::max_shapes_of_body || event.shape_B >= S::max_shapes_of_body) return false;
            if ((event.A.generation & event.B.generation & 1u) == 0) return false;
            return is_finite(event.P) && is_finite(event.n) && is_finite(event.speed);
        }
    };
    static constexpr bool has_entries = true;
    template <class S>
    static constexpr int entry_capacity = S::max_events;
    template <class S>
    static Index entry_count(const Storage<S>& storage) {
        return storage.event_count;
    }
    template <class S>
    static void set_entry_count(Storage<S>& storage, Index count) {
        storage.event_count = count;
    }
};

} } }  // namespace ingot::features
