// SPDX-License-Identifier: MIT
#include "time_of_impact.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "parting_plane.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A turn as the points of a shape notice it, rad in the step.
struct Spin {
    Vector turn;      ///< of the body
    Vector of_shape;  ///< what of it is seen on the surface
    Vector arm;       ///< m, from the body's centre of mass to the origin of the shape
    scalar bend;      ///< m; at most so far points are bent off their way, in units of step^-2
    scalar fastest;   ///< m; the fastest point, per step
};

/// Two shapes at a time, seen from the centre of mass of B's body: what is far from the origin loses no more digits.
struct Approach {
    PlacedShape A, B;
    Vector r;     ///< m, the centre of mass of A's body
    Vector v, a;  ///< m, per step and step^2; of A's body against B's
    Spin spin_A, spin_B;
};

Vector way_at(const BodyPath& path, scalar t) { return path.way + path.fall * (2 * (t - path.from)); }

Spin spin_of(const PlacedShape& s, const Vector& r_CM, const Vector& turn, scalar radius) {
    Vector of_shape = turn;
    if (s.shape.kind == ShapeKind::sphere) of_shape = {};
    if (s.shape.kind == ShapeKind::capsule || s.shape.kind == ShapeKind::cylinder) of_shape = turn - s.A.c2 * dot(s.A.c2, turn);
    const Vector arm = s.r - r_CM;
    const scalar angle = sqrt(length_sq(turn)), seen = sqrt(length_sq(of_shape)), away = sqrt(length_sq(arm));
    return {turn, of_shape, arm, angle * (angle * away + seen * radius), angle * away + seen * radius};
}

Approach approach_at(const ShapeOnPath& A, const ShapeOnPath& B, scalar t) {
    const PathFrame frame_A = frame_on_path(A.path, t), frame_B = frame_on_path(B.path, t);
    const Vector r = frame_A.r_CM - frame_B.r_CM;
    Approach now;
    now.A = place_on_body(A.shape, A.place, A.hull, r, frame_A.A);
    now.B = place_on_body(B.shape, B.place, B.hull, {}, frame_B.A);
    now.r = r;
    now.v = way_at(A.path, t) - way_at(B.path, t);
    now.a = (A.path.fall - B.path.fall) * scalar(2);
    now.spin_A = spin_of(now.A, r, A.path.turn, A.radius);
    now.spin_B = spin_of(now.B, {}, B.path.turn, B.radius);
    return now;
}

/// The gap that is as good as none.
scalar meeting_gap(const Approach& now, const ShapeOnPath& A, const ShapeOnPath& B, scalar least, scalar unit) {
    const scalar sizes = sum_of_components(now.r) + sum_of_components(A.path.r_CM) + sum_of_components(B.path.r_CM) + A.radius + B.radius;
    return min(limits::impact_gap * least, limits::impact_gap_max * unit) + 4 * epsilon * sizes;
}

/// How fast the point of a shape that turns so comes along m x turn, at most.
scalar reach_along(const PlacedShape& s, const Spin& spin, const Vector& m) {
    const scalar of_arm = dot(cross(spin.turn, m), spin.arm);
    const Vector along = cross(spin.of_shape, m);
    const scalar length = sqrt(length_sq(along));
    return length > 0 ? of_arm + dot(along, support_point(s, along * (1 / length)) - s.r) : of_arm;
}

/// Twice the gap over this is a time in which it does not close.
scalar closing_rate(scalar speed, scalar bend, scalar gap) {
    const scalar square = speed * speed + 2 * bend * gap;
    return speed + sqrt(square > 0 ? square : 0);
}

/// How long a gap at the plane n stays open, at least; `never` if it does not close.
scalar time_open(const Approach& now, const Vector& n, scalar gap) {
    const scalar closing = -dot(n, now.v), pull = -dot(n, now.a), fall = pull > 0 ? pull : 0;
    const scalar turning = reach_along(now.A, now.spin_A, n) + (now.spin_B.fastest > 0 ? reach_along(now.B, now.spin_B, -n) : 0);
    const scalar rate = min(closing_rate(closing + turning, now.spin_A.bend + now.spin_B.bend + fall, gap),
                            closing_rate(closing + now.spin_A.fastest + now.spin_B.fastest, fall, gap));
    return rate * never > 2 * gap ? 2 * gap / rate : never;
}

TimeOfImpact at_time(TimeOfImpact impact, scalar t) {
    impact.t = t;
    return impact;
}

}  // namespace

TimeOfImpact time_of_impact(const ShapeOnPath& A, const ShapeOnPath& B, const ImpactSearch& search) {
    const scalar least = min(least_half_extent(A.shape, A.hull), least_half_extent(B.shape, B.hull)), skin = limits::skin_share * least;
    TimeOfImpact impact = {max(search.since, max(A.path.from, B.path.from)), true, {}, {}};
    scalar depth = skin, room = 0;
    bool touching = true;  // until they are seen apart
    for (int approach_i = 0; approach_i < limits::approaches_max; ++approach_i) {
        const Approach now = approach_at(A, B, impact.t);
        const scalar gap = meeting_gap(now, A, B, least, search.unit);
        PlaneBetween plane = {impact.n, approach_i > 0 ? gap_along(now.A, now.B, impact.n) : scalar(0)};
        const auto room_at = [&] { return touching ? plane.gap + depth + gap / 2 : plane.gap; };
        // The direction of the look before does as long as it leaves half of the room that it had then.
        const bool looks_anew = approach_i == 0 || 2 * room_at() < room || (touching && !(plane.gap < 0));
        if (looks_anew) {
            const Nearest nearest = closest_points(now.A, now.B);
            impact.P = frame_on_path(B.path, impact.t).r_CM + (nearest.P_A + nearest.P_B) * scalar(0.5);
            if (nearest.overlap && !touching) return impact;
            const PartingPlane parting = parting_plane(now.A, now.B, nearest);
            if (!parting.found) return at_time(impact, approach_i == 0 ? never : impact.t);
            plane = parting.plane;
        }
        touching = touching && plane.gap <= max(gap, search.touch);
        if (approach_i == 0) {
            impact.touched = touching;
            depth = max(skin, -plane.gap);
        }
        impact.n = plane.n;
        const scalar left = room_at();
        if (approach_i > 0 && left <= (touching ? gap / 4 : gap)) return impact;
        if (looks_anew) room = left;
        const scalar next = impact.t + time_open(now, plane.n, left);
        if (next > search.latest) return at_time(impact, never);
        impact.t = next;
    }
    return impact;
}

bool may_meet(const ShapeOnPath& A, const ShapeOnPath& B, scalar unit) {
    if (B.shape.kind == ShapeKind::half_space) return true;
    const BodyPath &path_A = A.path, &path_B = B.path;
    const scalar begin = path_A.from > path_B.from ? path_A.from : path_B.from;
    const scalar end = min(path_A.until, path_B.until);
    const auto place = [](const BodyPath& path, scalar t) { return path.r_CM + (path.way + path.fall * (t - path.from)) * (t - path.from); };
    const Vector between = place(path_A, begin) - place(path_B, begin), way = place(path_A, end) - place(path_B, end) - between;
    const scalar way_sq = length_sq(way), along = -dot(between, way);
    const scalar t = along > 0 ? (along < way_sq ? along / way_sq : scalar(1)) : scalar(0);
    // A parabola leaves its chord by a quarter of the fall.
    const scalar bulge = (sum_of_components(path_A.fall) + sum_of_components(path_B.fall)) * scalar(0.25);
    const scalar reach = (A.radius + B.radius) * (1 + limits::flatness) + bulge + limits::impact_gap_max * unit +
                         8 * epsilon * (sum_of_components(path_A.r_CM) + sum_of_components(path_B.r_CM) + sum_of_components(way));
    return length_sq(between + way * t) <= reach * reach;
}

} }  // namespace ingot
