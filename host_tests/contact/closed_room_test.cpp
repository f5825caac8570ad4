// SPDX-License-Identifier: MIT
// Fast bodies of every shape, in worlds of every solver, that sleep or do not: nobody leaves a closed room, what sleeps is woken and not passed, and
// an impact within a step is what the laws of contact make of it.
#include <gtest/gtest.h>

#include <cstring>

#include "contact/play.h"
#include "reference/brief_types.h"
#include "reference/random_input.h"
#include "scenes/compounds.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot::BodyDef;
using ingot::Matrix;
using ingot_reference::BriefTypes;
using ingot_reference::RandomInput;

constexpr double eps = static_cast<double>(ingot::epsilon);

/// What worlds of fast bodies differ in.
template <class Solver, bool asleep, class BroadPhase = ingot::AllPairs>
struct Fast : Compounded<24, 200> {
    static constexpr bool continuous = true, sleeps = asleep;
    static constexpr scalar sleep_time = scalar(0.125);
    using solver = Solver;
    using broad_phase = BroadPhase;
};
using Engines = BriefTypes<4, Fast<ingot::BlockSweeps, false>, Fast<ingot::BlockSweeps, true, ingot::SortedTree>,
                           Fast<ingot::HybridIslands<8, 10>, true>, Fast<ingot::SequentialImpulses, true>,
                           Fast<ingot::HybridIslands<8, 10>, false, ingot::SortedTree>, Fast<ingot::SequentialImpulses, false>>;

enum Kind { ball, box, capsule, cylinder, hull, compound, kinds };

template <class S>
BodyId add(ingot::World<S>& world, const PlacedBody& body) {
    BodyDef def = body.def;
    def.friction = body.mu;
    const ingot::Result<BodyId> id = world.add(def);
    EXPECT_EQ(id.status, Status::ok);
    return id.value;
}

/// How a body is thrown.
struct Throw {
    Vector r, v, spin;
    Matrix A;
    scalar size, e, mu;  ///< m; of the largest half extent
};

/// A body of a kind; two of its three sizes are a quarter to all of the first. Returns it, and its mass through M.
template <class S>
BodyId throw_body(ingot::World<S>& world, Kind kind, const Throw& how, RandomInput& random, double& M) {
    const auto part_of = [&] { return how.size * static_cast<scalar>(random.real(0.25, 1)); };
    PlacedBody body = solid_ball(1, how.size, how.r, how.mu, how.e);
    if (kind == box) body = solid_box(1, {how.size, part_of(), part_of()}, how.r, how.mu, how.e);
    if (kind == hull) {
        const auto form = static_cast<HullForm>(random.integer(0, 3));
        body.def.mass = hull_body<S>(form, {}, 0).def.mass;
        body.def.shape = ingot::hull_of<S>(form);
    }
    const scalar thin = part_of();
    if (kind == capsule) {
        body.def.shape = ingot::Capsule{thin, how.size};
        body.def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, thin, how.size), 1)).value;
    }
    if (kind == cylinder) {
        body.def.shape = ingot::Cylinder{how.size, thin};
        body.def.mass = ingot::principal(ingot::with_mass(ingot::solid_cylinder(1, how.size, thin), 1)).value;
    }
    Parts<3> arms = jack(how.mu);
    for (ingot::ShapeDef& arm : arms.parts) {
        arm.shape.size = arm.shape.size * how.size;
        arm.restitution = how.e;
    }
    if (kind == compound) body.def.mass = arms.mass(1);
    body.turn(how.A);
    body.move(how.v, how.spin);
    M = static_cast<double>(body.def.mass.M);
    if (kind != compound) return add(world, body);
    body.def.shape = {};
    body.def.restitution = 0;
    const ingot::Result<BodyId> id = world.add(body.def, arms.parts);
    EXPECT_EQ(id.status, Status::ok);
    return id.value;
}

/// Six plates of 5 mm around a cube of 2 half_room.
template <class S>
void build_room(ingot::World<S>& world, scalar half_room, scalar mu, scalar e) {
    const scalar thin = scalar(0.0025), wide = half_room + 2 * thin;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            const scalar at = static_cast<scalar>(side) * (half_room + thin);
            (void)add(world, fixed_box({axis == 0 ? thin : wide, axis == 1 ? thin : wide, axis == 2 ? thin : wide},
                                       {axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0}, mu, e));
        }
    }
}

template <class S>
bool same_bits(const ingot::World<S>& a, const ingot::World<S>& b, BodyId id) {
    const BodyState A = a.state(id).value, B = b.state(id).value;
    return std::memcmp(&A, &B, sizeof A) == 0;
}

/// s
scalar random_step(RandomInput& random) {
    const int rates[] = {30, 60, 240, 1000};
    return 1 / static_cast<scalar>(rates[random.integer(0, 3)]);
}

template <class S>
class EveryEngine : public ::testing::Test {};
TYPED_TEST_SUITE(EveryEngine, Engines);

/// A shot of 1 to 800 m/s in a closed room, for thirty steps of any length.
///
/// It does not leave. Without friction it never has more energy than at the start: each part of a path and each impact rounds v_CM, L and A, by less
/// than four epsilon of the energy together, and a step has no more of them than path_parts_max and impacts_of_body_max; what restitution takes
/// is more than that in every other step. (With friction Newton's restitution itself may give energy to what is hit off its centre: Kane and
/// Levinson, "Dynamics", 1985.) A bystander outside goes on as if there were no shot, to the bit.
template <class S>
void expect_shot_stays(Kind kind, int shot, RandomInput& random) {
    static ingot::World<S> world, without;
    world = {};
    without = {};
    const scalar half_room = kind == hull ? 2 : scalar(0.5), e = static_cast<scalar>(random.real(0.2, 0.8));
    const scalar mu = shot % 2 == 0 ? 0 : static_cast<scalar>(random.real(0, 1)), h = random_step(random);
    BodyId bystander{}, thrown{};
    PlacedBody tumbler = solid_box(1, {1, scalar(0.5), scalar(0.25)}, {20, 0, 0}, mu);
    tumbler.move({scalar(0.5), 3, 5}, {scalar(0.25), 2, scalar(0.5)});
    for (ingot::World<S>* one : {&without, &world}) {
        ASSERT_EQ(one->set_gravity({0, 0, -standard_gravity}), Status::ok);
        build_room(*one, half_room, mu, e);
        bystander = add(*one, tumbler);
    }
    const Throw how = {ingot_reference::to_vector(random.vector(0.15)),
                       ingot_reference::to_vector(Vector3d(random.direction() * random.real(1, 800))),
                       ingot_reference::to_vector(Vector3d(random.direction() * random.real(0, 200))),
                       ingot_reference::to_matrix(random.rotation()),
                       static_cast<scalar>(random.real(0.02, 0.1)),
                       e,
                       mu};
    double M = 0;
    thrown = throw_body(world, kind, how, random, M);
    const auto energy = [&] {
        return static_cast<double>(world.kinetic_energy(thrown).value) +
               M * static_cast<double>(standard_gravity) * static_cast<double>(world.state(thrown).value.r_CM.z);
    };
    const double start = energy(), lowest = -M * static_cast<double>(standard_gravity * half_room);
    const double roundings = 4 * eps * (ingot::limits::path_parts_max + ingot::limits::impacts_of_body_max);
    for (int step_i = 0; step_i < 30; ++step_i) {
        (void)ingot::step(without, h);
        const StepReport report = ingot::step(world, h);
        ASSERT_EQ(report.bodies_frozen + report.contacts_lost, 0);
        const BodyState now = world.state(thrown).value;
        SCOPED_TRACE(::testing::Message() << "kind " << kind << ", shot " << shot << ", step " << step_i);
        ASSERT_LT(to_eigen(now.r_CM).cwiseAbs().maxCoeff(), static_cast<double>(half_room));
        if (mu == 0) {
            ASSERT_LE(energy() - lowest, (start - lowest) * (1 + roundings));
        }
        ASSERT_TRUE(same_bits(world, without, bystander));
    }
}
TYPED_TEST(EveryEngine, keeps_shots_in_a_room_of_thin_walls) {
    RandomInput random(20250);
    for (int shot = 0; shot < 12; ++shot)
        for (int kind = 0; kind < kinds; ++kind) expect_shot_stays<TypeParam>(static_cast<Kind>(kind), shot, random);
}

/// Two balls that meet on the line of their centres within a step: momentum stays, and they part at e times the speed at which they met. Each
/// velocity is rounded by the sweeps of four substeps: fewer than 64 times.
TYPED_TEST(EveryEngine, parts_balls_by_their_restitution) {
    RandomInput random(20251);
    for (int i = 0; i < 40; ++i) {
        static ingot::World<TypeParam> world;
        world = {};
        const double speed = random.real(20, 800), M[2] = {random.real(0.5, 2), random.real(0.5, 2)}, e = random.real(0, 1);
        const Vector3d along = random.direction();
        BodyId ids[2];
        for (int which = 0; which < 2; ++which) {
            const double side = which == 0 ? -1 : 1;
            const Vector r = ingot_reference::to_vector(Vector3d(along * side * speed / 100));
            PlacedBody one = solid_ball(static_cast<scalar>(M[which]), scalar(0.05), r, 0, static_cast<scalar>(e));
            one.move(ingot_reference::to_vector(Vector3d(along * -side * speed)));
            ids[which] = add(world, one);
        }
        for (int step_i = 0; step_i < 3; ++step_i) (void)ingot::step(world, display_rate_h);
        const Vector3d v[2] = {to_eigen(world.state(ids[0]).value.v_CM), to_eigen(world.state(ids[1]).value.v_CM)};
        const double roundings = 64 * eps * 2 * speed;
        EXPECT_NEAR((M[0] * v[0] + M[1] * v[1]).dot(along), (M[0] - M[1]) * speed, 4 * roundings) << i;
        // They may be off the line of their centres by the rounding of where they are, 8 m: so much of an angle, of 0.1 m.
        EXPECT_NEAR((v[1] - v[0]).dot(along), 2 * e * speed, roundings + 2 * speed * std::pow(8 * eps / 0.1 * speed / 100, 2) * 16) << i;
    }
}

/// A table that falls flat on its four feet, and a dumbbell on both of its balls: all touch at once, so that it is thrown back as it came, without
/// turning. The least of its parts makes it fast, and all manifolds between the two bodies carry it. Each part leaves at the same speed, rounded as
/// that of balls is; what they differ by turns the body, over half of its width.
TYPED_TEST(EveryEngine, throws_back_what_falls_flat_on_several_shapes) {
    for (const double speed : {50.0, 300.0}) {
        for (const bool has_legs : {true, false}) {
            static ingot::World<TypeParam> world;
            world = {};
            (void)add(world, fixed_box({4, 4, scalar(0.005)}, {0, 0, scalar(-0.005)}, 0, scalar(0.5)));
            const double half_width = has_legs ? 0.4375 : 0.5;
            const Parts<5> legs = table(0);
            const Parts<2> balls = dumbbell(scalar(0.0625), 1, 0);
            BodyDef def;
            def.mass = has_legs ? legs.mass(1) : balls.mass(1);
            def.state = ingot::body_state(def.mass, {{0, 0, static_cast<scalar>(speed / 100)}, ingot::identity_matrix<scalar>()});
            def.state.v_CM = {0, 0, static_cast<scalar>(-speed)};
            const ingot::Result<BodyId> id = has_legs ? world.add(def, legs.parts) : world.add(def, balls.parts);
            ASSERT_EQ(id.status, Status::ok);
            for (int step_i = 0; step_i < 2; ++step_i) ASSERT_EQ(ingot::step(world, display_rate_h).contacts_lost, 0);
            const BodyState now = world.state(id.value).value;
            EXPECT_NEAR(static_cast<double>(now.v_CM.z), speed / 2, 64 * eps * speed) << speed << (has_legs ? " table" : " dumbbell");
            EXPECT_LE(to_eigen(world.omega(id.value).value).norm(), 64 * eps * speed / half_width) << speed << (has_legs ? " table" : " dumbbell");
        }
    }
}

/// A crowd in a room, of which some bodies lie on the floor, some fly at up to 300 m/s, and some fall: what is hit leaves the bounds that the step
/// began with, and is met by others there.
template <class S>
void build_crowd(ingot::World<S>& world, uint64_t seed) {
    RandomInput random(seed);
    world = {};
    ASSERT_EQ(world.set_gravity({0, 0, -standard_gravity}), Status::ok);
    build_room(world, 2, scalar(0.5), scalar(0.25));
    for (int i = 0; i < 17; ++i) {
        const bool lies = i % 3 == 0;
        const Vector r = {scalar(i % 4) - scalar(1.5), scalar(i / 4 % 4) - scalar(1.5), lies ? scalar(-1.75) : scalar(0.5) * scalar(i % 5 - 2)};
        const double speed = i % 3 == 1 ? random.real(50, 300) : 0;
        const Throw how = {r,
                           ingot_reference::to_vector(Vector3d(random.direction() * speed)),
                           ingot_reference::to_vector(Vector3d(random.direction() * speed / 10)),
                           ingot_reference::to_matrix(random.rotation()),
                           static_cast<scalar>(random.real(0.05, 0.25)),
                           scalar(0.25),
                           scalar(0.5)};
        double M = 0;
        const Kind kind = i % kinds == hull ? box : static_cast<Kind>(i % kinds);
        (void)throw_body(world, kind, how, random, M);
    }
}

/// Who is looked at for an impact depends on the search; what comes of it does not, to the bit.
template <class Solver, bool asleep>
void expect_searches_alike() {
    static ingot::World<Fast<Solver, asleep, ingot::AllPairs>> all;
    static ingot::World<Fast<Solver, asleep, ingot::SortedTree>> tree;
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        build_crowd(all, seed);
        build_crowd(tree, seed);
        RandomInput random(seed);
        const scalar h = random_step(random);
        for (int step_i = 0; step_i < 40; ++step_i) {
            const StepReport by_all = ingot::step(all, h), by_tree = ingot::step(tree, h);
            ASSERT_EQ(all.state_hash(), tree.state_hash()) << "seed " << seed << ", step " << step_i;
            ASSERT_EQ(by_all.impacts_deferred, by_tree.impacts_deferred);
        }
    }
}
TEST(Searches, follow_fast_bodies_alike) {
    expect_searches_alike<ingot::BlockSweeps, false>();
    expect_searches_alike<ingot::BlockSweeps, true>();
    expect_searches_alike<ingot::SequentialImpulses, true>();
}

/// A large ball at rest is pushed by a small one after 0.4 of the step, by less than its radius in what is left of it: it is not fast, but 0.3 m out
/// of the bounds that the step began with. A box that spins, and so is followed in parts, passes there later, 0.8 m off the middle.
template <class S>
bool meets_what_left_its_bounds(ingot::World<S>& world, double phase) {
    constexpr scalar speed = 40, radius = scalar(0.05);
    world = {};
    PlacedBody first = solid_ball(1, radius, {scalar(-0.55) - scalar(0.4) * speed / 60, 0, 0}, 0, 1);
    PlacedBody across = solid_box(1, {radius, radius, radius}, {scalar(0.8), static_cast<scalar>(-4 * phase), 0}, 0, 1);
    first.move({speed, 0, 0});
    across.move({0, 240, 0}, {10, 60, 20});
    (void)add(world, first);
    (void)add(world, solid_ball(1, scalar(0.5), {}, 0, 1));
    const BodyId box_id = add(world, across);
    (void)ingot::step(world, display_rate_h);
    return world.state(box_id).value.v_CM.x != 0;
}
TEST(Searches, know_of_those_that_left_their_bounds) {
    static ingot::World<Fast<ingot::BlockSweeps, false, ingot::AllPairs>> all;
    static ingot::World<Fast<ingot::BlockSweeps, false, ingot::SortedTree>> tree;
    for (const double phase : {0.84, 0.86, 0.88, 0.9, 0.92}) {
        EXPECT_TRUE(meets_what_left_its_bounds(all, phase)) << phase;
        EXPECT_TRUE(meets_what_left_its_bounds(tree, phase)) << phase;
        EXPECT_EQ(all.state_hash(), tree.state_hash()) << phase;
    }
}

/// Surfaces that resist being rolled and that move by themselves, in worlds of both ways of solving.
template <class Solver>
struct Surfaced : Fast<Solver, false> {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
};
template <class S>
class EverySurface : public ::testing::Test {};
using Surfaces = ::testing::Types<Surfaced<ingot::BlockSweeps>, Surfaced<ingot::SequentialImpulses>>;
TYPED_TEST_SUITE(EverySurface, Surfaces);

/// A ball of 1 kg that flies against a wall in the middle of a step gets J = M (1 + e) v from it. A belt that is fast enough slips all the time and
/// drags it along by mu J; a resistance to rolling takes up to lever J of an angular momentum across the normal: all of it but that. All numbers
/// are rounded by four substeps, as in parts_balls_by_their_restitution.
TYPED_TEST(EverySurface, acts_within_a_step_as_in_any) {
    constexpr scalar radius = scalar(0.05), e = scalar(0.5), mu = scalar(1) / 64, lever = scalar(0.0001);
    for (const double speed : {50.0, 200.0, 400.0}) {  // and spins of up to 8 rad in a step
        for (const bool rolls : {false, true}) {
            static ingot::World<TypeParam> world;
            world = {};
            const BodyId wall = add(world, fixed_box({scalar(0.005), 4, 4}, {0, 0, 0}, rolls ? 0 : mu, e));
            PlacedBody flying = solid_ball(1, radius, {static_cast<scalar>(-speed / 100), 0, 0}, rolls ? 0 : mu, e);
            const double J = 1.5 * speed, I = static_cast<double>(flying.def.mass.I_body.x), spin = 2 * static_cast<double>(lever) * J / I;
            flying.move({static_cast<scalar>(speed), 0, 0}, rolls ? Vector{0, static_cast<scalar>(spin), 0} : Vector{});
            const BodyId id = add(world, flying);
            ASSERT_EQ(world.set_rolling_resistance(id, rolls ? lever : 0), Status::ok);
            // Slip ends at mu J (1 / M + R^2 / I) = 7/2 mu J / M.
            const double belt = 8 * static_cast<double>(mu) * J;
            ASSERT_EQ(world.set_surface_velocity(wall, {0, static_cast<scalar>(rolls ? 0 : belt), 0}), Status::ok);
            for (int step_i = 0; step_i < 2; ++step_i) ASSERT_TRUE(ingot::step(world, display_rate_h).clean());
            const Vector3d v = to_eigen(world.state(id).value.v_CM), L = to_eigen(world.state(id).value.L);
            const double roundings = 64 * eps;
            EXPECT_NEAR(v.x(), -speed / 2, roundings * speed);
            EXPECT_NEAR(v.y(), rolls ? 0 : static_cast<double>(mu) * J, roundings * belt);
            EXPECT_NEAR(L.y(), rolls ? I * spin / 2 : 0, roundings * I * spin);
            EXPECT_NEAR(std::abs(L.z()), rolls ? 0 : static_cast<double>(radius * mu) * J, roundings * static_cast<double>(radius) * belt);
        }
    }
}

using Sleepers = BriefTypes<3, Fast<ingot::BlockSweeps, true, ingot::SortedTree>, Fast<ingot::HybridIslands<8, 10>, true>,
                            Fast<ingot::SequentialImpulses, true>, Fast<ingot::BlockSweeps, true>>;
template <class S>
class EverySleeper : public ::testing::Test {};
TYPED_TEST_SUITE(EverySleeper, Sleepers);

/// Stacks of cubes sleep; a shot comes from afar at one of them. While they sleep it is never beyond the face it meets; in the step after the one
/// that it ends at that face all of the stack is awake; the other stacks sleep on, and keep their bits.
TYPED_TEST(EverySleeper, is_woken_by_what_it_is_shot_at_and_not_passed) {
    RandomInput random(20252);
    for (int shot = 0; shot < 24; ++shot) {
        static ingot::World<TypeParam> world;
        world = {};
        ASSERT_EQ(world.set_gravity({0, 0, -standard_gravity}), Status::ok);
        (void)add(world, flat_ground(scalar(0.5)));
        BodyId cubes[2][3];
        for (int stack_i = 0; stack_i < 2; ++stack_i)
            for (int i = 0; i < 3; ++i)
                cubes[stack_i][i] = add(world, unit_cube({0, scalar(20) * scalar(stack_i), scalar(i) + scalar(0.5)}, scalar(0.5)));
        for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(world, display_rate_h);
        for (const auto& stack : cubes)
            for (const BodyId cube : stack) ASSERT_TRUE(world.is_asleep(cube));
        const BodyState far_away = world.state(cubes[1][0]).value;
        const double speed = random.real(10, 800);
        const Throw how = {{static_cast<scalar>(-1 - random.real(1, 3) * speed / 60), scalar(0.125), scalar(1.5)},
                           {static_cast<scalar>(speed), 0, 0},
                           ingot_reference::to_vector(Vector3d(random.direction() * random.real(0, 100))),
                           ingot_reference::to_matrix(random.rotation()),
                           static_cast<scalar>(random.real(0.02, 0.1)),
                           scalar(0.25),
                           scalar(0.5)};
        double M = 0;
        const auto kind = static_cast<Kind>(shot % kinds);
        const BodyId thrown = throw_body(world, kind, how, random, M);
        bool arrived = false, woken = false;
        for (int step_i = 0; step_i < 8; ++step_i) {
            const bool was_there = arrived;
            (void)ingot::step(world, display_rate_h);
            const double x = static_cast<double>(world.state(thrown).value.r_CM.x);
            const bool all = !world.is_asleep(cubes[0][0]) && !world.is_asleep(cubes[0][1]) && !world.is_asleep(cubes[0][2]);
            ASSERT_TRUE(all || x < -0.5) << "kind " << kind << ", " << speed << " m/s, step " << step_i;
            ASSERT_TRUE(all || !was_there) << "kind " << kind << ", " << speed << " m/s, step " << step_i;
            woken = woken || all;
            // It has met the stack when its way along x was not that of a free flight.
            arrived = arrived || static_cast<double>(world.state(thrown).value.v_CM.x) < 0.99 * speed || x > -0.5 - 2 * static_cast<double>(how.size);
            if (woken) break;
        }
        EXPECT_TRUE(woken) << "kind " << kind << ", " << speed << " m/s";
        for (const BodyId cube : cubes[1]) EXPECT_TRUE(world.is_asleep(cube));
        const BodyState now = world.state(cubes[1][0]).value;
        EXPECT_EQ(std::memcmp(&now, &far_away, sizeof now), 0);
    }
}

}  // namespace
