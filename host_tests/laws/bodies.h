// SPDX-License-Identifier: MIT
// Solids with shapes, and what the laws are stated in: momentum and energy counted from the primary state in long double.
#pragma once

#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <vector>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace ingot_laws {

using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;
using ingot::scalar;

constexpr bool is_double = INGOT_DOUBLE != 0;
constexpr double u = static_cast<double>(ingot_reference::roundoff<scalar>);

/// A bar in double and in float.
constexpr double bar(double in_double, double in_float) { return is_double ? in_double : in_float; }

/// A solid ball of radius R and mass M, at r with velocity v.
inline ingot::BodyDef ball(double M, double R, const Eigen::Vector3d& r, const Eigen::Vector3d& v, double e) {
    ingot::BodyDef def = ingot_reference::definition(M, Eigen::Vector3d::Constant(0.4 * M * R * R));
    def.state.r_CM = ingot_reference::to_vector(r);
    def.state.v_CM = ingot_reference::to_vector(v);
    def.shape = ingot::Sphere{static_cast<scalar>(R)};
    def.restitution = static_cast<scalar>(e);
    return def;
}

/// A solid box of half extents `half` and mass M, at r with velocity v.
inline ingot::BodyDef box(double M, const Eigen::Vector3d& half, const Eigen::Vector3d& r, const Eigen::Vector3d& v, double e) {
    const Eigen::Vector3d sq = half.cwiseProduct(half);
    ingot::BodyDef def =
        ingot_reference::definition(M, Eigen::Vector3d(M / 3 * Eigen::Vector3d(sq(1) + sq(2), sq(2) + sq(0), sq(0) + sq(1))));
    def.state.r_CM = ingot_reference::to_vector(r);
    def.state.v_CM = ingot_reference::to_vector(v);
    def.shape = ingot::Box{ingot_reference::to_vector(half)};
    def.restitution = static_cast<scalar>(e);
    return def;
}

/// Ground: all points with n.r <= offset.
inline ingot::BodyDef half_space(const Eigen::Vector3d& n, double offset, double e = 0) {
    ingot::BodyDef def{};
    def.immovable = true;
    def.shape = ingot::HalfSpace{ingot_reference::to_vector(n), static_cast<scalar>(offset)};
    def.restitution = static_cast<scalar>(e);
    return def;
}

/// A body of a world together with the numbers it was made of.
struct Known {
    ingot::BodyId id;
    long double M;
    Column I;
};

template <class World>
Known add(World& world, const ingot::BodyDef& def) {
    const ingot::Result<ingot::BodyId> id = world.add(def);
    EXPECT_EQ(id.status, ingot::Status::ok);
    return {id.value, static_cast<long double>(def.mass.M), ingot_reference::to_eigen<long double>(def.mass.I_body)};
}

template <class World>
Eigen::Vector3d position(const World& world, const Known& body) {
    return ingot_reference::to_eigen(world.state(body.id).value.r_CM);
}
template <class World>
Eigen::Vector3d velocity(const World& world, const Known& body) {
    return ingot_reference::to_eigen(world.state(body.id).value.v_CM);
}
template <class World>
Eigen::Vector3d spin(const World& world, const Known& body) {
    return ingot_reference::to_eigen(world.omega(body.id).value);
}
template <class World>
Square attitude(const World& world, const Known& body) {
    return ingot_reference::to_eigen<long double>(world.state(body.id).value.A);
}

/// Energy of turning: y.(y / I) / 2 with y = A^T L.
inline long double rotation_energy(const ingot::BodyState& s, const Column& I) {
    const Column y = ingot_reference::to_eigen<long double>(s.A).transpose() * ingot_reference::to_eigen<long double>(s.L);
    return y.dot(y.cwiseQuotient(I)) / 2;
}
template <class World>
long double kinetic_energy(const World& world, const std::vector<Known>& bodies) {
    long double sum = 0;
    for (const Known& body : bodies) {
        const ingot::BodyState s = world.state(body.id).value;
        sum += body.M * ingot_reference::to_eigen<long double>(s.v_CM).squaredNorm() / 2 + rotation_energy(s, body.I);
    }
    return sum;
}
template <class World>
Column linear_momentum(const World& world, const std::vector<Known>& bodies) {
    Column sum = Column::Zero();
    for (const Known& body : bodies) sum += body.M * ingot_reference::to_eigen<long double>(world.state(body.id).value.v_CM);
    return sum;
}
/// About the origin.
template <class World>
Column angular_momentum(const World& world, const std::vector<Known>& bodies) {
    Column sum = Column::Zero();
    for (const Known& body : bodies) {
        const ingot::BodyState s = world.state(body.id).value;
        sum += ingot_reference::to_eigen<long double>(s.L) + ingot_reference::to_eigen<long double>(s.r_CM).cross(Column(
                                                                 body.M * ingot_reference::to_eigen<long double>(s.v_CM)));
    }
    return sum;
}

}  // namespace ingot_laws
