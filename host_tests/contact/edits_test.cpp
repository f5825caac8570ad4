// SPDX-License-Identifier: MIT
// Edits of bodies: a world that is edited is the world that was built so, byte by byte of its snapshot and step by step; saved after an edit it goes
// on to the same bits; what sleeps wakes; what is refused changes nothing.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

#include "reference/brief_types.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using namespace ingot;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;

constexpr scalar g = scalar(9.8125), h = scalar(1) / 60;

template <class Solver, bool sleepy = false, class Search = AllPairs>
struct Yard : Scene {
    static constexpr int max_bodies = 12, max_manifolds = 80, max_overlaps = 20, max_events = 60;
    static constexpr bool translates = true, sleeps = sleepy;
    using solver = Solver;
    using broad_phase = Search;
    using shapes = Shapes<Sphere, Capsule, Box, HalfSpace>;
};
struct Light : Yard<SequentialImpulses> {
    static constexpr bool recycles_manifolds = false;
};
struct Fast : Yard<BlockSweeps> {
    static constexpr bool continuous = true;
};
struct Many : Yard<BlockSweeps, true, SortedTree> {
    static constexpr int max_shapes_of_body = 2, max_pairs = 400;
};
struct Impacts : Scene {
    static constexpr int max_bodies = 12, max_contacts = 80;
    static constexpr bool translates = true;
    using solver = FrictionlessImpacts;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};

template <class S>
World<S>& empty_world(int which = 0) {
    static World<S> worlds[2];
    World<S>& world = worlds[which];
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    (void)world.set_gravity({0, 0, -g});
    return world;
}
template <class S>
std::vector<uint8_t> saved(const World<S>& world) {
    std::vector<uint8_t> bytes(snapshot_size<S>());
    bytes.resize(save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}
/// The motion of a body as it was added: L is of the mass that it had.
BodyState moving(BodyState state, const MassProperties& mass, const Vector& omega) {
    state.L = angular_momentum_of_spin(state.A, mass.I_body, omega);
    return state;
}
BodyDef ground() {
    BodyDef def;
    def.shape = HalfSpace{{0, 0, 1}, 0};
    def.immovable = true;
    return def;
}
template <class S>
BodyDef random_body(RandomInput& random) {
    const auto size = [&] { return static_cast<scalar>(random.real(0.25, 0.5)); };
    const Vector half = {size(), size(), size()};
    const bool is_box = S::max_contacts == 0 && random.integer(0, 1) == 0;
    BodyDef def;
    def.mass = principal(is_box ? solid_box(static_cast<scalar>(random.real(0.5, 4)), half) : solid_sphere(2, half.x)).value;
    def.shape = is_box ? Shape(Box{half}) : Shape(Sphere{half.x});
    def.friction = static_cast<scalar>(random.real(0, 1));
    def.restitution = static_cast<scalar>(random.real(0, 0.75));
    def.sensor = S::max_overlaps > 0 && random.integer(0, 5) == 0;
    def.immovable = random.integer(0, 4) == 0;
    return def;
}
template <class S>
void put(BodyDef& def, RandomInput& random, int place) {
    def.state.r_CM = to_vector(Eigen::Vector3d(random.real(-1, 1), random.real(-1, 1), 0.5 + 0.75 * place));
    def.state.A = to_matrix(random.rotation());
    if (!def.immovable) def.state.v_CM = to_vector(random.vector(3));
    if (!def.immovable) def.state = moving(def.state, def.mass, to_vector(random.vector(3)));
}
template <class S>
Result<BodyId> add(World<S>& world, const BodyDef& def) {
    if constexpr (S::max_shapes_of_body > 1) {
        if (def.shape.kind == ShapeKind::half_space) return world.add(def);
        BodyDef of = def;
        of.shape = {};
        const ShapeDef part = {def.shape, {}, identity_matrix<scalar>(), def.restitution, def.friction, def.sensor};
        ShapeDef parts[2] = {part, {Sphere{scalar(0.2)}, {scalar(0.25), 0, 0}}};
        return world.add(of, parts);
    } else {
        return world.add(def);
    }
}
/// Makes of one body another.
template <class S>
void edit(World<S>& world, BodyId id, const BodyDef& to) {
    const Status kind = to.immovable ? world.set_immovable(id) : world.set_movable(id, to.mass);
    ASSERT_EQ(kind, Status::ok);
    ASSERT_EQ(world.set_shape(id, to.shape), Status::ok);
    ASSERT_EQ(world.set_friction(id, to.friction), Status::ok);
    ASSERT_EQ(world.set_restitution(id, to.restitution), Status::ok);
    if constexpr (S::max_overlaps > 0) {
        ASSERT_EQ(world.set_sensor(id, to.sensor), Status::ok);
    }
}

template <class S>
class Edits : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<5, Yard<HybridIslands<10>, true>, Light, Fast, Many, Impacts, Yard<BlockSweeps>,
                                           Yard<BlockSweeps, false, SortedTree>, Yard<BlockSweeps, true, SortedTree>,
                                           Yard<SequentialImpulses, true>>;
TYPED_TEST_SUITE(Edits, Scenes);

TYPED_TEST(Edits, make_the_world_that_was_built_so) {
    for (int seed = 0; seed < 12; ++seed) {
        RandomInput random(static_cast<std::uint64_t>(500 + seed));
        World<TypeParam>&edited = empty_world<TypeParam>(0), &built = empty_world<TypeParam>(1);
        ASSERT_TRUE(add(edited, ground()).ok() && add(built, ground()).ok());
        std::vector<BodyDef> right;
        for (int i = 0; i < 10; ++i) {
            BodyDef wrong = random_body<TypeParam>(random), def = random_body<TypeParam>(random);
            put<TypeParam>(wrong, random, i);
            put<TypeParam>(def, random, i);
            ASSERT_TRUE(add(edited, wrong).ok() && add(built, def).ok());
            right.push_back(def);
        }
        for (int i = 0; i < 10; ++i) {
            const BodyId id = edited.body_at(i + 1);
            edit(edited, id, right[static_cast<std::size_t>(i)]);
            ASSERT_EQ(edited.set_state(id, right[static_cast<std::size_t>(i)].state), Status::ok);
        }
        ASSERT_EQ(saved(edited), saved(built)) << "seed " << seed;
        for (int step_i = 0; step_i < 150; ++step_i) {
            (void)step(edited, h);
            (void)step(built, h);
            ASSERT_EQ(edited.state_hash(), built.state_hash()) << "seed " << seed << " step " << step_i;
        }
        ASSERT_EQ(saved(edited), saved(built));
    }
}

TYPED_TEST(Edits, in_the_middle_of_it_all_are_saved) {
    for (int seed = 0; seed < 6; ++seed) {
        RandomInput random(static_cast<std::uint64_t>(700 + seed));
        World<TypeParam>&world = empty_world<TypeParam>(0), &restored = empty_world<TypeParam>(1);
        ASSERT_TRUE(add(world, ground()).ok());
        for (int i = 0; i < 10; ++i) {
            BodyDef def = random_body<TypeParam>(random);
            put<TypeParam>(def, random, i);
            ASSERT_TRUE(add(world, def).ok());
        }
        for (int round = 0; round < 6; ++round) {
            for (int step_i = 0; step_i < 50; ++step_i) ASSERT_EQ(step(world, h).status, Status::ok);
            for (int i = 0; i < 3; ++i) {
                const BodyId id = world.body_at(random.integer(1, 10));
                BodyDef to = random_body<TypeParam>(random);
                to.immovable = false;  // one that is let go from the place where it is
                if (!world.is_frozen(id)) edit(world, id, to);
            }
            const std::vector<uint8_t> bytes = saved(world);
            ASSERT_EQ(load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
            ASSERT_EQ(restored.state_hash(), world.state_hash());
            World<TypeParam>& ahead = restored;
            static World<TypeParam> here;
            std::memcpy(static_cast<void*>(&here), &world, sizeof world);
            for (int step_i = 0; step_i < 40; ++step_i) {
                (void)step(here, h);
                (void)step(ahead, h);
                ASSERT_EQ(here.state_hash(), ahead.state_hash()) << "seed " << seed << " round " << round << " step " << step_i;
            }
        }
    }
}

TYPED_TEST(Edits, of_mass_keep_the_motion) {
    RandomInput random(9);
    for (int i = 0; i < 200; ++i) {
        World<TypeParam>& world = empty_world<TypeParam>();
        BodyDef def = random_body<TypeParam>(random);
        def.immovable = false;
        put<TypeParam>(def, random, 3);
        const BodyId id = add(world, def).value;
        const Vector omega = world.omega(id).value;
        const BodyState before = world.state(id).value;
        const MassProperties mass = principal(solid_box(3, {scalar(0.25), scalar(0.5), 1})).value;
        ASSERT_EQ(world.set_mass(id, mass), Status::ok);
        const BodyState after = world.state(id).value;
        EXPECT_EQ(to_eigen(after.v_CM), to_eigen(before.v_CM));
        EXPECT_EQ(to_eigen(after.r_CM), to_eigen(before.r_CM));
        EXPECT_EQ(to_eigen(after.A), to_eigen(before.A));
        // L to omega and back, with two turns and two divisions each, and twice, for omega() does it too: relative to the largest component over the
        // spread of the moments, 1.25 / 0.3125 of the box and less of the others.
        EXPECT_LE((to_eigen(world.omega(id).value) - to_eigen(omega)).norm(), 4 * 20 * static_cast<double>(epsilon) * to_eigen(omega).norm() * 2);
        EXPECT_NEAR(static_cast<double>(world.mass(id).value / mass.M), 1, 2 * static_cast<double>(epsilon));
        const double I = to_eigen(mass.I_body).norm();
        EXPECT_LE((to_eigen(world.inertia(id).value) - to_eigen(mass.I_body)).norm(), 4 * static_cast<double>(epsilon) * I);
    }
}

/// Every edit of a body, with good values.
template <class S>
std::vector<std::function<Status(World<S>&, BodyId)>> all_edits() {
    const MassProperties mass = principal(solid_sphere(3, scalar(0.5))).value;
    std::vector<std::function<Status(World<S>&, BodyId)>> edits = {
        [=](World<S>& world, BodyId id) { return world.set_mass(id, mass); },
        [=](World<S>& world, BodyId id) { return world.set_movable(id, mass); },
        [](World<S>& world, BodyId id) { return world.set_friction(id, scalar(0.25)); },
        [](World<S>& world, BodyId id) { return world.set_restitution(id, scalar(0.25)); },
        [](World<S>& world, BodyId id) { return world.set_shape(id, Sphere{scalar(0.5)}); },
        [](World<S>& world, BodyId id) { return world.set_immovable(id); },
    };
    if constexpr (S::max_overlaps > 0) edits.push_back([](World<S>& world, BodyId id) { return world.set_sensor(id, false); });
    if constexpr (S::max_shapes_of_body > 1)
        edits.push_back([](World<S>& world, BodyId id) { return world.set_shape_place(id, {{0, 0, 0}, identity_matrix<scalar>()}, 1); });
    return edits;
}

TYPED_TEST(Edits, wake_a_body_and_those_it_touches) {
    if constexpr (TypeParam::sleeps)
        for (const auto& edit_of : all_edits<TypeParam>()) {
            World<TypeParam>& world = empty_world<TypeParam>();
            ASSERT_TRUE(add(world, ground()).ok());
            BodyDef def;
            def.mass = principal(solid_sphere(2, scalar(0.5))).value;
            def.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
            def.state.r_CM = {0, 0, scalar(0.5)};
            const BodyId lower = add(world, def).value;
            def.state.r_CM = {0, 0, scalar(1.5)};
            const BodyId upper = add(world, def).value;
            def.state.r_CM = {20, 0, scalar(0.5)};
            const BodyId far = add(world, def).value;
            for (int step_i = 0; step_i < 300 && world.asleep_count() < 3; ++step_i) (void)step(world, h);
            ASSERT_EQ(world.asleep_count(), 3);
            ASSERT_EQ(edit_of(world, lower), Status::ok);
            EXPECT_FALSE(world.is_asleep(lower));
            EXPECT_FALSE(world.is_asleep(upper));
            EXPECT_TRUE(world.is_asleep(far));
            for (int step_i = 0; step_i < 300; ++step_i) ASSERT_TRUE(step(world, h).clean());
        }
}

TYPED_TEST(Edits, are_refused_where_they_cannot_be) {
    using S = TypeParam;
    World<S>& world = empty_world<S>();
    static World<S> before;
    const BodyId floor = add(world, ground()).value;
    RandomInput random(5);
    BodyDef def = random_body<S>(random);
    def.immovable = def.sensor = false;
    put<S>(def, random, 1);
    const BodyId id = add(world, def).value, gone = add(world, def).value, foreign = {1, 9, 1};
    ASSERT_EQ(world.remove(gone), Status::ok);
    for (int step_i = 0; step_i < 60; ++step_i) (void)step(world, h);
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);

    const scalar nan = scalar(__builtin_nan("")), inf = scalar(__builtin_inf());
    MassProperties massless = def.mass, flat = def.mass, none = def.mass;
    massless.M = 0;
    flat.I_body = {1, 1, 5};
    none.I_body.x = nan;
    const auto expect = [&](Status status, Status expected) {
        EXPECT_EQ(status, expected) << name(status);
        EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);
    };
    for (const BodyId of : {id, floor}) {
        const bool moves = of == id;
        expect(world.set_mass(of, massless), moves ? Status::bad_mass : Status::immovable);
        expect(world.set_movable(of, flat), Status::bad_inertia);
        expect(world.set_movable(of, none), Status::not_finite);
        expect(world.set_friction(of, -1), Status::bad_friction);
        expect(world.set_friction(of, nan), Status::not_finite);
        expect(world.set_restitution(of, scalar(1.5)), Status::bad_restitution);
        expect(world.set_restitution(of, inf), Status::not_finite);
        expect(world.set_shape(of, Sphere{0}), Status::bad_shape);
        expect(world.set_shape(of, Sphere{nan}), Status::not_finite);
        expect(world.set_shape(of, Cylinder{1, 1}), Status::not_in_scene);
        expect(world.set_shape(of, Sphere{1}, -1), Status::out_of_range);
        expect(world.set_shape(of, Sphere{1}, S::max_shapes_of_body), Status::out_of_range);
        expect(world.set_friction(of, 1, 7), Status::out_of_range);
    }
    expect(world.set_movable(floor, def.mass), Status::bad_shape);
    expect(world.set_mass(floor, def.mass), Status::immovable);
    expect(world.set_immovable(floor), Status::ok);
    expect(world.set_shape(id, HalfSpace{{0, 0, 1}, 0}), Status::bad_shape);
    for (const BodyId of : {gone, foreign, BodyId{}}) {
        const Status expected = of == foreign ? Status::foreign_id : Status::stale_id;
        expect(world.set_mass(of, def.mass), expected);
        expect(world.set_movable(of, def.mass), expected);
        expect(world.set_immovable(of), expected);
        expect(world.set_friction(of, 1), expected);
        expect(world.set_restitution(of, 1), expected);
        expect(world.set_shape(of, Sphere{1}), expected);
        expect(world.inertia(of).status, expected);
        expect(world.shape(of).status, expected);
        expect(world.friction(of).status, expected);
        expect(world.restitution(of).status, expected);
        EXPECT_FALSE(world.is_movable(of));
        if constexpr (S::max_overlaps > 0) expect(world.set_sensor(of, true), expected);
        if constexpr (S::max_overlaps > 0) expect(world.is_sensor(of).status, expected);
    }
    if constexpr (S::max_shapes_of_body > 1) {
        const Matrix upright = identity_matrix<scalar>();
        expect(world.set_shape(id, Shape{}, 1), Status::bad_shape);
        expect(world.set_shape_place(id, {{nan, 0, 0}, upright}, 1), Status::not_finite);
        expect(world.set_shape_place(id, {{0, 2 * limits::position_max, 0}, upright}, 1), Status::out_of_range);
        expect(world.set_shape_place(id, {{}, upright * scalar(2)}, 1), Status::not_a_rotation);
        expect(world.set_shape_place(floor, {{}, upright}, 1), Status::out_of_range);
        expect(world.shape_place(gone, 0).status, Status::stale_id);
    }
}

TYPED_TEST(Edits, are_what_the_world_tells) {
    using S = TypeParam;
    World<S>& world = empty_world<S>();
    RandomInput random(6);
    BodyDef def = random_body<S>(random), to = random_body<S>(random);
    def.immovable = to.immovable = false;
    const BodyId id = add(world, def).value;
    edit(world, id, to);
    EXPECT_EQ(world.friction(id).value, to.friction);
    EXPECT_EQ(world.restitution(id).value, to.restitution);
    EXPECT_EQ(world.shape(id).value.kind, to.shape.kind);
    EXPECT_EQ(to_eigen(world.shape(id).value.size), to_eigen(to.shape.size));
    EXPECT_TRUE(world.is_movable(id));
    ASSERT_EQ(world.set_immovable(id), Status::ok);
    EXPECT_FALSE(world.is_movable(id));
    EXPECT_EQ(world.inertia(id).value.x, 0);
    if constexpr (S::max_overlaps > 0) {
        EXPECT_EQ(world.is_sensor(id).value, to.sensor);
        ASSERT_EQ(world.set_sensor(id, !to.sensor), Status::ok);
        EXPECT_EQ(world.is_sensor(id).value, !to.sensor);
    }
    if constexpr (S::max_shapes_of_body > 1) {
        const ShapePlace place = {{1, 2, 3}, axis_angle({0, 0, 1}, scalar(0.5))};
        ASSERT_EQ(world.set_shape_place(id, place, 1), Status::ok);
        EXPECT_EQ(to_eigen(world.shape_place(id, 1).value.r), to_eigen(place.r));
    }
}

TYPED_TEST(Edits, of_shape_and_kind_forget_contacts_and_those_of_material_keep_them) {
    using S = TypeParam;
    for (std::size_t edit_i = 0; edit_i < all_edits<S>().size(); ++edit_i) {
        World<S>& world = empty_world<S>();
        ASSERT_TRUE(add(world, ground()).ok());
        BodyDef def;
        def.mass = principal(solid_sphere(2, scalar(0.5))).value;
        def.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
        def.state.r_CM = {0, 0, scalar(0.5)};
        const BodyId id = add(world, def).value;
        for (int step_i = 0; step_i < 10; ++step_i) (void)step(world, h);
        const int before = world.contact_count();
        ASSERT_GT(before, 0);
        ASSERT_EQ(all_edits<S>()[edit_i](world, id), Status::ok);
        const bool keeps = edit_i < 4;  // mass, friction, restitution
        EXPECT_EQ(world.contact_count(), keeps ? before : 0) << edit_i;
        for (int step_i = 0; step_i < 10; ++step_i) (void)step(world, h);
        // A ball has less height to stand on than a cube of its radius, and falls by less than a margin; what is immovable touches no ground.
        EXPECT_EQ(world.contact_count() > 0, edit_i != 5) << edit_i;
    }
}

TEST(EditedCompound, has_its_shapes_where_they_were_put) {
    RandomInput random(21);
    for (int i = 0; i < 50; ++i) {
        World<Many>&edited = empty_world<Many>(0), &built = empty_world<Many>(1);
        const ShapeDef wrong[2] = {{Box{{scalar(0.5), scalar(0.25), scalar(0.25)}}}, {Sphere{scalar(0.25)}, {1, 0, 0}}};
        ShapeDef right[2] = {wrong[0], wrong[1]};
        for (ShapeDef& part : right) part.r = to_vector(random.vector(1)), part.A = to_matrix(random.rotation());
        BodyDef def;
        def.mass = principal(solid_of_shapes(1, wrong)).value;
        def.state = body_state(def.mass, {{0, 0, 3}, to_matrix(random.rotation())});
        ASSERT_TRUE(edited.add(ground()).ok() && built.add(ground()).ok());
        const BodyId id = edited.add(def, wrong).value;
        ASSERT_TRUE(built.add(def, right).ok());
        for (int part_i = 0; part_i < 2; ++part_i)
            ASSERT_EQ(edited.set_shape_place(id, place_in_body(right[part_i], def.mass), part_i), Status::ok);
        ASSERT_EQ(saved(edited), saved(built));
        for (int step_i = 0; step_i < 90; ++step_i) {
            (void)step(edited, h);
            (void)step(built, h);
            ASSERT_EQ(edited.state_hash(), built.state_hash());
        }
    }
}

/// Zero has no sign: who says -0 where he could say 0, of gravity, a place or a velocity, has the same world to the bit, and so it goes on.
TEST(EditsOfZero, have_no_sign) {
    for (int which = 0; which < 32; ++which) {
        const auto zero = [which](int bit) { return (which >> bit & 1) != 0 ? -scalar(0) : scalar(0); };
        World<Many>& with = empty_world<Many>(0);
        World<Many>& without = empty_world<Many>(1);
        for (World<Many>* world : {&with, &without}) {
            const auto of = [&](int bit) { return world == &with ? zero(bit) : scalar(0); };
            ASSERT_EQ(world->set_gravity({of(0), of(1), -g}), Status::ok);
            BodyDef def;
            def.mass = principal(solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
            def.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
            def.state.r_CM = {of(2), of(3), 3};
            const BodyId id = world->add(def).value;
            BodyState state = world->state(id).value;
            state.v_CM = {of(4), 1, of(0)};
            state.r_CM = {of(1), 2, of(2)};
            state.L = {of(3), of(4), of(0)};
            ASSERT_EQ(world->set_state(id, state), Status::ok);
        }
        for (int step_i = 0; step_i < 5; ++step_i) {
            ASSERT_EQ(with.state_hash(), without.state_hash()) << which << ", step " << step_i;
            ASSERT_EQ(saved(with), saved(without)) << which << ", step " << step_i;
            (void)step(with, scalar(1) / 64);
            (void)step(without, scalar(1) / 64);
        }
    }
}

/// What a crate on the ground does after an edit.
TEST(EditedCrate, slides_falls_stands_and_bounces_as_it_was_told) {
    using S = Yard<BlockSweeps, true>;
    World<S>& world = empty_world<S>();
    (void)world.add(ground());
    BodyDef def;
    def.mass = principal(solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
    def.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    def.state.r_CM = {0, 0, scalar(0.5)};
    const BodyId crate = world.add(def).value;
    const auto height = [&] { return static_cast<double>(world.state(crate).value.r_CM.z); };
    const auto run = [&](int steps) {
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(step(world, h).clean());
    };
    run(100);
    ASSERT_TRUE(world.is_asleep(crate));

    ASSERT_EQ(world.set_mass(crate, principal(solid_box(5, {scalar(0.5), scalar(0.5), scalar(0.5)})).value), Status::ok);
    run(100);
    double pressed = 0;
    for (const ContactInfo& contact : world.contacts_of(crate)) pressed += static_cast<double>(contact.j);
    EXPECT_NEAR(pressed / (5 * static_cast<double>(g * h)), 1, 1e-5) << "it presses with its new weight";

    ASSERT_EQ(world.set_shape(crate, Box{{scalar(0.5), scalar(0.5), scalar(0.625)}}), Status::ok);
    run(100);
    EXPECT_NEAR(height(), 0.625, 1e-4) << "it is pushed out of the ground that it has grown into";
    ASSERT_EQ(world.set_shape(crate, Box{{scalar(0.5), scalar(0.5), scalar(0.25)}}), Status::ok);
    run(100);
    EXPECT_NEAR(height(), 0.25, 1e-4) << "it fell onto its new underside";
    ASSERT_EQ(world.set_immovable(crate), Status::ok);
    ASSERT_EQ(world.set_shape(world.body_at(0), HalfSpace{{0, 0, 1}, -5}), Status::ok);
    run(60);
    EXPECT_NEAR(height(), 0.25, 1e-4) << "nothing moves it";
    ASSERT_EQ(world.set_movable(crate, def.mass), Status::ok);
    ASSERT_EQ(world.set_restitution(crate, 1), Status::ok);
    run(30);
    // r_CM of a body that falls freely is exact to rounding: it falls for 30 steps.
    EXPECT_NEAR(height(), 0.25 - 0.5 * static_cast<double>(g) * 0.25, 1e-4);
    run(120);
    EXPECT_GT(height(), -4.7) << "it bounces";
    ASSERT_EQ(world.set_sensor(crate, true), Status::ok);
    run(120);
    EXPECT_LT(height(), -10) << "and falls through";
    EXPECT_GT(world.overlap_count(), 0) << "as is told";
}

TEST(EditedCrate, of_less_friction_slides) {
    using S = Yard<HybridIslands<10>, true>;
    World<S>& world = empty_world<S>();
    BodyDef ramp = ground();
    const scalar slope = scalar(0.35);  // rad; tan = 0.365
    ramp.shape = HalfSpace{{sin_cos(slope).sin, 0, sin_cos(slope).cos}, 0};
    ramp.friction = scalar(0.5);
    (void)world.add(ramp);
    BodyDef def;
    def.mass = principal(solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.25)})).value;
    def.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.25)}};
    def.friction = scalar(0.5);
    def.state.A = axis_angle({0, 1, 0}, slope);
    def.state.r_CM = def.state.A * Vector{0, 0, scalar(0.25)};
    const BodyId crate = world.add(def).value;
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(step(world, h).clean());
    ASSERT_TRUE(world.is_asleep(crate));
    const Vector at_rest = world.state(crate).value.r_CM;
    ASSERT_EQ(world.set_friction(crate, scalar(0.125)), Status::ok);
    for (int step_i = 0; step_i < 60; ++step_i) ASSERT_TRUE(step(world, h).clean());
    // The pair's is the geometric mean, 0.25: a = g (sin - 0.25 cos), for a second.
    const double a = static_cast<double>(g) * (std::sin(0.35) - 0.25 * std::cos(0.35));
    const double way = (to_eigen(world.state(crate).value.r_CM) - to_eigen(at_rest)).norm();
    EXPECT_NEAR(way / (a / 2), 1, 1e-3) << "the constraint holds to settled_gap, and the solver's residual adds up to 1e-4 m/s";
}

}  // namespace
