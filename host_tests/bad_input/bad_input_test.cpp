// SPDX-License-Identifier: MIT
// Twenty-two bad inputs that were tried on eight builds of other engines: two of 22 to 17 of 22 ended those programs, and few were told
// to the caller. Here each is answered with a status, and the world goes on bitwise as if it had not been made.
//
// The scene is theirs: a ground, a column of three boxes of 1 m, a box apart, and on the column the victim. 30 steps, the bad call,
// 120 steps.
//
// Three of their rows are about what this kernel has not yet: `self joint` and `zero hinge axis` (joints), `collinear hull` (hulls).
// Their place is held by the calls that take the same nonsense: collide() of a body with itself and along no normal, solid_mesh() of
// points on a line. One row, `coincident`, is legal, and is answered with ok. What becomes of a body that legal input drives out of the
// range: capacity/frozen_test.
#include "capacity/yard.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace {

using namespace yard;

struct Column : ingot::Scene {
    static constexpr int max_bodies = 8;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 64;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

constexpr scalar nan_value = std::numeric_limits<scalar>::quiet_NaN();
constexpr scalar infinity = std::numeric_limits<scalar>::infinity();
constexpr int steps_before = 30, steps_after = 120;

BodyDef box_at(scalar x, scalar z) {
    BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
    def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    def.state.r_CM = {x, 0, z};
    return def;
}

/// A world of the scene, and the ids of two of its bodies.
struct Played {
    World<Column> world;
    BodyId victim, apart;
    BodyId outlived;  ///< its slot is the victim's

    void set_up() {
        clear(world);
        bool good = world.set_gravity({0, 0, scalar(-9.8125)}) == Status::ok && world.add(ground()).ok();
        for (const scalar z : {scalar(0.5), scalar(1.5), scalar(2.5)}) good = good && world.add(box_at(0, z)).ok();
        apart = world.add(box_at(10, scalar(0.5))).value;
        outlived = world.add(box_at(0, scalar(9.5))).value;
        good = good && world.remove(outlived) == Status::ok;
        victim = world.add(box_at(0, scalar(3.5))).value;
        ASSERT_TRUE(good && world.is_alive(apart) && world.is_alive(victim) && outlived.slot == victim.slot);
        play(steps_before);
    }
    void play(int steps) {
        for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, h);
    }
};

struct Row {
    const char* name;
    Status answer;
    Status (*make)(Played&);
};

/// The victim's state, spoilt.
template <class Spoil>
Status set_spoilt(Played& played, Spoil spoil) {
    BodyState state = played.world.state(played.victim).value;
    spoil(state);
    return played.world.set_state(played.victim, state);
}
template <class Spoil>
Status add_spoilt(Played& played, Spoil spoil) {
    BodyDef def = box_at(0, scalar(4.5));
    spoil(def);
    return played.world.add(def).status;
}

const Row rows[] = {
    {"nan_position", Status::not_finite, [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.r_CM.y = nan_value; }); }},
    {"nan_velocity", Status::not_finite, [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.v_CM.x = nan_value; }); }},
    {"inf_force", Status::not_finite, [](Played& p) { return p.world.add_central_force(p.victim, {infinity, 0, 0}); }},
    {"zero_mass", Status::bad_mass, [](Played& p) { return add_spoilt(p, [](BodyDef& def) { def.mass.M = 0; }); }},
    {"negative_mass", Status::bad_mass, [](Played& p) { return add_spoilt(p, [](BodyDef& def) { def.mass.M = -1; }); }},
    {"zero_size_box", Status::bad_shape, [](Played& p) { return add_spoilt(p, [](BodyDef& def) { def.shape = ingot::Box{{0, 0, 0}}; }); }},
    {"velocity_1e30", Status::out_of_range, [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.v_CM.x = scalar(1e30); }); }},
    {"position_1e18", Status::out_of_range, [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.r_CM.x = scalar(1e18); }); }},
    {"dt_zero", Status::bad_step, [](Played& p) { return ingot::step(p.world, 0).status; }},
    {"dt_minus_1", Status::bad_step, [](Played& p) { return ingot::step(p.world, -1).status; }},
    {"dt_1e6", Status::bad_step, [](Played& p) { return ingot::step(p.world, scalar(1e6)).status; }},
    {"dt_nan", Status::bad_step, [](Played& p) { return ingot::step(p.world, nan_value).status; }},
    {"stale_handle", Status::stale_id,
     [](Played& p) { return p.world.set_state(p.outlived, p.world.state(p.victim).value); }},
    {"self_collision_for_self_joint", Status::bad_shape,
     [](Played& p) { return p.world.collide(p.victim, p.victim, {0, 0, 3}, {0, 0, 1}, 1).status; }},
    {"collinear_mesh_for_collinear_hull", Status::bad_shape,
     [](Played&) {
         const Vector on_a_line[4] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
         const ingot::MeshTriangle faces[4] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
         return ingot::solid_mesh(1000, on_a_line, 4, faces, 4).status;
     }},
    {"zero_matrix_for_zero_quaternion", Status::not_a_rotation,
     [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.A = Matrix{}; }); }},
    {"nan_matrix_for_nan_quaternion", Status::not_finite,
     [](Played& p) { return set_spoilt(p, [](BodyState& s) { s.A = Matrix{} * nan_value; }); }},
    {"zero_normal_for_zero_hinge_axis", Status::bad_direction,
     [](Played& p) { return p.world.collide(p.victim, p.apart, {0, 0, 3}, {0, 0, 0}, 1).status; }},
    {"zero_axis_for_zero_hinge_axis", Status::bad_direction, [](Played&) { return ingot::rotation_about({0, 0, 0}, 1).status; }},
    {"nan_gravity", Status::not_finite, [](Played& p) { return p.world.set_gravity({0, 0, nan_value}); }},
};

class BadInput : public ::testing::TestWithParam<Row> {};

TEST_P(BadInput, is_answered_and_changes_nothing) {
    static Played undisturbed, played;
    undisturbed.set_up();
    played.set_up();
    ASSERT_TRUE(same_bytes(played.world, undisturbed.world));

    EXPECT_EQ(GetParam().make(played), GetParam().answer);
    ASSERT_TRUE(same_bytes(played.world, undisturbed.world)) << "the call changed the world";
    for (int step_i = 0; step_i < steps_after; ++step_i) {
        undisturbed.play(1);
        played.play(1);
        ASSERT_TRUE(same_bytes(played.world, undisturbed.world)) << "step " << step_i;
    }
    EXPECT_EQ(played.world.step_count(), static_cast<uint32_t>(steps_before + steps_after));
}

INSTANTIATE_TEST_SUITE_P(Rows, BadInput, ::testing::ValuesIn(rows), [](const auto& row) { return std::string(row.param.name); });

// Rows that do change the world, as far as they are legal.

TEST(BadInput, remove_twice) {
    static Played once, twice;
    once.set_up();
    twice.set_up();
    ASSERT_EQ(once.world.remove(once.victim), Status::ok);
    ASSERT_EQ(twice.world.remove(twice.victim), Status::ok);
    EXPECT_EQ(twice.world.remove(twice.victim), Status::stale_id);
    EXPECT_EQ(twice.world.remove(twice.victim), Status::stale_id);
    for (int step_i = 0; step_i < steps_after; ++step_i) {
        once.play(1);
        twice.play(1);
        ASSERT_TRUE(same_bytes(once.world, twice.world)) << "step " << step_i;
    }
}

TEST(BadInput, past_the_limit) {
    static Played full, pushed;
    full.set_up();
    pushed.set_up();
    int refused = 0;
    for (int body_i = 0; body_i < 40; ++body_i) {
        const BodyDef def = box_at(20 + 2 * static_cast<scalar>(body_i), scalar(0.5));
        if (full.world.body_count() < Column::max_bodies) {
            ASSERT_TRUE(full.world.add(def).ok());
        }
        const Status answer = pushed.world.add(def).status;
        EXPECT_EQ(answer, body_i < 2 ? Status::ok : Status::no_room);
        refused += answer == Status::no_room ? 1 : 0;
    }
    EXPECT_EQ(refused, 38);
    for (int step_i = 0; step_i < steps_after; ++step_i) {
        full.play(1);
        pushed.play(1);
        ASSERT_TRUE(same_bytes(full.world, pushed.world)) << "step " << step_i;
    }
}

/// Two bodies in one place are legal: none of the others is flung (their bound: 0.01 m), the box apart does not feel it.
TEST(BadInput, coincident) {
    static Played undisturbed, played;
    undisturbed.set_up();
    played.set_up();
    BodyDef twin = box_at(0, 0);
    twin.state = played.world.state(played.victim).value;
    const Result<BodyId> added = played.world.add(twin);
    ASSERT_EQ(added.status, Status::ok);
    for (int step_i = 0; step_i < steps_after; ++step_i) {
        undisturbed.play(1);
        played.play(1);
        for (int slot = 0; slot < Column::max_bodies; ++slot) {
            const BodyId id = played.world.body_at(slot);
            if (id == BodyId{}) continue;
            const BodyState state = played.world.state(id).value;
            ASSERT_TRUE(ingot::is_finite(state.r_CM) && ingot::is_finite(state.v_CM) && ingot::is_finite(state.L)) << "step " << step_i;
            ASSERT_FALSE(played.world.is_frozen(id)) << "step " << step_i;
            if (id == played.victim || id == added.value) continue;
            const Vector moved = state.r_CM - undisturbed.world.state(id).value.r_CM;
            ASSERT_LT(ingot::length_sq(moved), scalar(1e-4)) << "the body of slot " << slot << " at step " << step_i;
        }
        ASSERT_TRUE(same_bits(played.world.state(played.apart).value, undisturbed.world.state(undisturbed.apart).value));
    }
}

/// 22 rows: those of the table above, one of which has two calls in its place, and the three that follow it.
TEST(BadInput, has_all_22_rows) { EXPECT_EQ(std::size(rows) - 1 + 3, 22u); }

}  // namespace
