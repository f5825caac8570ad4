// SPDX-License-Identifier: MIT
// Materials of a level: each part of the ground is to touch as its material says, whatever it is cut into.
#include <gtest/gtest.h>

#include <limits>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;
using ingot::LevelMaterial;

struct Floors : OnLevel {
    static constexpr bool kinematic_bodies = true;
    static inline LevelTable levels[2] = {};
};
struct FastFloors : Floors {
    static constexpr bool continuous = true;
    static inline LevelTable levels[2] = {};
};

/// A plane, of material 1 where x is beyond the middle.
Ground halves(Random& random, Seams seams, bool one_material) {
    constexpr double step = 1.0 / 256;
    const int cells = between(random, 20, 60), cell = 40 * 256 / cells / 2 * 2;
    Ground ground;
    if (seams == Seams::field) {
        ground.field.heights.assign(static_cast<size_t>(61 * 31), 40);
        for (int row = 0; row < 30; ++row)
            for (int column = 0; column < 60; ++column) ground.field.cells.push_back(one_material || column >= 30 ? 1 : 0);
        ground.field.view.heights.spacing_x = ground.field.view.heights.spacing_y = scalar(0.75);
        ground.field.view.step = scalar(step);
        finish_heights(ground.field, 61, 31);
        ground.view = ground.field.view;
        ground.middle = {scalar(22.5), scalar(11.25), 40 * scalar(step)};
        return ground;
    }
    Soup soup = terrain(random, cells, cell, [](int, int) { return 8; });
    const int border = cells / 2 * cell;
    for (ingot::LevelFace& face : soup.faces) {
        int sum = 0;
        for (const int corner : {face.a, face.b, face.c}) sum += soup.points[static_cast<size_t>(corner)].x;
        face.material = one_material || sum > 3 * border ? 1 : 0;
    }
    take_mesh(soup, step, ground);
    ground.middle = {static_cast<scalar>(border * step), static_cast<scalar>(border * step), 8 * scalar(step)};
    return ground;
}

BodyDef placed(BodyDef def, const Vector& at) {
    def.state.r_CM = def.state.r_CM + at;
    return def;
}

/// Ground of one material goes as a level that has its friction and restitution for its own, to the bit.
template <class S>
void expect_as_of_the_level() {
    for (int draw = 0; draw < ingot_reference::draws(30); ++draw) {
        Random random(static_cast<uint64_t>(2100 + draw));
        const Ground ground = halves(random, draw % 2 == 0 ? Seams::field : Seams::grid, true);
        const LevelMaterial materials[] = {{1, 1}, {static_cast<scalar>(within(random, 0, 1.5)), static_cast<scalar>(within(random, 0, 0.8))}};
        const auto size = static_cast<scalar>(within(random, 0.1, 0.5));
        const BodyDef def = placed(goer(random, static_cast<Goer>(draw % goers_count), size, within(random, 0, 8)),
                                   ground.middle + Vector{0, 0, draw % 3 == 0 ? scalar(0.5) : scalar(0)});
        Vector r[2];
        for (int which = 0; which < 2; ++which) {
            auto& world = empty_world<S>();
            LevelDef level;
            S::levels[0] = which == 0 ? with_materials(ground.view, materials) : ground.view;
            level.friction = which == 0 ? scalar(0.1) : materials[1].friction;
            level.restitution = which == 0 ? scalar(0.9) : materials[1].restitution;
            ASSERT_TRUE(world.add_level(level).ok());
            const BodyId id = world.add(def).value;
            for (int i = 0; i < 90; ++i) (void)ingot::step(world, scalar(1) / 60);
            r[which] = world.state(id).value.r_CM;
        }
        EXPECT_TRUE(r[0].x == r[1].x && r[0].y == r[1].y && r[0].z == r[1].z) << "draw " << draw;
    }
}
TEST(LevelMaterials, all_over_the_ground_are_those_of_the_level) { expect_as_of_the_level<Floors>(); }
TEST(LevelMaterials, all_over_the_ground_are_those_of_the_level_for_fast_bodies) { expect_as_of_the_level<FastFloors>(); }

/// A box that slides from ice over a border stops v^2 / (2 mu g) behind it, to its half length: friction begins with its first corner and is whole
/// with its last. Rates 30 to 1000, sizes, speeds, fields and meshes, beside another; on each side its contacts name the material, and on the border
/// they name both and carry its weight together.
TEST(LevelMaterials, end_at_their_border) {
    for (int draw = 0; draw < ingot_reference::draws(30); ++draw) {
        Random random(static_cast<uint64_t>(2300 + draw));
        const Ground ground = halves(random, draw % 2 == 0 ? Seams::field : Seams::grid, false);
        const LevelMaterial materials[] = {{0, 0}, {static_cast<scalar>(within(random, 0.3, 1)), 0}};
        constexpr int rates[] = {30, 60, 120, 240, 1000};
        const int rate = rates[draw % 5];
        const double mu = std::sqrt(0.4 * static_cast<double>(materials[1].friction)), speed = within(random, 1, 6);
        auto& world = empty_world<Floors>();
        (void)add_level(world, with_materials(ground.view, materials), 1);
        const Vector half = {static_cast<scalar>(within(random, 0.1, 0.6)), static_cast<scalar>(within(random, 0.1, 0.6)), scalar(0.1)};
        BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(700, half)).value;
        def.shape = ingot::Box{half};
        def.friction = scalar(0.4);
        const Vector at = ground.middle + Vector{-2 * half.x - scalar(0.3), scalar(0.2), half.z};
        def.state = ingot::body_state(def.mass, {at, ingot::identity_matrix<scalar>()},
                                      {{static_cast<scalar>(speed), 0, 0}, {}});
        const BodyId id = world.add(def).value;
        BodyDef beside = def;
        beside.state.r_CM.y += 5;
        beside.state.v_CM = {};
        const BodyId still = world.add(beside).value;
        bool on_both = false;
        for (int i = 0; i < 3 * rate; ++i) {
            ASSERT_TRUE(ingot::step(world, 1 / static_cast<scalar>(rate)).clean());
            const scalar x = world.state(id).value.r_CM.x - ground.middle.x;
            double normal = 0;
            bool named[2] = {};
            for (const ingot::ContactInfo& contact : world.contacts_of(id)) {
                normal += static_cast<double>(contact.j);
                named[contact.material] = true;
            }
            // Points are told where they were as the step began, and within flush of the border they are on both.
            const scalar way = static_cast<scalar>(speed) / static_cast<scalar>(rate) + scalar(0.01);
            if (x < -half.x) {
                EXPECT_TRUE(named[0] && !named[1]);
            }
            if (x > half.x + way) {
                EXPECT_TRUE(named[1] && !named[0]);
            }
            if (!(named[0] && named[1])) continue;
            on_both = true;
            const double weight = 9.81 / rate * static_cast<double>(world.mass(id).value);
            EXPECT_NEAR(normal, weight, 0.02 * weight) << "draw " << draw;
        }
        EXPECT_TRUE(on_both);
        const double stop = static_cast<double>(world.state(id).value.r_CM.x - ground.middle.x), free = speed * speed / (2 * mu * 9.81);
        EXPECT_LE(std::abs(stop - free), static_cast<double>(half.x) + speed / rate) << "draw " << draw << ", " << rate << " Hz";
        EXPECT_EQ(world.state(still).value.r_CM.x, beside.state.r_CM.x);
    }
}

/// A body whose friction is changed while it slides is held by the mean of the new one and the material's from the next step on; and what a snapshot
/// keeps of it, on either side or on the border, goes on to the same bits.
TEST(LevelMaterials, are_mixed_anew_after_edits_and_kept_in_snapshots) {
    for (int draw = 0; draw < ingot_reference::draws(40); ++draw) {
        Random random(static_cast<uint64_t>(2500 + draw));
        const Ground ground = halves(random, draw % 2 == 0 ? Seams::field : Seams::grid, false);
        const double of_ground[] = {within(random, 0.1, 1), within(random, 0.1, 1)}, of_body[] = {within(random, 0.1, 0.4), within(random, 0.5, 1)};
        const LevelMaterial materials[] = {{static_cast<scalar>(of_ground[0]), 0}, {static_cast<scalar>(of_ground[1]), 0}};
        const int side = draw % 3;  // 2: over the border
        const scalar at = side == 0 ? scalar(-6) : side == 1 ? scalar(2) : scalar(-1);
        BodyDef def = placed(goer(random, Goer::box, scalar(0.2), 0), ground.middle + Vector{at, 0, 0});
        def.state.v_CM = {4, 0, 0};
        def.friction = static_cast<scalar>(of_body[0]);
        auto& world = empty_world<Floors>();
        (void)add_level(world, with_materials(ground.view, materials));
        const BodyId id = world.add(def).value;
        const auto go = [](World<Floors>& one, int steps) {
            for (int i = 0; i < steps; ++i) (void)ingot::step(one, scalar(1) / 60);
        };
        go(world, 6);
        EXPECT_EQ(world.set_friction(id, static_cast<scalar>(of_body[1])), Status::ok);
        const double before = static_cast<double>(world.state(id).value.v_CM.x);
        go(world, 6);
        const double lost = before - static_cast<double>(world.state(id).value.v_CM.x);
        // Of the mean with the friction it had before it would lose a third less, or more.
        if (side < 2) {
            EXPECT_NEAR(lost, std::sqrt(of_body[1] * of_ground[side]) * 9.81 * 0.1, 0.02 * lost) << "draw " << draw;
        }

        static World<Floors> kept;
        std::vector<std::uint8_t> bytes(ingot::snapshot_size<Floors>());
        const auto saved = ingot::save_snapshot(world, bytes.data(), bytes.size());
        ASSERT_TRUE(saved.ok());
        ASSERT_EQ(ingot::load_snapshot(kept, bytes.data(), saved.value), Status::ok);
        for (World<Floors>* one : {&world, &kept}) {
            go(*one, 3);
            EXPECT_EQ(one->set_friction(id, scalar(0.3)), Status::ok);
            go(*one, 30);
        }
        const Vector r = world.state(id).value.r_CM, again = kept.state(id).value.r_CM;
        EXPECT_TRUE(again.x == r.x && again.y == r.y && again.z == r.z) << "draw " << draw;
        Floors::levels[0] = ground.view;
        EXPECT_NE(ingot::load_snapshot(kept, bytes.data(), saved.value), Status::ok) << "other materials";
    }
}

TEST(LevelMaterials, that_are_none_are_refused) {
    Random random(2700);
    const Ground ground = halves(random, Seams::field, false);
    constexpr scalar not_a_number = std::numeric_limits<scalar>::quiet_NaN();
    const LevelMaterial bad[] = {{-1, 0}, {not_a_number, 0}, {scalar(0.5), 2}, {scalar(0.5), -1}, {scalar(0.5), not_a_number}, {scalar(1e30), 0}};
    for (const LevelMaterial& one : bad) {
        const LevelMaterial materials[] = {{}, one};
        auto& world = empty_world<Floors>();
        static World<Floors> before;
        std::memcpy(static_cast<void*>(&before), &world, sizeof world);
        Floors::levels[0] = with_materials(ground.view, materials);
        const Status status = world.add_level({}).status;
        EXPECT_TRUE(status == Status::bad_friction || status == Status::bad_restitution || status == Status::not_finite);
        EXPECT_EQ(std::memcmp(static_cast<void*>(&before), &world, sizeof world), 0);
    }
    const LevelMaterial good[] = {{}, {}};
    LevelTable level = with_materials(ground.view, good);
    EXPECT_EQ(check_level(level), Status::ok);
    EXPECT_NE(level.checksum, ground.view.checksum);
    level.material_count = LevelMaterial::count_max + 1;
    EXPECT_EQ(check_level(level), Status::bad_shape);
    level = with_materials(ground.view, good);
    level.materials = nullptr;
    EXPECT_EQ(check_level(level), Status::bad_shape);
    for (const int count : {-1, 2, LevelMaterial::count_max + 1}) {
        Floors::levels[0] = ground.view;
        Floors::levels[0].material_count = count;
        EXPECT_EQ(empty_world<Floors>().add_level({}).status, Status::bad_shape) << count;
    }
    level = with_materials(ground.view, bad);
    level.checksum ^= 1;
    EXPECT_EQ(check_level(level), Status::bad_shape);
}

}  // namespace
