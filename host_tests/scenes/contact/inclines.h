// SPDX-License-Identifier: MIT
// One body on a plane, against closed forms (host_tests/reference/ball_and_brick.h): incline, bricks, spheres.
#pragma once

#include "placed_body.h"

namespace scenes {

/// A plane through the origin that falls towards +x: down = (cos, 0, -sin) along it, up = (sin, 0, cos) away from it.
struct Slope {
    scalar sin_alpha, cos_alpha;

    constexpr Vector down() const { return {cos_alpha, 0, -sin_alpha}; }
    constexpr Vector up() const { return {sin_alpha, 0, cos_alpha}; }
    constexpr ingot::Matrix A() const { return {down(), {0, 1, 0}, up()}; }
};

constexpr Slope thirty_degrees = {scalar(0.5), scalar(0.86602540378443864676)};

/// S7: the unit cube at rest on 30 degrees.
///
/// Criterion: mu 0.7 creeps <= 0.001 mm in 10 s; mu 0.4: distance after 2 s, g (sin - mu cos) t^2 / 2 = 3.0139 m, within 0.001
/// %. Best published at 60 Hz: creep 0.02 mm (Jolt), distance +0.67 % (Box3D), +0.83 % (Jolt, ODE, ReactPhysics3D, qu3e).
template <int mu_percent>
struct Incline : OnEarth {
    static constexpr const char* name = "incline";
    static constexpr int body_count = 2;
    static constexpr scalar mu = scalar(mu_percent) / 100;
    static constexpr scalar seconds = mu_percent > 57 ? 10 : 2;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return half_space(thirty_degrees.up(), 0, mu);
        PlacedBody cube = unit_cube(thirty_degrees.up() * scalar(0.5), mu);
        cube.turn(thirty_degrees.A());
        return cube;
    }
};

/// A case of the tables brick_on_incline and sphere_on_incline: gravity 9.8125, the body touches the plane.
struct SlopeCase {
    const char* table_case;
    scalar mu;
    Slope slope;
    scalar v_0;     ///< m/s, down the slope
    scalar radius;  ///< m; 0: a brick, 1 x 0.8 x 0.2 m, which does not tip
    scalar seconds;

    static constexpr Vector gravity = {0, 0, scalar(-9.8125)};

    constexpr PlacedBody body(int body_i) const {
        if (body_i == 0) return half_space(slope.up(), 0, mu);
        if (radius > 0) {
            PlacedBody ball = solid_ball(1, radius, slope.up() * radius, mu);
            ball.move(slope.down() * v_0);
            return ball;
        }
        PlacedBody brick = solid_box(1, {scalar(0.5), scalar(0.4), scalar(0.1)}, slope.up() * scalar(0.1), mu);
        brick.turn(slope.A());
        brick.move(slope.down() * v_0);
        return brick;
    }
};

constexpr Slope flat = {0, 1}, three_four = {scalar(0.6), scalar(0.8)}, five_twelve = {scalar(5) / 13, scalar(12) / 13};
constexpr Slope one_eighth = {scalar(0.12403473458920846156), scalar(0.99227787671366769248)};  // 1 and 8 over sqrt 65

/// C5. Criterion: t_stop within 1 step, stop distance within 1 %.
constexpr SlopeCase brick_cases[] = {{"stop_on_flat", scalar(0.25), flat, 4, 0, 4},
                                     {"down_stops", scalar(0.5), five_twelve, 2, 0, 4},
                                     {"down_accelerates", scalar(0.25), three_four, scalar(0.5), 0, 2},
                                     {"up_and_back", scalar(0.25), three_four, -5, 0, 3},
                                     {"up_and_stick", scalar(0.875), three_four, -5, 0, 2},
                                     {"rest_sticks", scalar(0.78125), three_four, 0, 0, 2}};

/// C1, C2. Criterion: s(2 s) within 0.5 %, slip of a rolling ball <= 1e-3 m/s; the right side of tan = 7/2 mu at +-1 % of mu.
constexpr SlopeCase sphere_incline_cases[] = {{"roll", scalar(0.5), three_four, 0, scalar(0.5), 2},
                                              {"slide", scalar(0.125), three_four, 0, scalar(0.5), 2},
                                              {"threshold", scalar(3) / 14, three_four, 0, scalar(0.5), 2},
                                              {"gentle", scalar(0.25), one_eighth, 0, scalar(0.125), 4}};

/// A case of sphere_on_plane: set down sliding and spinning. `shell` has k = 2/3, which only its mass shows.
///
/// C3. Criterion: final velocity within 0.2 %, t_roll within 1 step, direction constant within 1e-3 rad. C4: rolling 60 s loses
/// < 0.1 % of the speed.
struct SpherePlaneCase {
    const char* table_case;
    scalar mu, radius, k;
    Vector v, omega;
    scalar seconds;

    static constexpr Vector gravity = {0, 0, scalar(-9.8125)};

    constexpr PlacedBody body(int body_i) const {
        if (body_i == 0) return flat_ground(mu);
        PlacedBody ball = solid_ball(1, radius, {0, 0, radius}, mu);
        const scalar I = k * radius * radius;
        ball.def.mass.I_body = {I, I, I};
        ball.move(v, omega);
        return ball;
    }
};

constexpr SpherePlaneCase sphere_plane_cases[] = {
    {"backspin", scalar(0.25), scalar(0.5), scalar(0.4), {3, 0, 0}, {0, -8, 0}, 8},
    {"oblique", scalar(0.125), scalar(0.25), scalar(0.4), {2, 1, 0}, {6, 0, 4}, 8},
    {"shell", scalar(0.5), scalar(0.5), scalar(2) / 3, {4, -1, 0}, {0, 0, 0}, 8}};

/// C7: a flat brick pushed off at 3 m/s at `degrees` to its edges. Criterion: the spread of stopping distances v^2 / (2 mu g)
/// over 0 .. 90 degrees < 1 % (a pyramid for a cone: 41 %).
constexpr PlacedBody brick_pushed_at(int body_i, scalar degrees, scalar mu) {
    if (body_i == 0) return flat_ground(mu);
    PlacedBody brick = solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.01)}, {0, 0, scalar(0.01)}, mu);
    const ingot::SinCos direction = ingot::sin_cos(degrees * scalar(0.01745329251994329577));
    brick.move({3 * direction.cos, 3 * direction.sin, 0});
    return brick;
}

/// C13: a box of width w and height H on a slope; it topples where tan(alpha) > w / H. Criterion: right at +-2 %.
constexpr PlacedBody box_that_may_topple(int body_i, const Slope& slope, scalar width, scalar height) {
    if (body_i == 0) return half_space(slope.up(), 0, 2);
    PlacedBody box = solid_box(1, {width / 2, scalar(0.5), height / 2}, slope.up() * (height / 2), 2);
    box.turn(slope.A());
    return box;
}

}  // namespace scenes
