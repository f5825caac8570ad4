// SPDX-License-Identifier: MIT
// Drives at their largest torque, as stiff as can be, that press on the ground and on walls.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include <ingot/figure/torque_of_ball.h>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;
using ingot_reference::to_eigen;
using Eigen::Matrix3d;
using Eigen::Vector3d;

scalar number(double x) { return static_cast<scalar>(x); }

/// Three rows as one: no more than there is, all of it where more is asked for, and along what is asked for. Answers are those of a joint, symmetric,
/// or of a servo, whose child is measured alone: K is symmetric and a part that is not.
TEST(TorqueOfBall, is_along_what_is_asked_for) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(3000); ++run_i) {
        Matrix3d axes;
        axes.col(0) = random.direction();
        axes.col(1) = axes.col(0).unitOrthogonal();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        const double scale = std::exp(random.real(std::log(1e-3), std::log(1e3)));
        Vector3d main;
        for (double& of : main) of = scale * std::exp(random.real(std::log(1e-2), 0));
        Matrix3d K = axes * main.asDiagonal() * axes.transpose();
        if (random.integer(0, 1) == 1) {
            const Vector3d w = random.direction() * (0.5 * main.minCoeff());
            K += (Matrix3d() << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0).finished();
        }
        const double gamma = scale * std::exp(random.real(std::log(1e-4), std::log(10)));
        const Vector3d b = random.direction() * std::exp(random.real(std::log(1e-3), std::log(1e3)));
        const double free = (K + gamma * Matrix3d::Identity()).lu().solve(b).norm(), most = free * std::exp(random.real(std::log(1e-3), std::log(3)));
        const ingot::AnswerOfThree answer = {{to_vector(K.col(0)), to_vector(K.col(1)), to_vector(K.col(2))}};
        const Vector3d j = to_eigen(ingot::impulse_of_three(answer, number(gamma), to_vector(b), number(most)));
        const double rounding = 64 * eps * 100;  // of what has the condition of K
        ASSERT_LE(j.norm(), most * (1 + 8 * eps)) << run_i;
        const Vector3d asked = b - K * j - gamma * j;
        if (free <= most * (1 - rounding)) {
            ASSERT_LE(asked.norm(), rounding * b.norm()) << run_i;
            continue;
        }
        if (free < most * (1 + rounding)) continue;
        // j is cut by torque_settled, at most, of what solves it exactly: so much of b is left beside it.
        const double settled = static_cast<double>(ingot::limits::torque_settled);
        ASSERT_GE(j.norm(), most * (1 - settled - rounding)) << run_i;
        ASSERT_GE(asked.dot(j), -(settled + rounding) * b.norm() * j.norm()) << run_i;
        ASSERT_LE(asked.cross(j).norm(), (2 * settled + rounding) * b.norm() * j.norm()) << run_i;
    }
}

struct Press : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 10, max_manifolds = 40, max_pairs = 80;
    static constexpr bool translates = true;
    static constexpr ingot::Effort effort = {4, 12};
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::BallJoint, ingot::WithDrives>;
};
using PressWorld = ingot::World<Press>;

struct Limb {
    ingot::BodyId body;
    ingot::JointId joint{};
    bool is_ball = false;
    double stiffness = 0, damping = 0, most = 0;
    Vector3d target = Vector3d::Zero();  ///< rad; of a hinge x
};

/// An arm, or what lies about, of a few boxes: each on one before it, with drives of up to 1e6 N m/rad that want to be elsewhere.
struct Pressed {
    std::unique_ptr<PressWorld> world = std::make_unique<PressWorld>();
    std::vector<Limb> limbs;

    explicit Pressed(RandomInput& random, double h) {
        EXPECT_TRUE(weigh(*world) && add_ground(*world));
        ingot::BodyDef wall;
        wall.immovable = true;
        wall.shape = ingot::HalfSpace{{1, 0, 0}};
        wall.state.r_CM = {scalar(-1.5), 0, 0};
        EXPECT_TRUE(world->add(wall).ok());
        const int count = random.integer(2, 6);
        const double size = std::exp(random.real(std::log(0.05), std::log(0.4)));
        const bool tied = random.integer(0, 1) == 1;
        Vector3d P = {0, 0, 0.2 + 1.5 * size};
        for (int i = 0; i < count; ++i) {
            const Vector3d half = size * Vector3d(random.real(0.3, 1), random.real(0.3, 1), random.real(0.3, 1));
            ingot::BodyDef body;
            body.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, to_vector(half)), number(1000 * half.prod()))).value;
            body.shape = ingot::Box{to_vector(half)};
            body.state.r_CM = to_vector(P + Vector3d(half.x(), 0, 0));
            body.friction = number(random.real(0, 1));
            limbs.push_back({world->add(body).value, {}, random.integer(0, 1) == 1});
            Limb& limb = limbs.back();
            if (i > 0 || tied) {
                ingot::JointDef def;
                def.body_A = i > 0 ? limbs[limbs.size() - 2].body : ingot::BodyId{};
                def.body_B = limb.body;
                def.joint = limb.is_ball ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::HingeJoint{});
                def.P = to_vector(P);
                def.axis = to_vector(random.direction());
                limb.joint = world->add_joint(def).value;
            }
            P.x() += 2 * half.x();
        }
        const double load = 1000 * std::pow(size, 3) * g * size;
        for (Limb& limb : limbs) {
            limb.stiffness = std::exp(random.real(std::log(10), std::log(1e6)));
            limb.damping = limb.stiffness * h * random.real(0, 2);
            limb.most = load * std::exp(random.real(std::log(0.1), std::log(100)));
        }
    }
    /// All want to be somewhere else.
    void aim(RandomInput& random) {
        for (Limb& limb : limbs) {
            if (limb.joint == ingot::JointId{}) continue;
            limb.target = limb.is_ball ? random.real(0, 2) * random.direction() : Vector3d(random.real(-2, 2), 0, 0);
            const ingot::SpringDrive drive = {number(limb.stiffness), number(limb.damping), number(limb.target.x()), 0, 0, number(limb.most)};
            EXPECT_EQ(limb.is_ball ? world->set_ball_drive(limb.joint, drive, to_vector(limb.target)) : world->set_joint_drive(limb.joint, drive),
                      Status::ok);
        }
    }
    double torque_over_limit() const {
        double most = 0;
        for (const Limb& limb : limbs) {
            if (limb.joint == ingot::JointId{}) continue;
            const double given = limb.is_ball ? to_eigen(world->ball_torque(limb.joint).value).norm()
                                              : std::abs(static_cast<double>(world->drive_torque(limb.joint).value));
            most = std::max(most, given / limb.most);
        }
        return most;
    }
    /// J: of motion and weight, and what the drives can still give. It never grows: a drive that is cut at its largest torque gives no more than
    /// that, times its way.
    double energy() const {
        double sum = static_cast<double>(world->kinetic_energy());
        for (const Limb& limb : limbs) {
            sum += g * static_cast<double>(world->mass(limb.body).value) * static_cast<double>(world->state(limb.body).value.r_CM.z);
            if (limb.joint == ingot::JointId{}) continue;
            const double off = limb.is_ball ? off_of(to_eigen(world->ball_turn(limb.joint).value), limb.target)
                                            : std::abs(static_cast<double>(world->joint_angle(limb.joint).value) - limb.target.x());
            const double bend = limb.most / limb.stiffness;
            sum += off < bend ? limb.stiffness * off * off / 2 : limb.most * (off - bend / 2);
        }
        return sum;
    }
    double depth() const {
        double most = 0;
        for (const ingot::ContactInfo& contact : world->contacts()) most = std::max(most, -static_cast<double>(contact.separation));
        return most;
    }

private:
    static Matrix3d rotation(const Vector3d& turn) {
        const double angle = turn.norm();
        return angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Matrix3d(Matrix3d::Identity());
    }
    static double off_of(const Vector3d& turn, const Vector3d& target) {
        return Eigen::AngleAxisd(Matrix3d(rotation(turn) * rotation(target).transpose())).angle();
    }
};

/// At any rate and any stiffness up to 1e6: no energy but what the drives have, and no more torque than they may give, in steps that have settled and
/// in those that say that they have not.
TEST(TorqueLimits, of_stiff_drives_that_press_are_kept_and_give_no_energy) {
    RandomInput random(2);
    int steps = 0, told = 0;
    double gain = 0, deepest = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(0, 4)];
        Pressed pressed(random, 1 / rate);
        for (int round = 0; round < 2; ++round) {
            pressed.aim(random);
            const double begin = pressed.energy();
            for (int step_i = 0; step_i < static_cast<int>(1.5 * rate); ++step_i) {
                const ingot::StepReport report = ingot::step(*pressed.world, number(1 / rate));
                ASSERT_EQ(report.status, Status::ok);
                ASSERT_EQ(report.bodies_frozen, 0) << run_i;
                ++steps;
                told += report.clean() ? 0 : 1;
                ASSERT_LE(pressed.torque_over_limit(), 1 + 64 * eps) << run_i << ", " << rate << " Hz, step " << step_i;
                gain = std::max(gain, pressed.energy() / begin - 1);
                deepest = std::max(deepest, pressed.depth());
                ASSERT_LE(pressed.energy(), 1.02 * begin) << run_i << ", " << rate << " Hz, step " << step_i;
            }
        }
    }
    RecordProperty("largest_gain", std::to_string(gain));
    RecordProperty("deepest_mm", std::to_string(1000 * deepest));
    RecordProperty("told_share", std::to_string(static_cast<double>(told) / steps));
}

}  // namespace
