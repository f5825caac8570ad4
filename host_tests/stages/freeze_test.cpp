// SPDX-License-Identifier: MIT
// freeze_bad_bodies: one body driven out of range stands still; no bit of any other changes.
#include <gtest/gtest.h>
#include <ingot/motion/integrate_L.h>
#include <ingot/motion/integrate_r.h>
#include <ingot/motion/integrate_v.h>
#include <ingot/motion/listing1_euler.h>
#include <ingot/motion/moser_veselov.h>
#include <ingot/world/state_hash.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using ingot_stages::Tiles;

constexpr int slots = 2 * ingot::lanes + 1;
constexpr scalar h = scalar(1) / 64;
const ingot::Vector gravity = {0, 0, -8};

Tiles random_tiles() {
    RandomInput random(151);
    Tiles tiles(slots);
    for (int slot = 0; slot < slots; ++slot) {
        ingot::BodyDef def = definition(1, random.moments(1));
        def.state = {to_vector(random.vector(3)), to_vector(random.vector(3)), to_matrix(random.rotation()),
                     to_vector(random.vector(1))};
        tiles.write(slot, def);
    }
    return tiles;
}

void all_stages(Tiles& tiles, std::uint32_t step_i) {
    ingot::integrate_L(tiles.view(), h);
    ingot::integrate_v(tiles.view(), h, gravity);
    ingot::MoserVeselov::integrate_A(tiles.view(), h, {step_i});
    ingot::integrate_r(tiles.view(), h, gravity);
    ingot::clear_forces(tiles.view());
}

std::uint64_t hash_of(Tiles& tiles, int slot) { return ingot::hash_body(tiles.view(), slot, ingot::state_hash_seed); }

/// What is done to one number of one body, and the stage that has to notice.
enum class Blow { torque, force, position, momentum };

class Freeze : public ::testing::TestWithParam<std::tuple<Blow, scalar>> {};

TEST_P(Freeze, stops_the_body_at_its_last_good_pose_and_no_other) {
    const auto [blow, number] = GetParam();
    for (int bad_slot : {0, ingot::lanes - 1, slots - 1}) {
        Tiles struck = random_tiles(), calm = random_tiles();
        const int lane_i = bad_slot % ingot::lanes;
        ingot::RotationTile& rotation = struck.rotation(bad_slot);
        ingot::TranslationTile& translation = struck.translation(bad_slot);
        if (blow == Blow::torque) rotation.tau_T[1][lane_i] = number;
        if (blow == Blow::force) translation.F_T[2][lane_i] = number;
        if (blow == Blow::position) translation.v_CM[0][lane_i] = std::numeric_limits<scalar>::max();
        if (blow == Blow::momentum) rotation.L[2][lane_i] = number;
        const ingot::BodyState before = struck.state(bad_slot);

        for (std::uint32_t step_i = 0; step_i < 20; ++step_i) {
            all_stages(struck, step_i);
            all_stages(calm, step_i);
            ASSERT_EQ(ingot::freeze_bad_bodies(struck.view()), step_i == 0 ? 1 : 0);
            ASSERT_EQ(ingot::freeze_bad_bodies(calm.view()), 0);
        }
        for (int slot = 0; slot < slots; ++slot) {
            EXPECT_EQ(ingot::is_frozen(struck.view(), slot), slot == bad_slot);
            EXPECT_EQ(hash_of(struck, slot) == hash_of(calm, slot), slot != bad_slot) << "slot " << slot;
        }
        const ingot::BodyState after = struck.state(bad_slot);
        EXPECT_EQ(to_eigen(after.v_CM), Eigen::Vector3d(0, 0, 0));
        EXPECT_EQ(to_eigen(after.L), Eigen::Vector3d(0, 0, 0));
        EXPECT_TRUE(is_finite(after.A) && is_finite(after.r_CM));
        // What was not struck may have moved in the first step, at the speeds of the body: a metre, a radian a second.
        EXPECT_LE((to_eigen(after.r_CM) - to_eigen(before.r_CM)).norm(), 10 * static_cast<double>(h));
        EXPECT_LE((to_eigen(after.A) - to_eigen(before.A)).norm(), 100 * static_cast<double>(h));
        if (blow == Blow::momentum) {
            EXPECT_EQ(to_eigen(after.A), to_eigen(before.A));
        }
        if (blow == Blow::position) {
            EXPECT_EQ(to_eigen(after.r_CM), to_eigen(before.r_CM));
        }
    }
}

constexpr scalar infinity = std::numeric_limits<scalar>::infinity();
constexpr scalar nan = std::numeric_limits<scalar>::quiet_NaN();
std::string name_of(const ::testing::TestParamInfo<std::tuple<Blow, scalar>>& blow) {
    const scalar number = std::get<1>(blow.param);
    const std::string size = std::isnan(number) ? "nan" : number > 0 ? "infinite" : number < 0 ? "minus_infinite" : "too_far";
    switch (std::get<0>(blow.param)) {
        case Blow::torque:
            return "torque_" + size;
        case Blow::force:
            return "force_" + size;
        case Blow::position:
            return "position_" + size;
        default:
            return "momentum_" + size;
    }
}
INSTANTIATE_TEST_SUITE_P(Blows, Freeze,
                         ::testing::Values(std::tuple(Blow::torque, nan), std::tuple(Blow::torque, infinity),
                                           std::tuple(Blow::force, nan), std::tuple(Blow::force, -infinity),
                                           std::tuple(Blow::position, scalar(0)), std::tuple(Blow::momentum, nan),
                                           std::tuple(Blow::momentum, -infinity)),
                         name_of);

TEST(FreezeListing1, marks_the_body_and_keeps_its_attitude) {
    Tiles tiles = random_tiles();
    tiles.rotation(slots - 1).L[1][0] = nan;
    const ingot::BodyState before = tiles.state(slots - 1);
    ingot::integrate_A_listing1(tiles.view(), h);
    EXPECT_EQ(ingot::freeze_bad_bodies(tiles.view()), 1);
    EXPECT_EQ(to_eigen(tiles.state(slots - 1).A), to_eigen(before.A));
    EXPECT_TRUE(ingot::is_frozen(tiles.view(), slots - 1));
    EXPECT_FALSE(ingot::is_frozen(tiles.view(), 0));
}

TEST(FreezeBadBodies, leaves_good_bodies_alone) {
    Tiles tiles = random_tiles();
    std::vector<std::uint64_t> before;
    for (int slot = 0; slot < slots; ++slot) before.push_back(hash_of(tiles, slot));
    EXPECT_EQ(ingot::freeze_bad_bodies(tiles.view()), 0);
    for (int slot = 0; slot < slots; ++slot) EXPECT_EQ(hash_of(tiles, slot), before[static_cast<std::size_t>(slot)]);
}

}  // namespace
