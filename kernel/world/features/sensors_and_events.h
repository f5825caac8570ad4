// SPDX-License-Identifier: MIT
// Who is in a sensor, who touches whom, and what a step tells of it.
#pragma once

#include "../../events/contact_events.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

struct Sensors : Feature {
    static constexpr uint32_t part = 512;
    template <class S>
    static constexpr bool named = has_sensors<S>;

    template <class S, bool present>
    struct Memory {
        uint8_t is_sensor[static_cast<unsigned>(shape_capacity<S>)] = {};
        PairOfBodies overlaps[static_cast<unsigned>(S::max_overlaps)] = {};
        uint16_t overlap_count = 0;

        PairOfBodiesList overlap_list() { return {overlaps, &overlap_count, S::max_overlaps}; }
        /// With an empty list of overlaps, for a step to fill.
        SensorView sensor_view(const uint32_t* generation, StepReport& report) {
            overlap_count = 0;
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
        static_assert(S::max_overlaps >= 0 && S::max_overlaps <= 65535, "a scene notes 0 to 65535 overlaps with sensors: set max_overlaps");
        static_assert(!has_sensors<S> || stacks<S>, "sensors are for scenes of contacts with friction: set max_manifolds, or max_overlaps = 0");
        return true;
    }
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
};

struct Events : Feature {
    template <class S>
    static constexpr bool named = has_events<S>;

    template <class S, bool present>
    struct SensorMemory {
        PairOfBodies overlaps_before[static_cast<unsigned>(S::max_overlaps)] = {};
        uint16_t overlap_count_before = 0;

        PairOfBodiesList overlap_list_before() { return {overlaps_before, &overlap_count_before, S::max_overlaps}; }
    };
    template <class S>
    struct SensorMemory<S, false> {};

    template <class S, bool present>
    struct Memory : SensorMemory<S, has_sensors<S>> {
        static constexpr unsigned touching_capacity = static_cast<unsigned>(S::max_manifolds);
        Event events[static_cast<unsigned>(S::max_events)] = {};
        ImpactNote notes[touching_capacity] = {};
        PairOfBodies touching[touching_capacity] = {}, touching_before[touching_capacity] = {};
        uint16_t event_count = 0, touching_count = 0, touching_count_before = 0;

        ImpactNote* impact_notes() { return notes; }
        PairOfBodiesList touching_list() { return {touching, &touching_count, S::max_manifolds}; }
        PairOfBodiesList touching_list_before() { return {touching_before, &touching_count_before, S::max_manifolds}; }
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
        each(S::hit_speed);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_events >= 0 && S::max_events <= 65535, "a scene tells 0 to 65535 events in a step: set max_events");
        static_assert(!has_events<S> || stacks<S>, "events are of contacts with friction: set max_manifolds, or max_events = 0");
        static_assert(S::hit_speed >= 0 && S::hit_speed <= limits::speed_runaway, "hits are told from a speed of 0 or more on: set hit_speed");
        return true;
    }
};

} }  // namespace ingot
