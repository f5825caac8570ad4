// SPDX-License-Identifier: MIT
// What draws: a type of the user's that can draw a line. What else it can draw is found out by the compiler; what it cannot is made of lines.
//
//     struct Pen {
//         void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor color);         // the least
//         void point(const ingot::Vector& P, ingot::DrawColor color);                                // else: a cross of three lines
//         void shape(const ingot::PlacedShape& shape, ingot::DrawColor color);                       // else: its wireframe
//     };
#pragma once

#include "wireframe.h"

namespace ingot { inline namespace INGOT_ABI {

/// What is drawn, or what is the case with it: the colours are the user's.
enum class DrawColor : uint8_t {
    awake, asleep, immovable, kinematic, frozen, sensor,  ///< of shapes: what their body is, or a sensor
    axis_x, axis_y, axis_z,                               ///< principal axes
    centre, bounds, L, omega,
    contact, impulse, friction,
    joint, joint_axis, island
};
inline constexpr int draw_color_count = static_cast<int>(DrawColor::island) + 1;

// The last argument tells the two of a name apart: int is nearer to 0 than long, so the first is taken wherever the pen has the function.

template <class Pen>
auto draw_point(Pen& pen, const Vector& P, scalar, DrawColor color, int) -> decltype(pen.point(P, color)) {
    return pen.point(P, color);
}
/// reach: m, of each arm of the cross.
template <class Pen>
void draw_point(Pen& pen, const Vector& P, scalar reach, DrawColor color, long) {
    pen.line(P - Vector{reach, 0, 0}, P + Vector{reach, 0, 0}, color);
    pen.line(P - Vector{0, reach, 0}, P + Vector{0, reach, 0}, color);
    pen.line(P - Vector{0, 0, reach}, P + Vector{0, 0, reach}, color);
}

template <class Pen>
auto draw_shape(Pen& pen, const PlacedShape& shape, scalar, DrawColor color, int) -> decltype(pen.shape(shape, color)) {
    return pen.shape(shape, color);
}
/// cell: see line_of.
template <class Pen>
void draw_shape(Pen& pen, const PlacedShape& shape, scalar cell, DrawColor color, long) {
    const int count = line_count(shape);
    // bound: lines_of_capsule, or the edges of a hull
    for (int line_i = 0; line_i < count; ++line_i) {
        const Line line = line_of(shape, line_i, cell);
        pen.line(line.a, line.b, color);
    }
}

} }  // namespace ingot
