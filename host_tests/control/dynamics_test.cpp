// SPDX-License-Identifier: MIT
// What World::read_dynamics and FigureDynamics tell, beside the equations of motion as dynamics_reference.h writes them.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

#include "control/read_figure.h"
#include "joints/figure.h"

namespace {

using namespace ingot_control;

struct Controlled : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 16, max_loops = 4, max_manifolds = 16;
    static constexpr bool translates = true, gravity_shares = true, body_forces = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::WheelJoint,
                                 ingot::RodJoint, ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint, ingot::WithDrives>;
};
using Figure = Read<Controlled>;

/// What pushes a body: a force and a torque in world axes, another in its own, and its share of gravity.
void push(Figure& of, RandomInput& random, std::size_t body_i) {
    RefBody& body = of.drawn.figure.bodies[body_i];
    const RefPose pose = of.drawn.figure.poses(of.drawn.q)[body_i];
    const ingot::BodyId id = of.built.bodies[body_i];
    const Vector3d F = random.vector(20), T = random.vector(5), F_body = random.vector(20), arm = random.vector(0.3);
    const double share = random.real(-0.5, 1.5);
    EXPECT_EQ(of.world->add_central_force(id, to_vector(F)), Status::ok);
    EXPECT_EQ(of.world->add_torque(id, to_vector(T)), Status::ok);
    EXPECT_EQ(of.world->add_body_force(id, to_vector(F_body), to_vector(arm)), Status::ok);
    EXPECT_EQ(of.world->set_gravity_share(id, static_cast<scalar>(share)), Status::ok);
    body.weight *= share;
    body.F += F + pose.A.at * F_body;
    body.T += T + pose.A.at * arm.cross(F_body);
}

/// Tied to the world, afloat, or tied to a platform that flies and turns.
void draw(Figure& of, RandomInput& random, int run_i) {
    const bool on_platform = run_i % 3 == 2;
    of.drawn = draw_figure(random, {random.integer(1, most_bodies), run_i % 2 == 0 ? 1.001 : 100, run_i % 4 < 2 ? 5.0 : 0.5, run_i % 3 != 1});
    ingot::BodyId ground{};
    if (on_platform) {
        const Vector3d v = random.vector(3), w = random.vector(2);
        of.drawn.figure.root = {{random.vector(2), v, Vector3d::Zero()}, turn_with(random.rotation(), w, Vector3d::Zero())};
        ingot::BodyDef platform;
        platform.kinematic = true;
        platform.state.r_CM = to_vector(of.drawn.figure.root.r.at);
        platform.state.A = ingot_reference::to_matrix(of.drawn.figure.root.A.at);
        platform.state.v_CM = to_vector(v);
        platform.state.L = to_vector(w);
        ground = of.world->add(platform).value;
    }
    of.built = add_figure(*of.world, of.drawn, ground);
    for (std::size_t i = 0; i < of.size(); ++i)
        if (random.integer(0, 1) == 1) push(of, random, i);
    of.read();
}

template <class Each>
void for_draws(int count, std::uint64_t seed, const Each& each) {
    RandomInput random(seed);
    for (int run_i = 0; run_i < draws(count); ++run_i) {
        const auto of = std::make_unique<Figure>();
        draw(*of, random, run_i);
        if (testing::Test::HasFatalFailure()) return;
        each(*of, random);
    }
}

}  // namespace

/// Directions are numbered as joints tell their rates.
TEST(Dynamics, are_of_the_rates_of_joints) {
    for_draws(60, 1, [](Figure& of, RandomInput&) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            const RefBody& body = of.drawn.figure.bodies[i];
            if (body.kind == RefKind::ball || of.built.joints[i] == ingot::JointId{}) continue;
            for (int k = 0; k < directions_of(body.kind); ++k) {
                const bool goes = body.kind == RefKind::slider || (body.kind == RefKind::wheel && k == 1);
                const scalar rate = goes ? of.world->joint_speed(of.built.joints[i]).value : of.world->joint_rate(of.built.joints[i], k).value;
                EXPECT_NEAR(static_cast<double>(rate), of.drawn.q[static_cast<std::size_t>(body.first + k)].rate, 2000 * eps);
            }
        }
    });
}

TEST(Dynamics, tell_rates) {
    for_draws(60, 9, [](Figure& of, RandomInput&) {
        ASSERT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
        double size = 1;
        for (const RefPose& pose : of.drawn.figure.poses(of.drawn.q)) size = std::max({size, pose.r.rate.norm(), pose.spin().norm()});
        for (int k = 0; k < of.count(); ++k) EXPECT_NEAR(of.given()(k), of.drawn.q[static_cast<std::size_t>(k)].rate, 64 * eps * size);
    });
}

TEST(Dynamics, inverse_is_of_the_textbook) {
    for_draws(80, 2, [&](Figure& of, RandomInput&) {
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const RefFigure::Torques expected = of.drawn.figure.torques(of.drawn.q);
        const VectorXd off = of.given() - expected.value;
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs(off(k)), tolerance * expected.size(k));
    });
}

TEST(Dynamics, gravity_is_held) {
    for_draws(60, 3, [](Figure& of, RandomInput&) {
        ASSERT_EQ(of.figure.gravity_torques(of.torques, of.count()), Status::ok);
        for (RefBody& body : of.drawn.figure.bodies) body.F = body.T = Vector3d::Zero();
        for (RefCoordinate& q : of.drawn.q) q.rate = q.second = 0;
        of.drawn.figure.root = {still(of.drawn.figure.root.r.at), still(of.drawn.figure.root.A.at)};
        const RefFigure::Torques expected = of.drawn.figure.torques(of.drawn.q);
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs(of.given()(k) - expected.value(k)), tolerance * expected.size(k));
    });
}

TEST(Dynamics, mass_matrix_is_of_the_textbook) {
    for_draws(60, 4, [](Figure& of, RandomInput&) {
        const MatrixXd M = of.mass(), expected = of.drawn.figure.mass_matrix(of.drawn.q);
        for (int i = 0; i < of.count(); ++i)
            for (int k = 0; k < of.count(); ++k) {
                EXPECT_LE(std::abs(M(i, k) - expected(i, k)), tolerance * std::sqrt(expected(i, i) * expected(k, k)));
                EXPECT_EQ(M(i, k), M(k, i));
            }
    });
}

/// M a + bias = torques, whatever was asked for before.
TEST(Dynamics, mass_matrix_and_bias_are_the_inverse) {
    for_draws(60, 5, [](Figure& of, RandomInput& random) {
        if (random.integer(0, 1) == 1 && of.count() > 0) (void)of.figure.effective_inertia(random.integer(0, of.count() - 1));
        const MatrixXd M = of.mass();
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const VectorXd torques = of.given(), a = in_order(of.numbers, of.order);
        const std::vector<scalar> zero(static_cast<std::size_t>(of.count()) + 1, 0);
        ASSERT_EQ(of.figure.inverse_dynamics(zero.data(), of.torques, of.count()), Status::ok);
        const VectorXd size = of.drawn.figure.torques(of.drawn.q).size;
        for (int k = 0; k < of.count(); ++k) {
            double sum = of.given()(k), all = size(k);
            for (int l = 0; l < of.count(); ++l) {
                sum += M(k, l) * a(l);
                all += std::abs(M(k, l) * a(l));
            }
            EXPECT_LE(std::abs(sum - torques(k)), tolerance * all);
        }
    });
}

TEST(Dynamics, forces_at_a_body_are_the_transposed_jacobian) {
    for_draws(60, 6, [](Figure& of, RandomInput& random) {
        const auto body_i = static_cast<std::size_t>(random.integer(0, static_cast<int>(of.size()) - 1));
        const Vector3d F = random.vector(10), T = random.vector(3);
        const Vector3d P = of.drawn.figure.poses(of.drawn.q)[body_i].r.at + random.vector(0.3);
        const ingot::BodyId id = of.built.bodies[body_i];
        const auto ask = [&](ingot::BodyId up_to) {
            return of.figure.transpose_torques(id, to_vector(P), to_vector(F), to_vector(T), of.torques, of.count(), up_to);
        };
        ASSERT_EQ(ask({}), Status::ok);
        const VectorXd to_root = of.given(), expected = of.drawn.figure.transposed_jacobian(of.drawn.q, body_i, P, F, T);
        // A partial velocity is no longer than what hangs together, 1 m a joint.
        const double size = F.norm() * (1 + static_cast<double>(of.size())) + T.norm();
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs(to_root(k) - expected(k)), tolerance * size);
        int ancestor = of.drawn.figure.bodies[body_i].parent;
        if (ancestor > 0 && random.integer(0, 1) == 1) ancestor = of.drawn.figure.bodies[static_cast<std::size_t>(ancestor)].parent;
        if (ancestor < 0) return;
        ASSERT_EQ(ask(of.built.bodies[static_cast<std::size_t>(ancestor)]), Status::ok);
        std::vector<bool> between(of.order.size(), false);
        for (int i = static_cast<int>(body_i); i != ancestor; i = of.drawn.figure.bodies[static_cast<std::size_t>(i)].parent) {
            const RefBody& body = of.drawn.figure.bodies[static_cast<std::size_t>(i)];
            for (int k = 0; k < directions_of(body.kind); ++k) between[static_cast<std::size_t>(body.first + k)] = true;
        }
        for (int k = 0; k < of.count(); ++k) EXPECT_EQ(of.given()(k), between[static_cast<std::size_t>(k)] ? to_root(k) : 0);
    });
}

/// Roundings of what is eliminated grow with the condition of the matrix, its diagonal brought to 1.
TEST(Dynamics, effective_inertia_is_of_the_inverse_matrix) {
    for_draws(60, 7, [](Figure& of, RandomInput& random) {
        if (random.integer(0, 1) == 1) (void)of.mass();
        if (of.count() == 0) return;
        MatrixXd scaled = of.drawn.figure.mass_matrix(of.drawn.q);
        const VectorXd diagonal = scaled.diagonal();
        for (int i = 0; i < of.count(); ++i)
            for (int k = 0; k < of.count(); ++k) scaled(i, k) /= std::sqrt(diagonal(i) * diagonal(k));
        const MatrixXd inverse = inverse_of(scaled);
        const double condition = scaled.norm() * inverse.norm();
        for (int k = 0; k < of.count(); ++k) {
            const double expected = diagonal(k) / inverse(k, k);
            const auto given = of.figure.effective_inertia(of.order[static_cast<std::size_t>(k)]);
            ASSERT_TRUE(given.ok());
            EXPECT_NEAR(static_cast<double>(given.value), expected, 4 * of.count() * eps * condition * expected);
        }
    });
}

/// Bodies put anywhere, so that the axes of a universal joint are near each other, or one: two directions that are nearly one leave roundings alone.
TEST(Dynamics, effective_inertia_is_above_zero_however_bodies_are_put) {
    RandomInput random(14);
    for (int run_i = 0; run_i < ingot_reference::draws(200); ++run_i) {
        const auto world = std::make_unique<ingot::World<Controlled>>();
        ingot::FigureDynamics<2> figure;
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, to_vector(Vector3d(0.1, 0.2, 0.3))), 3)).value;
        def.state.A = ingot_reference::to_matrix(random.rotation());
        def.state.r_CM = to_vector(random.vector(1));
        const bool floats = run_i % 2 == 0;
        ingot::JointDef joint;
        if (floats) joint.body_A = world->add(def).value;
        const ingot::BodyId id = joint.body_B = world->add(def).value;
        const Vector3d axis = random.direction(), axis_B = axis.cross(random.direction()).normalized();
        joint.joint = ingot::UniversalJoint{};
        joint.axis = to_vector(axis);
        joint.axis_B = to_vector(axis_B);
        ASSERT_TRUE(world->add_joint(joint).ok());
        // The turn that takes axis_B to where axis is, but for a small one.
        const double off = run_i % 5 == 0 ? 0 : std::pow(10, random.real(-8, -2));
        const auto turn = ingot_figures::least_turn(axis_B, axis) * Eigen::AngleAxisd(off, axis.cross(axis_B).normalized());
        ingot::BodyState state = world->state(id).value;
        state.A = ingot_reference::to_matrix((turn * ingot_reference::to_eigen(state.A)).eval());
        ASSERT_EQ(world->set_state(id, state), Status::ok);
        ASSERT_EQ(world->read_dynamics(id, figure), Status::ok);
        for (int k = 0; k < figure.direction_count(); ++k) {
            const auto inertia = figure.effective_inertia(k);
            EXPECT_GT(inertia.value, 0) << run_i << ", " << k;
            EXPECT_TRUE(std::isfinite(static_cast<double>(inertia.value)));
        }
    }
}

namespace {

/// Whether a world is to the byte as it was.
struct Untouched {
    const ingot::World<Controlled>& world;
    std::vector<unsigned char> bytes = std::vector<unsigned char>(sizeof world);
    explicit Untouched(const ingot::World<Controlled>& of) : world(of) { std::memcpy(bytes.data(), static_cast<const void*>(&of), sizeof of); }
    bool still() const { return std::memcmp(bytes.data(), static_cast<const void*>(&world), sizeof world) == 0; }
};

}  // namespace

TEST(Dynamics, leave_the_world_as_it_is) {
    for_draws(40, 11, [](Figure& of, RandomInput&) {
        const Untouched world(*of.world);
        ASSERT_EQ(of.world->read_dynamics(of.built.bodies.back(), of.figure), Status::ok);
        (void)of.mass();
        EXPECT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        EXPECT_EQ(of.figure.body_count(), static_cast<int>(of.size()));
        EXPECT_TRUE(world.still());
    });
}

/// Whichever body it is read by: of a figure that is tied, the same to the bit.
TEST(Dynamics, of_a_tied_figure_have_one_root) {
    for_draws(40, 12, [](Figure& of, RandomInput& random) {
        if (of.figure.floats()) return;
        scalar other[3 * most_bodies + 6];
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const ingot::BodyId by = of.built.bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(of.size()) - 1))];
        ASSERT_EQ(of.world->read_dynamics(by, of.figure), Status::ok);
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, other, of.count()), Status::ok);
        for (int k = 0; k < of.count(); ++k) EXPECT_EQ(of.torques[k], other[k]);
    });
}

TEST(Dynamics, of_what_is_not_there_are_refused) {
    RandomInput random(13);
    Figure of;
    of.drawn = draw_figure(random, {6, 2, 1, false});
    of.built = add_figure(*of.world, of.drawn);
    of.read();
    scalar numbers[3 * most_bodies + 6] = {}, kept[3 * most_bodies + 6];
    std::memcpy(kept, of.torques, sizeof kept);
    const Untouched world(*of.world);
    const int n = of.count();
    EXPECT_EQ(of.figure.inverse_dynamics(numbers, of.torques, n - 1), Status::out_of_range);
    EXPECT_EQ(of.figure.gravity_torques(of.torques, n + 1), Status::out_of_range);
    EXPECT_EQ(of.figure.direction_rates(of.torques, -1), Status::out_of_range);
    EXPECT_EQ(of.figure.mass_matrix(of.matrix, n), Status::out_of_range);
    EXPECT_EQ(of.figure.effective_inertia(-1).status, Status::out_of_range);
    EXPECT_EQ(of.figure.effective_inertia(n).status, Status::out_of_range);
    EXPECT_EQ(of.figure.directions_of({}).status, Status::stale_id);
    numbers[n - 1] = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_EQ(of.figure.inverse_dynamics(numbers, of.torques, n), Status::not_finite);
    const ingot::BodyId leaf = of.built.bodies.back(), root = of.built.bodies[0];
    const auto ask = [&](ingot::BodyId id, const ingot::Vector& P, ingot::BodyId up_to) {
        return of.figure.transpose_torques(id, P, {1, 0, 0}, {}, of.torques, n, up_to);
    };
    EXPECT_EQ(ask({}, {}, {}), Status::stale_id);
    EXPECT_EQ(ask(root, {}, leaf), Status::out_of_range);
    EXPECT_EQ(ask(leaf, {numbers[n - 1], 0, 0}, {}), Status::not_finite);
    EXPECT_EQ(std::memcmp(kept, of.torques, sizeof kept), 0);

    ingot::FigureDynamics<5> small;
    EXPECT_EQ(of.world->read_dynamics(root, small), Status::no_room);
    EXPECT_EQ(small.body_count(), 0);
    EXPECT_EQ(small.gravity_torques(of.torques, 0), Status::out_of_range);
    ingot::BodyId foreign = root;
    foreign.world_tag = 9;
    EXPECT_EQ(of.world->read_dynamics(foreign, of.figure), Status::foreign_id);
    EXPECT_EQ(of.figure.body_count(), 0);
    EXPECT_EQ(of.world->read_dynamics({}, of.figure), Status::stale_id);
    EXPECT_TRUE(world.still());
}

/// A rope and a target leave it a tree; a rod, a second joint to the ground and one between its bodies do not.
TEST(Dynamics, of_loops_are_refused) {
    RandomInput random(14);
    const ingot::Joint closing[] = {ingot::RodJoint{}, ingot::BallJoint{}, ingot::RopeJoint{}, ingot::TargetJoint{}};
    for (int run_i = 0; run_i < 8; ++run_i) {
        Figure of;
        of.drawn = draw_figure(random, {4, 2, 0, true});
        of.built = add_figure(*of.world, of.drawn);
        of.read();
        ingot::JointDef joint;
        joint.joint = closing[run_i / 2];
        const bool to_ground = run_i % 2 == 0 || joint.joint.kind == ingot::JointKind::target;
        joint.body_A = to_ground ? ingot::BodyId{} : of.built.bodies[0];
        joint.body_B = of.built.bodies[3];
        joint.P = to_ground ? ingot::Vector{3, 0, 0} : of.world->state(joint.body_A).value.r_CM;
        joint.P_B = of.world->state(joint.body_B).value.r_CM;
        ASSERT_TRUE(of.world->add_joint(joint).ok());
        const bool is_loop = run_i < 4;
        EXPECT_EQ(of.world->read_dynamics(of.built.bodies[1], of.figure), is_loop ? Status::bad_joint : Status::ok) << run_i;
        EXPECT_EQ(of.figure.body_count(), is_loop ? 0 : 4);
    }
}

/// A parallel joint of the root to the world, which keeps a figure in its plane, leaves joints as they are; of another body it does not.
TEST(Dynamics, of_a_root_that_is_kept_upright_are_told) {
    RandomInput random(15);
    for (int body_i = 0; body_i < 4; ++body_i) {
        Figure of;
        of.drawn = draw_figure(random, {4, 2, 0, false});
        of.built = add_figure(*of.world, of.drawn);
        of.read();
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const VectorXd free = of.given();
        ingot::JointDef joint;
        joint.body_B = of.built.bodies[static_cast<std::size_t>(body_i)];
        joint.joint = ingot::ParallelJoint{};
        ASSERT_TRUE(of.world->add_joint(joint).ok());
        ASSERT_EQ(of.world->read_dynamics(of.built.bodies[0], of.figure), body_i == 0 ? Status::ok : Status::bad_joint);
        if (body_i > 0) continue;
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        EXPECT_EQ(of.given(), free);
    }
}
