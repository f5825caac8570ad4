// SPDX-License-Identifier: MIT
#include "edit_bodies.h"

#include "../base/checks.h"
#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/axis_locks.h"
#include "../body/freeze_bad_bodies.h"
#include "../body/kinematics.h"
#include "../impulse/impulse.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vector inv_I_body_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const RotationTile& tile = bodies.rotation[at.tile];
    return lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane];
}

/// A sum of inputs may leave the range that each input kept.
Status check_sum(const Vector& sum, scalar limit) {
    return is_finite(sum) ? check_vector(sum, limit) : Status::out_of_range;
}

void write_checked_state(const BodyView& bodies, int slot, const BodyState& state) {
    const Place at = place_of(slot);
    const Vector positive_zero{};  // x + 0 turns -0 into +0: one value, one set of bits
    RotationTile& rotation = bodies.rotation[at.tile];
    set_lane(rotation.A, at.lane, nearest_rotation(state.A));
    set_lane(rotation.L, at.lane, state.L + positive_zero);
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | (1u << at.lane));
    if (bodies.compensation != nullptr) set_lane(bodies.compensation[at.tile].A_low, at.lane, Matrix{});
    if (bodies.translation != nullptr) {
        set_lane(bodies.translation[at.tile].r_CM, at.lane, state.r_CM + positive_zero);
        set_lane(bodies.translation[at.tile].v_CM, at.lane, state.v_CM + positive_zero);
    }
    INGOT_ASSERT(!is_frozen(bodies, slot));
}

struct NextMotion {
    Vector v_CM, L;
};

/// What an impulse j and an angular impulse k make of a body's motion, checked and not yet written.
Result<NextMotion> motion_after(const BodyView& bodies, int slot, const Vector& j, const Vector& k) {
    if (is_frozen(bodies, slot)) return {Status::frozen, {}};
    if (!is_dynamic(bodies, slot)) return {Status::immovable, {}};
    Status status = check_vector(j, limits::force_max);
    if (status == Status::ok) status = check_vector(k, limits::torque_max);
    if (status != Status::ok) return {status, {}};

    BodyState state = read_state(bodies, slot);
    state.L += k;
    if (bodies.translation != nullptr) state.v_CM += j * bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane];
    status = check_sum(state.v_CM, limits::speed_max);
    if (status == Status::ok)
        status = check_sum(scaled(inv_I_body_of(bodies, slot), transpose_times(state.A, state.L)), limits::spin_max);
    if (status != Status::ok) return {status, {}};
    return {Status::ok, {state.v_CM, state.L}};
}

void set_motion(const BodyView& bodies, int slot, const NextMotion& motion) {
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    set_lane(rotation.L, at.lane, motion.L);
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | (1u << at.lane));
    if (bodies.translation != nullptr) set_lane(bodies.translation[at.tile].v_CM, at.lane, motion.v_CM);
}

}  // namespace

Status check_definition(const BodyDef& def, bool scene_translates, bool scene_has_shape) {
    Vector inv_I_body{};
    if (def.immovable) {
        if (!is_zero(def.state.v_CM) || !is_zero(def.state.L)) return Status::immovable;
    } else {
        const Status status = check_mass_properties(def.mass);
        if (status != Status::ok) return status;
        if (def.shape.kind == ShapeKind::half_space) return Status::bad_shape;
        const ScaledInverseInertia inverse = scaled_inverse_inertia(def.mass.I_body);
        inv_I_body = inverse.ratio * inverse.scale;
    }
    Status status = check_state(def.state, inv_I_body);
    if (status != Status::ok) return status;
    if (!scene_translates && !(is_zero(def.state.r_CM) && is_zero(def.state.v_CM))) return Status::not_in_scene;
    return def.shape.kind == ShapeKind::none || scene_has_shape ? Status::ok : Status::not_in_scene;
}

Status check_surface(const BodyDef& def) {
    Status status = check_shape(def.shape);
    if (status == Status::ok) status = check_restitution(def.restitution);
    return status == Status::ok ? check_friction(def.friction) : status;
}

Status check_mass_frame(const MassProperties& mass) {
    const Status status = check_vector(mass.r_CM, limits::position_max);
    return status == Status::ok ? check_rotation(mass.A_principal) : status;
}

Status check_place(const ShapeDef& part, const MassProperties& mass) {
    if (part.shape.kind == ShapeKind::none) return Status::bad_shape;
    Status status = check_vector(part.r, limits::position_max);
    if (status == Status::ok) status = check_rotation(part.A);
    if (status != Status::ok) return status;
    const ShapePlace place = place_in_body(part, mass);
    status = check_vector(place.r, limits::position_max);
    return status == Status::ok ? check_rotation(place.A) : status;
}

BodyDef with_shape(const BodyDef& def, const ShapeDef& part) {
    BodyDef one = def;
    one.shape = part.shape;
    one.restitution = part.restitution;
    one.friction = part.friction;
    one.sensor = part.sensor;
    return one;
}

scalar radius_about_body(const Shape& shape, const ShapePlace& place) {
    if (shape.kind == ShapeKind::half_space) return 0;
    return (sqrt(length_sq(place.r)) + bounding_radius(shape)) * (1 + 4 * epsilon);  // its roundings
}

BodyDef body_of_level(const LevelTable& level, const LevelDef& def) {
    BodyDef body;
    body.immovable = true;
    body.state.r_CM = def.r + def.A * level.middle();
    body.state.A = def.A;
    body.shape = Level{half_extents_of(level), def.number, 0};
    body.restitution = def.restitution;
    body.friction = def.friction;
    body.filter = def.filter;
    return body;
}

void write_surface(Surface& to, const BodyDef& def) {
    write_shape_of(to, def.shape);
    to.e = def.restitution;
    to.mu = def.friction;
}

void write_body(const BodyView& bodies, int slot, const BodyDef& def) {
    set_identity_body(bodies, slot);
    if (!def.immovable) write_moments(bodies, slot, def.mass);
    write_checked_state(bodies, slot, def.state);
}

Vector moments_of_slot(const BodyView& bodies, int slot) {
    if (!is_dynamic(bodies, slot)) return {};
    const Vector inverse = inv_I_body_of(bodies, slot);
    return {1 / inverse.x, 1 / inverse.y, 1 / inverse.z};
}

Status write_mass(const BodyView& bodies, int slot, const MassProperties& mass) {
    if (is_frozen(bodies, slot)) return Status::frozen;
    if (!is_dynamic(bodies, slot)) return Status::immovable;
    const Status status = check_mass_properties(mass);
    if (status != Status::ok) return status;
    const Place at = place_of(slot);
    RotationTile& rotation = bodies.rotation[at.tile];
    const Matrix A = lane_of(rotation.A, at.lane);
    const Vector omega = spin_of(A, inv_I_body_of(bodies, slot), lane_of(rotation.L, at.lane));
    write_moments(bodies, slot, mass);
    set_lane(rotation.L, at.lane, angular_momentum_of_spin(A, mass.I_body, omega) + Vector{});
    rotation.kicked = static_cast<uint16_t>(rotation.kicked | (1u << at.lane));
    return Status::ok;
}

void stop_body(const BodyView& bodies, int slot) {
    const BodyState state = read_state(bodies, slot);
    set_identity_body(bodies, slot);
    write_checked_state(bodies, slot, {state.r_CM, {}, state.A, {}});
}

int next_living(const uint32_t* generation, int slot, int end) {
    while (slot < end && (generation[slot] & 1u) == 0) ++slot;  // bound: max_bodies
    return slot;
}

int next_free(const uint32_t* generation, int slot, int end) {
    while (slot < end && !is_free(generation[slot])) ++slot;  // bound: max_bodies
    return slot;
}

BodyState read_state(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    BodyState state{{}, {}, lane_of(bodies.rotation[at.tile].A, at.lane), lane_of(bodies.rotation[at.tile].L, at.lane)};
    if (bodies.translation != nullptr) {
        state.r_CM = lane_of(bodies.translation[at.tile].r_CM, at.lane);
        state.v_CM = lane_of(bodies.translation[at.tile].v_CM, at.lane);
    }
    return state;
}

Status write_state(const BodyView& bodies, int slot, const BodyState& state) {
    if (is_frozen(bodies, slot)) return Status::frozen;
    const Status status = check_state(state, inv_I_body_of(bodies, slot));
    if (status != Status::ok) return status;
    if (bodies.translation == nullptr && !(is_zero(state.r_CM) && is_zero(state.v_CM))) return Status::not_in_scene;
    if (!is_dynamic(bodies, slot) && !(is_zero(state.v_CM) && is_zero(state.L))) return Status::immovable;
    write_checked_state(bodies, slot, state);
    return Status::ok;
}

Status accumulate_force(const BodyView& bodies, int slot, const Vector& F, const Vector& tau) {
    if (is_frozen(bodies, slot)) return Status::frozen;
    if (!is_dynamic(bodies, slot)) return Status::immovable;
    Status status = check_vector(F, limits::force_max);
    if (status == Status::ok) status = check_vector(tau, limits::torque_max);
    if (status != Status::ok) return status;

    const Place at = place_of(slot);
    const Vector tau_T = lane_of(bodies.rotation[at.tile].tau_T, at.lane) + tau;
    status = check_sum(tau_T, limits::torque_max);
    if (status != Status::ok) return status;
    if (bodies.translation != nullptr) {
        const Vector F_T = lane_of(bodies.translation[at.tile].F_T, at.lane) + F;
        status = check_sum(F_T, limits::force_max);
        if (status != Status::ok) return status;
        set_lane(bodies.translation[at.tile].F_T, at.lane, F_T);
    }
    set_lane(bodies.rotation[at.tile].tau_T, at.lane, tau_T);
    return Status::ok;
}

Status accumulate_body_force(const BodyView& bodies, BodyForceTile& tile, int slot, const Vector& F_body, const Vector& tau_body) {
    if (is_frozen(bodies, slot)) return Status::frozen;
    if (!is_dynamic(bodies, slot)) return Status::immovable;
    Status status = check_vector(F_body, limits::force_max);
    if (status == Status::ok) status = check_vector(tau_body, limits::torque_max);
    if (status != Status::ok) return status;
    const int lane_i = place_of(slot).lane;
    const Vector F = lane_of(tile.F_body, lane_i) + F_body, tau = lane_of(tile.tau_body, lane_i) + tau_body;
    status = check_sum(F, limits::force_max);
    if (status == Status::ok) status = check_sum(tau, limits::torque_max);
    if (status != Status::ok) return status;
    set_lane(tile.F_body, lane_i, F);
    set_lane(tile.tau_body, lane_i, tau);
    return Status::ok;
}

Status accumulate_impulse(const BodyView& bodies, int slot, const Vector& j, const Vector& k) {
    const Result<NextMotion> kicked = motion_after(bodies, slot, j, k);
    if (kicked.ok()) set_motion(bodies, slot, kicked.value);
    return kicked.status;
}

Vector moment_about_centre(const BodyView& bodies, int slot, const Vector& F, const Vector& P) {
    return cross(P - read_state(bodies, slot).r_CM, F);
}

namespace {

/// restrict(slot, body): a body that does not move along, or turn about, some axes shows the impulse less.
template <class Restrict>
INGOT_INLINE Result<scalar> collide_restricted(const BodyView& bodies, int slot_A, int slot_B, const Vector& P, const Vector& n, scalar e,
                                               const Restrict& restrict) {
    Status status = check_vector(P, limits::position_max);
    if (status == Status::ok && !is_finite(n)) status = Status::not_finite;
    if (status == Status::ok && abs(length_sq(n) - 1) > limits::unit_length) status = Status::bad_direction;
    if (status == Status::ok) status = check_restitution(e);
    if (status == Status::ok && is_frozen(bodies, slot_A)) status = Status::frozen;
    if (status == Status::ok && is_frozen(bodies, slot_B)) status = Status::frozen;
    if (status == Status::ok && !is_dynamic(bodies, slot_A) && !is_dynamic(bodies, slot_B)) status = Status::immovable;
    if (status != Status::ok) return {status, 0};

    const auto colliding = [&](int slot) {
        const Place at = place_of(slot);
        const TranslationTile& translation = bodies.translation[at.tile];
        const RotationTile& rotation = bodies.rotation[at.tile];
        CollidingBody body{translation.inv_M[at.lane], inverse_inertia_world(lane_of(rotation.A, at.lane), inv_I_body_of(bodies, slot)),
                           lane_of(translation.v_CM, at.lane), omega_of(bodies, slot), P - lane_of(translation.r_CM, at.lane)};
        restrict(slot, body);
        return body;
    };
    const CollidingBody A = colliding(slot_A), B = colliding(slot_B);
    const scalar j = collision_impulse(A, B, n, e);
    if (j == 0) return {Status::ok, 0};

    // Both sides are checked before either is written.
    const bool move_A = is_dynamic(bodies, slot_A), move_B = is_dynamic(bodies, slot_B);
    const Result<NextMotion> none{Status::ok, {}};
    const Result<NextMotion> after_A = move_A ? motion_after(bodies, slot_A, n * j, cross(A.r_P, n * j)) : none;
    const Result<NextMotion> after_B = move_B ? motion_after(bodies, slot_B, n * -j, cross(B.r_P, n * -j)) : none;
    if (!after_A.ok()) return {after_A.status, 0};
    if (!after_B.ok()) return {after_B.status, 0};
    if (move_A) set_motion(bodies, slot_A, after_A.value);
    if (move_B) set_motion(bodies, slot_B, after_B.value);
    return {Status::ok, j};
}

}  // namespace

Result<scalar> collide_bodies(const BodyView& bodies, int slot_A, int slot_B, const Vector& P, const Vector& n, scalar e) {
    return collide_restricted(bodies, slot_A, slot_B, P, n, e, [](int, CollidingBody&) {});
}

Result<scalar> collide_locked_bodies(const BodyView& bodies, const uint8_t* locks, int slot_A, int slot_B, const Vector& P, const Vector& n,
                                     scalar e) {
    const Result<scalar> j = collide_restricted(bodies, slot_A, slot_B, P, n, e, [&](int slot, CollidingBody& body) {
        const LockedInertia inertia = locked_inertia_of(bodies, slot, locks[slot]);
        body.inv_M *= length_sq(free_part(n, translations_locked(locks[slot])));
        body.inv_I_world = inertia.inverse_world(lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane));
        body.omega = free_part(body.omega, inertia.axes);
    });
    const int both[] = {slot_A, slot_B};
    for (const int slot : both)
        if (j.ok() && locks[slot] != 0) hold_motion(bodies, slot, locks[slot]);
    return j;
}

Status push_body(const BodyView& bodies, int slot, const Vector& v, const Vector& P, const Vector& n, scalar j_max) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    CollidingBody pusher, body;
    pusher.v_CM = v;
    body = {translation.inv_M[at.lane], inverse_inertia_world(lane_of(bodies.rotation[at.tile].A, at.lane), inv_I_body_of(bodies, slot)),
            lane_of(translation.v_CM, at.lane), omega_of(bodies, slot), P - lane_of(translation.r_CM, at.lane)};
    const Vector j = n * -min(collision_impulse(pusher, body, n, 0), j_max);
    return length_sq(j) > 0 ? accumulate_impulse(bodies, slot, j, cross(body.r_P, j)) : Status::ok;
}

} }  // namespace ingot
