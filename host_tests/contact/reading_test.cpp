// SPDX-License-Identifier: MIT
// Contacts as World tells them: what they give is what bodies get, step by step and body by body; of what rests it is the weight; they lie where the
// shapes are; who reads changes nothing.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using namespace ingot;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Vector3 = Eigen::Vector3d;

constexpr double u = static_cast<double>(epsilon) / 2;
constexpr scalar g = scalar(9.8125);

template <class Solver, bool reads, bool sleepy = false>
struct Yard : Scene {
    static constexpr int max_bodies = 16, max_manifolds = 100;
    static constexpr bool translates = true, reads_contacts = reads, sleeps = sleepy;
    using solver = Solver;
    using shapes = Shapes<Sphere, Capsule, Box, HalfSpace>;
};
template <bool reads>
struct Impacts : Scene {
    static constexpr int max_bodies = 16, max_contacts = 100;
    static constexpr bool translates = true, reads_contacts = reads;
    using solver = FrictionlessImpacts;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};

template <class S>
World<S>& empty_world() {
    static World<S> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    (void)world.set_gravity({0, 0, -g});
    return world;
}
BodyDef ground() {
    BodyDef def;
    def.shape = HalfSpace{{0, 0, 1}, 0};
    def.immovable = true;
    def.friction = scalar(0.5);
    return def;
}
BodyDef box(const Vector& half, const Vector& r_CM, scalar density = 1) {
    BodyDef def;
    def.mass = principal(solid_box(density, half)).value;
    def.shape = Box{half};
    def.state.r_CM = r_CM;
    return def;
}
BodyDef ball(scalar radius, const Vector& r_CM) {
    BodyDef def;
    def.mass = principal(solid_sphere(1, radius)).value;
    def.shape = Sphere{radius};
    def.state.r_CM = r_CM;
    return def;
}

/// Bodies thrown into a corner of two walls on the ground, some of which bounce.
template <class S>
void throw_together(World<S>& world, RandomInput& random) {
    (void)world.add(ground());
    BodyDef wall = ground();
    wall.shape = HalfSpace{{1, 0, 0}, -2};
    (void)world.add(wall);
    for (int i = 0; i < 12; ++i) {
        const auto size = [&] { return static_cast<scalar>(random.real(0.25, 0.5)); };
        const Vector place = to_vector(Vector3(random.real(-1, 1), random.real(-1, 1), 1 + i));
        BodyDef def = i % 2 == 0 || S::max_contacts > 0 ? ball(size(), place) : box({size(), size(), size()}, place);
        def.restitution = i % 3 == 0 ? static_cast<scalar>(random.real(0, 1)) : 0;
        def.state.A = to_matrix(random.rotation());
        def.state.v_CM = to_vector(random.vector(6));
        ASSERT_EQ(world.add(def).status, Status::ok);
    }
}

template <class S>
class Contacts : public ::testing::Test {};
using Readers = ::testing::Types<Yard<BlockSweeps, true>, Yard<HybridIslands<12>, true>, Yard<SequentialImpulses, true>,
                                 Yard<BlockSweeps, true, true>, Yard<SequentialImpulses, true, true>, Impacts<true>>;
TYPED_TEST_SUITE(Contacts, Readers);

TYPED_TEST(Contacts, give_what_bodies_get) {
    // Impacts of one pair along two normals in one step are rare.
    const int seeds = TypeParam::max_contacts > 0 ? 40 : ingot_reference::draws(40);
    for (int seed = 0; seed < seeds; ++seed)
        for (const int rate : {30, 60, 240}) {
            RandomInput random(static_cast<std::uint64_t>(100 + seed));
            World<TypeParam>& world = empty_world<TypeParam>();
            throw_together(world, random);
            const scalar h = 1 / static_cast<scalar>(rate);
            int touches = 0;
            for (int step_i = 0; step_i < 2 * rate; ++step_i) {
                std::vector<Vector3> v(TypeParam::max_bodies), given(TypeParam::max_bodies, Vector3::Zero());
                std::vector<double> visits(TypeParam::max_bodies, 0);
                double fastest = 0;
                const auto velocity = [&](int slot) { return to_eigen(world.state(world.body_at(slot)).value.v_CM); };
                for (int slot = 2; slot < world.body_count(); ++slot) {
                    v[static_cast<unsigned>(slot)] = velocity(slot);
                    fastest = std::max(fastest, velocity(slot).norm() + static_cast<double>(g * h));
                }
                const StepReport report = step(world, h);
                double given_most = 0;
                for (const ContactInfo& contact : world.contacts()) {
                    const Vector3 j = to_eigen(contact.n) * static_cast<double>(contact.j) + to_eigen(contact.j_friction);
                    given[contact.A.slot] += j;
                    given[contact.B.slot] -= j;
                    ++visits[contact.A.slot], ++visits[contact.B.slot];
                    given_most = std::max(given_most, j.norm());
                    touches += contact.j > 0 ? 1 : 0;
                }
                for (int slot = 2; slot < world.body_count(); ++slot) {
                    const unsigned i = static_cast<unsigned>(slot);
                    const double M = static_cast<double>(world.mass(world.body_at(slot)).value);
                    if constexpr (TypeParam::sleeps)
                        if (world.is_asleep(world.body_at(slot))) continue;  // what still moved is taken away: see fall_asleep
                    const Vector3 got = M * (velocity(slot) - v[i] - Vector3(0, 0, static_cast<double>(-g * h)));
                    // Each visit of a contact rounds the velocity of its bodies for the normals, for friction and for the impulses themselves; it
                    // is visited once a sweep, in each impact of a chain by 64 sweeps at most, and eight times for the kicks and the ends of
                    // substeps.
                    const double sweeps = report.sweeps + 64.0 * report.impact_waves + 8;
                    const double roundings = 4 * sweeps * (visits[i] + 1);
                    ASSERT_LE((got - given[i]).norm(), roundings * u * (M * 3 * fastest + given_most)) << "step " << step_i << " body " << slot;
                }
            }
            EXPECT_GT(touches, rate) << "else nothing was tested";
        }
}

/// A column of boxes; the sum of the normals under each is the weight above it, times h.
template <class S>
void expect_weights(const World<S>& world, const std::vector<BodyId>& column, scalar h) {
    double weight = 0;
    for (std::size_t i = column.size(); i-- > 0;) {
        weight += static_cast<double>(world.mass(column[i]).value * g);
        double below = 0;
        for (const ContactInfo& contact : world.contacts_of(column[i])) {
            const BodyId other = contact.A == column[i] ? contact.B : contact.A;
            const bool is_below = i == 0 ? other.slot == 0 : other == column[i - 1];
            if (!is_below) continue;
            const double up = static_cast<double>(contact.n.z) * (contact.A == column[i] ? 1 : -1);
            EXPECT_NEAR(up, 1, 1e-5);
            below += static_cast<double>(contact.j) * up;
        }
        EXPECT_NEAR(below / (weight * static_cast<double>(h)), 1, 1e-5) << "box " << i << " at " << 1 / h;
    }
}

template <class S>
std::vector<BodyId> stack(World<S>& world, int height) {
    (void)world.add(ground());
    std::vector<BodyId> column;
    const scalar half = scalar(0.5);
    for (int i = 0; i < height; ++i)
        column.push_back(world.add(box({half, half, half}, {scalar(0.125), 0, static_cast<scalar>(i) + half}, static_cast<scalar>(1 + i % 2))).value);
    return column;
}

TYPED_TEST(Contacts, of_what_rests_carry_its_weight) {
    for (const int rate : {30, 60, 120, 240, 1000}) {
        World<TypeParam>& world = empty_world<TypeParam>();
        const std::vector<BodyId> column = stack(world, TypeParam::max_contacts > 0 ? 1 : 3);
        const scalar h = 1 / static_cast<scalar>(rate);
        for (int step_i = 0; step_i < rate; ++step_i) ASSERT_EQ(step(world, h).status, Status::ok);
        expect_weights(world, column, h);
    }
}

template <class Solver>
class UnnamedContacts : public ::testing::Test {};
using Solvers = ::testing::Types<BlockSweeps, HybridIslands<12>, SequentialImpulses>;
TYPED_TEST_SUITE(UnnamedContacts, Solvers);

TYPED_TEST(UnnamedContacts, tell_the_weight_of_what_rests_too) {
    for (const int rate : {30, 60, 1000}) {
        World<Yard<TypeParam, false>>& world = empty_world<Yard<TypeParam, false>>();
        const std::vector<BodyId> column = stack(world, 3);
        const scalar h = 1 / static_cast<scalar>(rate);
        for (int step_i = 0; step_i < rate; ++step_i) ASSERT_EQ(step(world, h).status, Status::ok);
        expect_weights(world, column, h);
    }
}

TYPED_TEST(UnnamedContacts, move_as_those_that_are_read) {
    RandomInput random(7), again(7);
    World<Yard<TypeParam, false>>& plain = empty_world<Yard<TypeParam, false>>();
    World<Yard<TypeParam, true>>& read = empty_world<Yard<TypeParam, true>>();
    throw_together(plain, random);
    throw_together(read, again);
    for (int step_i = 0; step_i < 200; ++step_i) {
        (void)step(plain, scalar(1) / 60);
        (void)step(read, scalar(1) / 60);
        ASSERT_EQ(plain.state_hash(), read.state_hash()) << step_i;
        ASSERT_EQ(plain.contact_count(), read.contact_count());
    }
}

TYPED_TEST(UnnamedContacts, of_sleepers_keep_what_they_had) {
    using S = Yard<TypeParam, true, true>;
    World<S>& world = empty_world<S>();
    static World<S> restored;
    const std::vector<BodyId> column = stack(world, 3);
    const scalar h = scalar(1) / 60;
    for (int step_i = 0; step_i < 120 && world.asleep_count() < 3; ++step_i) (void)step(world, h);
    ASSERT_EQ(world.asleep_count(), 3);
    for (int step_i = 0; step_i < 5; ++step_i) (void)step(world, h);
    EXPECT_EQ(world.contact_count(), 3);
    expect_weights(world, column, h);

    std::vector<uint8_t> bytes(snapshot_size<S>());
    bytes.resize(save_snapshot(world, bytes.data(), bytes.size()).value);
    ASSERT_EQ(load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    EXPECT_EQ(restored.contact_count(), 3);
    expect_weights(restored, column, h);
}

bool same(const ContactInfo& a, const ContactInfo& b) {
    bool equal = a.A == b.A && a.B == b.B && a.shape_A == b.shape_A && a.shape_B == b.shape_B && a.j == b.j && a.point_count == b.point_count &&
                 a.separation == b.separation && to_eigen(a.n) == to_eigen(b.n) && to_eigen(a.j_friction) == to_eigen(b.j_friction);
    for (int i = 0; i < 4; ++i)
        equal = equal && to_eigen(a.points[i].P) == to_eigen(b.points[i].P) && a.points[i].j == b.points[i].j &&
                a.points[i].separation == b.points[i].separation;
    return equal;
}

TYPED_TEST(Contacts, are_told_by_number_in_a_row_and_by_body) {
    RandomInput random(3);
    World<TypeParam>& world = empty_world<TypeParam>();
    static World<TypeParam> before;
    throw_together(world, random);
    for (int step_i = 0; step_i < 400; ++step_i) {
        (void)step(world, scalar(1) / 60);
        if (step_i % 20 != 0) continue;
        std::memcpy(static_cast<void*>(&before), &world, sizeof world);
        int count = 0, of_bodies = 0;
        for (const ContactInfo& contact : world.contacts()) {
            const Result<ContactInfo> numbered = world.contact(count++);
            ASSERT_EQ(numbered.status, Status::ok);
            ASSERT_TRUE(same(contact, numbered.value));
            ASSERT_TRUE(world.is_alive(contact.A) && world.is_alive(contact.B));
        }
        ASSERT_EQ(count, world.contact_count());
        for (int slot = 0; slot < world.body_count(); ++slot)
            for (const ContactInfo& contact : world.contacts_of(world.body_at(slot))) {
                ASSERT_TRUE(contact.A == world.body_at(slot) || contact.B == world.body_at(slot));
                ++of_bodies;
            }
        ASSERT_EQ(of_bodies, 2 * count) << "each is of two bodies";
        ASSERT_EQ(std::memcmp(&world, &before, sizeof world), 0) << "who reads changes nothing";
    }
    EXPECT_EQ(world.contact(-1).status, Status::out_of_range);
    EXPECT_EQ(world.contact(world.contact_count()).status, Status::out_of_range);
    int none = 0;
    const BodyId gone = world.body_at(5);
    ASSERT_EQ(world.remove(gone), Status::ok);
    for (const BodyId id : {BodyId{}, gone, BodyId{2, 9, 1}})
        for (const ContactInfo& contact : world.contacts_of(id)) none += contact.point_count + 1;
    EXPECT_EQ(none, 0);
    for (const ContactInfo& contact : world.contacts()) EXPECT_FALSE(contact.A.slot == 5 || contact.B.slot == 5) << "they went with it";
}

TYPED_TEST(Contacts, lie_between_the_surfaces) {
    RandomInput random(11);
    for (int i = 0; i < 200; ++i) {
        World<TypeParam>& world = empty_world<TypeParam>();
        (void)world.set_gravity({});
        (void)world.add(ground());
        const Vector half = {scalar(0.5), scalar(0.375), scalar(0.25)};
        const scalar depth = static_cast<scalar>(random.real(-0.00001, 0.0625)), x = static_cast<scalar>(random.real(-8, 8));
        BodyDef def = i % 2 == 0 ? box(half, {x, 1, half.z - depth}) : ball(half.z, {x, 1, half.z - depth});
        def.state.A = axis_angle({0, 0, 1}, static_cast<scalar>(random.real(-3, 3)));
        const BodyId id = world.add(def).value;
        // Places are those of the begin of the step, whatever takes the overlap back in it.
        (void)step(world, scalar(1) / 60);
        int points = 0;
        for (const ContactInfo& contact : world.contacts_of(id)) {
            ASSERT_EQ(to_eigen(contact.n) * (contact.A == id ? 1 : -1), Vector3(0, 0, 1));
            points += contact.point_count;
            for (int point_i = 0; point_i < contact.point_count; ++point_i) {
                const ContactPoint& point = contact.points[point_i];
                // A corner of the box, or the lowest point of the ball: a turn, a sum and a difference, of numbers up to 9 m.
                ASSERT_NEAR(static_cast<double>(point.separation), static_cast<double>(-depth), 8 * u * 9);
                ASSERT_NEAR(static_cast<double>(point.P.z), static_cast<double>(-depth) / 2, 16 * u * 9);
                const Vector body = transpose_times(def.state.A, point.P - def.state.r_CM);
                ASSERT_NEAR(std::abs(static_cast<double>(body.x)), i % 2 == 0 ? 0.5 : 0, 16 * u * 9);
                ASSERT_NEAR(std::abs(static_cast<double>(body.y)), i % 2 == 0 ? 0.375 : 0, 16 * u * 9);
            }
        }
        ASSERT_EQ(points, i % 2 == 0 ? 4 : 1);
    }
}

struct Feather : Scene {
    static constexpr int max_bodies = 2, max_manifolds = 4;
    static constexpr bool translates = true, reads_contacts = true;
    using shapes = Shapes<Sphere, HalfSpace>;
};

/// What next to no weight gives is below all normal numbers, whose inverse is none: its place is told all the same.
TEST(ReadingContacts, tell_where_next_to_nothing_presses) {
    int below = 0;
    for (int power = 0; power < (INGOT_DOUBLE ? 320 : 45); ++power) {
        const auto world = std::make_unique<ingot::World<Feather>>();
        ASSERT_EQ(world->set_gravity({0, 0, -std::pow(scalar(10), scalar(-power))}), ingot::Status::ok);
        ingot::BodyDef ground, def;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ASSERT_TRUE(world->add(ground).ok());
        const scalar M = ingot::limits::mass_min;
        def.mass = {M, {M / 10, M / 10, M / 10}, {}, ingot::identity_matrix<scalar>()};
        def.shape = ingot::Sphere{scalar(0.5)};
        def.state.r_CM = {3, 0, scalar(0.5)};
        const auto id = world->add(def);
        ASSERT_TRUE(id.ok());
        for (int step_i = 0; step_i < 3; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
        const ingot::ContactSum sum = world->contact_sum(id.value).value;
        if (!(sum.j_normal > 0)) continue;
        below += 1 / sum.j_normal > ingot::scalar_max ? 1 : 0;
        EXPECT_NEAR(static_cast<double>(sum.P.x), 3, 1e-3) << power;
    }
    EXPECT_GT(below, 0);
}

TEST(ReadingContacts, of_impacts_moves_nobody) {
    const int rates[] = {60, 30, 1000, 240};
    for (int seed = 0; seed < ingot_reference::draws(40); ++seed) {
        RandomInput random(static_cast<std::uint64_t>(100 + seed)), again(static_cast<std::uint64_t>(100 + seed));
        World<Impacts<false>>& plain = empty_world<Impacts<false>>();
        World<Impacts<true>>& read = empty_world<Impacts<true>>();
        throw_together(plain, random);
        throw_together(read, again);
        const int rate = rates[seed % 4];
        for (int step_i = 0; step_i < 2 * rate; ++step_i) {
            (void)step(plain, scalar(1) / static_cast<scalar>(rate));
            (void)step(read, scalar(1) / static_cast<scalar>(rate));
            ASSERT_EQ(plain.state_hash(), read.state_hash()) << "seed " << seed << ", step " << step_i;
        }
    }
}

TEST(ReadingContacts, costs_memory_only_where_it_is_named) {
    EXPECT_EQ(sizeof(World<Yard<BlockSweeps, true>>), sizeof(World<Yard<BlockSweeps, false>>) + 100 * sizeof(ImpulseSum));
    EXPECT_LE(sizeof(World<Impacts<true>>), sizeof(World<Impacts<false>>) + 100 * sizeof(Vector) + alignof(World<Impacts<true>>));
}

}  // namespace
