// SPDX-License-Identifier: MIT
// What a figure is tied to: the world, an immovable body, or a kinematic one.
#pragma once

#include "../body/turning_inertia.h"
#include "figure_view.h"

namespace ingot { inline namespace INGOT_ABI {

template <class T>
struct Ground {
    Vec3<T> r;      ///< m
    Mat3<T> A;
    Vec3<T> v, w;   ///< m/s, rad/s
};

/// A turned by a vector, rad: about the axis by an angle that is short by its ninth power / 6000.
inline Matrix turned_far(const Matrix& A, const Vector& turn) {
    const scalar sq = length_sq(turn);
    const scalar half_tangent = scalar(0.5) + sq * (scalar(1) / 24 + sq * (scalar(1) / 240 + sq * (scalar(17) / 40320)));
    return turned_about(A, turn * (2 * half_tangent));
}

/// Now. A kinematic body shows its motion in its tile from the begin of the step until it has been moved. slot: or no_body, the world.
inline Ground<scalar> ground_at(const FigureView& view, Index slot) {
    Ground<scalar> ground = {{}, identity_matrix<scalar>(), {}, {}};
    if (slot == no_body) return ground;
    const Place place = place_of(slot);
    const RotationTile& rotation = view.bodies.rotation[place.tile];
    const TranslationTile& translation = view.bodies.translation[place.tile];
    ground.v = lane_of(translation.v_CM, place.lane);
    ground.w = Vector{} - lane_of(rotation.L, place.lane);  // see kinematic_motion.h
    ground.r = lane_of(translation.r_CM, place.lane) + ground.v * view.elapsed;
    ground.A = lane_of(rotation.A, place.lane);
    if (length_sq(ground.w) > 0) ground.A = turned_far(ground.A, ground.w * view.elapsed);
    return ground;
}

/// Of one lane.
template <unsigned width, class Kinds>
Ground<scalar> ground_of(const FigureRows<width, Kinds>& rows, const OneLane<width>& at) {
    return ground_at(rows.view, rows.figure(at.lane_i).ground);
}

/// Of each lane.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
Ground<T> ground_of(const FigureRows<width, Kinds>& rows, const AllLanes<width, Kinds>&) {
    if constexpr (width == 1) return ground_of(rows, OneLane<1>{0});
    scalar r[3][width], A[9][width], v[3][width], w[3][width];
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
        const OneLane<width> at{lane_i};
        const Ground<scalar> ground = ground_of(rows, at);
        write(at, r, ground.r);
        write(at, A, ground.A);
        write(at, v, ground.v);
        write(at, w, ground.w);
    }
    return {read(rows.all, r), read(rows.all, A), read(rows.all, v), read(rows.all, w)};
}

} }  // namespace ingot
