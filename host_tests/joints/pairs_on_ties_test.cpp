// SPDX-License-Identifier: MIT
// Two balls on a rod or a rope, both of which move: the way of each is known in closed form. Their centre flies as one body. About it they go straight
// until the rope is as long as it can be; that takes the speed along it, as an impact that does not bounce; from there on they go in a circle, at the
// speed that is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct OnTies : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 12, max_loops = 12;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::RodJoint, ingot::RopeJoint, ingot::WithReactions>;
};
using OnTiesWorld = ingot::World<OnTies>;

struct TwoBalls {
    double M[2], length;
    Vector3d r[2], v[2], g;
    bool is_rope;

    double mass() const { return M[0] + M[1]; }
    double reduced() const { return M[0] * M[1] / mass(); }
    Vector3d apart() const { return r[1] - r[0]; }
    Vector3d speed_apart() const { return v[1] - v[0]; }
    Vector3d centre() const { return (r[0] * M[0] + r[1] * M[1]) / mass(); }
    Vector3d speed() const { return (v[0] * M[0] + v[1] * M[1]) / mass(); }
    /// s, after which the rope is at its end.
    double taut_at() const {
        if (!is_rope) return 0;
        const Vector3d d = apart(), u = speed_apart();
        const double b = d.dot(u), a = u.squaredNorm(), c = d.squaredNorm() - length * length;
        return (-b + std::sqrt(b * b - a * c)) / a;
    }
    /// What is apart of them at t, and how fast it changes.
    void at(double t, Vector3d& d, Vector3d& u) const {
        const double from = taut_at();
        if (t < from) {
            d = apart() + speed_apart() * t;
            u = speed_apart();
            return;
        }
        const Vector3d n = (apart() + speed_apart() * from) / length;
        const Vector3d across = speed_apart() - n * n.dot(speed_apart());
        const double fast = across.norm(), angle = fast / length * (t - from);
        const Vector3d along = fast > 0 ? Vector3d(across / fast) : Vector3d::Zero();
        d = length * (n * std::cos(angle) + along * std::sin(angle));
        u = fast * (along * std::cos(angle) - n * std::sin(angle));
    }
    /// rad/s, of the circle.
    double rate() const {
        Vector3d d, u;
        at(taut_at() + 1e-9, d, u);
        return u.norm() / length;
    }
};

/// rate_max: rad/s, of the circle, about as much. Masses that are as far apart as a hundred, either way round.
TwoBalls drawn_pair(RandomInput& random, double rate_max, bool is_rope) {
    TwoBalls two;
    two.is_rope = is_rope;
    two.g = random.integer(0, 1) == 0 ? Vector3d::Zero() : Vector3d(0, 0, -g);
    for (double& M : two.M) M = std::exp(random.real(0, std::log(100.0)));
    two.length = random.real(0.3, 2);
    two.r[0] = random.vector(2);
    const Vector3d n = random.direction(), across = n.cross(random.direction()).normalized();
    two.r[1] = two.r[0] + n * (is_rope ? two.length * random.real(0.5, 0.9) : two.length);
    const double fast = two.length * rate_max * random.real(0.3, 1);
    const Vector3d u = across * fast + (is_rope ? Vector3d(n * (fast * random.real(0.2, 1))) : Vector3d::Zero()), speed = random.vector(2);
    two.v[0] = speed - u * (two.M[1] / two.mass());
    two.v[1] = speed + u * (two.M[0] / two.mass());
    return two;
}

struct BuiltPair {
    ingot::BodyId balls[2];
    ingot::JointId tie;
};
BuiltPair add_pair(OnTiesWorld& world, const TwoBalls& two) {
    BuiltPair built;
    for (int i = 0; i < 2; ++i) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, scalar(0.1)), static_cast<scalar>(two.M[i]))).value;
        def.state.r_CM = to_vector(two.r[i]);
        def.state.v_CM = to_vector(two.v[i]);
        built.balls[i] = world.add(def).value;
    }
    ingot::JointDef def;
    def.body_A = built.balls[0];
    def.body_B = built.balls[1];
    def.P = to_vector(two.r[0]);
    def.P_B = to_vector(two.r[1]);
    if (two.is_rope) def.joint = ingot::RopeJoint{static_cast<scalar>(two.length)};
    else def.joint = ingot::RodJoint{static_cast<scalar>(two.length)};
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok());
    built.tie = id.value;
    return built;
}

TEST(PairsOnTies, probe) {
    RandomInput random(1);
    for (int run_i = 0; run_i < 60; ++run_i) {
        const bool is_rope = run_i % 2 == 0;
        const double rate = rates[random.integer(0, 4)], h = 1 / rate;
        const double per_step = std::exp(random.real(std::log(0.02), std::log(2.0)));
        const TwoBalls two = drawn_pair(random, per_step * rate, is_rope);
        const auto world = std::make_unique<OnTiesWorld>();
        ASSERT_EQ(world->set_gravity(to_vector(two.g)), Status::ok);
        const BuiltPair built = add_pair(*world, two);
        const int steps = 60;
        double gap = 0, off = 0, energy = 0, radial = 0, offT = 0, offc = 0;
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(h)).clean());
            Vector3d r[2], v[2];
            for (int i = 0; i < 2; ++i) {
                r[i] = to_eigen(world->state(built.balls[i]).value.r_CM);
                v[i] = to_eigen(world->state(built.balls[i]).value.v_CM);
            }
            Vector3d d, u;
            two.at(step_i * h, d, u);
            const Vector3d dk = r[1] - r[0], uk = v[1] - v[0];
            gap = std::max(gap, is_rope ? dk.norm() - two.length : std::abs(dk.norm() - two.length));
            off = (dk - d).norm() / two.length;
            const double fast = two.rate() * two.length;
            if (step_i * h > two.taut_at() + h) {
                energy = std::max(energy, std::abs(uk.norm() / fast - 1));
                radial = std::max(radial, std::abs(uk.dot(dk) / dk.norm()) / fast);
                const Vector3d F = to_eigen(world->joint_reaction(built.tie).value.force);
                offT = std::max(offT, std::abs(F.norm() / (two.reduced() * fast * two.rate()) - 1));
            }
            const Vector3d c = (r[0] * two.M[0] + r[1] * two.M[1]) / two.mass();
            const double t = step_i * h;
            offc = (c - (two.centre() + two.speed() * t + two.g * (t * t / 2))).norm();
        }
        std::printf("%d %s %g Hz turn/step %.3f M %.1f %.1f: gap %.1e off %.2e (after %.1f rad) speed %.1e radial %.1e tension %.1e centre %.1e\n", run_i, is_rope ? "rope" : "rod ", rate,
                    two.rate() * h, two.M[0], two.M[1], gap, off, two.rate() * (steps * h - two.taut_at()), energy, radial, offT, offc);
    }
}

}  // namespace
