// SPDX-License-Identifier: MIT
// Bodies that are drawn to a target: as their spring swings, within their force, and whatever hangs on them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;
using ingot_reference::to_eigen;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Drawing : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24, max_loops = 8;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::TargetJoint>;
};
using DrawingWorld = ingot::World<Drawing>;

struct Floor : Drawing {
    static constexpr int max_manifolds = 40, max_pairs = 100;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};
using FloorWorld = ingot::World<Floor>;

constexpr double pi = 3.14159265358979323846;

template <class Scene>
ingot::BodyId add_box(ingot::World<Scene>& world, double M, const Vector& half, const Vector& place, const Matrix3d& A = Matrix3d::Identity()) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half), static_cast<scalar>(M))).value;
    if constexpr (ingot::has_shapes<Scene>) def.shape = ingot::Box{half};
    def.state.r_CM = place;
    def.state.A = ingot_reference::to_matrix(A);
    return world.add(def).value;
}
template <class World>
ingot::JointId draw(World& world, ingot::BodyId body, const ingot::TargetDrive& drive, const Vector3d& off = Vector3d::Zero()) {
    ingot::JointDef def;
    def.body_B = body;
    def.joint = ingot::TargetJoint{};
    def.P = world.state(body).value.r_CM + to_vector(off);
    const ingot::JointId id = world.add_joint(def).value;
    EXPECT_EQ(world.set_target_drive(id, drive), Status::ok);
    return id;
}
ingot::TargetDrive tuned(double hertz, double ratio) { return {static_cast<scalar>(hertz), static_cast<scalar>(ratio)}; }

/// A body drawn by itself has at the end of each substep what the poles of the exact motion make of it: two steps tell the product and the sum, which
/// are exp(h lambda) of hertz and damping ratio, whatever its mass, its shape and its turn.
TEST(Targets, have_the_poles_of_their_spring) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(1, 4)], hertz = random.real(0.5, 0.02 * rate), ratio = random.real(0.1, 2);
        const auto world = std::make_unique<DrawingWorld>();
        const Vector half = to_vector(Vector3d(random.real(0.2, 1), random.real(0.2, 1), random.real(0.2, 1)));
        const ingot::BodyId body = add_box(*world, std::exp(random.real(0, std::log(1000))), half, {}, random.rotation());
        const ingot::JointId id = draw(*world, body, tuned(hertz, ratio));
        ASSERT_EQ(world->set_target(id, {1, 0, 0}), Status::ok);
        const double h = 1 / (rate * Drawing::effort.substeps), w = 2 * pi * hertz;
        const double p = std::exp(-2 * ratio * w * h);
        const double s = ratio < 1 ? 2 * std::exp(-ratio * w * h) * std::cos(w * std::sqrt(1 - ratio * ratio) * h)
                                   : 2 * std::exp(-ratio * w * h) * std::cosh(w * std::sqrt(ratio * ratio - 1) * h);
        // The same recursion, by itself.
        double x = -1, v = 0, most = 0;
        for (int step_i = 0; step_i < 20; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            for (int i = 0; i < Drawing::effort.substeps; ++i) {
                v = p * v - (1 + p - s) * x / h;
                x += h * v;
            }
            most = std::max(most, std::abs(v));
            const ingot::BodyState state = world->state(body).value;
            // 1 + p - s loses digits where it is computed so.
            const double rounding = 1e3 * eps * (1 + most / w) + 1e-15 / (w * h * w * h);
            EXPECT_NEAR(static_cast<double>(state.r_CM.x), 1 + x, rounding) << run_i << ", " << hertz << " Hz, " << ratio;
            EXPECT_LE(std::abs(static_cast<double>(state.r_CM.y)), rounding) << run_i;
        }
    }
}

/// Frequency and decay of a swing, read from its turning points, are those of its spring within 1 %.
TEST(Targets, swing_by_hertz_and_damping_ratio) {
    for (const double rate : {60.0, 240.0})
        for (const double hertz : {1.0, 2.0})
            for (const double ratio : {0.05, 0.2}) {
                const auto world = std::make_unique<DrawingWorld>();
                const ingot::BodyId body = add_box(*world, 3, {1, scalar(0.5), scalar(0.2)}, {});
                const ingot::JointId id = draw(*world, body, tuned(hertz, ratio));
                ASSERT_EQ(world->set_target(id, {1, 0, 0}, ingot::axis_angle({0, 0, 1}, scalar(0.01))), Status::ok);
                const double w = 2 * pi * hertz, wd = w * std::sqrt(1 - ratio * ratio);
                // x(t) = -exp(-z w t) (cos wd t + ...): passes its target every half period, and loses exp(-z w pi / wd) in one.
                double before = -1, t_before = 0, last_crossing = -1, first_crossing = -1, peak = 0, first_peak = 0, last_peak = 0;
                int crossings = 0;
                for (int step_i = 1; step_i <= static_cast<int>(4 * rate / hertz); ++step_i) {
                    ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
                    const double x = static_cast<double>(world->state(body).value.r_CM.x) - 1, t = step_i / rate;
                    peak = std::max(peak, std::abs(x));
                    if (x * before < 0) {
                        last_crossing = t_before + (t - t_before) * before / (before - x);
                        if (crossings == 0) first_crossing = last_crossing;
                        if (crossings == 1) first_peak = peak;
                        last_peak = peak;
                        peak = 0;
                        ++crossings;
                    }
                    before = x;
                    t_before = t;
                }
                ASSERT_GT(crossings, 4);
                EXPECT_NEAR((crossings - 1) * pi / (last_crossing - first_crossing), wd, 0.01 * wd) << rate << " Hz, " << hertz << ", " << ratio;
                const double decay = std::log(first_peak / last_peak) / ((crossings - 2) * pi / wd);
                EXPECT_NEAR(decay, ratio * w, 0.01 * w) << rate << " Hz, " << hertz << ", " << ratio;
            }
}

double angle_between(const ingot::Matrix& A, const ingot::Matrix& B) {
    const Matrix3d R = to_eigen(A) * to_eigen(B).transpose();
    return std::acos(std::max(-1.0, std::min(1.0, (R.trace() - 1) / 2)));
}

/// Any pose is reached from any other, stiff or soft, and held against gravity by as much as the spring gives.
TEST(Targets, are_reached) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(0, 4)], hertz = random.real(1, 20);
        const auto world = std::make_unique<DrawingWorld>();
        ASSERT_TRUE(weigh(*world));
        const ingot::BodyId body = add_box(*world, random.real(1, 1000), {1, scalar(0.5), scalar(0.2)}, {}, random.rotation());
        const ingot::JointId id = draw(*world, body, tuned(hertz, 1));
        const Vector3d P = random.vector(5);
        const ingot::Matrix A = ingot_reference::to_matrix(random.rotation());
        ASSERT_EQ(world->set_target(id, to_vector(P), A), Status::ok);
        for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i)
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        const ingot::BodyState state = world->state(body).value;
        const double phase = std::min(2 * pi * hertz / (rate * Drawing::effort.substeps), static_cast<double>(ingot::limits::tuned_turn_max));
        const double w = phase * rate * Drawing::effort.substeps, sag = g / (w * w);
        // What a substep of the spring makes of a load goes like its phase.
        EXPECT_NEAR(static_cast<double>(state.r_CM.z), P.z() - sag, 2 * phase * sag + 1e-4) << run_i << ", " << hertz << " Hz at " << rate;
        EXPECT_NEAR(static_cast<double>(state.r_CM.x), P.x(), 1e-4) << run_i;
        EXPECT_LE(angle_between(state.A, A), 1e-3) << run_i;
        const double M = static_cast<double>(world->mass(body).value);
        EXPECT_NEAR(static_cast<double>(world->target_force(id).value.z), M * g, 1e-3 * M * g) << run_i;
    }
}

/// An animation that tells its velocity is followed by what its curvature gives in a spring's time, and no lag.
TEST(Targets, follow_an_animation) {
    for (const double rate : {60.0, 240.0}) {
        const auto world = std::make_unique<DrawingWorld>();
        const ingot::BodyId body = add_box(*world, 5, {scalar(0.3), scalar(0.2), scalar(0.1)}, {1, 0, 0});
        const ingot::JointId id = draw(*world, body, tuned(10, 1));
        const double turn = 1;  // rad/s, about the origin
        double worst = 0;
        for (int step_i = 0; step_i < static_cast<int>(4 * rate); ++step_i) {
            const double a = turn * step_i / rate;
            const ingot::Matrix A = ingot::axis_angle({0, 0, 1}, static_cast<scalar>(a));
            ASSERT_EQ(world->set_target(id, to_vector(Vector3d(std::cos(a), std::sin(a), 0)), A,
                                        to_vector(turn * Vector3d(-std::sin(a), std::cos(a), 0)), {0, 0, static_cast<scalar>(turn)}),
                      Status::ok);
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            if (step_i < rate) continue;
            const double end = turn * (step_i + 1) / rate;
            worst = std::max(worst, (to_eigen(world->state(body).value.r_CM) - Vector3d(std::cos(end), std::sin(end), 0)).norm());
        }
        std::printf("    %g Hz: %.2e m behind\n", rate, worst);
        const double w = 2 * pi * 10;
        EXPECT_LE(worst, 2 * (turn * turn / (w * w) + turn / rate / rate)) << rate;
    }
}

/// Where a point goes by the same law, force and all, in steps of 10 us: m.
Vector3d drawn_point(double M, const ingot::TargetDrive& drive, const Vector3d& target, double time) {
    const double w = 2 * pi * static_cast<double>(drive.hertz), most = static_cast<double>(drive.max_force), h = 1e-5;
    Vector3d x = Vector3d::Zero(), v = Vector3d::Zero();
    for (int i = 0; i < static_cast<int>(std::lround(time / h)); ++i) {
        Vector3d F = M * (w * w * (target - x) - 2 * static_cast<double>(drive.damping_ratio) * w * v);
        if (F.norm() > most) F *= most / F.norm();
        v += h * (F / M - Vector3d(0, 0, g));
        x += h * v;
    }
    return x;
}

/// No step gives more than the largest force and torque, and a body goes where the law leads that has no more: a load that is too heavy sinks.
TEST(Targets, keep_to_their_force) {
    RandomInput random(3);
    double worst = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(1, 4)], M = std::exp(random.real(0, std::log(1000))), weight = M * g;
        const auto world = std::make_unique<DrawingWorld>();
        ASSERT_TRUE(weigh(*world));
        const ingot::BodyId body = add_box(*world, M, {scalar(0.4), scalar(0.3), scalar(0.2)}, {});
        ingot::TargetDrive drive = tuned(random.real(0.5, 2), 1);
        drive.max_force = static_cast<scalar>(weight * random.real(0.5, 3));
        drive.max_torque = static_cast<scalar>(0.3 * M);
        const ingot::JointId id = draw(*world, body, drive);
        const Vector3d target(3, 0, 4);
        ASSERT_EQ(world->set_target(id, to_vector(target), ingot::axis_angle({0, 1, 0}, 2)), Status::ok);
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            const double force = to_eigen(world->target_force(id).value).norm(), torque = to_eigen(world->target_torque(id).value).norm();
            ASSERT_LE(force, static_cast<double>(drive.max_force) * (1 + 64 * eps)) << run_i << ", step " << step_i;
            ASSERT_LE(torque, static_cast<double>(drive.max_torque) * (1 + 64 * eps)) << run_i << ", step " << step_i;
        }
        const double off = (to_eigen(world->state(body).value.r_CM) - drawn_point(M, drive, target, 2)).norm();
        // A substep moves by the velocity of its end: of first order, of speeds up to 2 g t and phases up to 2 pi hertz h.
        const double h = 1 / (rate * Drawing::effort.substeps), allowed = h / 2 * (4 * g + 2 * pi * static_cast<double>(drive.hertz) * 5);
        EXPECT_LE(off, allowed) << run_i << ", " << rate << " Hz";
        worst = std::max(worst, off / allowed);
    }
    std::printf("    %.2f of what first order allows\n", worst);
}

/// A ragdoll is dragged over the floor by its hand, as by a mouse that grabs a point and turns nothing; it stays together.
TEST(Targets, drag_a_ragdoll) {
    for (const double rate : {30.0, 60.0, 240.0}) {
        const auto world = std::make_unique<FloorWorld>();
        ASSERT_TRUE(add_ground(*world) && weigh(*world));
        Built built;
        add_ragdoll(*world, {0, 0, scalar(0.2)}, ingot::identity_matrix<scalar>(), built);
        ASSERT_TRUE(built.sound);
        ingot::TargetDrive mouse = tuned(15, 0.7);  // of the hand by itself
        mouse.max_force = 2000;
        mouse.max_torque = 0;
        const ingot::JointId id = draw(*world, built.bodies[4], mouse, {0.02, 0.03, 0});
        const Vector begin = world->state(built.bodies[4]).value.r_CM + to_vector(Vector3d(0.02, 0.03, 0));
        double gap = 0;
        for (int step_i = 0; step_i < static_cast<int>(4 * rate); ++step_i) {
            const double t = step_i / rate;
            ASSERT_EQ(world->set_target(id, begin + to_vector(Vector3d(t, std::sin(2 * t), std::min(t, 1.3)))), Status::ok);
            const ingot::StepReport report = ingot::step(*world, static_cast<scalar>(1 / rate));
            ASSERT_EQ(report.bodies_frozen + report.contacts_lost + report.joints_lost, 0);
            gap = std::max(gap, worst_gap(*world, built));
            ASSERT_EQ(to_eigen(world->target_torque(id).value).norm(), 0);
        }
        EXPECT_LE(gap, 5e-5) << rate;
        EXPECT_LE(world->joint_gap(id).value, scalar(0.3)) << rate;
        for (const ingot::BodyId body : built.bodies) EXPECT_GT(world->state(body).value.r_CM.z, scalar(0.02)) << rate;
    }
}

/// Held still, a body sleeps; a target that is set wakes it, and one that moves keeps it awake.
TEST(Targets, wake_what_they_draw) {
    const auto world = std::make_unique<FloorWorld>();
    ASSERT_TRUE(weigh(*world));
    const ingot::BodyId body = add_box(*world, 2, {scalar(0.3), scalar(0.2), scalar(0.1)}, {0, 0, 2});
    const ingot::JointId id = draw(*world, body, tuned(5, 1));
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) (void)ingot::step(*world, scalar(1) / 60);
    };
    run(300);
    EXPECT_TRUE(world->is_asleep(body));
    ASSERT_EQ(world->set_target(id, {1, 0, 2}, Vector{scalar(0.001), 0, 0}), Status::ok);
    EXPECT_FALSE(world->is_asleep(body));
    run(600);
    EXPECT_FALSE(world->is_asleep(body));
    EXPECT_NEAR(static_cast<double>(world->state(body).value.r_CM.x), 1.01, 1e-3);
    ASSERT_EQ(world->set_target(id, {0, 0, 2}), Status::ok);
    run(300);
    EXPECT_TRUE(world->is_asleep(body));
    ASSERT_EQ(world->remove(id), Status::ok);
    run(30);
    EXPECT_LT(world->state(body).value.v_CM.z, scalar(-3));
}

/// However slowly a target moves, far below what counts as rest, what it draws stays awake, and what others draw sleeps.
TEST(Targets, that_move_slowly_let_nobody_sleep) {
    RandomInput random(25);
    const auto world = std::make_unique<FloorWorld>();
    ASSERT_TRUE(weigh(*world));
    std::vector<ingot::BodyId> bodies;
    for (int i = 0; i < 6; ++i) {
        bodies.push_back(add_box(*world, 2, {scalar(0.3), scalar(0.2), scalar(0.1)}, {static_cast<scalar>(2 * i), 0, 2}));
        const ingot::JointId id = draw(*world, bodies.back(), tuned(5, 1));
        const Vector slow = to_vector(random.direction() * std::ldexp(static_cast<double>(ingot::limits::sleep_speed), -random.integer(2, 9)));
        const Vector place = world->state(bodies.back()).value.r_CM;
        const ingot::Matrix level = ingot::identity_matrix<scalar>();
        const Status status = i % 3 == 0   ? world->set_target(id, place, slow)
                              : i % 3 == 1 ? world->set_target(id, place, level, {}, slow)
                                           : world->set_target(id, place);
        ASSERT_EQ(status, Status::ok);
    }
    for (int i = 0; i < 300; ++i) (void)ingot::step(*world, scalar(1) / 60);
    for (size_t i = 0; i < bodies.size(); ++i) EXPECT_EQ(world->is_asleep(bodies[i]), i % 3 == 2) << i;
}

std::vector<uint8_t> saved(const FloorWorld& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<Floor>());
    bytes.resize(ingot::save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}

/// Saved as it is drawn, a body goes on to the same bits.
TEST(Targets, go_on_from_a_snapshot) {
    const auto world = std::make_unique<FloorWorld>(), other = std::make_unique<FloorWorld>();
    ASSERT_TRUE(weigh(*world));
    const ingot::BodyId body = add_box(*world, 2, {scalar(0.3), scalar(0.2), scalar(0.1)}, {0, 0, 2});
    ingot::TargetDrive drive = tuned(3, 0.3);
    drive.max_force = 30;
    const ingot::JointId id = draw(*world, body, drive, {0.3, 0.2, 0.1});
    ASSERT_EQ(world->set_target(id, {3, 2, 1}, ingot::axis_angle({1, 0, 0}, 1), {scalar(0.5), 0, 0}, {0, 0, 1}), Status::ok);
    for (int i = 0; i < 30; ++i) (void)ingot::step(*world, scalar(1) / 60);
    const auto bytes = saved(*world);
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), bytes.size()), Status::ok);
    for (int i = 0; i < 60; ++i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
    }
    EXPECT_EQ(world->state_hash(), other->state_hash());
}

/// At 0 Hz a target does not draw, whatever force it may take: its body goes as one that has none.
TEST(Targets, of_no_frequency_are_nothing) {
    for (const scalar most : {scalar(0), scalar(5), ingot::unlimited}) {
        const auto drawn = std::make_unique<DrawingWorld>(), free = std::make_unique<DrawingWorld>();
        std::vector<ingot::BodyId> bodies[2];
        for (auto* const world : {drawn.get(), free.get()}) {
            auto& of = bodies[world == drawn.get() ? 0 : 1];
            of.push_back(add_box(*world, 3, {scalar(0.3), scalar(0.2), scalar(0.1)}, {0, 0, 0}));
            ASSERT_EQ(world->apply_central_impulse(of[0], {3, 2, 1}), Status::ok);
            ASSERT_EQ(world->apply_angular_impulse(of[0], {scalar(0.1), scalar(0.2), scalar(0.3)}), Status::ok);
        }
        const ingot::JointId id = draw(*drawn, bodies[0][0], {0, 1, most, most});
        for (int step_i = 0; step_i < 60; ++step_i) {
            ASSERT_TRUE(ingot::step(*drawn, scalar(1) / 60).clean());
            ASSERT_TRUE(ingot::step(*free, scalar(1) / 60).clean());
            EXPECT_EQ(to_eigen(drawn->target_force(id).value).norm() + to_eigen(drawn->target_torque(id).value).norm(), 0);
        }
        const Vector3d r = to_eigen(drawn->state(bodies[0][0]).value.r_CM), L = to_eigen(drawn->state(bodies[0][0]).value.L);
        EXPECT_LE((r - to_eigen(free->state(bodies[1][0]).value.r_CM)).norm(), 256 * eps * r.norm());
        EXPECT_LE((L - to_eigen(free->state(bodies[1][0]).value.L)).norm(), 256 * eps * L.norm());
    }
}

/// What is wrong is refused, and nothing has changed.
TEST(Targets, that_are_bad_are_refused) {
    const auto world = std::make_unique<FloorWorld>();
    const ingot::BodyId A = add_box(*world, 1, {1, 1, 1}, {}), B = add_box(*world, 1, {1, 1, 1}, {5, 0, 0});
    const ingot::JointId id = draw(*world, A, tuned(5, 1));
    ingot::JointDef def;
    def.joint = ingot::BallJoint{};
    def.body_A = A;
    def.body_B = B;
    const ingot::JointId ball = world->add_joint(def).value;
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), far = 2 * ingot::limits::position_max;
    const auto before = saved(*world);
    const auto refused = [&](Status status, Status expected) {
        EXPECT_EQ(status, expected);
        EXPECT_EQ(saved(*world), before);
    };
    def.joint = ingot::TargetJoint{};
    refused(world->add_joint(def).status, Status::bad_joint);  // between two bodies
    def.body_B = {};
    refused(world->add_joint(def).status, Status::bad_joint);
    def.body_A = {};
    def.body_B = B;
    def.P.x = nan;
    refused(world->add_joint(def).status, Status::not_finite);
    refused(world->set_target(id, {nan, 0, 0}), Status::not_finite);
    refused(world->set_target(id, {0, far, 0}), Status::out_of_range);
    refused(world->set_target(id, {}, Vector{2 * ingot::limits::speed_max, 0, 0}), Status::out_of_range);
    refused(world->set_target(id, {}, ingot::Matrix{}), Status::not_a_rotation);
    refused(world->set_target(id, {1, 0, 0}, ingot::identity_matrix<scalar>(), {}, {0, nan, 0}), Status::not_finite);
    refused(world->set_target(ball, {}), Status::not_in_scene);
    refused(world->set_target_drive(ball, {}), Status::not_in_scene);
    refused(world->set_target_drive(id, {nan}), Status::not_finite);
    refused(world->set_target_drive(id, {-1}), Status::out_of_range);
    refused(world->set_target_drive(id, {1, -1}), Status::out_of_range);
    refused(world->set_target_drive(id, {1, 1, -1}), Status::out_of_range);
    refused(world->set_target_drive(id, {1, 1, 1, -1}), Status::out_of_range);
    ingot::JointId stale = id;
    stale.generation += 2;
    refused(world->set_target(stale, {}), Status::stale_id);
    EXPECT_EQ(world->target_force(ball).status, Status::not_in_scene);
    EXPECT_EQ(world->target_torque(stale).status, Status::stale_id);
}

}  // namespace
