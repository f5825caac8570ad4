// SPDX-License-Identifier: MIT
#include "pair_sub_world.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/check_body.h"
#include "../body/freeze_bad_bodies.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

FlightState flight_state(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    const RotationTile& rotation = bodies.rotation[at.tile];
    return {lane_of(translation.r_CM, at.lane), lane_of(translation.v_CM, at.lane), lane_of(rotation.L, at.lane), lane_of(rotation.A, at.lane)};
}

void put_state(const BodyView& bodies, int slot, const FlightState& motion) {
    const Place at = place_of(slot);
    TranslationTile& translation = bodies.translation[at.tile];
    RotationTile& rotation = bodies.rotation[at.tile];
    const uint16_t bit = static_cast<uint16_t>(1u << at.lane);
    if (!is_finite(motion.r_CM) || !is_finite(motion.v_CM) || !is_finite(motion.L) || !is_finite(motion.A)) {
        rotation.bad = static_cast<uint16_t>(rotation.bad | bit);
        return;
    }
    set_lane(translation.r_CM, at.lane, motion.r_CM);
    set_lane(translation.v_CM, at.lane, motion.v_CM);
    set_lane(rotation.L, at.lane, motion.L);
    // Who is put again and again, as he waits in each step, or turns in parts, has no flight of his own that would make A a rotation.
    set_lane(rotation.A, at.lane, nearest_rotation(motion.A));
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | bit);
    if (bodies.compensation != nullptr) set_lane(bodies.compensation[at.tile].A_low, at.lane, Matrix{});
}

void clear_tiles(const BodyView& bodies) {
    // bound: PairSubWorld::tiles
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        bodies.rotation[tile_i] = {};
        bodies.translation[tile_i] = {};
        bodies.compensation[tile_i] = {};
        bodies.energy[tile_i] = {};
    }
    // bound: PairSubWorld::tiles * lanes
    for (int place = 0; place < bodies.tile_count * lanes; ++place) set_identity_body(bodies, place);
}

void take_body(const BodyView& to, int place, const BodyView& from, int slot, const BodyPath& path) {
    const Place at = place_of(place), from_at = place_of(slot);
    const RotationTile& rotation_from = from.rotation[from_at.tile];
    RotationTile& rotation = to.rotation[at.tile];
    put_state(to, place, begin_of(path));
    to.translation[at.tile].inv_M[at.lane] = from.translation[from_at.tile].inv_M[from_at.lane];
    set_lane(to.translation[at.tile].F_T, at.lane, path.F_T);
    set_lane(rotation.tau_T, at.lane, path.tau_T);
    set_lane(rotation.inv_I_ratio, at.lane, lane_of(rotation_from.inv_I_ratio, from_at.lane));
    rotation.inv_I_scale[at.lane] = rotation_from.inv_I_scale[from_at.lane];
}

scalar Movers::moment() const {
    scalar spin = 0, fastest_sq = 0, turning = 0, least = limits::unbounded;
    for_each([&](int place) {
        const Vector v = flight_state(bodies, place).v_CM;
        fastest_sq = max(fastest_sq, length_sq(v));
        for_each([&](int other) { fastest_sq = max(fastest_sq, length_sq(v - flight_state(bodies, other).v_CM)); });
        least = min(least, extents[place].least);
        const scalar own = sqrt(length_sq(omega_of(bodies, place)));
        turning += own * extents[place].reach;
        if (extents[place].reach > 0) spin = max(spin, own);
    });
    const scalar fastest = sqrt(fastest_sq) + turning;
    const scalar way = limits::together_share * least, angle = limits::tilt_of_contact;
    const scalar by_way = fastest * limits::step_max > way ? way / fastest : limits::step_max,
                 by_turn = spin * limits::step_max > angle ? angle / spin : limits::step_max;
    return by_way < by_turn ? by_way : by_turn;
}

scalar Movers::kinetic_energy() const {
    scalar twice = 0;
    for (int place = 0; place < count; ++place) {  // bound: PairSubWorld::movers_max
        const FlightState motion = flight_state(bodies, place);
        const TranslationTile& tile = bodies.translation[place_of(place).tile];
        const int lane_i = place_of(place).lane;
        twice += length_sq(motion.v_CM) / tile.inv_M[lane_i] + dot(motion.L, lane_of(tile.inv_I_world, lane_i) * motion.L);
    }
    return twice / 2;
}

void Movers::take_part_of_change(const FlightState (&before)[2], scalar part) const {
    for (int place = 0; place < count; ++place) {  // bound: PairSubWorld::movers_max
        FlightState motion = flight_state(bodies, place);
        motion.v_CM = before[place].v_CM + (motion.v_CM - before[place].v_CM) * part;
        motion.L = before[place].L + (motion.L - before[place].L) * part;
        put_state(bodies, place, motion);
    }
}

bool Movers::some_fast(scalar h) const {
    bool some = false;
    // bound: PairSubWorld::movers_max
    for (int place = 0; place < count; ++place) {
        const scalar travel = sqrt(length_sq(flight_state(bodies, place).v_CM)) * h, turn = sqrt(length_sq(omega_of(bodies, place))) * h;
        some = some || travel + turn * extents[place].reach > limits::fast_share * extents[place].least;
    }
    return some;
}

scalar Movers::margin(int place_A, int place_B, scalar h, scalar unit) const {
    scalar reach = 0;
    const int places[] = {place_A, place_B};
    for (const int place : places) {
        const scalar angle = sqrt(length_sq(omega_of(bodies, place))) * h;
        reach += (angle < 2 ? angle : scalar(2)) * extents[place].reach;
    }
    const Vector v = flight_state(bodies, place_A).v_CM - flight_state(bodies, place_B).v_CM;
    return limits::contact_margin * unit + sqrt(length_sq(v)) * h + reach;
}

} }  // namespace ingot
