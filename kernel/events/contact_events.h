// SPDX-License-Identifier: MIT
// What a step tells of contacts: who began to touch, who ended, who was hit.
#pragma once

#include "../base/ids.h"
#include "../constraint/flight_impact.h"
#include "../constraint/impact_note.h"
#include "../narrow_phase/manifold_record.h"
#include "pair_rules.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of bodies of several shapes each pair of shapes begins, ends and hits by itself.
enum class EventKind : uint8_t {
    begin,  ///< A and B touch, and did not in the step before
    end,    ///< they touch no more, or one of them is removed: its id is stale then
    hit,    ///< they met faster than Scene::hit_speed
    enter,  ///< B is in the sensor A, and was not in the step before
    leave,  ///< it is no more, or one of them is removed
};

/// One thing that a step tells of two bodies.
struct Event {
    EventKind kind{};              ///< what
    uint8_t shape_A{}, shape_B{};  ///< which of their shapes, where a body has several; else 0
    BodyId A{}, B{};               ///< of enter and leave A is the sensor
    Vector P{};    ///< m, world, of the point that met fastest, at the begin of the step, or when fast bodies met in it; begin and hit
    Vector n{};    ///< unit, from B to A; begin and hit
    scalar speed{};  ///< m/s, at which A and B approached each other along n at P, just before they met; begin and hit
};

/// By members, as write_pair: an event has gaps.
INGOT_INLINE void write_event(Event& to, const Event& event) {
    to.kind = event.kind;
    to.shape_A = event.shape_A;
    to.shape_B = event.shape_B;
    to.A = event.A;
    to.B = event.B;
    to.P = event.P;
    to.n = event.n;
    to.speed = event.speed;
}

/// The events of a step, for reading: valid until the next step. `for (const ingot::Event& event : world.events())`.
struct EventView {
    const Event* first{};  ///< of them count
    int count{};           ///< 0 and more

    const Event* begin() const { return first; }  ///< for a range for
    const Event* end() const { return first + count; }  ///< for a range for
    const Event& operator[](int index) const { return first[index]; }  ///< 0 <= index < count
};

/// Where events are put, without its capacity.
struct EventList {
    Event* events;
    Index* count;
    int capacity;
    Index* lost;

    void add(const Event& event) const {
        if (*count < capacity)
            write_event(events[(*count)++], event);
        else
            ingot::count(*lost);
    }
};

/// Events of shape slots become events of bodies and the numbers of their shapes.
template <int shapes_of_body>
void name_bodies(const EventList& events) {
    for (int event_i = 0; event_i < *events.count; ++event_i) {  // bound: max_events
        Event& event = events.events[event_i];
        event.shape_A = static_cast<uint8_t>(event.A.slot % shapes_of_body);
        event.shape_B = static_cast<uint8_t>(event.B.slot % shapes_of_body);
        event.A.slot = static_cast<Index>(event.A.slot / shapes_of_body);
        event.B.slot = static_cast<Index>(event.B.slot / shapes_of_body);
    }
}

/// Before the solve: how fast points approach, v^2 = v_0^2 + 2 a s at the end of the gap s, under gravity and forces.
///
/// A meeting that other contacts of the same step cause is not foreseen: its hit is told with the speed it had before.
/// Frames: world. Units: m/s. Cost: about 80 flops a point.
void note_approaches(const BodyView& bodies, const Vector& gravity, scalar h, const ManifoldView& manifolds, ImpactNote* notes);

/// After the solve: the pairs that touch, in the order of manifolds.pairs.
///
/// Two bodies begin to touch when they push each other, or overlap at the begin of a step. They stop when they do neither and are further apart than
/// limits::touching_gap. So a body at rest does not flicker.
void find_touching(const ManifoldView& manifolds, scalar unit, const ImpactNote* notes, const uint32_t* generation, const PairOfBodiesList& before,
                   const PairOfBodiesList& touching);

INGOT_INLINE void copy_list(const PairOfBodiesList& from, const PairOfBodiesList& to) {
    // bound: max_overlaps or max_manifolds
    for (int pair_i = 0; pair_i < *from.count; ++pair_i) to.pairs[pair_i] = from.pairs[pair_i];
    *to.count = *from.count;
}

/// Pairs of `before` that are not in `now`, as events of the kind.
void emit_missing(const PairOfBodiesList& before, const PairOfBodiesList& now, EventKind kind, uint16_t world_tag, const EventList& events);
/// Pairs that met within the step touch in it: they come to those that do. Who has no room is counted in flights.lost.
void list_flights(const FlightImpactList& flights, const uint32_t* generation, const PairOfBodiesList& touching);

/// What a step knows of contacts: manifolds and what was noted of them; and who met in flight, a FlightImpactList or NoFlightImpacts.
template <class Flights>
struct ContactsOfStep {
    ManifoldView manifolds;
    const ImpactNote* notes;
    Flights flights;
};
/// Pairs that touch now and did not before.
template <class Flights>
void emit_begins(const ContactsOfStep<Flights>& contacts, const PairOfBodiesList& before, const PairOfBodiesList& touching, uint16_t world_tag,
                 const EventList& events);
/// Pairs whose points met faster than hit_speed, m/s, and did not in the step before: the solver may need two steps to stop a body.
template <class Flights>
void emit_hits(const ContactsOfStep<Flights>& contacts, scalar hit_speed, const PairOfBodiesList& before, const PairOfBodiesList& touching,
               uint16_t world_tag, const EventList& events);

} }  // namespace ingot
