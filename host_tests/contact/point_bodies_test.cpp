// SPDX-License-Identifier: MIT
// What the sequential solver takes in and gives back: motion that is finite, or none.
#include <gtest/gtest.h>
#include <ingot/body/auxiliary.h>
#include <ingot/solver/sequential/move_point_bodies.h>
#include <ingot/solver/sequential/sweep_points.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "stages/tiles.h"

namespace {

using ingot::PointBody;
using ingot::scalar;
using ingot::Vector;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_vector;

constexpr scalar h = scalar(1) / 64;
constexpr double eps = static_cast<double>(ingot::epsilon);
constexpr Vector gravity = {0, 0, -8};

/// Two bodies that touch, in the slots of one pair, and their solver.
struct Touching {
    static constexpr int slots[2] = {0, ingot::lanes + 1};
    ingot_stages::Tiles tiles{ingot::lanes + 2};
    std::vector<PointBody> bodies = std::vector<PointBody>(static_cast<std::size_t>(2 * ingot::lanes + 2));
    ingot::BodyPair pair = {0, ingot::lanes + 1, 0};
    ingot::ManifoldRecord record{};
    ingot::PointContact contact{};
    ingot::Index member = 0, body_slots[2 * ingot::lanes + 2] = {};
    ingot::PointView view{};
    int lowest = 0;  ///< slot of the lowest body of the first island

    Touching() {
        view.pairs = &pair, view.records = &record, view.manifold_count = 1;
        view.bodies = bodies.data(), view.contacts = &contact, view.members = &member, view.body_slots = body_slots;
        RandomInput random(1481);
        for (const int slot : slots) {
            ingot::BodyDef def = ingot_reference::definition(2, random.moments(2));
            def.state = {to_vector(random.vector(1)), to_vector(random.vector(1)), ingot_reference::to_matrix(random.rotation()),
                         to_vector(random.vector(1))};
            tiles.write(slot, def);
        }
        record.manifold.n = {0, 0, -1};
        record.manifold.count = 1;
        ingot::refresh_inv_I_world(tiles.view());
    }
    PointBody& body(int i) { return bodies[static_cast<std::size_t>(slots[i])]; }
    void take_in() {
        ingot::take_in_bodies(view, tiles.view(), gravity, h);
        ingot::join_bodies(view);
        lowest = ingot::next_island(view) ? view.body_slots[0] : view.slot_count;
    }
    bool is_bad(int i) { return (tiles.rotation(slots[i]).bad >> (slots[i] % ingot::lanes) & 1u) != 0; }
};

TEST(PointBodies, leave_the_motion_that_was_found) {
    Touching two;
    two.take_in();
    RandomInput random(1482);
    Eigen::Vector3d v[2], L[2], dp[2], turned[2];
    for (int i = 0; i < 2; ++i) {
        v[i] = random.vector(1), L[i] = random.vector(1), dp[i] = random.vector(0.01), turned[i] = random.vector(0.01);
        two.body(i).velocity.linear = to_vector(v[i]), two.body(i).velocity.moment = to_vector(L[i]);
        two.body(i).displacement.linear = to_vector(dp[i]), two.body(i).displacement.moment = to_vector(turned[i]);
    }
    ingot::write_contact_motion(two.view, ingot::NoJointedBodies{}, two.tiles.view(), gravity, h);
    const double step = static_cast<double>(h);
    for (int i = 0; i < 2; ++i) {
        const int lane_i = Touching::slots[i] % ingot::lanes;
        EXPECT_LE((to_eigen(two.tiles.state(Touching::slots[i]).v_CM) - v[i]).norm(), 8 * eps);
        EXPECT_LE((to_eigen(two.tiles.state(Touching::slots[i]).L) - L[i]).norm(), 8 * eps);
        // With a = F/M + g: dp = (v - a h / 2) h. With the mean L of the step in the middle: L - tau h / 2.
        const Eigen::Vector3d a = to_eigen(ingot::lane_of(two.tiles.translation(Touching::slots[i]).F_T, lane_i)) * 0.5 + to_eigen(gravity),
                              tau = to_eigen(ingot::lane_of(two.tiles.rotation(Touching::slots[i]).tau_T, lane_i));
        EXPECT_LE(((v[i] - a * step / 2) * step - dp[i]).norm(), 64 * eps);
        EXPECT_LE(((L[i] - tau * step / 2) * step - turned[i]).norm(), 64 * eps);
        EXPECT_FALSE(two.is_bad(i));
    }
}

TEST(PointBodies, that_are_no_numbers_are_marked_and_left_as_they_were) {
    for (int part = 0; part < 4; ++part) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const scalar bad : {std::numeric_limits<scalar>::quiet_NaN(), -std::numeric_limits<scalar>::infinity()}) {
                Touching two;
                two.take_in();
                const ingot::BodyState before = two.tiles.state(0);
                PointBody& body = two.body(0);
                Vector& of = part == 0   ? body.velocity.linear
                             : part == 1 ? body.velocity.angular
                             : part == 2 ? body.displacement.linear
                                         : body.displacement.moment;
                (axis == 0 ? of.x : axis == 1 ? of.y : of.z) = bad;
                ingot::write_contact_motion(two.view, ingot::NoJointedBodies{}, two.tiles.view(), gravity, h);
                EXPECT_TRUE(two.is_bad(0)) << part << " " << axis;
                EXPECT_FALSE(two.is_bad(1)) << "nobody else is";
                EXPECT_EQ(to_eigen(two.tiles.state(0).v_CM), to_eigen(before.v_CM));
                EXPECT_EQ(to_eigen(two.tiles.state(0).L), to_eigen(before.L));
            }
        }
    }
}

/// Forces that leave a body beyond all bounds do not reach those that touch it: it counts as one that cannot move.
TEST(PointBodies, that_forces_throw_out_are_not_taken_in) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Touching two;
            Eigen::Vector3d F = Eigen::Vector3d::Zero();
            F(axis) = sign * 2 * static_cast<double>(2 * ingot::limits::speed_runaway / h);
            ingot::set_lane(two.tiles.translation(0).F_T, 0, to_vector(F));
            two.take_in();
            EXPECT_TRUE(two.is_bad(0)) << axis;
            EXPECT_FALSE(two.is_bad(1));
            EXPECT_EQ(two.body(0).inv_M, 0);
            EXPECT_GT(two.body(1).inv_M, 0);
        }
    }
}

/// Of two that cannot move nothing is asked and nothing written; whoever of two can move is the one that does.
TEST(PointBodies, that_cannot_move_are_left_alone) {
    for (const int movable : {-1, 0, 1}) {
        Touching two;
        for (int i = 0; i < 2; ++i) {
            if (i == movable) continue;
            ingot::BodyDef wall{};
            wall.immovable = true;
            two.tiles.write(Touching::slots[i], wall);
        }
        ingot::refresh_inv_I_world(two.tiles.view());
        two.take_in();
        EXPECT_EQ(two.lowest, movable < 0 ? two.view.slot_count : Touching::slots[movable]) << "an island of the one that can, or none";
        two.contact.radius = 7;
        two.record.j[0] = 1;
        ingot::begin_contacts(two.view, 1, h);
        EXPECT_EQ(two.contact.radius == 7, movable < 0) << "begun, or not looked at";
        ingot::warm_start(two.view);
        if (movable < 0) continue;
        // A gets j n, B the opposite.
        const Eigen::Vector3d n(0, 0, movable == 0 ? -1 : 1), v = to_eigen(two.tiles.state(Touching::slots[movable]).v_CM);
        EXPECT_LE((to_eigen(two.body(movable).velocity.linear) - v - n / 2).norm(), 4 * eps);
        EXPECT_EQ(two.body(1 - movable).inv_M, 0);
    }
}

/// Bodies and pairs drawn at random, a part of the bodies immovable, islands mingled in the order of slots.
struct Mingled {
    std::vector<PointBody> bodies;
    std::vector<ingot::BodyPair> pairs;
    std::vector<ingot::Index> members, body_slots;
    ingot::PointView view{};

    explicit Mingled(RandomInput& random) : bodies(static_cast<std::size_t>(random.integer(2, 40))) {
        const int last = static_cast<int>(bodies.size()) - 1;
        for (std::size_t slot = 0; slot < bodies.size(); ++slot)
            bodies[slot].root = random.integer(0, 3) == 0 ? ingot::no_root : static_cast<ingot::Index>(slot);
        for (int A = 0; A < last; ++A)
            for (int B = A + 1; B <= last; ++B)
                if (random.integer(0, last) == 0) pairs.push_back({static_cast<ingot::Index>(A), static_cast<ingot::Index>(B), 0});
        members.resize(pairs.size() + 1);
        body_slots.resize(bodies.size());
        view.pairs = pairs.data(), view.manifold_count = static_cast<int>(pairs.size()), view.bodies = bodies.data();
        view.slot_count = static_cast<int>(bodies.size()), view.members = members.data(), view.body_slots = body_slots.data();
    }
    bool moves(int slot) const { return bodies[static_cast<std::size_t>(slot)].root != ingot::no_root; }
    /// The lowest body that each hangs together with, found by looking at all pairs again and again.
    std::vector<int> lowest() const {
        std::vector<int> of(bodies.size());
        for (std::size_t slot = 0; slot < of.size(); ++slot) of[slot] = static_cast<int>(slot);
        for (std::size_t pass_i = 0; pass_i < of.size(); ++pass_i)
            for (const ingot::BodyPair& pair : pairs)
                if (moves(pair.body_A) && moves(pair.body_B)) of[pair.body_A] = of[pair.body_B] = std::min(of[pair.body_A], of[pair.body_B]);
        return of;
    }
};

/// Island after island by their lowest bodies, each with its manifolds in the order of pairs and each of its bodies once.
TEST(PointBodies, are_listed_island_by_island) {
    RandomInput random(2027);
    int islands = 0;
    for (int draw_i = 0; draw_i < 500; ++draw_i) {
        Mingled crowd(random);
        std::map<int, std::vector<int>> manifolds_of;
        std::map<int, std::set<int>> bodies_of;
        const std::vector<int> lowest = crowd.lowest();
        for (std::size_t i = 0; i < crowd.pairs.size(); ++i)
            for (const int slot : {crowd.pairs[i].body_A, crowd.pairs[i].body_B}) {
                if (!crowd.moves(slot)) continue;
                const int root = lowest[static_cast<std::size_t>(slot)];
                if (manifolds_of[root].empty() || manifolds_of[root].back() != static_cast<int>(i)) manifolds_of[root].push_back(static_cast<int>(i));
                bodies_of[root].insert(slot);
            }
        ingot::join_bodies(crowd.view);
        for (const auto& [root, manifolds] : manifolds_of) {
            ASSERT_TRUE(ingot::next_island(crowd.view));
            EXPECT_EQ(std::vector<int>(crowd.view.members, crowd.view.members + crowd.view.member_count), manifolds) << "draw " << draw_i;
            const std::set<int> bodies(crowd.view.body_slots, crowd.view.body_slots + crowd.view.body_count);
            EXPECT_EQ(bodies, bodies_of[root]);
            EXPECT_EQ(static_cast<int>(bodies.size()), crowd.view.body_count) << "each once";
            for (const int slot : bodies) EXPECT_FALSE(crowd.bodies[static_cast<std::size_t>(slot)].hit);
            ++islands;
        }
        EXPECT_FALSE(ingot::next_island(crowd.view));
    }
    EXPECT_GT(islands, 1000);
}

}  // namespace
