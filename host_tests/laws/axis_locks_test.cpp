// SPDX-License-Identifier: MIT
// Bodies with locks in free flight: a locked coordinate keeps its bits, the others obey the equations of the free axes.
#include "laws/locked_bodies.h"

#include "reference/draws.h"

namespace {

using namespace locked_bodies;
using ingot_reference::draws;

struct Free : ingot::Scene {
    static constexpr int max_bodies = 8;
    static constexpr bool translates = true, axis_locks = true;
};
struct FreeToTurn : ingot::Scene {
    static constexpr int max_bodies = 8;
    static constexpr bool axis_locks = true;
};
/// W is what Eigen's inverse of the free block is, for random solids and needles. A bound on the error: the sums are of positive terms, so a few
/// roundings each of their result; and of the attitude, whose roundings are felt by the ratio of the moments.
TEST(AxisLocks, inverse_inertia_is_that_of_the_free_axes) {
    RandomInput random(1);
    for (int draw = 0; draw < 2000; ++draw) {
        const double long_one = std::pow(10, random.real(0, 3)), M = std::exp(random.real(-9, 9));
        const Vector3d I = M * Vector3d(1, long_one, long_one * random.real(1, 1 + 0.9 / long_one));
        const Matrix A = to_matrix(random.rotation());
        const unsigned locks = 8u * static_cast<unsigned>(random.integer(0, 7));
        const Vector inv_I = {scalar(1 / I.x()), scalar(1 / I.y()), scalar(1 / I.z())};
        const Matrix3d W = to_eigen(ingot::inverse_inertia_of_free(A, inv_I, locks >> 3)), A_double = to_eigen(A);
        const Vector3d I_rounded = to_eigen(inv_I).cwiseInverse();
        const Matrix3d wanted = restricted_inverse(A_double * I_rounded.asDiagonal() * A_double.transpose(), locks);
        EXPECT_LE((W - wanted).norm(), 16 * double(ingot::epsilon) * wanted.norm() * long_one) << "locks " << locks << " ratio " << long_one;
        for (int axis = 0; axis < 3; ++axis)
            if (is_locked(locks, 3 + axis)) {
                EXPECT_EQ(W.row(axis).norm() + W.col(axis).norm(), 0) << "to the bit";
            }
    }
}

/// Free flight with gravity and forces: what is locked stays to the bit, momentum along free axes is that of the free axes alone, to the bit where no
/// torque acts; and energy of rotation is kept as by MoserVeselov.
template <class S>
class LockedFlight : public ::testing::Test {};
using Flights = testing::Types<Free, FreeToTurn>;
TYPED_TEST_SUITE(LockedFlight, Flights);

TYPED_TEST(LockedFlight, keeps_locks_energy_and_momenta) {
    RandomInput random(2);
    for (int draw = 0; draw < 240; ++draw) {
        static World<TypeParam> world;
        std::memset(static_cast<void*>(&world), 0, sizeof world);
        const unsigned locks = static_cast<unsigned>(random.integer(0, 63)) & (TypeParam::translates ? 63u : 56u);
        const double rates[] = {30, 60, 120, 240, 1000};
        const scalar h = scalar(1 / rates[draw % 5]);
        BodyDef def = any_body(random, locks);
        const Vector3d omega = random.vector(6), v = random.vector(3);
        def.state.L = to_vector(Vector3d(inertia_of(def) * omega));
        if constexpr (TypeParam::translates) {
            def.state.v_CM = to_vector(v);
            ASSERT_EQ(world.set_gravity({scalar(random.real(-9, 9)), scalar(-9.8), 1}), Status::ok);
        } else {
            def.state.r_CM = {};
        }
        const BodyId id = world.add(def).value;
        const BodyState before = world.state(id).value;
        const double energy = world.kinetic_energy(id).value;
        EXPECT_TRUE(is_held(world, id, before));
        for (int step_i = 0; step_i < 60; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
        const BodyState after = world.state(id).value;
        EXPECT_TRUE(is_held(world, id, before)) << draw;
        for (int axis = 0; axis < 3; ++axis)
            if (!is_locked(locks, 3 + axis)) {
                EXPECT_TRUE(same(axis_of(before.L, axis), axis_of(after.L, axis)));
            }
        if constexpr (TypeParam::translates) {
            const Vector g = world.gravity();
            const double T = 60.0 * double(h);
            for (int axis = 0; axis < 3; ++axis)
                if (!is_locked(locks, axis)) {
                    EXPECT_NEAR(double(axis_of(after.r_CM, axis)),
                                double(axis_of(before.r_CM, axis)) + double(axis_of(before.v_CM, axis)) * T + double(axis_of(g, axis)) * T * T / 2,
                                60 * double(ingot::epsilon) * 40);
                }
        } else {
            // What a part cannot give back, where no turn changes the energy, is of the fifth of its angle.
            const double part = std::pow(double(ingot::limits::locked_turn_of_part), 5) / 120;
            EXPECT_NEAR(double(world.kinetic_energy(id).value), energy, (60 * double(ingot::limits::energy_rounding) + part) * energy) << locks;
        }
        EXPECT_LE(ingot::orthogonality_error(after.A), 20 * ingot::epsilon);
    }
}

/// About one free axis: the angle is omega t to the rounding of the steps, whatever the rate and the spin.
TYPED_TEST(LockedFlight, about_one_axis_is_exact) {
    RandomInput random(3);
    for (int draw = 0; draw < 60; ++draw) {
        static World<TypeParam> world;
        std::memset(static_cast<void*>(&world), 0, sizeof world);
        const int axis = draw % 3;
        BodyDef def = any_body(random, AxisLocks::rotation & ~(8u << axis));
        if (!TypeParam::translates) def.state.r_CM = {};
        Vector3d omega = Vector3d::Zero();
        omega[axis] = random.real(-20, 20);
        def.state.L = to_vector(Vector3d(inertia_of(def) * omega));
        const BodyId id = world.add(def).value;
        const double spin = to_eigen(world.omega(id).value)[axis], seconds = 2;
        const scalar h = scalar(1) / 64;
        for (int step_i = 0; step_i < 128; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
        Vector3d along = Vector3d::Zero();
        along[axis] = 1;
        const Matrix3d wanted = Eigen::AngleAxisd(spin * seconds, along).toRotationMatrix() * to_eigen(def.state.A);
        // Of the spin one rounding, over all of the turn; of each step one of its angle and of the rows, as a walk at worst all one way.
        EXPECT_LE((to_eigen(world.state(id).value.A) - wanted).norm(), double(ingot::epsilon) * (4 * std::abs(spin) * seconds + 4 * 128));
    }
}

/// About two free axes: against Runge and Kutta on A' = tilde(W(A) L) A in double.
TYPED_TEST(LockedFlight, about_two_axes_is_of_fourth_order) {
    RandomInput random(4);
    double error[2] = {};
    for (int draw = 0; draw < 12; ++draw) {
        const unsigned locks = 8u << draw % 3;
        BodyDef def = any_body(random, locks);
        if (!TypeParam::translates) def.state.r_CM = {};
        def.state.L = to_vector(Vector3d(inertia_of(def) * random.vector(2)));
        const int steps[2] = {16, 32};
        Matrix3d found[2], A = to_eigen(def.state.A);
        Vector3d L;
        for (int which = 0; which < 2; ++which) {
            static World<TypeParam> world;
            std::memset(static_cast<void*>(&world), 0, sizeof world);
            const BodyId id = world.add(def).value;
            L = to_eigen(world.state(id).value.L);
            for (int step_i = 0; step_i < steps[which]; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / scalar(steps[which])).clean());
            found[which] = to_eigen(world.state(id).value.A);
        }
        const Vector3d I = to_eigen(def.mass.I_body);
        const auto rate = [&](const Matrix3d& at) -> Matrix3d {
            const Vector3d omega = restricted_inverse(at * I.asDiagonal() * at.transpose(), locks) * L;
            Matrix3d tilde;
            tilde << 0, -omega.z(), omega.y(), omega.z(), 0, -omega.x(), -omega.y(), omega.x(), 0;
            return tilde * at;
        };
        for (int i = 0; i < 100; ++i) {
            const double dt = 1e-2;
            const Matrix3d k1 = rate(A), k2 = rate(A + k1 * dt / 2), k3 = rate(A + k2 * dt / 2), k4 = rate(A + k3 * dt);
            A += (k1 + 2 * k2 + 2 * k3 + k4) * dt / 6;
        }
        for (int which = 0; which < 2; ++which) error[which] += (found[which] - A).norm() / 12;
    }
    // A part turns by 0.125 rad at most, and is off by the fifth of that over 120; steps of 1/16 s and 1/32 s are one part each, or two.
    const double part = double(ingot::limits::locked_turn_of_part), roundings = 64 * 8 * double(ingot::epsilon);
    for (const double of : error) EXPECT_LT(of, 8 * std::pow(part, 5) / 120 * 32 + roundings);
    if (INGOT_DOUBLE != 0) {
        EXPECT_GT(error[0] / error[1], 8) << error[0] << ' ' << error[1];
    }
}

/// Bad input changes nothing, to the byte; a slot forgets its locks.
TEST(AxisLocksOfBody, are_refused_where_they_are_none_and_go_with_the_body) {
    static World<Free> world, before;
    static World<FreeToTurn> turning;
    RandomInput random(5);
    const BodyId id = world.add(any_body(random, AxisLocks::translate_x)).value;
    EXPECT_EQ(world.locks(id).value, AxisLocks::translate_x);
    ASSERT_EQ(world.set_locks(id, AxisLocks::to_plane_xy), Status::ok);
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);
    EXPECT_EQ(world.set_locks(id, 64), Status::out_of_range);
    EXPECT_EQ(world.set_locks(id, ~0u), Status::out_of_range);
    EXPECT_EQ(world.set_locks({}, AxisLocks::all), Status::stale_id);
    EXPECT_EQ(world.locks({}).status, Status::stale_id);
    EXPECT_EQ(world.add(any_body(random, 64)).status, Status::out_of_range);
    EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);
    ASSERT_EQ(world.remove(id), Status::ok);
    EXPECT_EQ(world.locks(world.add(any_body(random, 0)).value).value, 0u);
    EXPECT_EQ(turning.add(any_body(random, AxisLocks::translate_y)).status, Status::not_in_scene) << "nothing translates";
}

/// What acts along locked axes does nothing, and is seen to do nothing at once. What a body had along the others it keeps, also as it is let go.
TEST(AxisLocksOfBody, bear_forces_and_impulses) {
    static World<Free> world;
    RandomInput random(6);
    for (unsigned locks = 0; locks < 64; ++locks) {
        std::memset(static_cast<void*>(&world), 0, sizeof world);
        ASSERT_EQ(world.set_gravity({1, -9, 3}), Status::ok);
        BodyDef def = any_body(random, locks);
        def.state.r_CM = def.state.r_CM * scalar(1e-9);  // so near to the origin that it would be seen to move by the rounding of gravity
        const BodyId id = world.add(def).value;
        const BodyState before = world.state(id).value;
        const scalar M = world.mass(id).value / 64;
        for (int step_i = 0; step_i < 20; ++step_i) {
            ASSERT_EQ(world.apply_impulse(id, Vector{1, 2, 3} * M, before.r_CM + Vector{0, 1, scalar(0.5)}), Status::ok);
            EXPECT_TRUE(is_held(world, id, before)) << locks;
            ASSERT_EQ(world.add_force(id, Vector{30, 20, 10} * M, before.r_CM + Vector{1, 0, scalar(0.5)}), Status::ok);
            ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
            EXPECT_TRUE(is_held(world, id, before)) << locks;
        }
        const Vector v = world.state(id).value.v_CM, omega = world.omega(id).value;
        for (int axis = 0; axis < 3; ++axis)
            if (!is_locked(locks, axis)) {
                EXPECT_NE(axis_of(v, axis), 0);
            }
        ASSERT_EQ(world.set_locks(id, 0), Status::ok);
        EXPECT_TRUE(same(v, world.state(id).value.v_CM));
        EXPECT_LE((to_eigen(world.omega(id).value) - to_eigen(omega)).norm(), 32 * double(ingot::epsilon) * to_eigen(omega).norm());
    }
}

TEST(AxisLocksOfBody, are_hashed_and_saved) {
    static World<Free> world, restored;
    RandomInput random(7);
    std::vector<BodyId> ids;
    for (int body_i = 0; body_i < 8; ++body_i) {
        BodyDef def = any_body(random, 0);
        def.state.L = to_vector(random.vector(1));
        def.state.v_CM = {1, 2, 3};
        ids.push_back(world.add(def).value);
    }
    const uint64_t plain = world.state_hash();
    unsigned locks = 0;
    for (const BodyId id : ids) ASSERT_EQ(world.set_locks(id, 7u * locks++), Status::ok);
    EXPECT_NE(world.state_hash(), plain);
    for (int step_i = 0; step_i < 10; ++step_i) (void)ingot::step(world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Free>());
    bytes.resize(ingot::save_snapshot(world, bytes.data(), bytes.size()).value);
    ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    locks = 0;
    for (const BodyId id : ids) EXPECT_EQ(restored.locks(id).value, 7u * locks++);
    for (int step_i = 0; step_i < 10; ++step_i) {
        (void)ingot::step(world, scalar(1) / 60);
        (void)ingot::step(restored, scalar(1) / 60);
        ASSERT_EQ(restored.state_hash(), world.state_hash());
    }
}

/// World::collide: along n the points part by e times their speed, and nothing moves along locked axes.
TEST(AxisLocksOfBody, collide_by_the_free_axes) {
    static World<Free> world;
    RandomInput random(8);
    for (int draw = 0; draw < 400; ++draw) {
        std::memset(static_cast<void*>(&world), 0, sizeof world);
        BodyId ids[2];
        for (BodyId& id : ids) {
            BodyDef def = any_body(random, static_cast<unsigned>(random.integer(0, 63)));
            def.state.r_CM = to_vector(random.vector(1));
            def.state.v_CM = to_vector(random.vector(3));
            def.state.L = to_vector(Vector3d(inertia_of(def) * random.vector(3)));
            id = world.add(def).value;
        }
        const BodyState before[2] = {world.state(ids[0]).value, world.state(ids[1]).value};
        const Vector3d P = random.vector(1), n = random.direction();
        const double e = random.real(0, 1);
        const auto approach = [&] {
            Vector3d u = Vector3d::Zero();
            for (int i = 0; i < 2; ++i)
                u += (i == 0 ? 1 : -1) * (to_eigen(world.state(ids[i]).value.v_CM) +
                                          to_eigen(world.omega(ids[i]).value).cross(P - to_eigen(before[i].r_CM)));
            return n.dot(u);
        };
        const double u = approach();
        const auto j = world.collide(ids[0], ids[1], to_vector(P), to_vector(n), scalar(e));
        if (!j.ok() || !(u < -0.01)) continue;  // out of range, where they hardly can part
        const double spread = 1 + double(j.value) / double(std::min(world.mass(ids[0]).value, world.mass(ids[1]).value));
        EXPECT_NEAR(approach(), -e * u, 1e-4 * spread) << world.locks(ids[0]).value << ' ' << world.locks(ids[1]).value;
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(is_held(world, ids[i], before[i]));
    }
}

}  // namespace
