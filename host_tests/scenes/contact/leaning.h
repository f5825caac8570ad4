// SPDX-License-Identifier: MIT
// Structures that friction and thrust hold up: card house, arch, leaning plank; dominoes, and a rod that may jam.
#pragma once

#include "placed_body.h"

namespace scenes {

// Least friction of the card house of three levels and of the arch of 13 stones, thickness 0.2: of the exact solution of one
// step from rest, see contact_scenes_test.cpp.
constexpr double card_house_least_mu = 0.365, arch_least_mu = 0.306;

/// C10: a house of cards of 1 x 0.6 x 0.04 m and 1 kg. A level has pairs of cards that lean on each other at 25 degrees from
/// the upright, edge to edge, and cards laid across from ridge to ridge; the level above stands on those, its feet next to the
/// ridges so that the laid cards hardly bear. Levels 3: 6 pairs and 3 cards across.
///
/// Criterion: three levels stand for 60 s at 1.1 card_house_least_mu and above, and fall at 0.9. Where two edges
/// meet that number takes both faces' normals. One level: (tan(angle) - thickness / length) / 2 = 0.2132.
template <int levels, int mu_percent>
struct CardHouse : OnEarth {
    static constexpr const char* name = "card_house";
    static constexpr int pair_count = levels * (levels + 1) / 2, across_count = levels * (levels - 1) / 2;
    static constexpr int body_count = 1 + 2 * pair_count + across_count;
    static constexpr scalar seconds = 60;
    static constexpr scalar mu = scalar(mu_percent) / 100;

    static constexpr scalar length = 1, width = scalar(0.6), thickness = scalar(0.04), spare = scalar(0.01);
    static constexpr scalar angle = scalar(0.43633231299858239423);  ///< 25 degrees
    static constexpr scalar s = scalar(0.42261826174069943619), c = scalar(0.90630778703664996324);
    static constexpr scalar pitch = 2 * (length * s + thickness * c) + spare;  ///< from ridge to ridge
    static constexpr scalar pair_height = length * c + thickness * s;

    /// Cards of a level, pairs first: left, right, left, right, ..., then those across.
    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        int level = 0, card_i = body_i - 1;
        while (card_i >= 3 * (levels - level) - 1) card_i -= 3 * (levels - level++) - 1;
        const int pairs = levels - level;
        const scalar floor = static_cast<scalar>(level) * (pair_height + thickness);
        const auto ridge = [&](int pair_i) {
            return pitch * (static_cast<scalar>(pair_i) + static_cast<scalar>(level - levels + 1) / 2);
        };
        if (card_i >= 2 * pairs) {
            const scalar x = ridge(card_i - 2 * pairs) + pitch / 2;
            return solid_box(1, {(pitch - spare) / 2, width / 2, thickness / 2}, {x, 0, floor + pair_height + thickness / 2},
                             mu);
        }
        const scalar side = card_i % 2 == 0 ? scalar(-1) : scalar(1);
        const scalar x = ridge(card_i / 2) + side * (thickness * c + length * s) / 2;
        PlacedBody card = solid_box(1, {thickness / 2, width / 2, length / 2}, {x, 0, floor + pair_height / 2}, mu);
        card.turn(ingot::axis_angle({0, 1, 0}, -side * angle));
        return card;
    }
};

/// C10: a semicircular arch of equal voussoirs, mean radius 1 m, depth 0.5 m, thickness in permille of the radius, 2000 kg
/// m^-3, on flat ground. Its stones are hulls: prisms over isosceles trapezoids.
///
/// Criterion: stands for 60 s where the thickness is above the least one and falls at 0.9 of it, given friction enough. For
/// infinitely many stones the least is 0.1075 of the mean radius (Milankovitch 1907); joints at finite places allow a little
/// less: 13 stones stand at 0.105 and not at 0.100. Friction: at a thickness of 0.2 at least arch_least_mu.
template <int voussoirs, int thickness_permille, int mu_percent>
struct Arch : OnEarth {
    static constexpr const char* name = "arch";
    static constexpr int body_count = 1 + voussoirs;
    static constexpr scalar seconds = 60;
    static constexpr scalar mu = scalar(mu_percent) / 100;
    static constexpr scalar half_depth = scalar(0.25), density = 2000;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        constexpr scalar pi = scalar(3.14159265358979323846), t = scalar(thickness_permille) / 1000;
        constexpr scalar r_in = 1 - t / 2, r_out = 1 + t / 2, half_angle = pi / (2 * voussoirs);
        constexpr ingot::SinCos joint = ingot::sin_cos(half_angle);
        // The trapezoid: half widths a inside and b outside, H high along the radius, its centroid z_c above the inner side.
        constexpr scalar a = r_in * joint.sin, b = r_out * joint.sin, H = t * joint.cos;
        constexpr scalar area = (a + b) * H, z_c = H * (a + 2 * b) / (3 * (a + b));
        constexpr scalar M = density * area * 2 * half_depth;
        // Means of the squares of x (along the joint's normal), y and z about the centroid.
        constexpr scalar xx = H * (a + b) * (a * a + b * b) / 6 / area, yy = half_depth * half_depth / 3;
        constexpr scalar zz = 2 * H * H * H * (a / 12 + b / 4) / area - z_c * z_c;

        PlacedBody stone;
        stone.def.mass = {M, {M * (yy + zz), M * (xx + zz), M * (xx + yy)}, {}, ingot::identity_matrix<scalar>()};
        stone.mu = mu;
        stone.is_hull = true;
        for (int corner_i = 0; corner_i < 8; ++corner_i) {
            const bool outside = (corner_i & 4) != 0;
            const scalar x = outside ? b : a, y = half_depth;
            stone.corner[corner_i] = {(corner_i & 1) != 0 ? x : -x, (corner_i & 2) != 0 ? y : -y, outside ? H - z_c : -z_c};
        }
        // From the right springing (angle 0, along x) over the crown (pi / 2, along z) to the left.
        const ingot::SinCos at = ingot::sin_cos(half_angle * static_cast<scalar>(2 * (body_i - 1) + 1));
        const Vector radial = {at.cos, 0, at.sin};
        stone.def.state.r_CM = radial * (r_in * joint.cos + z_c);
        stone.turn({{at.sin, 0, -at.cos}, {0, 1, 0}, radial});
        return stone;
    }
};

/// C11: a plank of 2 x 0.3 x 0.02 m leans on a smooth wall (the plane x = 0, mu 0), `degrees` from the ground.
///
/// Criterion: sticks at 1.02 mu_least and slips at 0.98 mu_least. mu_least is where the thrust of the wall balances the weight
/// about the lower edge; for a thin plank 1 / (2 tan(theta)).
template <int degrees>
struct LeaningPlank : OnEarth {
    static constexpr const char* name = "leaning_plank";
    static constexpr int body_count = 3;
    static constexpr scalar seconds = 10;
    static constexpr scalar half_length = 1, half_thickness = scalar(0.01);
    static constexpr scalar angle = scalar(degrees) * scalar(0.01745329251994329577);
    static constexpr ingot::SinCos a = ingot::sin_cos(angle);

    // It goes down to the right: its axis is (cos, 0, -sin), its upper side looks to (sin, 0, cos).
    static constexpr scalar edge_x = half_length * a.cos - half_thickness * a.sin;  ///< lower edge beyond the centre
    static constexpr scalar height = 2 * half_length * a.sin;                       ///< of the upper contact over the lower
    static constexpr scalar mu_least = edge_x / height;

    static constexpr PlacedBody body(int body_i, scalar mu) {
        if (body_i == 0) return flat_ground(mu);
        if (body_i == 1) return half_space({1, 0, 0}, 0, 0);
        const Vector r_CM = {half_length * a.cos + half_thickness * a.sin, 0, half_length * a.sin + half_thickness * a.cos};
        PlacedBody plank = solid_box(1, {half_length, scalar(0.15), half_thickness}, r_CM, mu);
        plank.turn({{a.cos, 0, -a.sin}, {0, 1, 0}, {a.sin, 0, a.cos}});
        return plank;
    }
};

/// C10: dominoes of 1 x 0.5 x 0.1 m and 1 kg, 0.4 m apart; the first is given 1 rad/s about its lower edge (0.38 would do).
///
/// Criterion: all fall, each on the next, the last one flat; energy never grows; the time until the last one moves converges
/// with h.
template <int count>
struct Dominoes : OnEarth {
    static constexpr const char* name = "dominoes";
    static constexpr int body_count = 1 + count;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        constexpr Vector half = {scalar(0.05), scalar(0.25), scalar(0.5)};
        PlacedBody domino = solid_box(1, half, {static_cast<scalar>(body_i - 1) * scalar(0.4), 0, half.z}, mu);
        if (body_i == 1) domino.move({half.z, 0, half.x}, {0, 1, 0});
        return domino;
    }
};

/// C15: a plank of 2 x 0.4 x 0.1 m and 10 kg balances flat on the upper edge of an immovable bar turned by 45 degrees, its
/// length at yaw_microrad to the edge: from crossed (1570796) through all but parallel to parallel (0).
///
/// Criterion: over ten steps |omega| <= 1e-4 rad/s at every yaw: the normal stays vertical, no torque comes from nowhere.
template <int yaw_microrad>
struct PlankOnEdge : OnEarth {
    static constexpr const char* name = "plank_on_edge";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = scalar(10) / 60;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar half = scalar(0.2), root_half = scalar(0.70710678118654752440);
        if (body_i == 0) {
            PlacedBody bar = fixed_box({2, half, half}, {0, 0, 0}, mu);
            bar.turn({{1, 0, 0}, {0, root_half, root_half}, {0, -root_half, root_half}});
            return bar;
        }
        PlacedBody plank = solid_box(10, {1, scalar(0.2), scalar(0.05)}, {0, 0, 2 * half * root_half + scalar(0.05)}, mu);
        plank.turn(ingot::axis_angle({0, 0, 1}, scalar(yaw_microrad) * scalar(1e-6)));
        return plank;
    }
};

/// C14: a thin rod of 1 m slides on its lower end at 2 m/s, that end ahead, `degrees` from the ground. Friction digs the end
/// in: above mu = (1 + 3 cos^2) / (3 sin cos) no force of rigid friction is consistent (Painleve); least 4/3, 1.347 at 60
/// degrees.
///
/// Criterion: no NaN, no divergence; an impulse or a documented stick; energy does not grow.
template <int degrees, int mu_percent>
struct SlidingRod : OnEarth {
    static constexpr const char* name = "sliding_rod";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = 2;
    static constexpr scalar mu = scalar(mu_percent) / 100;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        constexpr ingot::SinCos a = ingot::sin_cos(scalar(degrees) * scalar(0.01745329251994329577));
        constexpr scalar half = scalar(0.5), thin = scalar(0.005);
        PlacedBody rod = solid_box(1, {half, thin, thin}, {0, 0, half * a.sin + thin * a.cos}, mu);
        rod.turn({{a.cos, 0, a.sin}, {0, 1, 0}, {-a.sin, 0, a.cos}});
        rod.move({-2, 0, 0});
        return rod;
    }
};

}  // namespace scenes
