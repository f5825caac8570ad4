// SPDX-License-Identifier: MIT
#include "body_path.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/rotation.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// No method follows a body that turns further in a step.
Vector turn_in_range(const Vector& turn) {
    constexpr scalar most = limits::kinematic_turn_max;
    const scalar angle_sq = length_sq(turn);
    return angle_sq > most * most ? turn * (most / sqrt(angle_sq)) : turn;
}

Matrix turned_by(const Matrix& A, const Vector& turn) {
    const scalar angle = sqrt(length_sq(turn));
    return angle > 0 ? axis_angle(turn * (1 / angle), angle) * A : A;
}

/// The small turn that takes A to B: a_i x b_i of their columns add up to twice it.
Vector turn_between(const Matrix& A, const Matrix& B) { return (cross(A.c0, B.c0) + cross(A.c1, B.c1) + cross(A.c2, B.c2)) * scalar(0.5); }

bool is_fast(const BodyExtent& extent, scalar travel, scalar angle) {
    const scalar spin = (angle < 2 ? angle : scalar(2)) * extent.reach;  // no point gets further from where it was than the diameter
    return travel + spin > limits::fast_share * extent.least;
}

}  // namespace

BodyExtent extent_of(const BodyShapes& shapes, int slot) {
    BodyExtent extent = {limits::unbounded, 0, 0};
    shapes.for_shapes(slot, [&](ShapeSlot shape) {
        const Surface& surface = shapes.surface(shape);
        const bool is_ball_at_centre = surface.shape.kind == ShapeKind::sphere && shapes.place(shape) == nullptr;
        extent.least = min(extent.least, least_half_extent(surface.shape, shapes.hull(shape)));
        extent.radius = max(extent.radius, surface.bounding_radius);
        if (!is_ball_at_centre) extent.reach = max(extent.reach, surface.bounding_radius);
    });
    return extent;
}

Vector seen_turn(const BodyShapes& shapes, int slot, const Matrix& A, const Vector& turn) {
    if (shapes.places != nullptr) return turn;
    const ShapeKind kind = shapes.surface({slot}).shape.kind;
    if (kind == ShapeKind::sphere) return {};
    return kind == ShapeKind::capsule || kind == ShapeKind::cylinder ? turn - A.c2 * dot(A.c2, turn) : turn;
}

PathFrame frame_on_path(const BodyPath& path, scalar t) {
    const scalar u = t - path.from;
    return {path.r_CM + (path.way + path.fall * u) * u, turned_by(path.A, path.turn * u)};
}

bool begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot) {
    return is_dynamic(bodies, slot) && kinematic_begins_fast(bodies, shapes, h, slot);
}

bool kinematic_begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot) {
    const Vector way = v_CM_of(bodies, slot) * h, turn = omega_of(bodies, slot) * h;
    return is_fast(extent_of(shapes, slot), sqrt(length_sq(way)), sqrt(length_sq(turn)));
}

void begin_path(const BodyView& bodies, scalar h, int slot, BodyPath& path) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    const RotationTile& rotation = bodies.rotation[at.tile];
    const bool fast = path.fast;
    path = {};
    path.r_CM = lane_of(translation.r_CM, at.lane);
    path.A = lane_of(rotation.A, at.lane);
    path.v_CM = lane_of(translation.v_CM, at.lane);
    path.L = lane_of(rotation.L, at.lane);
    path.F_T = lane_of(translation.F_T, at.lane);
    path.tau_T = lane_of(rotation.tau_T, at.lane);
    path.way = path.v_CM * h;
    path.turn = omega_of(bodies, slot) * h;
    path.until = 1;
    path.next = never;
    path.fast = fast;
}

void begin_kinematic_path(BodyPath& path) {
    path.turn = turn_in_range(path.turn);
    path.until = 1;
    path.next = never;
}

scalar end_of_path(const Vector& turn, scalar from, scalar most) {
    const scalar angle = sqrt(length_sq(turn_in_range(turn)));
    const scalar of_part = max(most, angle / limits::path_parts_max);
    return angle * (1 - from) > of_part ? from + of_part / angle : scalar(1);
}

void lay_path(const PathPoint& begin, scalar from, const PathPoint& end, scalar until, const Vector& fall, BodyPath& path) {
    const scalar time = until - from;
    path.r_CM = begin.r_CM;
    path.A = begin.A;
    path.fall = fall;
    path.way = (end.r_CM - begin.r_CM) * (1 / time) - fall * time;
    path.turn = turn_in_range((begin.turn + end.turn) * scalar(0.5));
    path.turn += turn_between(turned_by(path.A, path.turn * time), end.A) * (1 / time);
    path.from = from;
    path.until = until;
    path.next = never;
}

void FollowedBodies::move(int slot) {
    int place = paths[slot].place;
    paths[slot].due = paths[slot].next;
    // bound: log2(max_bodies) + 1: place halves each turn
    for (; place > 0 && is_before(slot, queue[(place - 1) / 2]); place = (place - 1) / 2) put(place, queue[(place - 1) / 2]);
    // bound: log2(max_bodies) + 1: place doubles each turn
    while (2 * place + 1 < count) {
        int child = 2 * place + 1;
        if (child + 1 < count && is_before(queue[child + 1], queue[child])) ++child;
        if (!is_before(queue[child], slot)) break;
        put(place, queue[child]);
        place = child;
    }
    put(place, slot);
}

bool leaves_bounds(const PathPoint& begin, const Vector& way, const Vector& turn, const BodyExtent& extent, scalar unit) {
    const scalar spare = limits::contact_margin / 4 * scale_of(unit, halvings_of(extent.least, unit));
    const bool further = abs(way.x) > abs(begin.way.x) + spare || abs(way.y) > abs(begin.way.y) + spare || abs(way.z) > abs(begin.way.z) + spare;
    return !(!further && sqrt(length_sq(turn)) * extent.radius <= sqrt(length_sq(begin.turn)) * extent.radius + spare);
}

bool is_fast_path(const BodyPath& path, const BodyExtent& extent) {
    const scalar left = 1 - path.from;
    return is_finite(path.way) && is_finite(path.turn) &&
           is_fast(extent, sqrt(length_sq(path.way + path.fall * left)) * left, sqrt(length_sq(path.turn)) * left);
}

void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t) {
    path.r_CM = r_CM;
    path.A = A;
    path.v_CM = path.L = path.way = path.fall = path.turn = {};
    path.from = t;
    path.until = 1;
    path.next = never;
    path.kind = PathKind::standing;
    ++path.version;
}

} }  // namespace ingot
