// SPDX-License-Identifier: MIT
// What swings far in a step goes along its arc: posts inside of it are not met, however near the chord of a step comes to them, and posts in its way
// are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 4, max_manifolds = 24, max_pairs = 60;
    static constexpr bool translates = true, continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};
using SwingingWorld = ingot::World<Swinging>;

/// A ball that goes in a circle of radius R about z, `turn` rad a step, from `phase` on. place: of the centre.
struct Swing {
    double R, radius, turn, phase;
    Vector3d centre;

    Vector3d at(double steps, double distance) const {
        const double angle = phase + turn * steps;
        return centre + distance * Vector3d(std::cos(angle), std::sin(angle), 0);
    }
    /// m, by which the way of a step leaves the circle: a hundredth of the radius times the cube of the angle.
    double off_circle() const { return 0.01 * R * turn * turn * turn; }
    double off_chord() const { return R * (1 - std::cos(turn / 2)); }
};

Swing drawn_swing(RandomInput& random) {
    const double R = random.real(0.5, 2);
    return {R, R * random.real(0.01, 0.04), random.real(0.4, 0.8), random.real(0, 6), Vector3d(random.vector(3))};
}

ingot::BodyId add_swing(SwingingWorld& world, const Swing& swing, double rate, bool by_hinge) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, static_cast<scalar>(swing.radius)), 2)).value;
    def.shape = ingot::Sphere{static_cast<scalar>(swing.radius)};
    def.state.r_CM = to_vector(swing.at(0, swing.R));
    const Vector3d omega(0, 0, swing.turn * rate);
    def.state.v_CM = to_vector(omega.cross(swing.at(0, swing.R) - swing.centre));
    def.state.L = to_vector(omega * static_cast<double>(def.mass.I_body.x));
    const ingot::BodyId id = world.add(def).value;
    ingot::JointDef joint;
    joint.body_B = id;
    joint.P = to_vector(swing.centre);
    joint.axis = {0, 0, 1};
    joint.joint = by_hinge ? ingot::Joint(ingot::HingeJoint{}) : ingot::Joint(ingot::BallJoint{});
    EXPECT_TRUE(world.add_joint(joint).ok());
    return id;
}

ingot::BodyId add_post(SwingingWorld& world, const Vector3d& place, double radius) {
    ingot::BodyDef def;
    def.immovable = true;
    def.shape = ingot::Sphere{static_cast<scalar>(radius)};
    def.state.r_CM = to_vector(place);
    return world.add(def).value;
}

/// Posts at the middle of some of its steps, inside of the circle by more than the path of a step may be off, and less than a chord would be: the
/// ball goes on as if they were not there.
TEST(Swings, pass_what_is_inside_of_their_arc) {
    RandomInput random(1);
    int posts = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(400); ++run_i) {
        const Swing swing = drawn_swing(random);
        const double rate = rates[random.integer(0, 4)], roundings = 64 * eps * 10;
        const auto world = std::make_unique<SwingingWorld>(), alone = std::make_unique<SwingingWorld>();
        const bool by_hinge = run_i % 2 == 0;
        const ingot::BodyId ball = add_swing(*world, swing, rate, by_hinge), free = add_swing(*alone, swing, rate, by_hinge);
        for (int step_i = 1; step_i < 7; ++step_i) {
            const double clear = swing.off_circle() * 1.5 + 2 * roundings + 0.1 * swing.off_chord(), least = 0.7 * swing.off_chord();
            const double radius = swing.radius * random.real(0.5, 1);
            if (clear >= least || random.integer(0, 2) == 0) continue;
            const Vector3d place = swing.at(step_i + 0.5, swing.R - swing.radius - radius - random.real(clear, least));
            // Where the step begins and ends the two are apart by more than contacts look ahead.
            if ((place - swing.at(step_i, swing.R)).norm() < 2.5 * (swing.radius + radius)) continue;
            add_post(*world, place, radius);
            ++posts;
        }
        for (int step_i = 0; step_i < 8; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            ASSERT_TRUE(ingot::step(*alone, static_cast<scalar>(1 / rate)).clean());
            const ingot::BodyState a = world->state(ball).value, b = alone->state(free).value;
            ASSERT_EQ((to_eigen(a.r_CM) - to_eigen(b.r_CM)).norm(), 0) << run_i << ", step " << step_i << ", " << swing.turn << " rad a step";
            ASSERT_EQ((to_eigen(a.v_CM) - to_eigen(b.v_CM)).norm(), 0) << run_i << ", step " << step_i;
            // It does go in the circle that the posts are beside.
            ASSERT_LE((to_eigen(b.r_CM) - swing.centre).norm() - swing.R, held) << run_i;
        }
    }
    EXPECT_GT(posts, ingot_reference::draws(400));
}

/// And a post in the way of the arc, beyond the chord: the ball does not get past it.
TEST(Swings, do_not_pass_what_is_in_their_arc) {
    RandomInput random(2);
    int stopped = 0, waited = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(400); ++run_i) {
        const Swing swing = drawn_swing(random);
        const double rate = rates[random.integer(0, 4)], radius = swing.radius * random.real(0.5, 1);
        const auto world = std::make_unique<SwingingWorld>();
        const ingot::BodyId ball = add_swing(*world, swing, rate, run_i % 2 == 0);
        const int at_step = random.integer(1, 3);
        const double reach = swing.radius + radius, in_way = 0.5 * reach - swing.off_circle();
        if (in_way <= 0) continue;
        const Vector3d place = swing.at(at_step + random.real(0.3, 0.7), swing.R + random.real(0, in_way));
        if ((place - swing.at(at_step, swing.R)).norm() < 2.5 * reach || (place - swing.at(at_step + 1, swing.R)).norm() < 2.5 * reach) continue;
        const ingot::BodyId post = add_post(*world, place, radius);
        const Vector3d to_post = (place - swing.centre).normalized();
        double furthest = -1;
        double energy = static_cast<double>(world->kinetic_energy());
        for (int step_i = 0; step_i < at_step + 2; ++step_i) {
            (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            // It is stopped by a contact, or it waits there until the next step: then its way that was cut short has taken nothing of its energy,
            // beside the hundredth that so far a turn in a step loses.
            const double now = static_cast<double>(world->kinetic_energy());
            if (step_i <= at_step && now > 0.5 * energy) {
                ++waited;
                EXPECT_NEAR(now, energy, 0.02 * energy) << run_i << ", " << swing.turn << " rad a step";
            }
            energy = now;
            const Vector3d r = to_eigen(world->state(ball).value.r_CM) - swing.centre;
            // rad, beyond the post: it comes from before it.
            furthest = std::max(furthest, std::asin(to_post.cross(r.normalized()).z()));
            EXPECT_GE((to_eigen(world->state(ball).value.r_CM) - to_eigen(world->state(post).value.r_CM)).norm(),
                      reach - 0.5 * std::min(swing.radius, radius)) << run_i;
        }
        EXPECT_LE(furthest, 0) << run_i << ", " << swing.turn << " rad a step";
        ++stopped;
    }
    EXPECT_GT(stopped, ingot_reference::draws(400) / 3);
    EXPECT_GT(waited, ingot_reference::draws(400) / 3);
}

/// Dumb-bells and nets: balls on rods, which close loops or hold single bodies together.
struct Rodded : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 16, max_loops = 16, max_manifolds = 40, max_pairs = 100;
    static constexpr bool translates = true, continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::RodJoint>;
};

/// Thrown at a plate, one ball of them first, in whichever order they were added: all that rods hold together waits where one of it meets the plate,
/// so rods are as long as they were, and nobody is beyond it.
TEST(FastOnRods, are_stopped_together) {
    RandomInput random(3);
    int stopped = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(240); ++run_i) {
        const auto world = std::make_unique<ingot::World<Rodded>>();
        ASSERT_EQ(world->set_gravity({}), Status::ok);
        const double rate = rates[random.integer(0, 4)], radius = random.real(0.05, 0.1), length = random.real(0.3, 1);
        const int count = random.integer(2, 5);
        const Eigen::Matrix3d R = random.rotation();
        std::vector<Vector3d> places = {Vector3d(0, 0, 1.5)};
        for (int i = 1; i < count; ++i) {
            Vector3d way = random.direction();
            way.z() = std::abs(way.z());
            places.push_back(places[static_cast<size_t>(random.integer(0, i - 1))] + way * length);
        }
        const Vector3d v(random.real(-1, 1), random.real(-1, 1), -random.real(4, 20) * radius * rate);
        ingot::BodyDef plate;
        plate.immovable = true;
        plate.shape = ingot::Box{{50, 50, scalar(0.01)}};
        plate.state.A = ingot_reference::to_matrix(R);
        plate.state.r_CM = to_vector(R * Vector3d(0, 0, -0.01));
        const bool plate_first = random.integer(0, 1) == 0;
        if (plate_first) {
            ASSERT_TRUE(world->add(plate).ok());
        }
        std::vector<ingot::BodyId> balls(places.size());
        for (int k = 0; k < count; ++k) {
            const auto i = static_cast<size_t>(run_i % 2 == 0 ? k : count - 1 - k);
            ingot::BodyDef def;
            const auto M = static_cast<scalar>(std::exp(random.real(0, 3)));
            def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, static_cast<scalar>(radius)), M)).value;
            def.shape = ingot::Sphere{static_cast<scalar>(radius)};
            def.state.r_CM = to_vector(R * places[i]);
            def.state.v_CM = to_vector(R * v);
            balls[i] = world->add(def).value;
        }
        if (!plate_first) {
            ASSERT_TRUE(world->add(plate).ok());
        }
        struct Rod {
            ingot::JointId id;
            size_t A, B;
            double length;
        };
        std::vector<Rod> rods;
        for (size_t i = 1; i < places.size(); ++i)
            for (size_t k = 0; k < i; ++k) {
                if (k + 1 < i && random.integer(0, 2) != 0) continue;
                ingot::JointDef def;
                def.body_A = balls[k];
                def.body_B = balls[i];
                def.P = world->state(balls[k]).value.r_CM;
                def.P_B = world->state(balls[i]).value.r_CM;
                def.joint = ingot::RodJoint{};
                const auto id = world->add_joint(def);
                ASSERT_TRUE(id.ok());
                rods.push_back({id.value, k, i, (places[i] - places[k]).norm()});
            }
        bool met = false;
        for (int step_i = 0; step_i < 10; ++step_i) {
            (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            const Vector3d speed = R.transpose() * to_eigen(world->state(balls[0]).value.v_CM);
            met = met || speed.z() > 0.9 * v.z();
            const auto place = [&](size_t i) { return Vector3d(R.transpose() * to_eigen(world->state(balls[i]).value.r_CM)); };
            for (const Rod& rod : rods)
                ASSERT_LE(std::abs((place(rod.B) - place(rod.A)).norm() - rod.length), static_cast<double>(ingot::limits::parted_gap))
                    << run_i << ", step " << step_i << ", " << rate << " Hz";
            for (size_t i = 0; i < balls.size(); ++i) ASSERT_GE(place(i).z(), 0.25 * radius) << run_i << ", step " << step_i << ", ball " << i;
        }
        stopped += met ? 1 : 0;
    }
    EXPECT_GT(stopped, ingot_reference::draws(240) / 4);
}

}  // namespace
