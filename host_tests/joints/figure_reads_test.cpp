// SPDX-License-Identifier: MIT
// Figures as one: masses, centres, momenta and energies of all that hangs together.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;
using ingot_reference::to_eigen;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 26;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
struct SwingingFreely : Swinging {
    using figure_motion = ingot::EnergyMomentum<>;
};

struct BodyNow {
    Vector3d r, v, L;
    Matrix3d A;
};
template <class World>
std::vector<BodyNow> bodies_now(const World& world, const std::vector<ingot::BodyId>& ids) {
    std::vector<BodyNow> bodies;
    for (const ingot::BodyId id : ids) {
        const ingot::BodyState state = world.state(id).value;
        bodies.push_back({to_eigen(state.r_CM), to_eigen(state.v_CM), to_eigen(state.L), to_eigen(state.A)});
    }
    return bodies;
}
FigureScene tree_of(RandomInput& random, int run_i, int most_bodies) {
    return random_tree(random, {random.integer(2, most_bodies), run_i % 2 == 0 ? 1.001 : 100, random.real(0.1, 4), run_i % 4 < 2});
}

/// Sums by Eigen, in double, of any body and joint of a figure; another is beside it.
TEST(Figures, move_as_one) {
    RandomInput random(7);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const FigureScene scene = tree_of(random, run_i, 11), beside = tree_of(random, run_i, 11);
        const auto world = std::make_unique<ingot::World<Swinging>>();
        (void)add_scene(*world, beside);
        const Built built = add_scene(*world, scene);
        for (int step_i = 0; step_i < 5; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
        const std::vector<BodyNow> bodies = bodies_now(*world, built.bodies);
        double M = 0, energy = 0, p_size = 0, L_size = 0, length = 0;
        Vector3d r = Vector3d::Zero(), p = Vector3d::Zero(), L = Vector3d::Zero();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            M += scene.bodies[i].M;
            r += scene.bodies[i].M * bodies[i].r;
            p += scene.bodies[i].M * bodies[i].v;
            p_size += scene.bodies[i].M * bodies[i].v.norm();
            length = std::max(length, bodies[i].r.norm());
        }
        r /= M;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vector3d moment = scene.bodies[i].M * (bodies[i].r - r).cross(bodies[i].v - p / M), L_body = bodies[i].A.transpose() * bodies[i].L;
            L += bodies[i].L + moment;
            L_size += bodies[i].L.norm() + scene.bodies[i].M * (bodies[i].r - r).norm() * (bodies[i].v.norm() + (p / M).norm());
            energy += (scene.bodies[i].M * bodies[i].v.squaredNorm() + L_body.cwiseQuotient(scene.bodies[i].I_body).dot(L_body)) / 2;
        }
        const double few = 4 * static_cast<double>(bodies.size()) * eps;
        const ingot::FigureInfo first = world->figure(built.bodies[0]).value;
        EXPECT_EQ(first.body_count, scene.body_count());
        EXPECT_NEAR(static_cast<double>(first.mass), M, few * M);
        EXPECT_LE((to_eigen(first.r_CM) - r).norm(), few * length);
        EXPECT_LE((to_eigen(first.p) - p).norm(), few * p_size);
        EXPECT_LE((to_eigen(first.v_CM) - p / M).norm(), few * p_size / M);
        EXPECT_LE((to_eigen(first.L) - L).norm(), few * (L_size + length * p_size));
        EXPECT_NEAR(static_cast<double>(first.kinetic_energy), energy, few * energy);
        const auto is_first = [&](const ingot::Result<ingot::FigureInfo>& figure) {
            return figure.ok() && std::memcmp(&figure.value, &first, sizeof first) == 0;
        };
        for (const ingot::BodyId id : built.bodies) EXPECT_TRUE(is_first(world->figure(id)));
        for (const ingot::JointId id : built.joints) EXPECT_TRUE(is_first(world->figure(id)));
    }
}

/// What floats keeps its momenta, as it tells them, to the roundings of its steps.
TEST(Figures, tell_momenta_that_stay) {
    RandomInput random(8);
    for (int run_i = 0; run_i < ingot_reference::draws(20); ++run_i) {
        const FigureScene scene = random_tree(random, {random.integer(2, 12), 10, 1, false});
        const auto world = std::make_unique<ingot::World<SwingingFreely>>();
        const Built built = add_scene(*world, scene);
        (void)ingot::step(*world, scalar(1) / 120);
        const ingot::FigureInfo before = world->figure(built.bodies[0]).value;
        double p_size = 0, L_size = 0;
        for (const BodyNow& body : bodies_now(*world, built.bodies)) {
            p_size += 10 * body.v.norm();
            L_size += body.L.norm() + 10 * body.v.norm() * (body.r - to_eigen(before.r_CM)).norm();
        }
        constexpr int steps = 60;
        for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(*world, scalar(1) / 120);
        const ingot::FigureInfo after = world->figure(built.bodies.back()).value;
        EXPECT_LE((to_eigen(after.p) - to_eigen(before.p)).norm(), steps * 8 * eps * p_size);
        EXPECT_LE((to_eigen(after.L) - to_eigen(before.L)).norm(), steps * 8 * eps * (L_size + p_size));
    }
}

/// Ids of what is not there, and what does not move.
TEST(Figures, are_of_what_moves) {
    const auto world = std::make_unique<ingot::World<Swinging>>();
    RandomInput random(3);
    const Built built = add_scene(*world, random_tree(random, {4, 2, 1, true}));
    ingot::BodyId stale = built.bodies[0], foreign = built.bodies[0];
    stale.generation += 2;
    foreign.world_tag = 5;
    ingot::JointId stale_joint = built.joints[0];
    stale_joint.generation += 2;
    EXPECT_EQ(world->figure(stale).status, Status::stale_id);
    EXPECT_EQ(world->figure(ingot::BodyId{}).status, Status::stale_id);
    EXPECT_EQ(world->figure(foreign).status, Status::foreign_id);
    EXPECT_EQ(world->figure(stale_joint).status, Status::stale_id);
    ingot::BodyDef post;
    post.immovable = true;
    const ingot::BodyId fixed = world->add(post).value;
    EXPECT_EQ(world->figure(fixed).status, Status::immovable);
    post = {};
    post.mass = ingot::principal(ingot::solid_box(1, {1, 1, 1})).value;
    const ingot::BodyId alone = world->add(post).value;
    EXPECT_EQ(world->figure(alone).value.body_count, 1);
    ingot::JointDef tie;
    tie.body_A = fixed;
    tie.body_B = alone;
    tie.joint = ingot::BallJoint{};
    const auto tied = world->add_joint(tie);
    EXPECT_EQ(world->figure(tied.value).value.body_count, 1);
}

struct Read : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 16, max_loops = 10;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RodJoint, ingot::RopeJoint, ingot::ServoJoint, ingot::WithLimits,
                                 ingot::WithDrives>;
};
using ReadWorld = ingot::World<Read>;
using ReadDynamics = ingot::FigureDynamics<6>;

ingot::BodyId add_link(ReadWorld& world, double x, const Matrix3d& A = Matrix3d::Identity()) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {scalar(0.3), scalar(0.2), scalar(0.1)}), 2)).value;
    def.state.r_CM = {static_cast<scalar>(x), 0, 0};
    def.state.A = ingot_reference::to_matrix(A);
    return world.add(def).value;
}
ingot::JointId join(ReadWorld& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector3d& axis = {0, 0, 1}) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = world.state(B).value.r_CM - Vector{scalar(0.5), 0, 0};
    def.P_B = world.state(B).value.r_CM;
    def.axis = to_vector(axis);
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok()) << ingot::name(id.status);
    return id.value;
}

/// What closes a loop is told, however many there are, whichever body is asked for, and in whatever order joints came; ropes and servos close none,
/// and what is read is the same with them as without.
TEST(Figures, with_loops_have_no_dynamics) {
    enum What { tree, servo, rope, two_grounds, three_grounds, twice, thrice, rod_within, two_rods_within, root_on_rod, late_ground, count };
    ReadDynamics plain{};
    for (int what = tree; what < count; ++what) {
        const auto world = std::make_unique<ReadWorld>();
        ASSERT_TRUE(weigh(*world));
        ingot::BodyId bodies[4];
        for (int i = 0; i < 4; ++i) bodies[i] = add_link(*world, i);
        const bool floats = what == root_on_rod || what == rod_within;
        if (what == late_ground) (void)join(*world, ingot::BallJoint{}, {}, bodies[3]);  // of a lower number than that of the body before
        if (!floats) (void)join(*world, ingot::HingeJoint{}, {}, bodies[0]);
        for (int i = 0; i < 3; ++i) (void)join(*world, ingot::HingeJoint{}, bodies[i], bodies[i + 1]);
        if (what == servo) (void)join(*world, ingot::ServoJoint{}, bodies[0], bodies[2]);
        if (what == rope) (void)join(*world, ingot::RopeJoint{9}, {}, bodies[2]);
        const int loops = what == thrice ? 3 : what == three_grounds || what == two_rods_within ? 2 : 1;
        for (int i = 0; i < loops; ++i) {
            if (what == two_grounds || what == three_grounds) (void)join(*world, ingot::BallJoint{}, {}, bodies[0]);
            if (what == twice || what == thrice) (void)join(*world, ingot::BallJoint{}, bodies[0], bodies[3]);
            if (what == rod_within || what == two_rods_within) (void)join(*world, ingot::RodJoint{}, bodies[0], bodies[2]);
        }
        if (what == root_on_rod) (void)join(*world, ingot::RodJoint{}, {}, bodies[0]);
        ASSERT_EQ(world->apply_angular_impulse(bodies[3], {scalar(0.1), scalar(0.2), scalar(0.3)}), Status::ok);
        for (int i = 0; i < 4; ++i) {
            ReadDynamics read{};
            const bool good = what <= rope || (what == root_on_rod && i == 0);
            EXPECT_EQ(world->read_dynamics(bodies[i], read), good ? Status::ok : Status::bad_joint) << what << ", " << i;
            EXPECT_EQ(read.body_count(), good ? 4 : 0) << what;
            if (what > rope) continue;
            constexpr int n = 4;
            scalar matrix[n * n], again[n * n], of_plain[n * n];
            if (what == tree && i == 0) plain = read;
            ASSERT_EQ(read.direction_count(), n);
            ASSERT_EQ(read.mass_matrix(matrix, n * n), Status::ok);
            ASSERT_EQ(read.mass_matrix(again, n * n), Status::ok);  // asked twice, it is the same
            ASSERT_EQ(plain.mass_matrix(of_plain, n * n), Status::ok);
            for (int k = 0; k < n * n; ++k) {
                EXPECT_EQ(matrix[k], again[k]);
                EXPECT_EQ(matrix[k], of_plain[k]) << what << ", " << i;
            }
        }
    }
}

/// The rates of a ball joint's twist and swing are what their angles change by.
TEST(Figures, rates_of_ball_joints_are_those_of_their_angles) {
    RandomInput random(9);
    const double dt = INGOT_DOUBLE ? 1e-5 : 4e-3;
    int looked_at = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const auto world = std::make_unique<ReadWorld>();
        const ingot::BodyId A = add_link(*world, 0), B = add_link(*world, 1);
        const Vector3d axis = random.direction(), spin = random.vector(2);
        const ingot::JointId id = join(*world, ingot::BallJoint{}, A, B, axis);
        const Matrix3d turned = Eigen::AngleAxisd(random.real(0.3, 2), random.direction()).toRotationMatrix();
        const auto put = [&](double t) {
            ingot::BodyState state = world->state(B).value;
            state.A = ingot_reference::to_matrix(Matrix3d(Eigen::AngleAxisd(spin.norm() * t, spin.normalized()).toRotationMatrix() * turned));
            EXPECT_EQ(world->set_state(B, state), Status::ok);
        };
        const double swing = std::acos((turned * axis).dot(axis));
        if (swing < 0.3 || swing > 2) continue;  // at its ends the swing has no direction
        ++looked_at;
        for (int which = 0; which < 2; ++which) {
            put(dt);
            const double after = static_cast<double>(world->joint_angle(id, which).value);
            put(-dt);
            const double before = static_cast<double>(world->joint_angle(id, which).value);
            put(0);
            const Vector3d I = Vector3d(2.0 / 3 * (0.04 + 0.01), 2.0 / 3 * (0.09 + 0.01), 2.0 / 3 * (0.09 + 0.04));
            ingot::BodyState state = world->state(B).value;
            state.L = to_vector(Vector3d(turned * I.cwiseProduct(turned.transpose() * spin)));
            ASSERT_EQ(world->set_state(B, state), Status::ok);
            // Third derivatives are of the cube of the spin, which is up to 4 rad/s, over the swing; an angle is rounded by a few eps.
            const double rate = static_cast<double>(world->joint_rate(id, which).value), allowed = 64 / 0.3 * dt * dt + 32 * eps / dt;
            EXPECT_NEAR(rate, (after - before) / (2 * dt), allowed) << run_i;
        }
    }
    EXPECT_GT(looked_at, 0);
}

}  // namespace
