// SPDX-License-Identifier: MIT
// Arithmetic on the lattice of a level, in integers: nothing here rounds but the way onto it.
#pragma once

#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI { namespace lattice {

inline constexpr int64_t last = 65535;  ///< steps from the origin
/// Steps of the origin of a level from that of its frame: so every corner is a scalar without rounding.
inline constexpr int64_t origin_max = static_cast<int64_t>(1 / epsilon);
inline constexpr int halvings_max = 20;  ///< the least step is 2^-20 m, the largest 2^20

/// A power of two from 2^-20 to 2^20.
constexpr bool is_step(scalar step) {
    scalar power = scalar(1) / (1 << halvings_max);
    for (int i = 0; i <= 2 * halvings_max; ++i, power *= 2)
        if (step == power) return true;
    return false;
}

/// On the lattice of its step, and near enough to 0 that no corner is rounded.
constexpr bool is_origin(scalar origin, scalar step) {
    const scalar steps = origin / step;
    return abs(steps) <= static_cast<scalar>(origin_max) && static_cast<scalar>(static_cast<int64_t>(steps)) == steps;
}

/// The number of the step that is next to x, which is no further than limits::position_max; of two, the upper.
constexpr int64_t nearest_step(scalar x, scalar step) {
    const scalar steps = x / step;
    const auto whole = static_cast<int64_t>(steps);
    const scalar rest = steps - static_cast<scalar>(whole);
    return rest >= scalar(0.5) ? whole + 1 : rest < scalar(-0.5) ? whole - 1 : whole;
}

/// Orders points by x, then y, then z.
constexpr uint64_t key_of_point(const LatticePoint& p) { return static_cast<uint64_t>(p.x) << 32 | static_cast<uint64_t>(p.y) << 16 | p.z; }
constexpr LatticePoint point_of_key(uint64_t key) {
    return {static_cast<uint16_t>(key >> 32), static_cast<uint16_t>(key >> 16), static_cast<uint16_t>(key)};
}

/// A vector between points.
struct Offset {
    int64_t x{}, y{}, z{};
};
constexpr Offset between(const LatticePoint& from, const LatticePoint& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }
constexpr Offset cross(const Offset& a, const Offset& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
constexpr int64_t dot(const Offset& a, const Offset& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Twice the area along the normal: below 2^33 by component.
constexpr Offset area_of(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) { return cross(between(a, b), between(a, c)); }
constexpr bool has_area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
    const Offset area = area_of(a, b, c);
    return (area.x | area.y | area.z) != 0;
}

/// A number of up to 2^88: 40 bits in the lower word.
struct Wide {
    uint64_t upper{}, lower{};
};
/// x^2, of |x| < 2^40.
constexpr Wide square(int64_t x) {
    const auto size = static_cast<uint64_t>(x < 0 ? -x : x);
    constexpr uint64_t half = (uint64_t{1} << 20) - 1, word = (uint64_t{1} << 40) - 1;
    const uint64_t a = size >> 20, b = size & half, twice = 2 * a * b;
    const uint64_t lower = ((twice & half) << 20) + b * b;
    return {a * a + (twice >> 20) + (lower >> 40), lower & word};
}
constexpr Wide operator+(const Wide& a, const Wide& b) {
    constexpr uint64_t word = (uint64_t{1} << 40) - 1;
    const uint64_t lower = a.lower + b.lower;
    return {a.upper + b.upper + (lower >> 40), lower & word};
}
constexpr bool operator<=(const Wide& a, const Wide& b) { return a.upper < b.upper || (a.upper == b.upper && a.lower <= b.lower); }

/// True where a point that is `volume` above a plane, six times that of the tetrahedron, is no further from it than half a step.
constexpr bool within_half_a_step(int64_t volume, const Offset& area) {
    const int64_t twice = 2 * (volume < 0 ? -volume : volume);
    if (twice >= int64_t{1} << 35) return false;  // above any |area|
    return square(twice) <= square(area.x) + square(area.y) + square(area.z);
}

/// Of so many bits less, where it is long, that products of two are in range.
constexpr Offset shortened(const Offset& a) {
    constexpr int64_t limit = int64_t{1} << 30;
    const bool is_long = a.x >= limit || a.x <= -limit || a.y >= limit || a.y <= -limit || a.z >= limit || a.z <= -limit;
    return is_long ? Offset{a.x / 16, a.y / 16, a.z / 16} : a;
}

/// What lies beyond the edge from a to b of the triangle a b c: the triangle b a d. The same from both sides: flat where either far corner is in the
/// plane of the other triangle, so slivers, whose planes are uncertain, make no ridges.
constexpr EdgeKind kind_of_edge(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
    const Offset area = area_of(a, b, c), other = area_of(b, a, d);
    const int64_t volume = dot(area, between(a, d));
    if (dot(shortened(area), shortened(other)) > 0 && (within_half_a_step(volume, area) || within_half_a_step(volume, other))) return EdgeKind::flat;
    // Folded onto itself it is in its plane too: a blade.
    return volume > 0 ? EdgeKind::concave : EdgeKind::convex;
}

/// A box that holds all points from low to high.
struct Box {
    uint16_t low[3]{}, high[3]{};
};
constexpr uint16_t least(uint16_t a, uint16_t b) { return a < b ? a : b; }
constexpr uint16_t most(uint16_t a, uint16_t b) { return a < b ? b : a; }
constexpr Box box_of(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
    return {{least(least(a.x, b.x), c.x), least(least(a.y, b.y), c.y), least(least(a.z, b.z), c.z)},
            {most(most(a.x, b.x), c.x), most(most(a.y, b.y), c.y), most(most(a.z, b.z), c.z)}};
}
constexpr void hold(Box& box, const Box& other) {
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = least(box.low[axis], other.low[axis]);
        box.high[axis] = most(box.high[axis], other.high[axis]);
    }
}
/// Of all corners of a mesh, of which there is one.
constexpr Box box_of_corners(const MeshTable& mesh) {
    Box box = box_of(mesh.corners[0], mesh.corners[0], mesh.corners[0]);
    for (int i = 1; i < mesh.corner_count; ++i) hold(box, box_of(mesh.corners[i], mesh.corners[i], mesh.corners[i]));  // bound: corners
    return box;
}
/// Half of the area of its sides, square steps: below 2^34.
constexpr uint64_t half_area(const Box& box) {
    const auto x = static_cast<uint64_t>(box.high[0] - box.low[0]), y = static_cast<uint64_t>(box.high[1] - box.low[1]),
               z = static_cast<uint64_t>(box.high[2] - box.low[2]);
    return x * y + y * z + z * x;
}

/// Sorts in place, with as much room aside. Cost: n log2 n comparisons.
constexpr void sort_keys(uint64_t* keys, uint64_t* aside, int count) {
    // bound: log2 of the count: the width doubles
    for (int width = 1; width < count; width *= 2) {
        for (int begin = 0; begin < count; begin += 2 * width) {  // bound: the count
            const int middle = begin + width < count ? begin + width : count;
            const int end = middle + width < count ? middle + width : count;
            int left = begin, right = middle;
            for (int to = begin; to < end; ++to)  // bound: the count
                aside[to] = right >= end || (left < middle && keys[left] <= keys[right]) ? keys[left++] : keys[right++];
        }
        for (int i = 0; i < count; ++i) keys[i] = aside[i];
    }
}

}}}  // namespace ingot::INGOT_ABI::lattice
