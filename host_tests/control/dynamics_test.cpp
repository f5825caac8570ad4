// SPDX-License-Identifier: MIT
// What World::read_dynamics and FigureDynamics tell, beside the equations of motion as dynamics_reference.h writes them.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

#include "control/drawn_figure.h"
#include "reference/draws.h"

namespace {

using namespace ingot_control;
using ingot::scalar;
using ingot::Status;
using ingot_reference::draws;

constexpr double tolerance = sizeof(scalar) == 8 ? 1e-12 : 1e-5;  // of the sum of what is summed
constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr int most_bodies = 12;

struct Controlled : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 16, max_loops = 4, max_manifolds = 16;
    static constexpr bool translates = true, gravity_shares = true, body_forces = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::WheelJoint,
                                 ingot::RodJoint, ingot::RopeJoint, ingot::TargetJoint, ingot::WithDrives>;
};
using Figure = ingot::FigureDynamics<most_bodies>;

VectorXd in_order(const scalar* numbers, const std::vector<int>& order) {
    VectorXd all(static_cast<Eigen::Index>(order.size()));
    for (std::size_t k = 0; k < order.size(); ++k) all(static_cast<Eigen::Index>(k)) = static_cast<double>(numbers[order[k]]);
    return all;
}

/// A figure in a world of its own, read, and what belongs to it.
struct Read {
    DrawnFigure drawn;
    BuiltFigure built;
    std::unique_ptr<ingot::World<Controlled>> world = std::make_unique<ingot::World<Controlled>>();
    Figure figure;
    std::vector<int> order;
    scalar numbers[3 * most_bodies + 6] = {}, torques[3 * most_bodies + 6] = {}, matrix[(3 * most_bodies + 6) * (3 * most_bodies + 6)] = {};

    int count() const { return figure.direction_count(); }
    std::size_t size() const { return drawn.figure.size(); }
    void read() {
        ASSERT_TRUE(built.sound);
        ASSERT_EQ(world->read_dynamics(built.bodies[0], figure), Status::ok);
        ASSERT_EQ(count(), drawn.figure.count);
        ASSERT_EQ(figure.body_count(), static_cast<int>(size()));
        ASSERT_EQ(figure.floats(), drawn.figure.floats);
        order = numbers_of(figure, drawn, built);
        for (std::size_t k = 0; k < order.size(); ++k) numbers[order[k]] = static_cast<scalar>(drawn.q[k].second);
    }
    VectorXd given() const { return in_order(torques, order); }
    MatrixXd mass() {
        EXPECT_EQ(figure.mass_matrix(matrix, count() * count()), Status::ok);
        MatrixXd M(count(), count());
        for (int i = 0; i < count(); ++i)
            for (int k = 0; k < count(); ++k)
                M(i, k) = static_cast<double>(matrix[order[static_cast<std::size_t>(i)] * count() + order[static_cast<std::size_t>(k)]]);
        return M;
    }
};

/// What pushes a body: a force and a torque in world axes, another in its own, and its share of gravity.
void push(Read& of, RandomInput& random, std::size_t body_i) {
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
void draw(Read& of, RandomInput& random, int run_i) {
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
        const auto of = std::make_unique<Read>();
        draw(*of, random, run_i);
        if (testing::Test::HasFatalFailure()) return;
        each(*of, random);
    }
}

}  // namespace

/// Directions are numbered as joints tell their rates.
TEST(Dynamics, are_of_the_rates_of_joints) {
    for_draws(60, 1, [](Read& of, RandomInput&) {
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
    for_draws(60, 9, [](Read& of, RandomInput&) {
        ASSERT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
        double size = 1;
        for (const RefPose& pose : of.drawn.figure.poses(of.drawn.q)) size = std::max({size, pose.r.rate.norm(), pose.spin().norm()});
        for (int k = 0; k < of.count(); ++k) EXPECT_NEAR(of.given()(k), of.drawn.q[static_cast<std::size_t>(k)].rate, 64 * eps * size);
    });
}

TEST(Dynamics, inverse_is_of_the_textbook) {
    for_draws(240, 2, [&](Read& of, RandomInput&) {
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const RefFigure::Torques expected = of.drawn.figure.torques(of.drawn.q);
        const VectorXd off = of.given() - expected.value;
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs(off(k)), tolerance * expected.size(k));
    });
}

TEST(Dynamics, gravity_is_held) {
    for_draws(120, 3, [](Read& of, RandomInput&) {
        ASSERT_EQ(of.figure.gravity_torques(of.torques, of.count()), Status::ok);
        for (RefBody& body : of.drawn.figure.bodies) body.F = body.T = Vector3d::Zero();
        for (RefCoordinate& q : of.drawn.q) q.rate = q.second = 0;
        of.drawn.figure.root = {still(of.drawn.figure.root.r.at), still(of.drawn.figure.root.A.at)};
        const RefFigure::Torques expected = of.drawn.figure.torques(of.drawn.q);
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs(of.given()(k) - expected.value(k)), tolerance * expected.size(k));
    });
}

TEST(Dynamics, mass_matrix_is_of_the_textbook) {
    for_draws(120, 4, [](Read& of, RandomInput&) {
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
    for_draws(120, 5, [](Read& of, RandomInput& random) {
        if (random.integer(0, 1) == 1 && of.count() > 0) (void)of.figure.effective_inertia(random.integer(0, of.count() - 1));
        const MatrixXd M = of.mass();
        ASSERT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
        const VectorXd torques = of.given(), a = in_order(of.numbers, of.order);
        const std::vector<scalar> zero(static_cast<std::size_t>(of.count()) + 1, 0);
        ASSERT_EQ(of.figure.inverse_dynamics(zero.data(), of.torques, of.count()), Status::ok);
        const VectorXd size = of.drawn.figure.torques(of.drawn.q).size + M.cwiseAbs() * a.cwiseAbs();
        for (int k = 0; k < of.count(); ++k) EXPECT_LE(std::abs((M * a)(k) + of.given()(k) - torques(k)), tolerance * size(k));
    });
}

TEST(Dynamics, forces_at_a_body_are_the_transposed_jacobian) {
    for_draws(120, 6, [](Read& of, RandomInput& random) {
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
    for_draws(120, 7, [](Read& of, RandomInput& random) {
        if (random.integer(0, 1) == 1) (void)of.mass();
        if (of.count() == 0) return;
        const MatrixXd M = of.drawn.figure.mass_matrix(of.drawn.q);
        const VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
        const MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal(), inverse = scaled.inverse();
        const double condition = scaled.norm() * inverse.norm();
        for (int k = 0; k < of.count(); ++k) {
            const double expected = 1 / (inverse(k, k) * scale(k) * scale(k));
            const auto given = of.figure.effective_inertia(of.order[static_cast<std::size_t>(k)]);
            ASSERT_TRUE(given.ok());
            EXPECT_NEAR(static_cast<double>(given.value), expected, 4 * of.count() * eps * condition * expected);
        }
    });
}

namespace {

/// Has every joint give a torque, and the root of what floats a wrench, over the next step.
void give(Read& of) {
    const auto torque_of = [&](std::size_t i, int k) { return of.torques[of.order[static_cast<std::size_t>(of.drawn.figure.bodies[i].first + k)]]; };
    if (of.figure.floats()) {
        EXPECT_EQ(of.world->add_central_force(of.built.bodies[0], {of.torques[0], of.torques[1], of.torques[2]}), Status::ok);
        EXPECT_EQ(of.world->add_torque(of.built.bodies[0], {of.torques[3], of.torques[4], of.torques[5]}), Status::ok);
    }
    for (std::size_t i = 0; i < of.size(); ++i) {
        const RefKind kind = of.drawn.figure.bodies[i].kind;
        const ingot::JointId id = of.built.joints[i];
        if (id == ingot::JointId{}) continue;
        if (kind == RefKind::ball) {
            EXPECT_EQ(of.world->set_ball_drive(id, ingot::SpringDrive{}, {}, {}, {torque_of(i, 0), torque_of(i, 1), torque_of(i, 2)}), Status::ok);
            continue;
        }
        for (int k = 0; k < directions_of(kind); ++k) {
            ingot::SpringDrive drive;
            drive.feedforward = torque_of(i, k);
            EXPECT_EQ(of.world->set_joint_drive(id, drive, k), Status::ok);
        }
    }
}

/// What a torque of 1 along one number of a figure at rest makes of its rate in a step: rad/s^2, m/s^2.
struct Felt {
    double expected = 1, given = 1;
    double most = 0;  ///< of any of its numbers
};
Felt felt_in_step(Read& of, RandomInput& random, double h) {
    Felt felt;
    of.drawn = draw_figure(random, {random.integer(1, 5), 10, 0, true});
    of.drawn.g.setZero();
    of.built = add_figure(*of.world, of.drawn);
    of.read();
    if (of.count() == 0) return felt;
    const int k = random.integer(0, of.count() - 1);
    felt.expected = 1 / static_cast<double>(of.figure.effective_inertia(k).value);
    for (int i = 0; i < of.count(); ++i) felt.most = std::max(felt.most, 1 / static_cast<double>(of.figure.effective_inertia(i).value));
    for (scalar& torque : of.torques) torque = 0;
    of.torques[k] = 1;
    give(of);
    (void)ingot::step(*of.world, static_cast<scalar>(h));
    of.read();
    EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
    felt.given = static_cast<double>(of.torques[k]) / h;
    return felt;
}

/// What is asked of the second step of h, as a root mean square over all numbers: how far the mean acceleration is off. Velocities that a
/// step leaves fit the pose within its last substep: after the first step all by as much, and not those that were set.
double off_after(double h, std::uint64_t seed) {
    RandomInput random(seed);
    double sum = 0, all = 0;
    for (int run_i = 0; run_i < draws(80); ++run_i) {
        Read of;
        of.drawn = draw_figure(random, {random.integer(2, 5), 3, 1, run_i % 2 == 0});
        of.built = add_figure(*of.world, of.drawn);
        VectorXd before(of.drawn.figure.count);
        for (int step_i = 0; step_i < 2; ++step_i) {
            of.read();
            EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
            before = of.given();
            EXPECT_EQ(of.figure.inverse_dynamics(of.numbers, of.torques, of.count()), Status::ok);
            give(of);
            (void)ingot::step(*of.world, static_cast<scalar>(h));
        }
        of.read();
        EXPECT_EQ(of.figure.direction_rates(of.torques, of.count()), Status::ok);
        const VectorXd wanted = in_order(of.numbers, of.order);
        sum += ((of.given() - before) / h - wanted).squaredNorm();
        all += wanted.squaredNorm();
    }
    return std::sqrt(sum / all);
}

}  // namespace

/// Nothing but the torque acts as it begins: what rates and turns add grows with the square of the step. Joints draw together in a substep, a quarter
/// of the step, what places were rounded by.
TEST(Dynamics, effective_inertia_is_what_a_drive_feels) {
    RandomInput random(10);
    const double h = sizeof(scalar) == 8 ? 1e-3 : 1.0 / 60;
    for (int run_i = 0; run_i < draws(80); ++run_i) {
        Read of;
        const Felt felt = felt_in_step(of, random, h);
        const double roundings = 64 * eps / (h * h), second = 8 * felt.most * felt.most * h * h;
        EXPECT_NEAR(felt.given, felt.expected, roundings + second);
    }
}

/// Drives that give what was computed make the accelerations that were asked for: to first order, as means over a step.
TEST(Dynamics, torques_as_computed_accelerate_as_asked) {
    const double at_120 = off_after(1.0 / 120, 8), at_240 = off_after(1.0 / 240, 8);
    EXPECT_LE(at_240, 0.1);
    EXPECT_NEAR(at_120 / at_240, 2, 0.2);
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
    for_draws(40, 11, [](Read& of, RandomInput&) {
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
    for_draws(40, 12, [](Read& of, RandomInput& random) {
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
    Read of;
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
        Read of;
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
