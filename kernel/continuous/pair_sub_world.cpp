// SPDX-License-Identifier: MIT
#include "pair_sub_world.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
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
    set_lane(rotation.A, at.lane, motion.A);
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | bit);
    if (bodies.compensation != nullptr) set_lane(bodies.compensation[at.tile].A_low, at.lane, Matrix{});
}

void PairSubWorld::clear() {
    const BodyView all = bodies();
    for (int tile_i = 0; tile_i < tiles; ++tile_i) {
        rotation[tile_i] = {};
        translation[tile_i] = {};
        compensation[tile_i] = {};
        energy[tile_i] = {};
    }
    for (int slot = 0; slot < tiles * lanes; ++slot) set_identity_body(all, slot);
}

void PairSubWorld::take(int which, const BodyView& from, const BodyShapes& shapes, int slot) {
    const Place at = place_of(which), from_at = place_of(slot);
    put_state(bodies(), which, flight_state(from, slot));
    const TranslationTile& translation_from = from.translation[from_at.tile];
    const RotationTile& rotation_from = from.rotation[from_at.tile];
    translation[at.tile].inv_M[at.lane] = translation_from.inv_M[from_at.lane];
    set_lane(translation[at.tile].F_T, at.lane, lane_of(translation_from.F_T, from_at.lane));
    set_lane(rotation[at.tile].tau_T, at.lane, lane_of(rotation_from.tau_T, from_at.lane));
    set_lane(rotation[at.tile].inv_I_ratio, at.lane, lane_of(rotation_from.inv_I_ratio, from_at.lane));
    rotation[at.tile].inv_I_scale[at.lane] = rotation_from.inv_I_scale[from_at.lane];
    extents[which] = extent_of(shapes, slot);
}

void PairSubWorld::keep_forces() {
    for (int which = 0; which < 2; ++which) {
        const Place at = place_of(which);
        F_T[which] = lane_of(translation[at.tile].F_T, at.lane);
        tau_T[which] = lane_of(rotation[at.tile].tau_T, at.lane);
    }
}

void PairSubWorld::return_forces() {
    for (int which = 0; which < 2; ++which) {
        const Place at = place_of(which);
        set_lane(translation[at.tile].F_T, at.lane, F_T[which]);
        set_lane(rotation[at.tile].tau_T, at.lane, tau_T[which]);
    }
}

scalar PairSubWorld::moment() {
    const Vector v_A = flight_state(bodies(), 0).v_CM, v_B = flight_state(bodies(), 1).v_CM;
    scalar spin = 0, fastest = sqrt(max(length_sq(v_A - v_B), max(length_sq(v_A), length_sq(v_B))));
    for (int which = 0; which < 2; ++which) {
        const scalar own = sqrt(length_sq(omega_of(bodies(), which)));
        fastest += own * extents[which].radius;
        spin = own > spin ? own : spin;
    }
    const scalar way = limits::together_share * min(extents[0].least, extents[1].least), angle = limits::angle_per_path / 2;
    const scalar by_way = fastest * limits::step_max > way ? way / fastest : limits::step_max,
                 by_turn = spin * limits::step_max > angle ? angle / spin : limits::step_max;
    return by_way < by_turn ? by_way : by_turn;
}

bool PairSubWorld::some_fast(scalar h) {
    bool some = false;
    for (int which = 0; which < 2; ++which) {
        const scalar travel = sqrt(length_sq(flight_state(bodies(), which).v_CM)) * h, turn = sqrt(length_sq(omega_of(bodies(), which))) * h;
        some = some || travel + turn * extents[which].radius > limits::fast_share * extents[which].least;
    }
    return some;
}

scalar PairSubWorld::margin(scalar h, scalar unit) {
    scalar reach = 0;
    for (int which = 0; which < 2; ++which) {
        const scalar angle = sqrt(length_sq(omega_of(bodies(), which))) * h;
        reach += (angle < 2 ? angle : scalar(2)) * extents[which].radius;
    }
    return limits::contact_margin * unit + sqrt(length_sq(flight_state(bodies(), 0).v_CM - flight_state(bodies(), 1).v_CM)) * h + reach;
}

} }  // namespace ingot
