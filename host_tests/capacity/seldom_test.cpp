// SPDX-License-Identifier: MIT
// What seldom happens: numbers of a body that go bad in the middle of a pile, the last range of each argument, readings of ids that went stale.
#include "capacity/yard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <ingot/impulse/collide_shapes.h>
#include <ingot/shape/hull_of_points.h>
#include <ingot/broad_phase/body_bounds.h>

namespace {

using namespace yard;

constexpr scalar infinity = std::numeric_limits<scalar>::infinity();

struct Impacts : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 48;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
struct Friction : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 20;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

/// Ground, two stacks of two crates, and a ball of its own.
template <class S>
void fill_stacks(World<S>& world) {
    clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    ASSERT_TRUE(world.add(ground()).ok());
    const ingot::Box crate{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    for (int body_i = 0; body_i < 4; ++body_i)
        ASSERT_TRUE(world.add(plain_body({scalar(10 * (body_i / 2)), 0, scalar(body_i % 2) + scalar(0.5)}, crate)).ok());
    ASSERT_TRUE(world.add(plain_body({0, 30, scalar(0.5)}, ingot::Sphere{scalar(0.5)})).ok());
    for (int step_i = 0; step_i < 20; ++step_i) (void)ingot::step(world, h);
}

/// Writes over a number where it stands in the world's bytes: once, or the world holds it several times.
template <class S>
int overwrite(World<S>& world, scalar from, scalar to) {
    uint8_t* const bytes = reinterpret_cast<uint8_t*>(&world);
    int found = 0;
    for (size_t offset = 0; offset + sizeof from <= sizeof world; offset += sizeof from) {
        if (memcmp(bytes + offset, &from, sizeof from) != 0) continue;
        memcpy(bytes + offset, &to, sizeof to);
        ++found;
    }
    return found;
}

bool is_finite(const BodyState& state) {
    scalar numbers[18];
    memcpy(numbers, &state, sizeof state);
    for (const scalar number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

constexpr int steps_after = 31;

/// The upper crate of the first stack gets a number that is not one, and is frozen for it. Whatever is read afterwards is a number.
template <class S>
void put_bad_number(World<S>& world, scalar bad, bool in_L) {
    fill_stacks(world);
    const BodyId id = world.body_at(2);
    const scalar mark = scalar(0.0001220703125) * scalar(1.2345678);  // a value that stands nowhere else
    BodyState state = world.state(id).value;
    (in_L ? state.L.y : state.v_CM.x) = mark;
    ASSERT_EQ(world.set_state(id, state), Status::ok);
    ASSERT_EQ(overwrite(world, mark, bad), 1);

    EXPECT_GE(ingot::step(world, h).bodies_frozen, 1);
    EXPECT_TRUE(world.is_frozen(id));
    for (int step_i = 0; step_i < steps_after - 1; ++step_i) (void)ingot::step(world, h);
    for (int slot = 0; slot < S::max_bodies; ++slot) EXPECT_TRUE(is_finite(world.state(world.body_at(slot)).value)) << "slot " << slot;
}

/// The stack and the ball that do not touch it are not frozen, and are where they were.
template <class S>
void expect_that_the_others_go_on(const World<S>& world) {
    static World<S> undisturbed;
    fill_stacks(undisturbed);
    for (int step_i = 0; step_i < steps_after; ++step_i) (void)ingot::step(undisturbed, h);
    for (const int slot : {3, 4, 5}) {
        EXPECT_FALSE(world.is_frozen(world.body_at(slot))) << "slot " << slot;
        const Vector with = world.state(world.body_at(slot)).value.r_CM, without = undisturbed.state(undisturbed.body_at(slot)).value.r_CM;
        EXPECT_NEAR(with.x, without.x, 1e-3) << "slot " << slot;
        EXPECT_NEAR(with.z, without.z, 1e-3) << "slot " << slot;
    }
}

TEST(GoneBad, by_impacts_none_but_those_that_touch_it) {
    for (const scalar bad : {infinity, infinity - infinity}) {
        for (const bool in_L : {false, true}) {
            static World<Impacts> world;
            put_bad_number(world, bad, in_L);
            expect_that_the_others_go_on(world);
        }
    }
}

TEST(GoneBad, with_friction_all_that_is_read_stays_a_number) {
    for (const scalar bad : {infinity, infinity - infinity}) {
        for (const bool in_L : {false, true}) {
            static World<Friction> world;
            put_bad_number(world, bad, in_L);
        }
    }
}

// Those that stand on the same ground do not touch it.
TEST(GoneBad, with_friction_none_but_those_that_touch_it) {
    for (const scalar bad : {infinity, infinity - infinity}) {
        for (const bool in_L : {false, true}) {
            static World<Friction> world;
            put_bad_number(world, bad, in_L);
            expect_that_the_others_go_on(world);
        }
    }
}

// The same by legal calls, in float: the lightest speck under the largest force and torque.
TEST(GoneBad, a_speck_that_is_driven_out_of_the_range_freezes_alone) {
    static World<Friction> world;
    fill_stacks(world);
    ASSERT_EQ(world.remove(world.body_at(2)), Status::ok);
    BodyDef speck = plain_body({0, 0, scalar(1.5)}, ingot::Sphere{scalar(0.5)});
    speck.mass = mass_of(limits::mass_min, Vector{1, 1, 1} * (2 * limits::inertia_min));
    const BodyId id = world.add(speck).value;
    for (int step_i = 0; step_i < steps_after; ++step_i) {
        (void)world.add_central_force(id, {0, 0, -limits::force_max});
        (void)world.add_torque(id, {limits::torque_max, 0, 0});
        (void)ingot::step(world, h);
    }
    expect_that_the_others_go_on(world);
}

// Pressed to the ground by forces that leave them in the range or just not: what is settled for them is not for the rest of the world.
TEST(GoneBad, bodies_pressed_down_by_almost_too_much_stir_no_other) {
    struct Pressed {
        scalar M, I, size, F;
    };
    for (const Pressed& pressed : {Pressed{scalar(6.22457), scalar(0.00488858), scalar(55.3684), scalar(1.94087e9)},
                                   Pressed{scalar(49810.9), scalar(21.3255), scalar(11.6709), scalar(7.70441e14)},
                                   Pressed{scalar(23604.5), scalar(3.85639e-15), scalar(0.011165), scalar(4.61573e12)},
                                   Pressed{scalar(200429), scalar(6.0254e-7), scalar(0.00208955), scalar(1.8407e14)}}) {
        static World<Friction> world;
        fill_stacks(world);
        ASSERT_EQ(world.remove(world.body_at(2)), Status::ok);
        BodyDef box = plain_body({0, -300, pressed.size}, ingot::Box{{pressed.size, pressed.size, pressed.size}});
        box.mass = mass_of(pressed.M, Vector{1, 1, 1} * pressed.I);
        const Result<BodyId> added = world.add(box);
        ASSERT_TRUE(added.ok());
        for (int step_i = 0; step_i < steps_after; ++step_i) {
            (void)world.add_central_force(added.value, {0, 0, -pressed.F});
            (void)ingot::step(world, h);
        }
        expect_that_the_others_go_on(world);
    }
}

struct Tops : ingot::Scene {
    static constexpr int max_bodies = 3;
};

TEST(Readings, of_a_world_are_the_sums_of_its_bodies) {
    static World<Friction> world;
    fill_stacks(world);
    for (int slot = 1; slot < 6; ++slot) {
        BodyState state = world.state(world.body_at(slot)).value;
        state.v_CM = {scalar(slot), -1, scalar(0.5)};
        state.L = {1, scalar(slot), -2};
        ASSERT_EQ(world.set_state(world.body_at(slot), state), Status::ok);
    }
    Vector momentum{}, angular{};
    for (int slot = 0; slot < 6; ++slot) {
        const BodyId id = world.body_at(slot);
        const BodyState state = world.state(id).value;
        const Result<Vector> p = world.linear_momentum(id), L = world.angular_momentum(id);
        ASSERT_TRUE(p.ok() && L.ok());
        const Vector expected = slot == 0 ? Vector{} : state.v_CM;  // mass 1; the ground does not move
        EXPECT_EQ(p.value.x, expected.x);
        EXPECT_EQ(p.value.y, expected.y);
        EXPECT_EQ(p.value.z, expected.z);
        EXPECT_EQ(world.mass(id).value, slot == 0 ? 0 : 1);
        // L + r x M v, of numbers up to 30: four roundings of products of them.
        const double tolerance = 4 * 30 * 6 * static_cast<double>(ingot::epsilon);
        EXPECT_NEAR(L.value.x, state.L.x + state.r_CM.y * expected.z - state.r_CM.z * expected.y, tolerance);
        EXPECT_NEAR(L.value.y, state.L.y + state.r_CM.z * expected.x - state.r_CM.x * expected.z, tolerance);
        EXPECT_NEAR(L.value.z, state.L.z + state.r_CM.x * expected.y - state.r_CM.y * expected.x, tolerance);
        momentum += p.value;
        angular += L.value;
    }
    EXPECT_EQ(world.linear_momentum().x, momentum.x);
    EXPECT_EQ(world.linear_momentum().y, momentum.y);
    EXPECT_EQ(world.linear_momentum().z, momentum.z);
    EXPECT_EQ(world.angular_momentum().x, angular.x);
    EXPECT_EQ(world.angular_momentum().y, angular.y);
    EXPECT_EQ(world.angular_momentum().z, angular.z);
}

TEST(Readings, of_bodies_that_only_turn) {
    static World<Tops> world;
    clear(world);
    BodyDef def = plain_body({});
    def.state.L = {1, 2, 3};
    const BodyId a = world.add(def).value, b = world.add(def).value;
    EXPECT_EQ(world.angular_momentum(a).value.y, 2);
    EXPECT_EQ(world.angular_momentum().z, 6);
    EXPECT_EQ(world.kinetic_energy(b).value, world.kinetic_energy(a).value);
    EXPECT_NEAR(world.kinetic_energy(a).value, 0.5 * (1 / 1.0 + 4 / 1.5 + 9 / 2.0), 16 * static_cast<double>(ingot::epsilon));
    EXPECT_EQ(world.kinetic_energy(), 2 * world.kinetic_energy(a).value);
}

TEST(Readings, of_a_body_that_was_removed_are_refused) {
    static World<Friction> world;
    fill_stacks(world);
    const BodyId id = world.body_at(3);
    ASSERT_EQ(world.remove(id), Status::ok);
    EXPECT_EQ(world.mass(id).status, Status::stale_id);
    EXPECT_EQ(world.linear_momentum(id).status, Status::stale_id);
    EXPECT_EQ(world.angular_momentum(id).status, Status::stale_id);
    EXPECT_EQ(world.kinetic_energy(id).status, Status::stale_id);
}

TEST(Ids, of_two_worlds_differ_in_their_tag_alone) {
    const BodyId a{3, 1, 5};
    EXPECT_TRUE(a == (BodyId{3, 1, 5}));
    EXPECT_FALSE(a == (BodyId{3, 2, 5}));
    EXPECT_TRUE(a != (BodyId{3, 2, 5}));
    EXPECT_TRUE(a != (BodyId{4, 1, 5}));
    EXPECT_TRUE(a != (BodyId{3, 1, 7}));
}

TEST(Reports, are_clean_when_no_count_is_raised) {
    StepReport report{};
    EXPECT_TRUE(report.clean());
    for (ingot::Index StepReport::*const harmless : {&StepReport::contacts, &StepReport::impact_waves, &StepReport::sweeps}) {
        report.*harmless = 1;
        EXPECT_TRUE(report.clean());
    }
    for (ingot::Index StepReport::*const telling :
         {&StepReport::bodies_frozen, &StepReport::spins_clamped, &StepReport::contacts_lost, &StepReport::pairs_untested,
          &StepReport::impacts_deferred, &StepReport::sweeps_unfinished, &StepReport::overlaps_lost, &StepReport::events_lost}) {
        report.*telling = 1;
        EXPECT_FALSE(report.clean());
        report.*telling = 0;
    }
    report.status = Status::bad_step;
    EXPECT_FALSE(report.clean());
}

struct Solids : Friction {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

TEST(Door, of_surfaces_ends_where_limits_say) {
    static World<Solids> world;
    clear(world);
    const scalar small = limits::size_min / 2, large = limits::size_max * 2, good = 1;
    const Shape bad[] = {ingot::Box{{small, good, good}},
                         ingot::Box{{good, small, good}},
                         ingot::Box{{good, good, small}},
                         ingot::Box{{large, good, good}},
                         ingot::Box{{good, large, good}},
                         ingot::Box{{good, good, large}},
                         ingot::Cylinder{small, good},
                         ingot::Cylinder{good, small},
                         ingot::Cylinder{large, good},
                         ingot::Cylinder{good, large},
                         ingot::Capsule{small, good},
                         ingot::Capsule{good, large},
                         ingot::Sphere{small},
                         ingot::Sphere{large}};
    for (const Shape& shape : bad) EXPECT_EQ(world.add(plain_body({}, shape)).status, Status::bad_shape);
    BodyDef def = plain_body({}, ingot::Sphere{1});
    def.friction = limits::friction_max * 2;
    EXPECT_EQ(world.add(def).status, Status::bad_friction);
    def.friction = -1;
    EXPECT_EQ(world.add(def).status, Status::bad_friction);
    def.friction = infinity;
    EXPECT_EQ(world.add(def).status, Status::not_finite);
    EXPECT_EQ(world.body_count(), 0);
    def.friction = limits::friction_max;
    EXPECT_TRUE(world.add(def).ok());
}

TEST(UserFrame, has_no_spin_about_an_axis_without_a_moment) {
    MassProperties mass = mass_of(1, {0, 0, 0});
    BodyState state{};
    state.A = ingot::identity_matrix<scalar>();
    state.L = {3, 6, 9};
    for (int axis = 0; axis < 3; ++axis) {
        mass.I_body = {axis == 0 ? scalar(0) : 3, axis == 1 ? scalar(0) : 3, axis == 2 ? scalar(0) : 3};
        const Vector omega = ingot::user_motion(mass, state).omega;
        EXPECT_EQ(omega.x, axis == 0 ? 0 : 1);
        EXPECT_EQ(omega.y, axis == 1 ? 0 : 2);
        EXPECT_EQ(omega.z, axis == 2 ? 0 : 3);
    }
}

TEST(Meshes, beyond_the_range_are_refused_along_each_axis) {
    const ingot::MeshTriangle triangles[4] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const scalar far = limits::position_max * 2;
    const Vector corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    ASSERT_TRUE(ingot::solid_mesh(1, corners, 4, triangles, 4).ok());
    for (const Vector& beyond : {Vector{far, 0, 0}, Vector{0, far, 0}, Vector{0, 0, far}, Vector{0, 0, -far}}) {
        const Vector spoilt[4] = {corners[0], corners[1], corners[2], beyond};
        EXPECT_EQ(ingot::solid_mesh(1, spoilt, 4, triangles, 4).status, Status::out_of_range);
    }
    for (const scalar edge : {limits::position_max, -limits::position_max}) {  // a range ends with its limit: what is refused is the flat solid
        const Vector spoilt[4] = {corners[0], corners[1], corners[2], {edge, edge, edge}};
        EXPECT_NE(ingot::solid_mesh(1, spoilt, 4, triangles, 4).status, Status::out_of_range);
    }
    // The volume is 1/6, and the mass more than a scalar holds: that of a cube of edge 60 is 2e5 times the density.
    const Vector large[4] = {{0, 0, 0}, {60, 0, 0}, {0, 60, 0}, {0, 0, 60}};
    EXPECT_EQ(ingot::solid_mesh(ingot::scalar_max / 16, large, 4, triangles, 4).status, Status::out_of_range);
}

TEST(Hulls, beyond_the_range_are_refused_along_each_axis) {
    const scalar far = limits::position_max * 2, wide = limits::size_max * 3;
    for (const Vector& beyond : {Vector{far, 0, 0}, Vector{0, far, 0}, Vector{0, 0, far}}) {
        const Vector points[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, beyond};
        EXPECT_EQ(ingot::convex_hull(points).status, Status::out_of_range);
    }
    const Vector huge[4] = {{0, 0, 0}, {wide, 0, 0}, {-wide, 1, 0}, {wide, wide, wide}};
    EXPECT_EQ(ingot::convex_hull(huge).status, Status::out_of_range);
}

/// Balls and boxes that come near and do not touch: scenes without friction look at each pair whose bounding balls touch.
TEST(Impacts, of_what_is_apart_are_none) {
    ingot::Contact contacts[8];
    ingot::Index count = 0, lost = 0;
    ingot::ContactSink sink{{contacts, &count, 8}, 0, 1, 0, &lost};
    const ingot::Matrix upright = ingot::identity_matrix<scalar>();
    const ingot::Placed ball{ingot::Sphere{1}, {0, 0, scalar(2.5)}, upright}, other{ingot::Sphere{1}, {}, upright},
        floor{ingot::HalfSpace{{0, 0, 1}, 0}, {}, upright};
    ingot::collide_sphere_sphere(ball, other, sink);
    EXPECT_EQ(count, 0);
    ingot::collide_sphere_half_space(ball, floor, sink);
    EXPECT_EQ(count, 0);
    ingot::collide_sphere_half_space(other, floor, sink);
    EXPECT_EQ(count, 1);
    EXPECT_EQ(contacts[0].separation, -1);
}

TEST(Impacts, of_what_overlaps_say_by_how_much) {
    ingot::Contact contacts[8];
    ingot::Index count = 0, lost = 0;
    ingot::ContactSink sink{{contacts, &count, 8}, 0, 1, 0, &lost};
    const ingot::Matrix upright = ingot::identity_matrix<scalar>();
    const ingot::Placed ball{ingot::Sphere{1}, {0, 0, scalar(1.75)}, upright}, other{ingot::Sphere{scalar(0.5)}, {0, 0, scalar(0.5)}, upright};
    ingot::collide_sphere_sphere(ball, other, sink);
    ASSERT_EQ(count, 1);
    EXPECT_EQ(contacts[0].separation, scalar(-0.25));
    EXPECT_EQ(contacts[0].n.z, 1);

    // A box turned by its axes, its lowest face a quarter under the ground; all numbers are exact.
    count = 0;
    const ingot::Placed floor{ingot::HalfSpace{{0, 0, 1}, 0}, {}, upright},
        box{ingot::Box{{1, 2, 4}}, {0, 0, scalar(1.75)}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    ingot::collide_box_half_space(box, floor, sink);
    ASSERT_EQ(count, 4);
    bool seen[2][2] = {};
    for (const ingot::Contact& contact : {contacts[0], contacts[1], contacts[2], contacts[3]}) {
        EXPECT_EQ(contact.separation, scalar(-0.25));
        // r x n of the corner (+-4, +-1, -2) is (+-1, -+4, 0).
        EXPECT_EQ(std::abs(contact.lever_A.x), 1);
        EXPECT_EQ(std::abs(contact.lever_A.y), 4);
        EXPECT_EQ(contact.lever_A.z, 0);
        seen[contact.lever_A.x > 0][contact.lever_A.y > 0] = true;
    }
    EXPECT_TRUE(seen[0][0] && seen[0][1] && seen[1][0] && seen[1][1]) << "four different corners";
}

TEST(Shapes, hold_nothing_that_they_do_not_need) {
    const Shape all[] = {ingot::Sphere{1}, ingot::Capsule{1, 2}, ingot::Cylinder{1, 2}, ingot::Box{{1, 2, 3}}};
    for (const Shape& shape : all) EXPECT_EQ(shape.offset, 0);
    for (int shape_i = 0; shape_i < 3; ++shape_i) {
        EXPECT_EQ(all[shape_i].size.y, shape_i == 0 ? 0 : 2);
        EXPECT_EQ(all[shape_i].size.z, 0);
    }
}

/// The bounds of a body hold its shape, and by no more than the margin, whatever the attitude.
TEST(Bounds, of_round_shapes_are_theirs) {
    constexpr int slots = ingot::lanes;
    ingot::RotationTile rotation{};
    ingot::TranslationTile translation{};
    ingot::BoundsTile bounds{};
    ingot::Surface surfaces[slots]{};
    const ingot::BodyView bodies{&rotation, &translation, nullptr, nullptr, 1};
    const scalar radius = scalar(0.5), half_length = 2;
    const Vector axes[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {scalar(0.6), 0, scalar(0.8)}, {scalar(0.48), scalar(0.6), scalar(0.64)}};
    for (const Vector& axis : axes) {
        for (const bool capsule : {false, true}) {
            const Shape shape = capsule ? Shape(ingot::Capsule{radius, half_length}) : Shape(ingot::Cylinder{radius, half_length});
            surfaces[0] = {shape, ingot::bounding_radius(shape), 0, 0};
            ingot::set_identity_body(bodies, 0);
            const Vector other = axis.z > scalar(0.9) ? Vector{1, 0, 0} : Vector{0, 0, 1};
            Vector c0 = ingot::cross(other, axis);
            c0 = c0 * (1 / std::sqrt(ingot::length_sq(c0)));
            ingot::set_lane(rotation.A, 0, ingot::Matrix{c0, ingot::cross(axis, c0), axis});
            ingot::invalidate_bounds(&bounds, 0);
            (void)ingot::refresh_bounds(bodies, {surfaces, 1}, h, &bounds);
            const scalar along[3] = {std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)};
            for (int k = 0; k < 3; ++k) {
                // sin of the angle between the axis of the shape and that of the world, in double: rounding is within flatness.
                const double across = std::sqrt(std::fmax(0.0, 1 - static_cast<double>(along[k]) * static_cast<double>(along[k])));
                const double reach = static_cast<double>(along[k] * half_length) + static_cast<double>(radius) * (capsule ? 1 : across);
                const double more = static_cast<double>(limits::contact_margin) / 2,
                             slack = 2 * static_cast<double>(limits::flatness) * 3 + std::sqrt(static_cast<double>(ingot::epsilon));
                EXPECT_GE(static_cast<double>(bounds.high[k][0]), reach + more - std::sqrt(static_cast<double>(ingot::epsilon)));
                EXPECT_LE(static_cast<double>(bounds.high[k][0]), reach + more + slack);
                EXPECT_EQ(bounds.low[k][0], -bounds.high[k][0]);
            }
        }
    }
}

}  // namespace
