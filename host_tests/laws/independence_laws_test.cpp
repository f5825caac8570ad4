// SPDX-License-Identifier: MIT
// Where a body lives, slot, tile and lane, and who lives beside it, does not change one bit of its motion. (Answers of calls
// are not looked at: what is refused has to be refused everywhere.)
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>

#include "laws/bodies.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

constexpr int count = 23;
const scalar h = scalar(1) / 60;

template <class Rotation>
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = 64;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 64;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Rotation;
};

/// Bodies far from each other, of all speeds: some at rest, some in substeps, some beyond the clamp.
std::vector<ingot::BodyDef> random_definitions(double spin_max) {
    RandomInput random(321);
    std::vector<ingot::BodyDef> defs;
    for (int i = 0; i < count; ++i) {
        const double M = random.real(0.1, 10), R = 0.3;
        ingot::BodyDef def = i % 2 == 0 ? ball(M, R, {}, {}, 0.5) : box(M, {0.3, 0.2, 0.1}, {}, {}, 0.5);
        const Eigen::Vector3d I = i % 2 == 0 ? random.moments(M) : to_eigen(def.mass.I_body);
        def.mass = to_mass(M, I);
        const Eigen::Matrix3d A = random.rotation();
        const double spin = i % 5 == 0 ? 0 : std::exp(random.real(-3, std::log(spin_max)));
        def.state = {to_vector(Eigen::Vector3d(10.0 * i, 0, 0.1 + random.real(0, 1))),
                     to_vector(Eigen::Vector3d(0, 0, random.real(-1, 1))), to_matrix(A),
                     to_vector(A * I.cwiseProduct(random.direction() * spin))};
        defs.push_back(def);
    }
    return defs;
}

/// Steps a world with the bodies added in the given order, after `before` others, with pushes that depend on the body alone;
/// gives the state of each body, by its number, after the last step.
template <class Rotation>
std::vector<ingot::BodyState> flown(const std::vector<ingot::BodyDef>& defs, const std::vector<int>& order, int before,
                                    bool remove_others) {
    auto world = std::make_unique<ingot::World<Crowd<Rotation>>>();
    EXPECT_EQ(world->set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
    std::vector<ingot::BodyId> others, ids(defs.size());
    RandomInput random(331);
    for (int i = 0; i < before; ++i) {
        ingot::BodyDef def = definition(1, random.moments(1));
        def.state.r_CM = to_vector(Eigen::Vector3d(10.0 * i, 1000, 1000));
        def.state.L = to_vector(random.vector(100));
        others.push_back(world->add(def).value);
    }
    for (const int body : order) {
        ids[static_cast<std::size_t>(body)] = world->add(defs[static_cast<std::size_t>(body)]).value;
        EXPECT_TRUE(world->is_alive(ids[static_cast<std::size_t>(body)]));
    }
    if (remove_others) {
        for (const ingot::BodyId id : others) EXPECT_EQ(world->remove(id), ingot::Status::ok);
    }
    EXPECT_EQ(world->add(half_space({0, 0, 1}, 0)).status, ingot::Status::ok);
    for (int step_i = 0; step_i < 200; ++step_i) {
        for (const int body : order) {
            const double phase = 0.1 * step_i + body;
            const ingot::BodyId id = ids[static_cast<std::size_t>(body)];
            if ((step_i + body) % 7 == 0)
                (void)world->add_torque(id, to_vector(Eigen::Vector3d(std::cos(phase), std::sin(phase), 1)));
        }
        (void)ingot::step(*world, h);
    }
    std::vector<ingot::BodyState> states;
    for (const ingot::BodyId id : ids) states.push_back(world->state(id).value);
    return states;
}

template <class Rotation>
class Independence : public ::testing::Test {
protected:
    static constexpr double spin_max() { return std::is_same_v<Rotation, ingot::MoserVeselov> ? 1000 : 20; }

    void expect_same(const std::vector<int>& order, int before, bool remove_others) {
        const std::vector<ingot::BodyDef> defs = random_definitions(spin_max());
        std::vector<int> as_they_come(count);
        std::iota(as_they_come.begin(), as_they_come.end(), 0);
        const std::vector<ingot::BodyState> one = flown<Rotation>(defs, as_they_come, 0, false),
                                            other = flown<Rotation>(defs, order, before, remove_others);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(std::memcmp(&one[i], &other[i], sizeof one[i]), 0) << "body " << i;
            EXPECT_NE(std::memcmp(&one[i], &defs[i].state, sizeof one[i]), 0) << "it did move";
        }
    }
};
struct MethodName {
    template <class Rotation>
    static std::string GetName(int index) {
        return std::string(Rotation::name) + "_" + std::to_string(index);
    }
};
using Methods = ::testing::Types<ingot::MoserVeselov, ingot::Listing1Euler, ingot::LieMidpoint, ingot::Rk4Polar,
                                 ingot::ExactElliptic, ingot::SymmetricTop, ingot::SymmetricTopSplitting<2>, ingot::SymmetricTopSplitting<6>,
                                 ingot::DiscreteMoserVeselov<4, false, false>>;
TYPED_TEST_SUITE(Independence, Methods, MethodName);

TYPED_TEST(Independence, order_of_the_slots_does_not_matter) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    RandomInput random(341);
    for (int shuffle = 0; shuffle < 2; ++shuffle) {
        for (int i = count - 1; i > 0; --i)
            std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(random.integer(0, i))]);
        this->expect_same(order, 0, false);
    }
}

TYPED_TEST(Independence, neighbours_in_the_tile_do_not_matter) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (const int before : {1, 3, 9}) this->expect_same(order, before, false);
    this->expect_same(order, 5, true);
}

/// One body in a world of its own moves as in a crowd.
TYPED_TEST(Independence, a_body_alone_moves_as_in_a_crowd) {
    const std::vector<ingot::BodyDef> defs = random_definitions(this->spin_max());
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    const std::vector<ingot::BodyState> crowd = flown<TypeParam>(defs, all, 0, false);
    for (const int body : {1, 2, 11, 22}) {
        const std::size_t i = static_cast<std::size_t>(body);
        auto world = std::make_unique<ingot::World<Crowd<TypeParam>>>();
        ASSERT_EQ(world->set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
        const ingot::BodyId id = world->add(defs[i]).value;
        ASSERT_TRUE(world->add(half_space({0, 0, 1}, 0)).ok());
        for (int step_i = 0; step_i < 200; ++step_i) {
            const double phase = 0.1 * step_i + body;
            if ((step_i + body) % 7 == 0)
                (void)world->add_torque(id, to_vector(Eigen::Vector3d(std::cos(phase), std::sin(phase), 1)));
            (void)ingot::step(*world, h);
        }
        const ingot::BodyState alone = world->state(id).value;
        EXPECT_EQ(std::memcmp(&alone, &crowd[i], sizeof alone), 0) << "body " << body;
    }
}

}  // namespace
