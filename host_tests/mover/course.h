// SPDX-License-Identifier: MIT
// Courses of boxes, as bodies and as one mesh, and how deep a capsule is in them, in double.
#pragma once

#include <ingot/ingot.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "level/meshes.h"
#include "reference/draws.h"

namespace mover_test {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::LevelTable;
using ingot::Matrix;
using ingot::Mover;
using ingot::MoverFooting;
using ingot::MoverInput;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using ingot::World;
using V = Eigen::Vector3d;

struct Street : ingot::Scene {
    static constexpr int max_bodies = 160, max_manifolds = 160;
    static constexpr bool translates = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace, ingot::Level>;
    static inline LevelTable levels[1] = {};
};
/// Everything twice as large.
struct Twofold : Street {
    static constexpr scalar length_unit = 2;
};
struct Belts : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true, kinematic_bodies = true, surface_velocities = true;
    using shapes = ingot::Shapes<ingot::Box>;
};
/// The same, and what is near is told by a tree.
struct Planted : Street {
    using broad_phase = ingot::QueryTree;
};

constexpr double pi = 3.14159265358979;

inline double within(level_test::Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 1048576) / 1048576;
}
/// Even in its logarithm.
inline double about(level_test::Random& random, double low, double high) { return low * std::pow(high / low, within(random, 0, 1)); }

inline V exact(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
inline Vector rounded(const V& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }
inline bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Turned about y: x falls by the angle.
inline Matrix pitched(double angle) {
    const auto c = static_cast<scalar>(std::cos(angle)), s = static_cast<scalar>(std::sin(angle));
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

struct Block {
    V low, high;                                        ///< m, in its own frame
    Matrix A = ingot::identity_matrix<scalar>();  ///< to the world
    V r = V::Zero();                                    ///< m, of its frame
};

template <class S>
World<S>& empty_world() {
    static World<S> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    (void)world.set_gravity({0, 0, scalar(-9.81) * S::length_unit});
    return world;
}

template <class S>
BodyId add_box(World<S>& world, const V& half, const V& r, const Matrix& A = ingot::identity_matrix<scalar>(), bool kinematic = false) {
    BodyDef def;
    def.immovable = !kinematic;
    def.kinematic = kinematic;
    def.shape = ingot::Box{rounded(half)};
    def.state.r_CM = rounded(r);
    def.state.A = A;
    const auto id = world.add(def);
    EXPECT_TRUE(id.ok()) << ingot::name(id.status);
    return id.value;
}
template <class S>
BodyId add_plane(World<S>& world, const Vector& n = {0, 0, 1}, scalar offset = 0) {
    BodyDef def;
    def.immovable = true;
    def.shape = ingot::HalfSpace{n, offset};
    return world.add(def).value;
}

/// m, on a lattice of 2^-10, so that boxes and triangles are the same.
inline double on_lattice(double x) { return std::round(x * 1024) / 1024; }

/// The blocks as boxes.
template <class S>
void add_as_boxes(World<S>& world, const std::vector<Block>& blocks) {
    const double unit = static_cast<double>(S::length_unit);
    for (const Block& block : blocks) {
        const V middle = block.r + exact(block.A * rounded((block.high + block.low) / 2));
        (void)add_box(world, (block.high - block.low) * (unit / 2), middle * unit, block.A);
    }
}
/// The same as one mesh, which has to outlive the world.
template <class S>
void add_as_mesh(World<S>& world, const std::vector<Block>& blocks, level_tool::MeshData& mesh) {
    level_test::Soup soup;
    V low = blocks[0].low;
    for (const Block& block : blocks) low = low.cwiseMin(block.low);
    const auto steps = [&low](const V& p, int axis) { return static_cast<int>(std::lround((p[axis] - low[axis]) * 1024)); };
    for (const Block& block : blocks)
        level_test::add_box(soup, {steps(block.low, 0), steps(block.low, 1), steps(block.low, 2)},
                            {steps(block.high, 0), steps(block.high, 1), steps(block.high, 2)}, 0);
    mesh = level_test::built(soup);
    S::levels[0] = mesh.view;
    ingot::LevelDef def;
    def.r = rounded(low);
    const auto id = world.add_level(def);
    EXPECT_TRUE(id.ok()) << ingot::name(id.status);
}

/// In double; not of Eigen, which takes fifty times as long where it is not optimised.
using Exact = ingot::Vec3<double>;
inline Exact in_double(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
inline Exact in_double(const V& v) { return {v.x(), v.y(), v.z()}; }

/// m, how near the capsule is to a block; below 0 inside. The distance of the axis from it is a convex function of the place on the axis.
inline double gap_to(const Mover& mover, const Block& block) {
    const Exact x = in_double(block.A.c0), y = in_double(block.A.c1), z = in_double(block.A.c2);
    const auto seen = [&](const Exact& v) { return Exact{dot(x, v), dot(y, v), dot(z, v)}; };
    const Exact r = seen(in_double(mover.r) - in_double(block.r)), up = seen(in_double(mover.up));
    const Exact low = in_double(block.low), high = in_double(block.high);
    const double half = static_cast<double>(mover.capsule.half_length), radius = static_cast<double>(mover.capsule.radius);
    const auto outside = [](double p, double from, double to) { return p < from ? from - p : p > to ? p - to : 0; };
    const auto inside = [](double p, double from, double to) { return p - from < to - p ? p - from : to - p; };
    const auto distance = [&](double t) {
        const Exact p = r + up * t, away = {outside(p.x, low.x, high.x), outside(p.y, low.y, high.y), outside(p.z, low.z, high.z)};
        const double away_sq = dot(away, away);
        if (away_sq > 0) return std::sqrt(away_sq);
        return -std::min({inside(p.x, low.x, high.x), inside(p.y, low.y, high.y), inside(p.z, low.z, high.z)});
    };
    double from = -half, to = half;
    for (int i = 0; i < 40; ++i) {  // to 10^-7 of it
        const double a = from + (to - from) / 3, b = to - (to - from) / 3;
        if (distance(a) < distance(b))
            to = b;
        else
            from = a;
    }
    return std::min({distance((from + to) / 2), distance(-half), distance(half)}) - radius;
}
inline double gap_to(const Mover& mover, const std::vector<Block>& blocks) {
    const double reach = static_cast<double>(mover.capsule.half_length + mover.capsule.radius) + 0.1;
    double least = 1e9;
    for (const Block& block : blocks) {
        // Most are far away; those that are turned are looked at.
        const Exact r = in_double(mover.r), low = in_double(block.low), high = in_double(block.high);
        const bool turned = block.A.c0.x < 1 || block.A.c1.y < 1;
        const auto near = [reach](double p, double from, double to) { return p > from - reach && p < to + reach; };
        if (turned || (near(r.x, low.x, high.x) && near(r.y, low.y, high.y) && near(r.z, low.z, high.z)))
            least = std::min(least, gap_to(mover, block));
    }
    return least;
}

inline bool stands(const Mover& mover) { return mover.ground.footing == MoverFooting::walkable; }

/// A mover that stands at x, y on ground of height z.
template <class S>
Mover standing_at(World<S>& world, double x, double y, double z) {
    const double unit = static_cast<double>(S::length_unit);
    Mover mover;
    mover.capsule = {scalar(0.3) * S::length_unit, scalar(0.6) * S::length_unit};
    mover.r = rounded(V(x, y, z + 0.95) * unit);
    for (int i = 0; i < 200 && !stands(mover); ++i) EXPECT_EQ(world.move(mover, {}, scalar(1) / 120), Status::ok);
    EXPECT_TRUE(stands(mover));
    EXPECT_EQ(world.move(mover, {}, scalar(1) / 120), Status::ok);  // out of what it came into its skin by when it landed
    return mover;
}

}  // namespace mover_test
