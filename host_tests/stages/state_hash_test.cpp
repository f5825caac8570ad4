// SPDX-License-Identifier: MIT
// The hash of a body is of every number that its motion has, and of no other body's.
#include <gtest/gtest.h>
#include <ingot/body/energy_momentum.h>
#include <ingot/world/state_hash.h>

#include <set>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::lanes;
using ingot::scalar;
using ingot_stages::Tiles;

TEST(StateHash, is_of_every_number_of_one_body) {
    constexpr int slot = lanes + 1, lane_i = slot % lanes;
    RandomInput random(331);
    Tiles tiles(2 * lanes + 1);
    for (int i = 0; i < 2 * lanes + 1; ++i) {
        ingot::BodyDef def = definition(1, random.moments(1));
        def.state = {to_vector(random.vector(3)), to_vector(random.vector(3)), to_matrix(random.rotation()), to_vector(random.vector(1))};
        tiles.write(i, def);
    }
    const auto hash = [&](int of) { return ingot::hash_body(tiles.view(), of, ingot::state_hash_seed); };
    const std::uint64_t before = hash(slot), other = hash(0);
    std::set<std::uint64_t> seen = {before};
    int numbers = 0;
    const auto change = [&](scalar& number) {
        const scalar kept = number;
        number = kept + scalar(0.5);
        EXPECT_TRUE(seen.insert(hash(slot)).second) << numbers;
        EXPECT_EQ(hash(0), other);
        number = kept;
        ++numbers;
    };
    for (auto& row : tiles.rotation(slot).A) change(row[lane_i]);
    for (auto& row : tiles.rotation(slot).L) change(row[lane_i]);
    for (auto& row : tiles.view().compensation[slot / lanes].A_low) change(row[lane_i]);
    for (auto& row : tiles.translation(slot).r_CM) change(row[lane_i]);
    for (auto& row : tiles.translation(slot).v_CM) change(row[lane_i]);
    EXPECT_EQ(numbers, 27);
    EXPECT_EQ(hash(slot), before);
    EXPECT_NE(ingot::hash_body(tiles.view(), slot, 1), before) << "and of what was hashed before";
}

/// One value, one set of bits: a state's -0 is +0 from the begin.
TEST(StateHash, is_the_same_of_both_zeros) {
    std::uint64_t hashes[2];
    for (const int i : {0, 1}) {
        const scalar zero = i == 0 ? scalar(0) : -scalar(0);
        Tiles tiles(1);
        ingot::BodyDef def = definition(1, Eigen::Vector3d::Ones());
        def.state = {{zero, 1, zero}, {zero, zero, 2}, {{1, zero, zero}, {zero, 1, zero}, {zero, zero, 1}}, {3, zero, zero}};
        tiles.write(0, def);
        hashes[i] = ingot::hash_body(tiles.view(), 0, ingot::state_hash_seed);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

/// inv_I_world goes into lanes and comes back as it was.
TEST(StateHash, symmetric_matrices_go_into_lanes_and_back) {
    scalar rows[6][lanes], again[6][lanes];
    for (int row = 0; row < 6; ++row)
        for (int lane_i = 0; lane_i < lanes; ++lane_i) rows[row][lane_i] = static_cast<scalar>(10 * row + lane_i);
    ingot::store(again, ingot::load(rows));
    for (int row = 0; row < 6; ++row)
        for (int lane_i = 0; lane_i < lanes; ++lane_i) EXPECT_EQ(again[row][lane_i], rows[row][lane_i]);
}

/// Bodies of scenes that do not translate have no tiles for it.
TEST(StateHash, bodies_that_only_turn_have_no_place) {
    Tiles tiles(2);
    ingot::BodyDef def = definition(3, Eigen::Vector3d(1, 2, 4));
    def.state.L = {1, 2, 4}, def.state.r_CM = {5, 0, 0};
    for (const int slot : {0, 1}) tiles.write(slot, def);
    ingot::BodyView view = tiles.view();
    const std::uint64_t with_place = ingot::hash_body(view, 1, ingot::state_hash_seed);
    view.translation = nullptr;
    EXPECT_NE(ingot::hash_body(view, 1, ingot::state_hash_seed), with_place);
    // L^2 / (2 I) of each axis: 1/2 (1 + 2 + 4), and no momentum but L.
    EXPECT_NEAR(static_cast<double>(ingot::kinetic_energy_of(view, 1)), 3.5, 16 * static_cast<double>(ingot::epsilon));
    EXPECT_EQ(to_eigen(ingot::linear_momentum_of(view, 1)), Eigen::Vector3d::Zero());
    EXPECT_EQ(to_eigen(ingot::angular_momentum_of(view, 1)), Eigen::Vector3d(1, 2, 4));
    EXPECT_EQ(ingot::freeze_bad_bodies(view), 0);
    tiles.rotation(1).bad = static_cast<std::uint16_t>(1u << (1 % lanes));
    EXPECT_EQ(ingot::freeze_bad_bodies(view), 1);
    EXPECT_TRUE(ingot::is_frozen(view, 1));
    EXPECT_NE(tiles.translation(1).inv_M[1 % lanes], 0) << "what the view has not stays";
    ingot::set_identity_body(view, 1);
    EXPECT_EQ(tiles.rotation(1).inv_I_scale[1 % lanes], 0);
    EXPECT_EQ(tiles.rotation(0).L[2][0], 4) << "the other stays";
    EXPECT_EQ(tiles.translation(1).r_CM[0][1 % lanes], 5) << "and so does what the view has not";
}

}  // namespace
