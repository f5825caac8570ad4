// SPDX-License-Identifier: MIT
#include "time_of_impact.h"

#include "../base/limits.h"
#include "../narrow_phase/plane_between.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

scalar sum_of_extents(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// Two bodies at a time, A seen from B: what is far from the origin loses no more digits.
struct Approach {
    PlacedShape A, B;
    Vector v, a;  ///< m, per step and step^2; of A against B
    scalar R_A, R_B;
};

Vector way_at(const BodyPath& path, scalar t) { return path.way + path.fall * (2 * (t - path.from)); }

Approach approach_at(const BodyPath& path_A, const Shape& A, const BodyPath& path_B, const Shape& B, scalar t) {
    Approach now = {place_on_path(path_A, A, t), place_on_path(path_B, B, t), way_at(path_A, t) - way_at(path_B, t),
                    (path_A.fall - path_B.fall) * scalar(2), bounding_radius(A), bounding_radius(B)};
    now.A.r -= now.B.r;
    now.B.r = {};
    return now;
}

/// The gap that is as good as none.
scalar meeting_gap(const Approach& now, const Vector& r_A, const Vector& r_B) {
    const scalar least = min(least_half_extent(now.A.shape), least_half_extent(now.B.shape));
    const scalar roundings = 4 * epsilon * (sum_of_extents(now.A.r) + sum_of_extents(r_A) + sum_of_extents(r_B) + now.R_A + now.R_B);
    return min(limits::impact_gap * least, limits::impact_gap_max) + roundings;
}

/// The most that a point of a turning shape moves along m / |turn|: m . p of the point furthest along m.
scalar reach_along(const PlacedShape& s, const Vector& m) {
    const scalar length = sqrt(length_sq(m));
    return length > 0 ? dot(m, support_point(s, m * (1 / length)) - s.r) : 0;
}

/// Twice the gap over this is a time in which it does not close.
scalar closing_rate(scalar speed, scalar bend, scalar gap) {
    const scalar square = speed * speed + 2 * bend * gap;
    return speed + sqrt(square > 0 ? square : 0);
}

/// How long a gap at the plane n stays open, at least; `never` if it does not close.
scalar time_open(const Approach& now, const Vector& turn_A, const Vector& turn_B, const PlacedShape& A, const Vector& n, scalar gap) {
    const scalar closing = -dot(n, now.v), pull = -dot(n, now.a), fall = pull > 0 ? pull : 0;
    const scalar spin_A = sqrt(length_sq(turn_A)), spin_B = sqrt(length_sq(turn_B));
    const scalar turning = reach_along(A, cross(turn_A, n)) + (spin_B > 0 ? reach_along(now.B, cross(n, turn_B)) : 0);
    const scalar bend = spin_A * spin_A * now.R_A + spin_B * spin_B * now.R_B;
    const scalar rate = min(closing_rate(closing + turning, bend + fall, gap),
                               closing_rate(closing + spin_A * now.R_A + spin_B * now.R_B, fall, gap));
    return rate * never > 2 * gap ? 2 * gap / rate : never;
}

Shape core_of(const Shape& shape, int skins) {
    return {shape.kind, shape.size * (1 - limits::skin_share * static_cast<scalar>(skins)), shape.offset};
}

/// The ball about the centre that is half as large as the shape is thick.
Shape ball_in(const Shape& shape) { return Sphere{least_half_extent(shape) * scalar(0.5)}; }

bool is_clear(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest, scalar gap) {
    return !nearest.overlap && plane_between(A, B, nearest).gap > gap;
}

}  // namespace

scalar time_of_impact(const BodyPath& path_A, const Shape& A, const BodyPath& path_B, const Shape& B, scalar latest, bool unsolved) {
    scalar t = path_A.from > path_B.from ? path_A.from : path_B.from;
    bool touching = true, deep = false;  // until they are seen apart
    int skins = 1;
    for (int approach_i = 0; approach_i < limits::approaches_max; ++approach_i) {
        const Approach now = approach_at(path_A, A, path_B, B, t);
        const scalar gap = meeting_gap(now, path_A.r_CM, path_B.r_CM);
        PlacedShape A_now = now.A;
        if (deep) A_now.shape = ball_in(A);
        Nearest nearest = closest_points(A_now, now.B);
        if (nearest.overlap && (deep || !touching)) return deep && approach_i == 0 ? never : t;
        PlaneBetween plane = {};
        if (!nearest.overlap) plane = plane_between(A_now, now.B, nearest);
        touching = touching && plane.gap <= gap;
        if (touching) {
            A_now.shape = core_of(A, skins);
            nearest = closest_points(A_now, now.B);
            // bound: limits::skins_max: ++skins
            while (approach_i == 0 && !is_clear(A_now, now.B, nearest, gap) && skins < limits::skins_max) {
                A_now.shape = core_of(A, ++skins);
                nearest = closest_points(A_now, now.B);
            }
            if (nearest.overlap && approach_i == 0) {
                deep = true;
                A_now.shape = ball_in(A);
                nearest = closest_points(A_now, now.B);
                if (nearest.overlap) return never;
            }
            if (nearest.overlap) return t;
            plane = plane_between(A_now, now.B, nearest);
            if (approach_i == 0 && unsolved && !deep) {
                const scalar skin = limits::skin_share * min(least_half_extent(A), least_half_extent(B));
                const Vector v = now.v + cross(path_A.turn, nearest.P_A - now.A.r) - cross(path_B.turn, nearest.P_B);
                if (-dot(plane.n, v) * (1 - t) > skin) return t;
            }
            touching = !deep;
        }
        const bool leaves = !(dot(plane.n, now.v) < 0);
        if (plane.gap <= gap) return approach_i == 0 && (touching || (deep && leaves)) ? never : t;
        const scalar open = time_open(now, path_A.turn, path_B.turn, A_now, plane.n, plane.gap - gap / 2);
        if (t + open > latest) return never;
        t += open;
    }
    return t;
}

bool may_meet(const BodyPath& path_A, const Surface& A, const BodyPath& path_B, const Surface& B) {
    if (B.shape.kind == ShapeKind::half_space) return true;
    const scalar begin = path_A.from > path_B.from ? path_A.from : path_B.from;
    const scalar end = min(path_A.until, path_B.until);
    const auto place = [](const BodyPath& path, scalar t) { return path.r_CM + (path.way + path.fall * (t - path.from)) * (t - path.from); };
    const Vector between = place(path_A, begin) - place(path_B, begin), way = place(path_A, end) - place(path_B, end) - between;
    const scalar way_sq = length_sq(way), along = -dot(between, way);
    const scalar t = along > 0 ? (along < way_sq ? along / way_sq : scalar(1)) : scalar(0);
    // A parabola leaves its chord by a quarter of the fall.
    const scalar bulge = (sum_of_extents(path_A.fall) + sum_of_extents(path_B.fall)) * scalar(0.25);
    const scalar reach = (A.bounding_radius + B.bounding_radius) * (1 + limits::flatness) + bulge + limits::impact_gap_max +
                         8 * epsilon * (sum_of_extents(path_A.r_CM) + sum_of_extents(path_B.r_CM) + sum_of_extents(way));
    return length_sq(between + way * t) <= reach * reach;
}

} }  // namespace ingot
