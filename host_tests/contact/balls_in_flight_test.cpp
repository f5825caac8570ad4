// SPDX-License-Identifier: MIT
// Balls that meet in flight: what they do to each other changes neither momentum nor angular momentum, however they glance.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/play.h"
#include "reference/brief_types.h"
#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::BriefTypes;
using ingot_reference::RandomInput;
using ingot_reference::to_vector;

template <class Solver, class Shapes, bool asleep = false>
struct Sky : ingot::Scene {
    static constexpr int max_bodies = 16, max_manifolds = 64;
    static constexpr bool translates = true, sleeps = asleep;
    using solver = Solver;
    using shapes = Shapes;
};
using Skies = BriefTypes<2, Sky<ingot::BlockSweeps, ingot::Shapes<ingot::Sphere>>,
                         Sky<ingot::HybridIslands<8, 10>, ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule>, true>,
                         Sky<ingot::BlockSweeps, ingot::Shapes<ingot::Sphere, ingot::Box>>>;
template <class S>
class EverySky : public ::testing::Test {};
TYPED_TEST_SUITE(EverySky, Skies);

/// Two balls about a place, and what they have together, in double.
struct PairOfBalls {
    ingot::BodyId id[2];
    double M[2];

    template <class S>
    Vector3d momentum(const ingot::World<S>& world) const {
        return M[0] * v(world, 0) + M[1] * v(world, 1);
    }
    /// About their centre of mass.
    template <class S>
    Vector3d angular_momentum(const ingot::World<S>& world) const {
        const Vector3d away = r(world, 0) - r(world, 1), slip = v(world, 0) - v(world, 1);
        const Vector3d spin = to_eigen(world.state(id[0]).value.L) + to_eigen(world.state(id[1]).value.L);
        return away.cross(slip) * (M[0] * M[1] / (M[0] + M[1])) + spin;
    }
    template <class S>
    Vector3d r(const ingot::World<S>& world, int which) const {
        return to_eigen(world.state(id[which]).value.r_CM);
    }
    template <class S>
    Vector3d v(const ingot::World<S>& world, int which) const {
        return to_eigen(world.state(id[which]).value.v_CM);
    }
};

/// They meet within a step or two, anywhere from head on to past each other by a little, so fast that they go by up to their reach in a step.
template <class S>
PairOfBalls thrown_pair(ingot::World<S>& world, RandomInput& random, const Vector3d& place, double h) {
    const double radii[2] = {std::pow(10, random.real(-1.5, 0)), std::pow(10, random.real(-1.5, 0))}, reach = radii[0] + radii[1];
    const double closing = std::min(reach / h * random.real(0.05, 1), 40.0), e = random.real(0.1, 1), mu = random.real(0, 1);
    const Vector3d way = random.direction(), off = random.direction(), across = (off - way * way.dot(off)).normalized();
    const Vector3d from = across * (reach * random.real(0, 1.1)) - way * (reach * 1.05 + closing * h * random.real(0, 2));
    PairOfBalls pair{};
    for (int which = 0; which < 2; ++which) {
        ingot::BodyDef def;
        const auto radius = static_cast<scalar>(radii[which]);
        def.shape = ingot::Sphere{radius};
        def.mass = ingot::principal(ingot::solid_sphere(static_cast<scalar>(random.real(100, 9000)), radius)).value;
        def.friction = static_cast<scalar>(mu);
        def.restitution = static_cast<scalar>(e);
        const double share = which == 0 ? 0.5 : -0.5;
        const ingot::UserPose pose = {to_vector(Vector3d(place + from * share)), ingot_reference::to_matrix(random.rotation())};
        const Vector3d spin = random.vector(std::min(closing / reach, 0.5 / h));
        def.state = ingot::body_state(def.mass, pose, {to_vector(Vector3d(way * (closing * share))), to_vector(spin)});
        pair.M[which] = static_cast<double>(def.mass.M);
        pair.id[which] = world.add(def).value;
    }
    return pair;
}

/// Several pairs at a time, under gravity. Each step rounds places and speeds by some epsilon, of r up to 16 m and v up to 48 m/s: as many of m v r.
/// Those that glance by less than limits::bounce_speed_min do not bounce, but stop within the step: meanwhile they move aside.
template <class S>
void keeps_momenta(int draw) {
    RandomInput random(static_cast<uint64_t>(7700 + draw));
    constexpr int rates[] = {30, 60, 120, 240, 1000};
    const double h = 1.0 / rates[random.integer(0, 4)];
    static ingot::World<S> world;
    world = {};
    (void)world.set_gravity({0, 0, -standard_gravity});
    std::vector<PairOfBalls> pairs;
    std::vector<Vector3d> momenta, angular, slips;
    for (int i = 0; i < 6; ++i) {
        pairs.push_back(thrown_pair(world, random, {10.0 * (i % 3 - 1), 10.0 * (i / 3) - 5, 0}, h));
        momenta.push_back(pairs.back().momentum(world));
        angular.push_back(pairs.back().angular_momentum(world));
        slips.push_back(pairs.back().v(world, 0) - pairs.back().v(world, 1));
    }
    constexpr int steps = 8;
    for (int step_i = 0; step_i < steps; ++step_i) {
        const ingot::StepReport report = ingot::step(world, static_cast<scalar>(h));
        ASSERT_EQ(report.contacts_lost + report.bodies_frozen + report.sweeps_unfinished, 0) << "draw " << draw;
    }
    const double eps = static_cast<double>(ingot::epsilon);
    for (size_t i = 0; i < pairs.size(); ++i) {
        const double M = pairs[i].M[0] + pairs[i].M[1], least = std::min(pairs[i].M[0], pairs[i].M[1]);
        const Vector3d fall(0, 0, -static_cast<double>(standard_gravity) * M * steps * static_cast<double>(static_cast<scalar>(h)));
        const double rounding = 4 * steps * eps;
        EXPECT_LE((pairs[i].momentum(world) - momenta[i] - fall).norm(), rounding * M * 48) << "draw " << draw << ", pair " << i;
        const double slow = static_cast<double>(ingot::limits::bounce_speed_min) * h;
        const double off = (rounding * 16 + slow) * least * slips[i].norm() + rounding * angular[i].norm();
        EXPECT_LE((pairs[i].angular_momentum(world) - angular[i]).norm(), off)
            << "draw " << draw << ", pair " << i << ", " << 1 / h << " Hz, of " << angular[i].norm();
    }
}

TYPED_TEST(EverySky, balls_that_bounce_keep_their_momenta) {
    for (int draw = 0; draw < ingot_reference::draws(200); ++draw) keeps_momenta<TypeParam>(draw);
}

}  // namespace
