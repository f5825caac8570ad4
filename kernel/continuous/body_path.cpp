// SPDX-License-Identifier: MIT
#include "fast_pairs.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/rotation.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr scalar turn_max = 500;  ///< rad in a step, of a path; no method follows a body that far
static_assert(turn_max == limits::kinematic_turn_max);

Vector turn_in_range(const Vector& turn) {
    const scalar angle_sq = length_sq(turn);
    return angle_sq > turn_max * turn_max ? turn * (turn_max / sqrt(angle_sq)) : turn;
}

Matrix turned_by(const Matrix& A, const Vector& turn) {
    const scalar angle = sqrt(length_sq(turn));
    return angle > 0 ? axis_angle(turn * (1 / angle), angle) * A : A;
}

/// The small turn that takes A to B: a_i x b_i of their columns add up to twice it.
Vector turn_between(const Matrix& A, const Matrix& B) { return (cross(A.c0, B.c0) + cross(A.c1, B.c1) + cross(A.c2, B.c2)) * scalar(0.5); }

bool is_fast(const BodyExtent& extent, scalar travel, scalar angle) {
    const scalar spin = (angle < 2 ? angle : scalar(2)) * extent.radius;  // no point gets further from where it was than the diameter
    return travel + spin > limits::fast_share * extent.least;
}

}  // namespace

BodyExtent extent_of(const BodyShapes& shapes, int slot) {
    BodyExtent extent = {limits::unbounded, 0};
    shapes.for_shapes(slot, [&](ShapeSlot shape) {
        const Surface& surface = shapes.surface(shape);
        extent.least = min(extent.least, least_half_extent(surface.shape, shapes.hull(shape)));
        extent.radius = max(extent.radius, surface.bounding_radius);
    });
    return extent;
}

PathFrame frame_on_path(const BodyPath& path, scalar t) {
    const scalar u = t - path.from;
    return {path.r_CM + (path.way + path.fall * u) * u, turned_by(path.A, path.turn * u)};
}

bool begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot) {
    return is_dynamic(bodies, slot) && kinematic_begins_fast(bodies, shapes, h, slot);
}

bool kinematic_begins_fast(const BodyView& bodies, const BodyShapes& shapes, scalar h, int slot) {
    const Vector way = lane_of(bodies.translation[place_of(slot).tile].v_CM, place_of(slot).lane) * h, turn = omega_of(bodies, slot) * h;
    return is_fast(extent_of(shapes, slot), sqrt(length_sq(way)), sqrt(length_sq(turn)));
}

void begin_path(const BodyView& bodies, scalar h, int slot, BodyPath& path) {
    const Place at = place_of(slot);
    const bool fast = path.fast;
    path = {};
    path.r_CM = lane_of(bodies.translation[at.tile].r_CM, at.lane);
    path.A = lane_of(bodies.rotation[at.tile].A, at.lane);
    path.v_CM = lane_of(bodies.translation[at.tile].v_CM, at.lane);
    path.L = lane_of(bodies.rotation[at.tile].L, at.lane);
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
    path.in_contact = path.falls_free = false;
}

scalar end_of_path(const Vector& turn, scalar from) {
    const scalar angle = sqrt(length_sq(turn_in_range(turn)));
    const scalar of_part = max(limits::angle_per_path, angle / limits::path_parts_max);
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

bool FastPairs::meets_hard(const BodyPair& pair, const Manifold& manifold) const {
    const ShapeSlot of_pair[2] = {{pair.body_A}, {pair.body_B}};
    Vector r[2], v[2], omega[2];
    scalar least_extent = limits::unbounded, least_fast = limits::unbounded, closing = 0;
    for (int which = 0; which < 2; ++which) {
        const int slot = shapes.body_of(of_pair[which]);
        const Place at = place_of(slot);
        if (!paths[slot].fast && is_dynamic(bodies, slot)) return false;
        r[which] = lane_of(bodies.translation[at.tile].r_CM, at.lane);
        v[which] = lane_of(bodies.translation[at.tile].v_CM, at.lane);
        omega[which] = omega_of(bodies, slot);
        const scalar extent = least_half_extent(shapes.surface(of_pair[which]).shape, shapes.hull(of_pair[which]));
        least_extent = min(least_extent, extent);
        if (paths[slot].fast) least_fast = min(least_fast, extent);
    }
    const scalar deep = limits::skin_share * least_fast;
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        if (manifold.points[point_i].separation < -deep) return false;
        const Vector& P = manifold.points[point_i].P;
        closing = max(closing, -dot(manifold.n, v[0] + cross(omega[0], P - r[0]) - v[1] - cross(omega[1], P - r[1])));
    }
    bool tilts = false;
    for (const Vector& one : omega) tilts = tilts || length_sq(cross(one, manifold.n)) * h * h > limits::angle_per_path * limits::angle_per_path / 4;
    return tilts || closing * h > limits::skin_share * least_extent;
}

void end_path(BodyPath& path, const Vector& r_CM, const Matrix& A, scalar t) {
    path.r_CM = r_CM;
    path.A = A;
    path.way = path.fall = path.turn = {};
    path.from = t;
    path.until = 1;
    path.next = never;
    path.fast = path.falls_free = false;
}

} }  // namespace ingot
