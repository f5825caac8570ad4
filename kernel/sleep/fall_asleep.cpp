// SPDX-License-Identifier: MIT
#include "fall_asleep.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_none(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Of the ball about the centre of mass that holds all shapes of a body, m.
scalar radius_of(const SurfaceView& surfaces, const RestView& rest, int slot) {
    scalar R = 0;
    const int first = slot * rest.shapes_of_body;
    // bound: max_shapes_of_body
    for (int shape_slot = first; shape_slot < first + rest.shapes_of_body; ++shape_slot) R = max(R, surfaces.surfaces[shape_slot].bounding_radius);
    return R;
}

bool is_at_rest(const BodyView& bodies, const SurfaceView& surfaces, const RestView& rest, const Vector& gravity, scalar pull_sq,
                scalar speed, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    const RotationTile& rotation = bodies.rotation[at.tile];
    if (((rotation.bad | translation.bad) >> at.lane & 1u) != 0) return false;
    const Vector v = lane_of(translation.v_CM, at.lane), L = lane_of(rotation.L, at.lane);
    if (!(pull_sq > 0)) return is_none(v) && is_none(L);

    const scalar R = radius_of(surfaces, rest, slot), speed_sq = speed * speed;
    const Vector a = lane_of(translation.F_T, at.lane) * translation.inv_M[at.lane] + gravity;
    return length_sq(v) <= speed_sq && length_sq(omega_of(bodies, slot)) * (R * R) <= speed_sq &&
           length_sq(a) <= limits::balance * limits::balance * pull_sq;
}

/// Immovable bodies have no motion to lose.
void put_to_sleep(const BodyView& bodies, const RestView& rest, int slot) {
    const Place at = place_of(slot);
    rest.settle(slot);
    set_lane(bodies.rotation[at.tile].L, at.lane, Vector{});
    set_lane(bodies.translation[at.tile].v_CM, at.lane, Vector{});
    if (bodies.energy != nullptr) bodies.energy[at.tile].E_0[at.lane] = 0;
    uint16_t& kicked = bodies.rotation[at.tile].kicked;
    kicked = static_cast<uint16_t>(kicked & ~(1u << at.lane));
}

}  // namespace

void fall_asleep(const BodyView& bodies, const SurfaceView& surfaces, const Vector& gravity, scalar h, const SleepLimits& limits,
                 const RestView& rest, const scalar* pull_sq) {
    const scalar g_sq = length_sq(gravity);
    for_awake(rest, [&](int slot) { rest.marks[slot] = 0; });
    // A root whose island is not ready is marked.
    for_awake(rest, [&](int slot) {
        if (!is_dynamic(bodies, slot)) return;
        scalar& rest_time = rest.rest_time[slot];
        const scalar longer = rest_time + h;
        const bool rests = is_at_rest(bodies, surfaces, rest, gravity, pull_sq != nullptr ? pull_sq[slot] : g_sq, limits.speed, slot);
        rest_time = !rests ? 0 : longer < limits.time ? longer : limits.time;
        if (!rests || rest_time < limits.time) rest.marks[rest.root(slot)] = 1;  // with a time of 0 none is too short
    });
    for_awake(rest, [&](int slot) {
        if (!is_dynamic(bodies, slot) || rest.marks[rest.root(slot)] == 0) put_to_sleep(bodies, rest, slot);
    });
}

void note_pulls(const BodyView& bodies, const RestView& rest, const Vector& gravity, scalar* pull_sq) {
    const scalar g = sqrt(length_sq(gravity));
    for_awake(rest, [&](int slot) {
        const TranslationTile& tile = bodies.translation[place_of(slot).tile];
        const scalar pull = g + sqrt(length_sq(lane_of(tile.F_T, place_of(slot).lane))) * tile.inv_M[place_of(slot).lane];
        pull_sq[slot] = pull * pull;
    });
}

} }  // namespace ingot
