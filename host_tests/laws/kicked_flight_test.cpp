// SPDX-License-Identifier: MIT
// After a torque, an impulse or an impact the body flies freely with the L it was left with: with that energy, on that path.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>
#include <string>

#include "laws/bodies.h"
#include "reference/eigen_free_body.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

const scalar h = scalar(1) / 60;

struct Flyer : ingot::Scene {
    static constexpr bool translates = true;
};
using World = ingot::World<Flyer>;

enum class Kick { impulse_at_a_point, angular_impulse, torque, force_at_a_point, new_state };

class KickedFlight : public ::testing::TestWithParam<Kick> {
protected:
    /// Gives the body something to turn by, about a tenth of its momentum; takes effect at once or over the step that follows.
    static void kick(World& world, const Known& body) {
        const ingot::Vector P = world.state(body.id).value.r_CM + ingot::Vector{0, scalar(0.5), 0};
        switch (GetParam()) {
            case Kick::impulse_at_a_point:
                ASSERT_EQ(world.apply_impulse(body.id, {0, 0, scalar(0.25)}, P), ingot::Status::ok);
                break;
            case Kick::angular_impulse:
                ASSERT_EQ(world.apply_angular_impulse(body.id, {scalar(0.125), 0, 0}), ingot::Status::ok);
                break;
            case Kick::torque:
                ASSERT_EQ(world.add_torque(body.id, {8, 0, 0}), ingot::Status::ok);
                break;
            case Kick::force_at_a_point:
                ASSERT_EQ(world.add_force(body.id, {0, 0, 16}, P), ingot::Status::ok);
                break;
            case Kick::new_state: {
                ingot::BodyState s = world.state(body.id).value;
                s.L = s.L * scalar(1.125);
                ASSERT_EQ(world.set_state(body.id, s), ingot::Status::ok);
                break;
            }
        }
    }
};

/// The book case, kicked after ten steps. Energy: 6 roundings of A's, times the ratio of moments (3). Attitude: the bar of R1.
TEST_P(KickedFlight, is_the_free_flight_of_the_new_momentum) {
    World world{};
    ingot::BodyDef def = definition(1, Eigen::Vector3d(1, 2, 3));
    def.state.L = {scalar(0.5), 2, scalar(2.25)};
    const Known body = add(world, def);
    for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
    kick(world, body);
    ASSERT_TRUE(ingot::step(world, h).clean());

    const ingot::BodyState begin = world.state(body.id).value;
    ASSERT_GT((to_eigen(begin.L) - to_eigen(def.state.L)).norm(), 0.1);
    const long double energy = rotation_energy(begin, body.I);
    Square A = to_eigen<long double>(begin.A);
    A += A * (Square::Identity() - A.transpose() * A) / 2;
    FreeBody exact(body.I, A, to_eigen<long double>(begin.L));
    double worst_attitude = 0, worst_energy = 0;
    for (int step_i = 1; step_i <= 1800; ++step_i) {
        ASSERT_TRUE(ingot::step(world, h).clean());
        exact.advance(static_cast<long double>(h));
        if (step_i % 10 != 0) continue;
        worst_attitude = std::max(worst_attitude, attitude_error(attitude(world, body), exact.A()));
        worst_energy = std::max(
            worst_energy, static_cast<double>(std::abs(rotation_energy(world.state(body.id).value, body.I) / energy - 1)));
    }
    std::printf("    30 s after the kick: attitude off by %.1e rad, energy by %.1e\n", worst_attitude, worst_energy);
    EXPECT_LE(worst_energy, 6 * 3 * u);
    EXPECT_LE(worst_attitude, bar(1e-12, 1e-5));
}
std::string name_of(const ::testing::TestParamInfo<Kick>& kick) {
    switch (kick.param) {
        case Kick::impulse_at_a_point:
            return "impulse_at_a_point";
        case Kick::angular_impulse:
            return "angular_impulse";
        case Kick::torque:
            return "torque";
        case Kick::force_at_a_point:
            return "force_at_a_point";
        default:
            return "new_state";
    }
}
INSTANTIATE_TEST_SUITE_P(Kicks, KickedFlight,
                         ::testing::Values(Kick::impulse_at_a_point, Kick::angular_impulse, Kick::torque,
                                           Kick::force_at_a_point, Kick::new_state),
                         name_of);

/// A torque far above the momentum there is, again and again: a body at rest or nearly so is set in motion, not frozen.
TEST(KickedBody, slow_bodies_survive_strong_torques) {
    RandomInput random(351);
    for (int i = 0; i < 50; ++i) {
        World world{};
        const Eigen::Vector3d I = random.moments(1);
        ingot::BodyDef def = definition(1, I);
        def.state.A = to_matrix(random.rotation());
        def.state.L = to_vector(random.vector(i % 2 == 0 ? 0 : 0.01));
        const Known body = add(world, def);
        for (int step_i = 0; step_i < 300; ++step_i) {
            if (step_i % 7 == 0) {
                ASSERT_EQ(world.add_torque(body.id, to_vector(random.vector(1))), ingot::Status::ok)
                    << "body " << i << ", step " << step_i;
            }
            ASSERT_TRUE(ingot::step(world, h).clean()) << "body " << i << ", step " << step_i;
        }
    }
}

}  // namespace
