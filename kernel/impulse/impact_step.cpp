// SPDX-License-Identifier: MIT
#include "impact_step.h"

namespace ingot { inline namespace INGOT_ABI {

Vector acceleration_in(const ImpactStep& step, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = step.bodies.translation[at.tile];
    const scalar inv_M = tile.inv_M[at.lane];
    return inv_M > 0 ? lane_of(tile.F_T, at.lane) * inv_M + step.gravity : Vector{};
}

Ways ways_in(const ImpactStep& step) {
    scalar a_sq = 0, v_sq = 0;
    for (int slot = 0; slot < step.surfaces.slot_count; ++slot) {  // bound: max_bodies
        a_sq = max(a_sq, length_sq(acceleration_in(step, slot)));
        v_sq = max(v_sq, length_sq(v_CM_of(step.bodies, slot)));
    }
    const scalar fall = sqrt(a_sq) * step.h * step.h;  // of two, half of it each
    return {step.h, fall, 2 * sqrt(v_sq) * step.h + fall};
}

void raise_ways(ImpactStep& step, int slot) {
    const Place at = place_of(slot);
    const scalar v_sq = length_sq(lane_of(step.bodies.translation[at.tile].v_CM, at.lane));
    step.ways.most = max(step.ways.most, 2 * sqrt(v_sq) * step.h + step.ways.fall);
}

Placed placed_at(const ImpactStep& step, int slot, scalar t) {
    Placed body = placed(step.bodies, step.surfaces, slot);
    body.a = acceleration_in(step, slot);
    body.v = v_CM_of(step.bodies, slot);
    body.r_CM += (body.v + body.a * (t / 2)) * t;
    body.v += body.a * t;
    return body;
}

Placed turning_at(const ImpactStep& step, int slot, scalar t) {
    Placed body = placed_at(step, slot, t);
    const Place at = place_of(slot);  // as rows have it
    body.omega = lane_of(step.bodies.translation[at.tile].inv_I_world, at.lane) * lane_of(step.bodies.rotation[at.tile].L, at.lane);
    return body;
}

ContactSink sink_of(const ImpactStep& step, const ContactView& contacts, int slot_A, int slot_B, scalar now, bool is_again, StepReport& report) {
    const Surface* const surfaces = step.surfaces.surfaces;
    const bool swap = surfaces[slot_A].shape.kind == ShapeKind::half_space;
    ContactSink sink = {contacts, swap ? slot_B : slot_A, swap ? slot_A : slot_B, max(surfaces[slot_A].e, surfaces[slot_B].e), &report.contacts_lost,
                        &step.bodies};
    sink.now = now;
    sink.rest = step.h - now;
    sink.slow = step.rest_speed;
    sink.still = step.still();
    sink.together = step.h * limits::corners_together;
    sink.is_again = is_again;
    return sink;
}

SpeedInStep speed_at(const ImpactStep& step, const Contact& contact, scalar t) {
    const auto gained = [&](int slot) {
        const Place at = place_of(slot);
        return BodyMotionNow{acceleration_in(step, slot) * t, lane_of(step.bodies.rotation[at.tile].tau_T, at.lane) * t};
    };
    const NormalSpeed begin = normal_speed(contact, step.bodies), change = normal_speed(contact, gained(contact.body_A), gained(contact.body_B));
    return {{begin.u + change.u, begin.magnitude + change.magnitude}, change.u};
}

} }  // namespace ingot
