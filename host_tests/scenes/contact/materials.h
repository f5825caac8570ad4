// SPDX-License-Identifier: MIT
// Surfaces that resist being rolled, and belts: a ball, a box, and a line of conveyors.
#pragma once

#include "inclines.h"

namespace scenes {

/// A body beside what it is made of.
struct MaterialBody {
    PlacedBody body;
    scalar rolling_lever = 0;      ///< m
    Vector surface_velocity = {};  ///< m/s, body axes
};

/// A box of 1 x 1 x 0.4 m that lies on the ground or on an incline.
constexpr PlacedBody parcel(const Slope& slope, scalar mu) {
    PlacedBody box = solid_box(2, {scalar(0.5), scalar(0.5), scalar(0.2)}, slope.up() * scalar(0.2), mu);
    box.turn(slope.A());
    return box;
}

/// An incline that carries parcels up to a table that carries them on, balls that roll to rest on it, and a crawler on the ground.
///
/// Parcels start at rest on the incline of 3 : 4, whose belt moves up; the table's moves across. Every ball resists rolling by another lever.
struct ConveyorLine {
    static constexpr int body_count = 16;

    static constexpr MaterialBody body(int body_i) {
        constexpr scalar mu = scalar(1.25);  // sticks on 3 : 4 with a third to spare
        if (body_i == 0) return {flat_ground(scalar(0.5)), scalar(0.002), {}};
        if (body_i == 1) {
            PlacedBody incline = fixed_box({3, 1, scalar(0.1)}, {-3, 0, 2}, mu);
            incline.turn({{scalar(0.8), 0, scalar(0.6)}, {0, 1, 0}, {scalar(-0.6), 0, scalar(0.8)}});
            return {incline, 0, {1, 0, 0}};
        }
        if (body_i == 2) return {fixed_box({2, 2, scalar(0.1)}, {scalar(1.5), 0, scalar(3.6)}, mu), scalar(0.01), {scalar(0.25), scalar(0.5), 0}};
        if (body_i == 3) return {solid_box(3, {scalar(0.4), scalar(0.3), scalar(0.1)}, {0, -4, scalar(0.1)}, mu), 0, {-1, scalar(0.25), 0}};
        const int piece_i = body_i - 4;
        if (piece_i < 4) {
            const scalar along = scalar(piece_i) - 2;
            PlacedBody parcel_on_incline =
                solid_box(2, {scalar(0.2), scalar(0.3), scalar(0.15)},
                          {-3 + scalar(0.8) * along - scalar(0.6) * scalar(0.25), 0, 2 + scalar(0.6) * along + scalar(0.8) * scalar(0.25)}, mu);
            parcel_on_incline.turn({{scalar(0.8), 0, scalar(0.6)}, {0, 1, 0}, {scalar(-0.6), 0, scalar(0.8)}});
            return {parcel_on_incline, 0, {}};
        }
        const int ball_i = piece_i - 4;
        const scalar radius = scalar(0.15) + scalar(0.0625) * scalar(ball_i % 3);
        const bool on_table = ball_i < 4;
        PlacedBody ball = solid_ball(
            1, radius,
            {on_table ? scalar(ball_i) : 3 * scalar(ball_i) - 14, on_table ? scalar(-1) : scalar(-3), (on_table ? scalar(3.75) : 0) + radius},
            scalar(0.6), ball_i % 2 == 0 ? scalar(0.5) : scalar(0));
        ball.move({scalar(0.5), scalar(0.25) * scalar(ball_i), 0}, {0, 0, 1});
        return {ball, scalar(0.005) * scalar(ball_i), {}};
    }
};

}  // namespace scenes
