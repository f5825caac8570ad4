// SPDX-License-Identifier: MIT
#include "time_of_impact.h"

#include "../base/limits.h"
#include "../narrow_phase/plane_between.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Two shapes at a time, seen from the centre of mass of B's body: what is far from the origin loses no more digits.
struct Approach {
    PlacedShape A, B;
    Vector r;     ///< m, the centre of mass of A's body
    Vector v, a;  ///< m, per step and step^2; of A's body against B's
    scalar R_A, R_B;
};

Vector way_at(const BodyPath& path, scalar t) { return path.way + path.fall * (2 * (t - path.from)); }

Approach approach_at(const ShapeOnPath& A, const ShapeOnPath& B, scalar t) {
    const PathFrame frame_A = frame_on_path(A.path, t), frame_B = frame_on_path(B.path, t);
    const Vector r = frame_A.r_CM - frame_B.r_CM;
    return {place_on_body(A.shape, A.place, A.hull, r, frame_A.A), place_on_body(B.shape, B.place, B.hull, {}, frame_B.A), r,
            way_at(A.path, t) - way_at(B.path, t), (A.path.fall - B.path.fall) * scalar(2), A.radius, B.radius};
}

/// The gap that is as good as none.
scalar meeting_gap(const Approach& now, scalar least, scalar unit, const Vector& r_A, const Vector& r_B) {
    const scalar roundings = 4 * epsilon * (sum_of_components(now.r) + sum_of_components(r_A) + sum_of_components(r_B) + now.R_A + now.R_B);
    return min(limits::impact_gap * least, limits::impact_gap_max * unit) + roundings;
}

/// The most that a point of a shape that turns about r moves along m / |turn|: m . p of the point furthest along m.
scalar reach_along(const PlacedShape& s, const Vector& r, const Vector& m) {
    const scalar length = sqrt(length_sq(m));
    return length > 0 ? dot(m, support_point(s, m * (1 / length)) - r) : 0;
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
    const scalar turning = reach_along(A, now.r, cross(turn_A, n)) + (spin_B > 0 ? reach_along(now.B, {}, cross(n, turn_B)) : 0);
    const scalar bend = spin_A * spin_A * now.R_A + spin_B * spin_B * now.R_B;
    const scalar rate = min(closing_rate(closing + turning, bend + fall, gap),
                               closing_rate(closing + spin_A * now.R_A + spin_B * now.R_B, fall, gap));
    return rate * never > 2 * gap ? 2 * gap / rate : never;
}

/// The shape without some of its skins. A hull shrinks about its centre, by the axes that it is seen along.
PlacedShape core_of(const PlacedShape& s, int skins) {
    const scalar left = 1 - limits::skin_share * static_cast<scalar>(skins);
    if (s.hull == nullptr) return {{s.shape.kind, s.shape.size * left, s.shape.offset}, s.r, s.A, nullptr};
    return {s.shape, s.r + s.A * s.hull->centre * (1 - left), s.A * left, s.hull};
}

/// The ball about the centre that is half as large as the shape is thick.
PlacedShape ball_in(const PlacedShape& s, scalar least) {
    return {Sphere{least * scalar(0.5)}, s.hull == nullptr ? s.r : s.r + s.A * s.hull->centre, s.A, nullptr};
}

bool is_clear(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest, scalar gap) {
    return !nearest.overlap && plane_between(A, B, nearest).gap > gap;
}

}  // namespace

scalar time_of_impact(const ShapeOnPath& A, const ShapeOnPath& B, scalar unit, scalar latest, bool unsolved) {
    const BodyPath &path_A = A.path, &path_B = B.path;
    const scalar least_A = least_half_extent(A.shape, A.hull), least = min(least_A, least_half_extent(B.shape, B.hull));
    scalar t = path_A.from > path_B.from ? path_A.from : path_B.from;
    bool touching = true, deep = false;  // until they are seen apart
    int skins = 1;
    for (int approach_i = 0; approach_i < limits::approaches_max; ++approach_i) {
        const Approach now = approach_at(A, B, t);
        const scalar gap = meeting_gap(now, least, unit, path_A.r_CM, path_B.r_CM);
        PlacedShape A_now = deep ? ball_in(now.A, least_A) : now.A;
        Nearest nearest = closest_points(A_now, now.B);
        if (nearest.overlap && (deep || !touching)) return deep && approach_i == 0 ? never : t;
        PlaneBetween plane = {};
        if (!nearest.overlap) plane = plane_between(A_now, now.B, nearest);
        touching = touching && plane.gap <= gap;
        if (touching) {
            A_now = core_of(now.A, skins);
            nearest = closest_points(A_now, now.B);
            // bound: limits::skins_max: ++skins
            while (approach_i == 0 && !is_clear(A_now, now.B, nearest, gap) && skins < limits::skins_max) {
                A_now = core_of(now.A, ++skins);
                nearest = closest_points(A_now, now.B);
            }
            if (nearest.overlap && approach_i == 0) {
                deep = true;
                A_now = ball_in(now.A, least_A);
                nearest = closest_points(A_now, now.B);
                if (nearest.overlap) return never;
            }
            if (nearest.overlap) return t;
            plane = plane_between(A_now, now.B, nearest);
            if (approach_i == 0 && unsolved && !deep) {
                const scalar skin = limits::skin_share * least;
                const Vector v = now.v + cross(path_A.turn, nearest.P_A - now.r) - cross(path_B.turn, nearest.P_B);
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
