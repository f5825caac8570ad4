// SPDX-License-Identifier: MIT
// Gears: the ratio of two joints, wherever they are, over any number of turns; what they share of torque, momentum and energy.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "random_trees.h"
#include "reference/draws.h"
#include "reference/powers_of_two.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;
using ingot_reference::to_eigen;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Geared : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 48, max_loops = 16;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::GearJoint, ingot::WithLimits, ingot::WithDrives>;
};
using GearedWorld = ingot::World<Geared>;

template <class Scene>
ingot::BodyId add_rotor(ingot::World<Scene>& world, double M, const Vector3d& half, const Vector3d& place, const Matrix3d& A = Matrix3d::Identity()) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, to_vector(half)), static_cast<scalar>(M))).value;
    if constexpr (ingot::has_shapes<Scene>) def.shape = ingot::Box{to_vector(half)};
    def.state.r_CM = to_vector(place);
    def.state.A = ingot_reference::to_matrix(A);
    return world.add(def).value;
}
template <class Scene>
ingot::JointId join(ingot::World<Scene>& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector3d& P, const Vector3d& axis) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = to_vector(P);
    def.axis = to_vector(axis);
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok());
    return id.value;
}
/// kg m^2, of a box of mass 1 about z.
double moment_about_z(const Vector3d& half) { return (half.x() * half.x() + half.y() * half.y()) / 3; }

/// Two rotors tied to the world, at rest; one is struck. What both get is what the equation of a train of gears says: (I_A + r^2 I_B) omega_A = H.
TEST(Gears, rotors_share_what_one_is_struck_by) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const auto world = std::make_unique<GearedWorld>();
        const double r = (random.integer(0, 1) * 2 - 1) * std::exp(random.real(-3, 3)), rate = rates[random.integer(0, 4)];
        const Vector3d half_A(random.real(0.2, 1), random.real(0.2, 1), 0.1), half_B(random.real(0.2, 1), random.real(0.2, 1), 0.1);
        const double M_A = random.real(1, 30), M_B = random.real(1, 30), I_A = M_A * moment_about_z(half_A), I_B = M_B * moment_about_z(half_B);
        const ingot::BodyId A = add_rotor(*world, M_A, half_A, {0, 0, 0}), B = add_rotor(*world, M_B, half_B, {3, 0, 0});
        const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 0}, {0, 0, 1});
        const bool turned = random.integer(0, 1) == 1;  // A of it is the body: its angle goes the other way
        const ingot::JointId at_B = turned ? join(*world, ingot::HingeJoint{}, B, {}, {3, 0, 0}, {0, 0, 1})
                                           : join(*world, ingot::HingeJoint{}, {}, B, {3, 0, 0}, {0, 0, 1});
        const auto gear = world->add_gear(at_A, at_B, static_cast<scalar>(r));
        ASSERT_TRUE(gear.ok());
        const double H = random.real(0.1, 1) * I_A;
        ASSERT_EQ(world->apply_angular_impulse(A, {0, 0, static_cast<scalar>(H)}), Status::ok);
        const double omega = H / (I_A + r * r * I_B);
        for (int step_i = 0; step_i < 20; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            const double rounding = 64 * eps * (1 + std::abs(r)) * H / I_A;
            EXPECT_NEAR(static_cast<double>(world->joint_rate(at_A).value), omega, rounding) << run_i << ", " << step_i;
            EXPECT_NEAR(static_cast<double>(world->joint_rate(at_B).value), r * omega, std::max(1.0, std::abs(r)) * rounding) << run_i;
            EXPECT_LE(static_cast<double>(world->joint_gap(gear.value).value), 64 * eps * (1 + std::abs(r))) << run_i << ", " << step_i;
        }
    }
}

/// Two rotors that have turned for a while are coupled where they are: none is turned by that, and from there on the one goes its ratio of what the
/// other goes, as often as they are coupled and let go.
TEST(Gears, couple_from_where_joints_are) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const auto world = std::make_unique<GearedWorld>();
        const double r = (random.integer(0, 1) * 2 - 1) * std::exp(random.real(-1.5, 1.5)), rate = rates[random.integer(0, 4)];
        const bool slides = run_i % 3 == 0;
        const ingot::BodyId A = add_rotor(*world, random.real(1, 5), {0.5, 0.4, 0.1}, {0, 0, 0});
        const ingot::BodyId B = add_rotor(*world, 2, {0.2, 0.3, 0.1}, {3, 0, 0});
        const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 0}, {0, 0, 1});
        const ingot::JointId at_B = slides ? join(*world, ingot::SliderJoint{}, {}, B, {3, 0, 0}, {0, 0, 1})
                                           : join(*world, ingot::HingeJoint{}, {}, B, {3, 0, 0}, {0, 0, 1});
        const auto place = [&](ingot::BodyId id) {  // about z, or along it
            const ingot::BodyState state = world->state(id).value;
            if (slides && id == B) return static_cast<double>(state.r_CM.z);
            return std::atan2(static_cast<double>(state.A.c0.y), static_cast<double>(state.A.c0.x));
        };
        const auto step_on = [&](int steps) {
            for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
        };
        for (int times = 0; times < 3; ++times) {
            const auto angular = [&] { return Vector{0, 0, static_cast<scalar>(random.real(-3, 3))}; };
            ASSERT_EQ(world->apply_angular_impulse(A, angular()), Status::ok);
            if (slides) {
                ASSERT_EQ(world->apply_impulse(B, {0, 0, static_cast<scalar>(random.real(-1, 1))}, world->state(B).value.r_CM), Status::ok);
            } else {
                ASSERT_EQ(world->apply_angular_impulse(B, angular()), Status::ok);
            }
            step_on(random.integer(1, 20));
            const double begin[2] = {place(A), place(B)};
            const auto gear = world->add_gear(at_A, at_B, static_cast<scalar>(r));
            ASSERT_TRUE(gear.ok());
            EXPECT_EQ(world->joint_gap(gear.value).value, 0) << run_i;
            double turned[2] = {};
            double before[2] = {begin[0], begin[1]};
            for (int step_i = 0; step_i < 12; ++step_i) {
                step_on(1);
                const ingot::BodyId of[2] = {A, B};
                for (int i = 0; i < 2; ++i) {
                    const double now = place(of[i]), way = now - before[i];
                    turned[i] += slides && i == 1 ? way : std::remainder(way, 2 * 3.14159265358979);
                    before[i] = now;
                }
                const double rounding = 64 * eps * (1 + std::abs(r)) * (4 + std::abs(turned[0]) + std::abs(turned[1])) + held;
                const double off = std::abs(turned[1] - r * turned[0]);
                ASSERT_LE(off, rounding * std::max(1.0, std::abs(r))) << run_i << ", time " << times << ", step " << step_i;
            }
            ASSERT_EQ(world->remove(gear.value), Status::ok);
        }
    }
}

/// A thousand turns of the faster, and more: the phase is as good as in the first.
TEST(Gears, do_not_slip) {
    for (const double r : {-1.0 / 3, 17.0 / 31, 7.3, -40.0}) {
        const auto world = std::make_unique<GearedWorld>();
        const ingot::BodyId A = add_rotor(*world, 2, {0.5, 0.4, 0.1}, {0, 0, 0}), B = add_rotor(*world, 1, {0.2, 0.3, 0.1}, {3, 0, 0});
        const ingot::JointId at_A = join(*world, ingot::HingeJoint{}, {}, A, {0, 0, 0}, {0, 0, 1});
        const ingot::JointId at_B = join(*world, ingot::HingeJoint{}, {}, B, {3, 0, 0}, {0, 0, 1});
        const auto gear = world->add_gear(at_A, at_B, static_cast<scalar>(r));
        ASSERT_TRUE(gear.ok());
        const double speed = 100 / std::max(1.0, std::abs(r));  // rad/s, of A: the faster turns by less than half a turn in a substep
        ASSERT_EQ(world->set_joint_drive(at_A, ingot::MotorDrive{static_cast<scalar>(speed)}), Status::ok);
        double worst = 0;
        const int steps = INGOT_TEST_BRIEF ? 4000 : 40000;
        for (int step_i = 0; step_i < steps; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
            worst = std::max(worst, static_cast<double>(world->joint_gap(gear.value).value));
        }
        const double turns = std::abs(static_cast<double>(world->joint_angle(at_B).value)) / (2 * pi);
        std::printf("    ratio %g: %.0f turns of B, worst phase %.2g rad\n", r, turns, worst);
        EXPECT_LE(worst, 64 * eps * (1 + std::abs(r))) << r;
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_B).value), r * speed, 1e-4 * std::abs(r) * speed) << r;
        // Beside its turns the joint reads what its bodies do: the angle of B is r times that of A, as far as a float tells so large an angle.
        const double a = static_cast<double>(world->joint_angle(at_A).value), b = static_cast<double>(world->joint_angle(at_B).value);
        EXPECT_NEAR(b, static_cast<double>(static_cast<scalar>(r)) * a, 4 * eps * std::abs(b) + 64 * eps * (1 + std::abs(r))) << r;
    }
}

/// A rack that falls turns its pinion: (M + I / R^2) a = M g.
TEST(Gears, a_rack_turns_its_pinion) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const auto world = std::make_unique<GearedWorld>();
        ASSERT_TRUE(weigh(*world));
        const double R = random.real(0.05, 2) * (random.integer(0, 1) * 2 - 1), M = random.real(0.5, 20), M_pinion = random.real(0.5, 20);
        const double rate = rates[random.integer(0, 4)];
        const Vector3d half(random.real(0.1, 1), random.real(0.1, 1), 0.1);
        const ingot::BodyId rack = add_rotor(*world, M, {0.1, 0.1, 1}, {0, 0, 0}), pinion = add_rotor(*world, M_pinion, half, {1, 0, 0});
        const ingot::JointId slider = join(*world, ingot::SliderJoint{}, {}, rack, {0, 0, 0}, {0, 0, 1});
        const ingot::JointId hinge = join(*world, ingot::HingeJoint{}, {}, pinion, {1, 0, 0}, {0, 0, 1});
        const bool to_rack = random.integer(0, 1) == 1;
        const auto gear = to_rack ? world->add_gear(hinge, slider, static_cast<scalar>(R))  //
                                  : world->add_gear(slider, hinge, static_cast<scalar>(1 / R));
        ASSERT_TRUE(gear.ok());
        const double a = -g * M / (M + M_pinion * moment_about_z(half) / (R * R));
        const int steps = static_cast<int>(rate / 4);
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            const double v = a * step_i / rate, rounding = 64 * eps * (g * std::sqrt(step_i / rate) + std::abs(v));
            EXPECT_NEAR(static_cast<double>(world->joint_speed(slider).value), v, rounding) << run_i << ", " << step_i;
            EXPECT_NEAR(static_cast<double>(world->joint_rate(hinge).value), v / R, rounding * (1 + 1 / std::abs(R))) << run_i;
        }
        EXPECT_LE(static_cast<double>(world->joint_gap(gear.value).value), 256 * eps * (1 + std::abs(R) + 1 / std::abs(R))) << run_i;
    }
}

/// Two loads whose ways are opposite: Atwood's machine.
TEST(Gears, sliders_are_a_balance) {
    const auto world = std::make_unique<GearedWorld>();
    ASSERT_TRUE(weigh(*world));
    const ingot::BodyId A = add_rotor(*world, 3, {0.1, 0.1, 0.1}, {0, 0, 0}), B = add_rotor(*world, 2, {0.1, 0.1, 0.1}, {1, 0, 0});
    const ingot::JointId at_A = join(*world, ingot::SliderJoint{}, {}, A, {0, 0, 0}, {0, 0, 1});
    const ingot::JointId at_B = join(*world, ingot::SliderJoint{}, {}, B, {1, 0, 0}, {0, 0, 1});
    const auto gear = world->add_gear(at_A, at_B, -1);
    ASSERT_TRUE(gear.ok());
    for (int step_i = 1; step_i <= 60; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        EXPECT_NEAR(static_cast<double>(world->joint_speed(at_B).value), g / 5 * step_i / 60, 256 * eps);
        EXPECT_NEAR(static_cast<double>(world->joint_travel(at_A).value + world->joint_travel(at_B).value), 0, 64 * eps);
    }
}

/// Two shafts on one carrier, by -1: both get the same torque, whatever they turn. The equations of its two freedoms, the turn c of the carrier and
/// what d the shafts turn by against it.
TEST(Gears, a_differential_shares_torque) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const auto world = std::make_unique<GearedWorld>();
        const double I_c = random.real(0.1, 2), I_L = random.real(0.1, 5), I_R = random.real(0.1, 5), T = random.real(-3, 3);
        const double rate = rates[random.integer(0, 4)];
        const Vector3d half(0.5, 0.4, 0.1);
        const auto rotor = [&](double I, double z) { return add_rotor(*world, I / moment_about_z(half), half, {0, 0, z}); };
        const ingot::BodyId carrier = rotor(I_c, 0), left = rotor(I_L, 1), right = rotor(I_R, -1);
        const ingot::JointId at_world = join(*world, ingot::HingeJoint{}, {}, carrier, {0, 0, 0}, {0, 0, 1});
        const ingot::JointId at_left = join(*world, ingot::HingeJoint{}, carrier, left, {0, 0, 1}, {0, 0, 1});
        const ingot::JointId at_right = join(*world, ingot::HingeJoint{}, carrier, right, {0, 0, -1}, {0, 0, 1});
        ASSERT_TRUE(world->add_gear(at_left, at_right, -1).ok());
        // [I_c + I_L + I_R, I_L - I_R; I_L - I_R, I_L + I_R] (c, d)'' = (T, 0)
        const double a = I_c + I_L + I_R, b = I_L - I_R, d = I_L + I_R, det = a * d - b * b;
        const double of_c = T * d / det, of_d = -T * b / det;
        const int steps = static_cast<int>(rate / 2);
        for (int step_i = 0; step_i < steps; ++step_i) {
            ASSERT_EQ(world->add_torque(carrier, {0, 0, static_cast<scalar>(T)}), Status::ok);
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        }
        const double t = steps / rate, rounding = 64 * eps * std::sqrt(static_cast<double>(steps)) * std::abs(T) * (1 / I_c + 1 / I_L + 1 / I_R);
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_world).value), of_c * t, rounding) << run_i;
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_left).value), of_d * t, rounding) << run_i;
        EXPECT_NEAR(static_cast<double>(world->joint_rate(at_right).value), -of_d * t, rounding) << run_i;
    }
}

/// A tree of balls, hinges and sliders, and gears between any two of its joints that turn or slide; with another beside it, perhaps of one machine.
struct GearedTrees {
    FigureScene scene;
    struct Gear {
        int A, B;
        double ratio;
    };
    std::vector<Gear> gears;
};
GearedTrees geared_trees(RandomInput& random, bool tied) {
    GearedTrees drawn;
    drawn.scene = turning_tree(random, 8, tied, 4, 3, [](FigureJoint&) {});
    if (random.integer(0, 1) == 1) {
        FigureScene other = turning_tree(random, 5, tied, 4, 3, [](FigureJoint&) {});
        const int first = drawn.scene.body_count();
        for (FigureBody& body : other.bodies) {
            body.r_CM.y() += 6;
            drawn.scene.add(body);
        }
        for (FigureJoint& joint : other.joints) {
            joint.anchor.y() += 6;
            if (joint.body_A != the_world) joint.body_A += first;
            joint.body_B += first;
            drawn.scene.join(joint);
        }
    }
    std::vector<int> free;
    for (int i = 0; i < drawn.scene.joint_count(); ++i)
        if (drawn.scene.joints[static_cast<size_t>(i)].kind != FigureJointKind::ball) free.push_back(i);
    const int count = static_cast<int>(free.size());
    for (int i = count < 2 ? 0 : random.integer(1, std::min(3, count - 1)); i > 0; --i) {
        const int A = random.integer(0, count - 2), B = random.integer(A + 1, count - 1);
        const double ratio = (random.integer(0, 1) * 2 - 1) * std::exp(random.real(-1.5, 1.5));
        drawn.gears.push_back({free[static_cast<size_t>(A)], free[static_cast<size_t>(B)], ratio});
    }
    return drawn;
}
template <class Scene>
Built add_geared(ingot::World<Scene>& world, const GearedTrees& drawn, std::vector<ingot::JointId>& gears) {
    Built built = add_scene(world, drawn.scene);
    for (const GearedTrees::Gear& gear : drawn.gears) {
        const auto joint = [&](int i) { return built.joints[static_cast<size_t>(i)]; };
        const auto id = world.add_gear(joint(gear.A), joint(gear.B), static_cast<scalar>(gear.ratio));
        built.sound = built.sound && id.ok();
        gears.push_back(id.value);
    }
    return built;
}

/// Whatever hangs on them, at any rate of steps: gears hold their phase, joints hold, nothing gains, and what floats keeps its momenta.
TEST(Gears, hold_in_trees) {
    RandomInput random(4);
    double worst = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(200); ++run_i) {
        const bool tied = random.integer(0, 1) == 1;
        GearedTrees drawn = geared_trees(random, tied);
        drawn.scene.g = tied ? Vector3d(0, 0, -g) : Vector3d(0, 0, 0);
        const double rate = rates[random.integer(0, 4)];
        const auto world = std::make_unique<GearedWorld>();
        std::vector<ingot::JointId> gears;
        const Built built = add_geared(*world, drawn, gears);
        ASSERT_TRUE(built.sound) << run_i;
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());  // what gears do not allow is lost here
        const auto energy = [&] { return tied ? energy_of(*world, built) : static_cast<double>(world->kinetic_energy()); };
        const Vector3d p = to_eigen(world->linear_momentum()), L = to_eigen(world->angular_momentum());
        const double begin = energy();
        double most = begin, kinetic = 0, M = 0, size = 0;
        for (const ingot::BodyId id : built.bodies) {
            const double M_of = static_cast<double>(world->mass(id).value);
            M += M_of;
            size += M_of * (1 + to_eigen(world->state(id).value.v_CM).norm()) * (1 + to_eigen(world->state(id).value.r_CM).norm());
        }
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            for (size_t i = 0; i < gears.size(); ++i)
                worst = std::max(worst, static_cast<double>(world->joint_gap(gears[i]).value) / (1 + std::abs(drawn.gears[i].ratio)));
            EXPECT_LE(worst_gap(*world, built), held) << run_i << ", " << step_i;
            most = std::max(most, energy());
            kinetic = std::max(kinetic, static_cast<double>(world->kinetic_energy()));
        }
        EXPECT_LE(most - begin, 0.01 * ((tied ? M * g : 0) + kinetic)) << run_i << ", " << rate << " Hz";
        if (tied) continue;
        const double rounding = 640 * std::sqrt(2 * rate) * eps * size;
        EXPECT_LE((to_eigen(world->linear_momentum()) - p).norm(), rounding) << run_i;
        EXPECT_LE((to_eigen(world->angular_momentum()) - L).norm(), rounding + 2e-3 * size) << run_i << ", " << rate << " Hz";
    }
    std::printf("    %.2e rad at most\n", worst);
    EXPECT_LE(worst, held);
}

}  // namespace
