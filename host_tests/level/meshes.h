// SPDX-License-Identifier: MIT
// Meshes drawn at random, of the kinds that levels have.
#pragma once

#include <limits>
#include <random>

#include "level_tool/level_data.h"

namespace level_test {

using Random = std::mt19937_64;  // the standard fixes its numbers

inline constexpr ingot::scalar not_a_number = std::numeric_limits<ingot::scalar>::quiet_NaN(),
                               infinity = std::numeric_limits<ingot::scalar>::infinity();

inline int between(Random& random, int from, int to) { return from + static_cast<int>(random() % static_cast<uint64_t>(to - from + 1)); }

inline ingot::LatticePoint lattice_point(int x, int y, int z) {
    return {static_cast<uint16_t>(x), static_cast<uint16_t>(y), static_cast<uint16_t>(z)};
}

/// Points on the lattice, and faces.
struct Soup {
    std::vector<ingot::LatticePoint> points;
    std::vector<ingot::LevelFace> faces;
};

/// Triangles of any size up to `size`, anywhere within `extent`.
inline Soup loose_triangles(Random& random, int count, int extent, int size) {
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const int origin[3] = {between(random, 0, extent - size), between(random, 0, extent - size), between(random, 0, extent - size)};
        for (int k = 0; k < 3; ++k)
            soup.points.push_back(
                lattice_point(origin[0] + between(random, 0, size), origin[1] + between(random, 0, size), origin[2] + between(random, 0, size)));
        soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2, static_cast<uint8_t>(i)});
    }
    return soup;
}

/// Ground over a grid of n by n cells of the lattice, as high as `height` says; each cell is cut along one diagonal or the other.
template <class Height>
Soup terrain(Random& random, int n, int cell, const Height& height) {
    Soup soup;
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column) soup.points.push_back(lattice_point(column * cell, row * cell, height(column, row)));
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const int a = row * (n + 1) + column, b = a + 1, c = a + n + 2, d = a + n + 1;
            if (random() % 2 == 0) {
                soup.faces.push_back({a, b, c});
                soup.faces.push_back({a, c, d});
            } else {
                soup.faces.push_back({a, b, d});
                soup.faces.push_back({b, c, d});
            }
        }
    return soup;
}

/// A plane cut into slivers, a hundred times as long as wide, that share one corner, or none.
inline Soup slivers(int count, bool fan) {
    Soup soup;
    const auto point = [&soup](int x, int y, int z) {
        soup.points.push_back(lattice_point(x, y, z));
        return static_cast<int>(soup.points.size()) - 1;
    };
    const int apex = point(0, 0, 8);
    for (int i = 0; i < count; ++i) {
        if (fan) {
            const int a = point(20000, 200 * i, 8), b = point(20000, 200 * (i + 1), 8);
            soup.faces.push_back({apex, a, b});
        } else {
            const int a = point(0, 200 * i, 8), b = point(20000, 200 * i, 8), c = point(20000, 200 * (i + 1), 8), d = point(0, 200 * (i + 1), 8);
            soup.faces.push_back({a, b, c});
            soup.faces.push_back({a, c, d});
        }
    }
    return soup;
}

/// A closed box, its corners for itself.
inline void add_box(Soup& soup, const int (&low)[3], const int (&high)[3], uint8_t material) {
    const int first = static_cast<int>(soup.points.size());
    for (int i = 0; i < 8; ++i)
        soup.points.push_back(lattice_point((i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]));
    const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        soup.faces.push_back({first + q[0], first + q[1], first + q[2], material});
        soup.faces.push_back({first + q[0], first + q[2], first + q[3], material});
    }
}

/// Boxes on a grid, flush in places: T-joints between their sides.
inline Soup village(Random& random, int n) {
    Soup soup;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const int x = 2000 * column, y = 2000 * row;
            add_box(soup, {x, y, 0}, {x + 2000, y + between(random, 500, 2000), between(random, 100, 6000)}, static_cast<uint8_t>(row));
        }
    return soup;
}

inline level_tool::MeshData built(const Soup& soup, ingot::scalar step = ingot::scalar(1) / 1024, int64_t x = 0, int64_t y = 0, int64_t z = 0) {
    level_tool::MeshData data;
    const ingot::Status status = level_tool::build_mesh(soup.points, soup.faces, {x, y, z}, step, data);
    if (status != ingot::Status::ok) data.triangles.clear();
    return data;
}

}  // namespace level_test
