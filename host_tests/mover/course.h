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

/// m, how near the capsule is to a block; below 0 inside. The distance of the axis from it is a convex function of the place on the axis.
inline double gap_to(const Mover& mover, const Block& block) {
    Eigen::Matrix3d A;
    A << exact(block.A.c0), exact(block.A.c1), exact(block.A.c2);
    const V r = A.transpose() * (exact(mover.r) - block.r), up = A.transpose() * exact(mover.up);
    const double half = static_cast<double>(mover.capsule.half_length), radius = static_cast<double>(mover.capsule.radius);
    const auto distance = [&](double t) {
        const V p = r + up * t, q = p.cwiseMax(block.low).cwiseMin(block.high);
        const double outside = (p - q).norm();
        if (outside > 0) return outside;
        return -std::min((p - block.low).minCoeff(), (block.high - p).minCoeff());
    };
    double low = -half, high = half;
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    return std::min({distance((low + high) / 2), distance(-half), distance(half)}) - radius;
}
inline double gap_to(const Mover& mover, const std::vector<Block>& blocks) {
    double least = 1e9;
    for (const Block& block : blocks) {
        const double reach = static_cast<double>(mover.capsule.half_length + mover.capsule.radius) + 0.1, size = (block.high - block.low).norm() / 2;
        if ((exact(mover.r) - block.r - exact(block.A * rounded((block.low + block.high) / 2))).norm() < reach + size)
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
    for (int i = 0; i < 40 && !stands(mover); ++i) EXPECT_EQ(world.move(mover, {}, scalar(1) / 120), Status::ok);
    EXPECT_TRUE(stands(mover));
    EXPECT_EQ(world.move(mover, {}, scalar(1) / 120), Status::ok);  // out of what it came into its skin by when it landed
    return mover;
}

}  // namespace mover_test
