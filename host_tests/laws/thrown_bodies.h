// SPDX-License-Identifier: MIT
// Bodies of every shape that are thrown about, and their energy in double.
#pragma once

#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace thrown_bodies {

using ingot::BodyDef;
using ingot::scalar;
using ingot::Vector;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;

template <class Solver, bool fast, int substeps = ingot::limits::substeps, int sweeps = ingot::limits::sweeps>
struct Room : ingot::Scene {
    static constexpr int max_bodies = 96;
    static constexpr bool translates = true, sleeps = true, continuous = fast;
    static constexpr int max_manifolds = 600;
    static constexpr ingot::Effort effort = {substeps, sweeps};
    using broad_phase = ingot::SortedTree;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::Cylinder, ingot::HalfSpace>;
};

/// Of the energy. A substep may gain limits::inertia_turn of the energy of rotation, of bodies whose inertia it does not turn, and
/// limits::energy_rounding where it does; sweeps that end at their bound limits::gain_allowed.
template <class S>
constexpr double gain_of_step = S::effort.substeps * static_cast<double>(ingot::limits::inertia_turn + ingot::limits::energy_rounding +
                                                                         ingot::limits::gain_allowed);

struct Surface {
    double e, mu;
};

/// A world, what was put into it, and its energy in double.
template <class S>
class Thrown {
public:
    Thrown(double g, const Surface& of) : world(new ingot::World<S>{}), surface(of), g_(g) {
        EXPECT_EQ(world->set_gravity({0, scalar(-g), 0}), ingot::Status::ok);
    }

    void wall(const Vector& n, double distance) {
        BodyDef def;
        def.immovable = true;
        def.shape = ingot::HalfSpace{n, 0};
        def.state.r_CM = n * scalar(-distance);
        add(def);
    }
    /// Uniform mass of 500 kg/m^3: of the box around it, which is what its moments are to within a half.
    void body(const ingot::Shape& shape, const Vector3d& r, const Vector3d& v, const Vector3d& omega, RandomInput& random) {
        body_at(shape, r, v, omega, to_eigen(ingot_reference::to_matrix(random.rotation())));
    }
    void body_at(const ingot::Shape& shape, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Matrix3d& attitude) {
        const Vector3d half = extents_of(shape);
        const double M = 4000 * half.prod();
        const Vector3d sq = half.cwiseProduct(half), I = M / 3 * Vector3d(sq.y() + sq.z(), sq.z() + sq.x(), sq.x() + sq.y());
        BodyDef def = ingot_reference::definition(M, I);
        def.shape = shape;
        def.state.A = ingot_reference::to_matrix(attitude);
        const Matrix3d A = to_eigen(def.state.A);
        const Vector3d L = A * I.cwiseProduct(A.transpose() * omega);
        def.state.r_CM = ingot_reference::to_vector(r);
        def.state.v_CM = ingot_reference::to_vector(v);
        def.state.L = ingot_reference::to_vector(L);
        add(def);
        moving.push_back({ids.back(), static_cast<double>(def.mass.M), to_eigen(def.mass.I_body)});
    }
    double energy() const {
        double sum = 0;
        for (const Moving& of : moving) {
            const ingot::BodyState state = world->state(of.id).value;
            const Vector3d L = to_eigen(state.A).transpose() * to_eigen(state.L);
            sum += of.M * (to_eigen(state.v_CM).squaredNorm() / 2 + g_ * static_cast<double>(state.r_CM.y)) +
                   L.cwiseProduct(L).cwiseQuotient(of.I).sum() / 2;
        }
        return sum;
    }

    std::unique_ptr<ingot::World<S>> world;
    Surface surface;

private:
    struct Moving {
        ingot::BodyId id;
        double M;
        Vector3d I;
    };
    static Vector3d extents_of(const ingot::Shape& shape) {
        const Vector3d size = to_eigen(shape.size);
        switch (shape.kind) {
            case ingot::ShapeKind::sphere: return Vector3d::Constant(size.x());
            case ingot::ShapeKind::box: return size;
            case ingot::ShapeKind::capsule: return {size.x(), size.x(), size.x() + size.y()};
            default: return {size.x(), size.x(), size.y()};
        }
    }
    void add(BodyDef& def) {
        def.restitution = scalar(surface.e);
        def.friction = scalar(surface.mu);
        const auto added = world->add(def);
        EXPECT_EQ(added.status, ingot::Status::ok);
        ids.push_back(added.value);
    }
    std::vector<ingot::BodyId> ids;
    std::vector<Moving> moving;
    double g_;
};

inline ingot::Shape any_shape(int kind, double size, RandomInput& random) {
    const auto part = [&](double least) { return scalar(size * random.real(least, 1)); };
    switch (kind % 4) {
        case 0: return ingot::Sphere{scalar(size)};
        case 1: return ingot::Box{{scalar(size), part(0.3), part(0.3)}};
        case 2: return ingot::Capsule{part(0.1), scalar(size)};
        default: return ingot::Cylinder{part(0.4), part(0.3)};
    }
}
inline Vector3d any_vector(double most, RandomInput& random) {
    return {random.real(-most, most), random.real(-most, most), random.real(-most, most)};
}

template <class S>
void close_room(Thrown<S>& thrown, double half) {
    for (const Vector& n : {Vector{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) thrown.wall(n, half);
}

/// Forty of them, in the lower part of a room of half size 2, each on its way.
template <class S>
void throw_forty(Thrown<S>& thrown, RandomInput& random) {
    for (int i = 0; i < 40; ++i) {
        const Vector3d place = {(i % 3 - 1) * 0.9, -1.5 + 0.7 * (i / 9), (i / 3 % 3 - 1) * 0.9};
        const Vector3d v = any_vector(3, random), omega = any_vector(9, random);
        thrown.body(any_shape(i, 0.2, random), place, v, omega, random);
    }
}

/// A tray with so many dice above it, nine in a layer, about to fall.
template <class S>
void drop_dice(Thrown<S>& dice, int count, RandomInput& random) {
    dice.wall({0, 1, 0}, 0);
    for (const Vector& n : {Vector{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) dice.wall(n, 1.2);
    for (int i = 0; i < count; ++i) {
        const Vector3d place = {(i % 3 - 1) * 0.6, 0.5 + 0.6 * (i / 9), (i / 3 % 3 - 1) * 0.6}, aside = any_vector(0.05, random);
        dice.body(ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}}, place + aside, Vector3d::Zero(), Vector3d::Zero(), random);
    }
}

/// The largest gain of a step, of the energy at the begin.
template <class S>
double largest_gain(Thrown<S>& thrown, double h, double seconds) {
    const double scale = thrown.energy();
    double before = scale, most = 0;
    for (int step_i = 0; step_i < static_cast<int>(seconds / h); ++step_i) {
        (void)ingot::step(*thrown.world, scalar(h));
        const double now = thrown.energy();
        most = std::max(most, (now - before) / scale);
        before = now;
    }
    return most;
}

}  // namespace thrown_bodies
