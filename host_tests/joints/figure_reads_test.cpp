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

}  // namespace
