// SPDX-License-Identifier: MIT
// Kinematic bodies in the hands of a stranger: tiny, huge, sudden, long, and called at random.
#include "kinematic.h"

#include <random>

namespace {

using namespace kinematic;

template <class Solver, bool is_continuous, bool sleepy, class Search>
struct Everything : Yard<Solver, sleepy, is_continuous, Search> {
    static constexpr int max_bodies = 24, max_manifolds = 120, max_pairs = 2000, max_shapes_of_body = 2, max_events = 200, max_overlaps = 30;
    static constexpr bool damping = true, gravity_shares = true, body_forces = true, rolling_resistance = true, surface_velocities = true;
};
template <class S>
struct Random : testing::Test {};
using RandomScenes = BriefTypes<3, Everything<BlockSweeps, true, true, AllPairs>, Everything<HybridIslands<20, 10>, true, true, SortedTree>,
                                Everything<SequentialImpulses, true, false, AllPairs>, Everything<BlockSweeps, false, false, AllPairs>>;
TYPED_TEST_SUITE(Random, RandomScenes);

/// Draws calls, with what is right for them.
struct Draw {
    std::mt19937 engine;

    scalar real(double low, double high) { return of(low + (high - low) * (static_cast<double>(engine()) / 4294967296.0)); }
    int integer(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
    Vector vector(double most) { return {real(-most, most), real(-most, most), real(-most, most)}; }
    Matrix rotation() {
        Vector n = vector(1);
        if (length_sq(n) < scalar(0.01)) n = {0, 0, 1};
        return axis_angle(n * of(1 / length(n)), real(-3, 3));
    }
    BodyDef body() {
        const scalar a = real(0.05, 0.5);
        BodyDef def;
        def.mass = principal(solid_box(500, {a, a, a})).value;
        def.shape = integer(2) == 0 ? Shape(Sphere{a}) : integer(2) == 0 ? Shape(Capsule{a, a}) : Shape(Box{{a, real(0.05, 0.5), a}});
        def.kinematic = integer(3) == 0;
        def.immovable = !def.kinematic && integer(6) == 0;
        def.sensor = integer(8) == 0;
        def.restitution = integer(2) == 0 ? real(0, 1) : 0;
        def.state.r_CM = vector(2);
        def.state.A = rotation();
        if (!def.immovable) def.state.v_CM = vector(3);
        if (def.kinematic) def.state.L = vector(5);
        return def;
    }
};
/// One call, of a body of the world or of none. False where what is right was refused.
template <class S>
bool call(World<S>& world, Draw& draw, std::vector<BodyId>& ids) {
    const size_t which = ids.empty() ? 0 : static_cast<size_t>(draw.integer(static_cast<int>(ids.size())));
    const BodyId id = ids.empty() ? BodyId{} : ids[which];
    switch (draw.integer(13)) {
        case 0:
        case 1: {
            const Result<BodyId> added = world.add(draw.body());
            if (added.ok()) ids.push_back(added.value);
            return added.ok() || added.status == Status::no_room;
        }
        case 2:
            if (ids.empty()) return true;
            ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(which));
            return world.remove(id) == Status::ok;
        case 3: return world.set_velocity(id, draw.vector(5), draw.vector(5)) == Status::ok || !world.is_kinematic(id);
        case 4: return world.move_to(id, draw.vector(2), draw.rotation()) == Status::ok || !world.is_kinematic(id);
        case 5: return world.set_kinematic(id) == Status::ok || ids.empty();
        case 6: return world.set_immovable(id) == Status::ok || ids.empty();
        case 7: return world.set_movable(id, principal(solid_sphere(500, scalar(0.2))).value) == Status::ok || ids.empty();
        case 8: return world.set_damping(id, {draw.real(0, 3), draw.real(0, 3)}) == Status::ok || ids.empty();
        case 9: return world.set_surface_velocity(id, draw.vector(2)) == Status::ok || ids.empty();
        case 10: return world.set_state(id, {draw.vector(2), {}, draw.rotation(), {}}) == Status::ok || ids.empty();
        case 11: return world.add_central_force(id, draw.vector(50)) == Status::ok || !world.is_movable(id);
        default: return world.set_gravity_share(id, draw.real(-1, 1)) == Status::ok || ids.empty();
    }
}
TYPED_TEST(Random, calls_leave_a_world_that_can_be_saved_and_goes_on) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        World<TypeParam>&world = empty_world<TypeParam>(0), &loaded = empty_world<TypeParam>(1);
        Draw draw{std::mt19937(seed)};
        std::vector<BodyId> ids;
        std::vector<uint8_t> bytes(snapshot_size<TypeParam>());
        for (int i = 0; i < 200; ++i) {
            ASSERT_TRUE(call(world, draw, ids)) << seed << ", " << i;
            const Result<size_t> size = save_snapshot(world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            ASSERT_EQ(load_snapshot(loaded, bytes.data(), size.value), Status::ok) << seed << ", " << i;
            (void)step(world, scalar(1) / 60);
            (void)step(loaded, scalar(1) / 60);
            ASSERT_EQ(loaded.state_hash(), world.state_hash()) << seed << ", " << i;
            for (const BodyId id : ids) {
                const BodyState now = state(world, id);
                const bool sound = is_finite(now.r_CM) && is_finite(now.v_CM) && is_finite(now.A) && is_finite(now.L);
                ASSERT_TRUE(sound && !world.is_frozen(id)) << seed << ", " << i;
            }
        }
    }
}

struct Millimetres : Swept {
    static constexpr scalar length_unit = scalar(0.001);
};
/// 0.1 mm for cubes of 0.1 m is a thousandth of their half extent, and so it is for those of a millimetre and of a hundred metres.
template <class S>
void carry(scalar half, int rate) {
    World<S>& world = empty_world<S>();
    const BodyId under = add(world, platform({10 * half, 10 * half, half}, {}, {{0, 0, scalar(0.5)}, {0, 0, 1}}));
    BodyId ids[3];
    const auto place = [&](int i) { return Vector{0, 0, half * of(2 + 2 * i)}; };
    for (int i = 0; i < 3; ++i) ids[i] = add(world, cube(half, {place(i), identity_matrix<scalar>()}, {{0, 0, scalar(0.5)}, {0, 0, 1}}));
    for (int i = 0; i < 5 * rate; ++i) (void)step(world, scalar(1) / of(rate));
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(length(state(world, ids[i]).r_CM - state(world, under).r_CM - place(i)), 1e-3 * static_cast<double>(half)) << rate;
}
TEST(KinematicSizes, the_tiny_and_the_huge_are_carried_alike) {
    for (const int rate : {60, 240}) {
        carry<Swept>(scalar(0.001), rate);
        carry<Millimetres>(scalar(0.001), rate);
        carry<Swept>(scalar(0.02), rate);
        carry<Swept>(100, rate);
    }
}

template <class S>
struct Sudden : testing::Test {};
using SuddenScenes = BriefTypes<3, Swept, HybridFast, LightFast, Hybrid, Light>;
TYPED_TEST_SUITE(Sudden, SuddenScenes);

/// A lift that starts at once throws what stands on it, and loses nobody. A hit without restitution gives less than one with all of it: 2 v.
TYPED_TEST(Sudden, a_lift_that_starts_at_once_loses_nobody) {
    for (const int rate : {30, 60, 240}) {
        for (const scalar v : {scalar(1.6), scalar(20), scalar(300)}) {
            World<TypeParam>& world = empty_world<TypeParam>();
            const BodyId lift = add(world, platform({5, 5, scalar(0.1)}));
            std::vector<BodyId> ids;
            for (int i = 0; i < 5; ++i) ids.push_back(add(world, cube(scalar(0.1), {{0, 0, of(0.2 + 0.2 * i)}, identity_matrix<scalar>()})));
            for (int i = 0; i < rate; ++i) (void)step(world, scalar(1) / of(rate));
            ASSERT_EQ(world.set_velocity(lift, {0, 0, v}), Status::ok);
            for (int i = 0; 2 * i < rate; ++i) {
                (void)step(world, scalar(1) / of(rate));
                for (const BodyId id : ids) {
                    EXPECT_LT(length(state(world, id).v_CM), 2 * static_cast<double>(v)) << rate << " Hz, " << v;
                    EXPECT_GT(state(world, id).r_CM.z, state(world, lift).r_CM.z) << rate << " Hz, " << v;
                }
            }
        }
    }
}

/// A platform of a metre in a second, for an hour, far from the origin: rounding does not add up, see a_body_goes_exactly_on_its_way.
TEST(KinematicLong, an_hour_on_the_way_is_exact) {
    World<Swept>& world = empty_world<Swept>();
    const BodyId id = add(world, platform({1, 1, 1}, {{0, 1000, 0}, identity_matrix<scalar>()}, {{0, scalar(0.001), 0}, {0, 0, scalar(0.001)}}));
    for (int i = 0; i < 3600 * 60; ++i) (void)step(world, scalar(1) / 60);
    const double eps = static_cast<double>(epsilon);
    EXPECT_NEAR(state(world, id).r_CM.y, 1003.6, 4 * eps * 1003.6);
    EXPECT_NEAR(state(world, id).A.c0.x, std::cos(3.6), 8 * eps * 3.6 + 16 * eps);
}

}  // namespace
