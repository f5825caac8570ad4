// SPDX-License-Identifier: MIT
#include "contact_events.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

struct ToldBody {
    Vector r_CM, v_CM, omega, a;
};

ToldBody told_body(const BodyView& bodies, const Vector& gravity, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = bodies.translation[at.tile];
    const scalar inv_M = tile.inv_M[at.lane];
    const Vector a = inv_M > 0 ? lane_of(tile.F_T, at.lane) * inv_M + gravity : Vector{};
    return {lane_of(tile.r_CM, at.lane), lane_of(tile.v_CM, at.lane), omega_of(bodies, slot), a};
}

/// Speed at which a gap of s closes: it shrinks at `speed`, which grows by `a`. 0 if it stays open for h.
scalar closing_speed(scalar speed, scalar a, scalar s, scalar h) {
    const scalar v_sq = speed * speed + 2 * a * s, at_end = speed + a * h;
    const scalar most = at_end > speed ? at_end : speed;  // a body on its way out comes back no faster than this
    if (!(most > 0 && v_sq > 0)) return 0;
    const scalar v = sqrt(v_sq);
    return v < most ? v : most;
}

ImpactNote note_of(const ToldBody& A, const ToldBody& B, scalar h, const Manifold& manifold) {
    ImpactNote note{};
    const Vector& n = manifold.n;
    const scalar a = dot(n, B.a - A.a);
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const ManifoldPoint& point = manifold.points[point_i];
        const Vector v_A = A.v_CM + cross(A.omega, point.P - A.r_CM), v_B = B.v_CM + cross(B.omega, point.P - B.r_CM);
        const scalar v = closing_speed(dot(n, v_B - v_A), a, point.separation > 0 ? point.separation : 0, h);
        if (!(v > note.speed)) continue;
        note.speed = v;
        note.point = static_cast<uint8_t>(point_i);
    }
    return note;
}

const Manifold& manifold_of(const ManifoldView& manifolds, int manifold_i) {
    return manifolds.records[manifolds.pairs[manifold_i].record].manifold;
}

/// Walks along a sorted list, ahead of a walk along another.
struct Finger {
    const PairOfBodiesList& list;
    int at = 0;

    bool finds(const PairOfBodies& pair) {
        // bound: max_overlaps or max_manifolds: over the whole walk: at only grows
        while (at < *list.count && list.pairs[at].key() < pair.key()) ++at;
        return at < *list.count && list.pairs[at].same_bodies(pair);
    }
};

BodyId name_A(const PairOfBodies& pair, uint16_t world_tag) { return {pair.body_A, world_tag, pair.generation_A}; }
BodyId name_B(const PairOfBodies& pair, uint16_t world_tag) { return {pair.body_B, world_tag, pair.generation_B}; }

/// How the bodies of a pair met.
struct Meeting {
    Vector P, n;
    scalar speed;
    bool carried;
};

/// Walks along the contacts of a step, ahead of a walk along those that touch.
template <class Flights>
struct MeetingFinger {
    const ContactsOfStep<Flights>& contacts;
    int at = 0;

    /// By manifold or in flight, whichever was faster.
    Meeting of(const PairOfBodies& pair) {
        const ManifoldView& manifolds = contacts.manifolds;
        // bound: max_manifolds: over the whole walk: at only grows
        while (at < *manifolds.count && manifolds.pairs[at].key() < pair.key()) ++at;
        const bool has_manifold = at < *manifolds.count && manifolds.pairs[at].key() == pair.key();
        const FlightImpact* const flight = contacts.flights.find(pair.key());
        if (flight != nullptr && !(has_manifold && contacts.notes[at].speed >= flight->speed)) return {flight->P, flight->n, flight->speed, true};
        if (!has_manifold) return {};
        const Manifold& manifold = manifold_of(manifolds, at);
        const ImpactNote& note = contacts.notes[at];
        return {manifold.points[note.point].P, manifold.n, note.speed, note.carried};
    }
};

Event event_of(EventKind kind, const PairOfBodies& pair, uint16_t world_tag, const Meeting& meeting) {
    return {kind, 0, 0, name_A(pair, world_tag), name_B(pair, world_tag), meeting.P, meeting.n, meeting.speed};
}

}  // namespace

void note_approaches(const BodyView& bodies, const Vector& gravity, scalar h, const ManifoldView& manifolds, ImpactNote* notes) {
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[manifold_i];
        const ToldBody A = told_body(bodies, gravity, pair.body_A), B = told_body(bodies, gravity, pair.body_B);
        write_note(notes[manifold_i], note_of(A, B, h, manifold_of(manifolds, manifold_i)));
    }
}

void find_touching(const ManifoldView& manifolds, scalar unit, const ImpactNote* notes, const uint32_t* generation, const PairOfBodiesList& before,
                   const PairOfBodiesList& touching) {
    Finger finger{before};
    *touching.count = 0;
    for (int manifold_i = 0; manifold_i < *manifolds.count; ++manifold_i) {
        const BodyPair& pair = manifolds.pairs[manifold_i];
        const PairOfBodies bodies = {pair.body_A, pair.body_B, generation[pair.body_A], generation[pair.body_B], false};
        const scalar gap = least_separation(manifold_of(manifolds, manifold_i));
        const scalar allowed = finger.finds(bodies) ? limits::touching_gap * scale_of(unit, manifold_of(manifolds, manifold_i).halvings) : scalar(0);
        if (notes[manifold_i].carried || gap <= allowed) write_pair(touching.pairs[(*touching.count)++], bodies);
    }
}

void emit_missing(const PairOfBodiesList& before, const PairOfBodiesList& now, EventKind kind, uint16_t world_tag, const EventList& events) {
    Finger finger{now};
    for (int pair_i = 0; pair_i < *before.count; ++pair_i) {  // bound: max_overlaps or max_manifolds
        const PairOfBodies& pair = before.pairs[pair_i];
        if (!finger.finds(pair)) events.add({kind, 0, 0, name_A(pair, world_tag), name_B(pair, world_tag), {}, {}, 0});
    }
}

void list_flights(const FlightImpactList& flights, const uint32_t* generation, const PairOfBodiesList& touching) {
    // bound: limits::flight_impacts_max
    for (int flight_i = 0; flight_i < *flights.count; ++flight_i) {
        const FlightImpact& flight = flights.impacts[flight_i];
        int place = *touching.count;
        // bound: max_manifolds and limits::flight_impacts_max
        while (place > 0 && touching.pairs[place - 1].key() > flight.key()) --place;
        if (place > 0 && touching.pairs[place - 1].key() == flight.key()) continue;
        if (*touching.count == touching.capacity) {
            count(*flights.lost);
            continue;
        }
        // bound: max_manifolds and limits::flight_impacts_max
        for (int i = (*touching.count)++; i > place; --i) write_pair(touching.pairs[i], touching.pairs[i - 1]);
        write_pair(touching.pairs[place], {flight.shape_A, flight.shape_B, generation[flight.shape_A], generation[flight.shape_B], false});
    }
}

template <class Flights>
void emit_begins(const ContactsOfStep<Flights>& contacts, const PairOfBodiesList& before, const PairOfBodiesList& touching, uint16_t world_tag,
                 const EventList& events) {
    Finger finger{before};
    MeetingFinger<Flights> meetings{contacts};
    for (int pair_i = 0; pair_i < *touching.count; ++pair_i) {  // bound: max_overlaps or max_manifolds
        const PairOfBodies& pair = touching.pairs[pair_i];
        if (!finger.finds(pair)) events.add(event_of(EventKind::begin, pair, world_tag, meetings.of(pair)));
    }
}

template <class Flights>
void emit_hits(const ContactsOfStep<Flights>& contacts, scalar hit_speed, const PairOfBodiesList& before, const PairOfBodiesList& touching,
               uint16_t world_tag, const EventList& events) {
    Finger finger{before};
    MeetingFinger<Flights> meetings{contacts};
    for (int pair_i = 0; pair_i < *touching.count; ++pair_i) {
        PairOfBodies& pair = touching.pairs[pair_i];
        const Meeting meeting = meetings.of(pair);
        pair.hit = meeting.carried && meeting.speed > hit_speed;
        if (pair.hit && !(finger.finds(pair) && before.pairs[finger.at].hit))
            events.add(event_of(EventKind::hit, pair, world_tag, meeting));
    }
}

// The linker takes the ones that the scene calls.
#define INGOT_FLIGHTS(Flights)                                                                                                                     \
    template void emit_begins(const ContactsOfStep<Flights>&, const PairOfBodiesList&, const PairOfBodiesList&, uint16_t, const EventList&);       \
    template void emit_hits(const ContactsOfStep<Flights>&, scalar, const PairOfBodiesList&, const PairOfBodiesList&, uint16_t, const EventList&)
INGOT_FLIGHTS(NoFlightImpacts);
INGOT_FLIGHTS(FlightImpactList);
#undef INGOT_FLIGHTS

} }  // namespace ingot
