// SPDX-License-Identifier: MIT
// Bodies with locks in contact: a locked coordinate keeps its bits, whatever hits the body; impulses are those of a dense solve in the free axes;
// nothing gains energy; and who has none moves as in a scene without them, to the bit.
#include "laws/locked_bodies.h"

#include "reference/draws.h"

namespace {

using namespace locked_bodies;
using ingot_reference::draws;

struct LockedRoom : Room<ingot::BlockSweeps, false> {
    static constexpr bool sleeps = false, axis_locks = true, reads_contacts = true, kinematic_bodies = true;
};
struct UnlockedRoom : LockedRoom {
    static constexpr bool axis_locks = false;
};
struct WithMaterials : Room<ingot::BlockSweeps, true> {
    static constexpr bool axis_locks = true, rolling_resistance = true;
};

/// A room of bodies of every shape, each with locks of its own or none.
template <class S>
void lock_some(Thrown<S>& thrown, RandomInput& random) {
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const BodyId id = thrown.world->body_at(slot);
        if (id.generation == 0 || !thrown.world->is_movable(id)) continue;
        const int kind = random.integer(0, 4);
        const unsigned any = static_cast<unsigned>(random.integer(0, 63));
        const unsigned locks = kind == 0 ? 0 : kind == 1 ? AxisLocks::rotation : kind == 2 ? AxisLocks::to_plane_xy : any;
        ASSERT_EQ(thrown.world->set_locks(id, locks), Status::ok);
    }
}
template <class S>
std::vector<BodyState> states_of(const World<S>& world) {
    std::vector<BodyState> states;
    for (int slot = 0; slot < S::max_bodies; ++slot) states.push_back(world.state(world.body_at(slot)).value_or({}));
    return states;
}

struct PointMaterials : Room<ingot::SequentialImpulses, false> {
    static constexpr bool sleeps = false, axis_locks = true, rolling_resistance = true, reads_contacts = true;
};

template <class S>
class LockedContacts : public ::testing::Test {};
using Rooms = testing::Types<LockedRoom, WithMaterials>;
TYPED_TEST_SUITE(LockedContacts, Rooms);

/// Bodies of every shape, with e in 0 .. 1, among each other in a room, at any rate: locked coordinates keep their bits, and no step gains energy.
/// Without gravity, as the law of bodies without locks: of two that bounce while one falls and the other does not, a step may gain 1e-4 of energy,
/// with gravity_shares as with locks.
TYPED_TEST(LockedContacts, hold_locks_and_give_no_energy) {
    RandomInput random(11);
    double worst = 0;
    for (int case_i = 0; case_i < draws(TypeParam::continuous ? 8 : 24); ++case_i) {
        const double e = case_i % 3 == 0 ? 1 : random.real(0, 1), mu = case_i % 2 == 0 ? 0 : random.real(0, 1);
        const double rates[] = {60, 30, 120, 240, 1000}, h = 1 / rates[case_i % 5];
        Thrown<TypeParam> thrown(0, {e, mu});
        close_room(thrown, 2);
        throw_forty(thrown, random);
        lock_some(thrown, random);
        auto& world = *thrown.world;
        const std::vector<BodyState> begin = states_of(world);
        const double scale = thrown.energy();
        double before = scale;
        for (int step_i = 0; step_i < static_cast<int>(1 / h); ++step_i) {
            (void)ingot::step(world, scalar(h));
            const double now = thrown.energy();
            if (!TypeParam::continuous) {  // as without locks: see energy_laws_test
                EXPECT_LE(now - before, gain_of_step<TypeParam> * scale) << case_i << " step " << step_i << " e " << e << " mu " << mu << " h " << h;
            }
            worst = std::max(worst, (now - before) / scale);
            before = now;
            for (int slot = 0; slot < TypeParam::max_bodies; ++slot)
                if (world.is_alive(world.body_at(slot))) {
                    ASSERT_TRUE(is_held(world, world.body_at(slot), begin[static_cast<size_t>(slot)])) << slot;
                }
        }
    }
    printf("    largest gain of a step, of the energy %.3g, allowed %.3g\n", worst, gain_of_step<TypeParam>);
}

template <class S>
class LockedRolling : public ::testing::Test {};
using RollingRooms = testing::Types<WithMaterials, PointMaterials>;
TYPED_TEST_SUITE(LockedRolling, RollingRooms);

/// Where locks leave a body no turn across a contact there is nothing to roll: it does not freeze, and what contacts tell is finite.
TYPED_TEST(LockedRolling, is_nothing_where_no_turn_is_left) {
    RandomInput random(12);
    for (int case_i = 0; case_i < draws(40); ++case_i) {
        const double rates[] = {60, 30, 120, 240, 1000}, h = 1 / rates[case_i % 5];
        Thrown<TypeParam> thrown(9.81, {random.real(0, 0.5), random.real(0, 1)});
        close_room(thrown, 2);
        throw_forty(thrown, random);
        auto& world = *thrown.world;
        for (int slot = 0; slot < TypeParam::max_bodies; ++slot) {
            const BodyId id = world.body_at(slot);
            if (id.generation == 0 || !world.is_movable(id)) continue;
            ASSERT_EQ(world.set_locks(id, static_cast<unsigned>(random.integer(0, 7)) << 3), Status::ok);
            ASSERT_EQ(world.set_rolling_resistance(id, scalar(random.real(0, 0.1))), Status::ok);
        }
        for (int step_i = 0; step_i < 60; ++step_i) {
            ASSERT_EQ(ingot::step(world, scalar(h)).bodies_frozen, 0) << case_i << " step " << step_i;
            if constexpr (TypeParam::reads_contacts)
                for (const ingot::ContactInfo& contact : world.contacts()) ASSERT_TRUE(ingot::is_finite(contact.j)) << case_i << " step " << step_i;
        }
    }
}

/// Who has no locks moves as in a scene whose bodies have none, to the bit; also beside bodies with locks that it does not meet.
TEST(AxisLocks, leave_others_alone) {
    for (int case_i = 0; case_i < draws(12); ++case_i) {
        RandomInput random(static_cast<std::uint64_t>(20 + case_i)), again = random;
        const Surface surface = {case_i % 2 == 0 ? 0 : 0.5, 0.5};
        Thrown<LockedRoom> with(9.81, surface);
        Thrown<UnlockedRoom> without(9.81, surface);
        with.wall({0, 1, 0}, 2);
        without.wall({0, 1, 0}, 2);
        throw_forty(with, random);
        throw_forty(without, again);
        for (int i = 0; i < 8; ++i) {  // far away
            with.body(any_shape(i, 0.3, random), {40.0 + i, 0, 40}, random.vector(2), random.vector(5), random);
            ASSERT_EQ(with.world->set_locks(with.world->body_at(41 + i), static_cast<unsigned>(random.integer(1, 63))), Status::ok);
        }
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*with.world, scalar(1) / 60);
            (void)ingot::step(*without.world, scalar(1) / 60);
        }
        for (int slot = 1; slot < 41; ++slot) {
            const BodyState a = with.world->state(with.world->body_at(slot)).value, b = without.world->state(without.world->body_at(slot)).value;
            EXPECT_TRUE(same(a.r_CM, b.r_CM) && same(a.v_CM, b.v_CM) && same(a.L, b.L) && same(a.A.c0, b.A.c0)) << case_i << " slot " << slot;
        }
    }
}

struct Side {
    Vector3d inv_M, r;
    Matrix3d W;
    double compliance(const Vector3d& P, const Vector3d& n) const {
        const Vector3d J = (P - r).cross(n);
        return n.dot(inv_M.cwiseProduct(n)) + J.dot(W * J);
    }
};
Side side_of(const BodyDef& def) {
    Vector3d inv_M = Vector3d::Constant(1 / double(def.mass.M));
    for (int axis = 0; axis < 3; ++axis)
        if (is_locked(def.locks, axis)) inv_M[axis] = 0;
    return {inv_M, to_eigen(def.state.r_CM), restricted_inverse(inertia_of(def), def.locks)};
}

/// Two capsules cross and meet. Of one contact without friction the impulse is that of Fig. 4 with 1/M along free axes and W in the place of I^-1.
TEST(AxisLocks, meet_with_the_impulse_of_the_free_axes) {
    RandomInput random(31);
    int met = 0;
    double worst = 0;
    for (int draw = 0; draw < draws(1200); ++draw) {
        static World<LockedRoom> world;
        std::memset(static_cast<void*>(&world), 0, sizeof world);
        BodyDef defs[2];
        for (BodyDef& def : defs) {
            def = any_body(random, static_cast<unsigned>(random.integer(0, 63)));
            def.shape = ingot::Capsule{scalar(0.2), scalar(0.8)};
            def.friction = 0;
        }
        const Vector3d a = to_eigen(defs[0].state.A).col(2), b = to_eigen(defs[1].state.A).col(2);
        if (a.cross(b).norm() < 0.2) continue;
        const Vector3d across = a.cross(b).normalized();
        defs[0].state.r_CM = {};
        defs[1].state.r_CM = to_vector(Vector3d(random.real(-0.7, 0.7) * a - across * (0.4 - 1e-4) - random.real(-0.7, 0.7) * b));
        BodyId ids[2];
        for (int i = 0; i < 2; ++i) {
            defs[i].state.v_CM = to_vector(random.vector(1));
            defs[i].state.L = to_vector(Vector3d(inertia_of(defs[i]) * random.vector(1)));
            ids[i] = world.add(defs[i]).value;
        }
        const BodyState before[2] = {world.state(ids[0]).value, world.state(ids[1]).value};
        const Vector3d omega[2] = {to_eigen(world.omega(ids[0]).value), to_eigen(world.omega(ids[1]).value)};
        const ingot::StepReport report = ingot::step(world, scalar(1) / 4096);
        EXPECT_LE(report.sweeps, 2 * LockedRoom::effort.substeps) << "a row that knows its compliance is solved by one sweep, and the next sees it";
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(is_held(world, ids[i], before[i]));
        for (const ingot::ContactInfo& contact : world.contacts()) {
            if (contact.point_count != 1) continue;
            const Vector3d n = to_eigen(contact.n), P = to_eigen(contact.points[0].P);
            const Side A = side_of(defs[0]), B = side_of(defs[1]);
            const auto velocity = [&](int i) -> Vector3d {
                return to_eigen(before[i].v_CM) + omega[i].cross(Vector3d(P - to_eigen(before[i].r_CM)));
            };
            const double u = n.dot(velocity(0) - velocity(1)), K = A.compliance(P, n) + B.compliance(P, n);
            if (K < 1e-3 * (1 / double(defs[0].mass.M) + 1 / double(defs[1].mass.M))) continue;  // they hardly can part
            const double j = u < 0 ? -u / K : 0;
            // In the step they go 1/4096 of a length, and turn by as much: so far is the contact from that of its begin.
            EXPECT_NEAR(double(contact.j), j, 0.004 * j + 1e-4 * std::abs(u) / K) << "locks " << defs[0].locks << ' ' << defs[1].locks;
            for (int i = 0; i < 2; ++i) {
                const BodyState after = world.state(ids[i]).value;
                const Vector3d given = (i == 0 ? 1 : -1) * double(contact.j) * n, r = to_eigen(defs[i].state.r_CM);
                const Vector3d v = to_eigen(before[i].v_CM) + side_of(defs[i]).inv_M.cwiseProduct(given);
                EXPECT_LE((to_eigen(after.v_CM) - v).norm(), 1e-5 * (v.norm() + 1 + given.norm() / double(defs[i].mass.M)));
                const Vector3d L = to_eigen(before[i].L) + (P - r).cross(given);
                for (int axis = 0; axis < 3; ++axis)
                    if (!is_locked(defs[i].locks, 3 + axis)) {
                        EXPECT_NEAR(to_eigen(after.L)[axis], L[axis], 1e-3 * (L.norm() + given.norm()));
                    }
            }
            worst = std::max(worst, j > 0 ? std::abs(double(contact.j) / j - 1) : 0);
            ++met;
        }
    }
    printf("    %d contacts, worst of the impulses off by %.3g of it\n", met, worst);
    EXPECT_GT(met, draws(1200) / 2);
}

/// A body all of whose axes are locked is to others what an immovable one is.
TEST(AxisLocks, of_all_axes_are_as_if_it_was_immovable) {
    for (int case_i = 0; case_i < draws(24); ++case_i) {
        RandomInput first(static_cast<std::uint64_t>(50 + case_i)), second = first;
        const Surface surface = {case_i % 3 == 0 ? 0.5 : 0, 0.5};
        Thrown<LockedRoom> locked(9.81, surface), immovable(9.81, surface);
        const auto set_up = [&](Thrown<LockedRoom>& thrown, RandomInput& random) {
            ingot::Shape table = ingot::Box{{1, scalar(0.5), 1}};
            if (case_i % 2 != 0) table = ingot::Cylinder{1, scalar(0.5)};
            thrown.body_at(table, {0, 0, 0}, Vector3d::Zero(), Vector3d::Zero(),
                           case_i % 2 == 0 ? Matrix3d::Identity() : Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix());
            thrown.body(any_shape(case_i / 2, 0.2, random), {0.1, 1.2, 0}, any_vector(0.5, random), any_vector(3, random), random);
        };
        set_up(locked, first);
        set_up(immovable, second);
        ASSERT_EQ(locked.world->set_locks(locked.world->body_at(0), AxisLocks::all), Status::ok);
        ASSERT_EQ(immovable.world->set_immovable(immovable.world->body_at(0)), Status::ok);
        const BodyState before = locked.world->state(locked.world->body_at(0)).value;
        for (int step_i = 0; step_i < 30; ++step_i) {
            (void)ingot::step(*locked.world, scalar(1) / 60);
            (void)ingot::step(*immovable.world, scalar(1) / 60);
        }
        EXPECT_TRUE(is_held(*locked.world, locked.world->body_at(0), before));
        const BodyState a = locked.world->state(locked.world->body_at(1)).value, b = immovable.world->state(immovable.world->body_at(1)).value;
        EXPECT_LE((to_eigen(a.r_CM) - to_eigen(b.r_CM)).norm(), 1e-3) << case_i;
        EXPECT_LE((to_eigen(a.v_CM) - to_eigen(b.v_CM)).norm(), 1e-2) << case_i;
    }
}

/// Bodies that stay in one plane keep momentum in it, and angular momentum across it, whatever they do to each other.
TEST(AxisLocks, keep_the_momenta_of_the_free_axes) {
    for (int case_i = 0; case_i < draws(16); ++case_i) {
        RandomInput random(static_cast<std::uint64_t>(70 + case_i));
        Thrown<LockedRoom> thrown(0, {case_i % 2 == 0 ? 0.7 : 0, case_i % 3 == 0 ? 0 : 0.5});
        for (int i = 0; i < 25; ++i) {
            const Vector3d place(i % 5 - 2, i / 5 - 2, 0);
            thrown.body(any_shape(i, 0.35, random), place * 0.9, -place + any_vector(1, random), any_vector(4, random), random);
        }
        auto& world = *thrown.world;
        for (int slot = 0; slot < 25; ++slot) ASSERT_EQ(world.set_locks(world.body_at(slot), AxisLocks::to_plane_xy), Status::ok);
        const Vector3d p = to_eigen(world.linear_momentum()), L = to_eigen(world.angular_momentum());
        double size = 0;
        for (int slot = 0; slot < 25; ++slot) size += double(world.mass(world.body_at(slot)).value) * 3;
        double given = 0;  // impulses times the way that their places go in a step, at 6 m/s
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(world, scalar(1) / 60);
            for (const ingot::ContactInfo& contact : world.contacts()) given += double(contact.j) * 6 / 60;
        }
        EXPECT_GT(given, 0);
        // Of 240 substeps some roundings each.
        EXPECT_LE((to_eigen(world.linear_momentum()) - p).norm(), 240 * double(ingot::epsilon) * size);
        EXPECT_EQ(world.linear_momentum().z, 0);
        EXPECT_NEAR(to_eigen(world.angular_momentum()).z(), L.z(), 4 * 240 * double(ingot::epsilon) * size + given) << case_i;
    }
}

/// A character: its capsule stays upright to the bit, however it is pushed and hit, stands on the floor, and goes where it is pushed.
TEST(AxisLocks, keep_a_character_upright) {
    Thrown<WithMaterials> thrown(9.81, {0, 0.5});
    RandomInput random(90);
    thrown.wall({0, 1, 0}, 0);
    thrown.body_at(ingot::Capsule{scalar(0.3), scalar(0.6)}, {0, 0.9, 0}, Vector3d::Zero(), Vector3d::Zero(),
                   Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix());
    for (int i = 0; i < 12; ++i) thrown.body(any_shape(i, 0.25, random), {2.0 + 0.7 * i, 1.4, 0}, {-8, 0, 0}, any_vector(5, random), random);
    auto& world = *thrown.world;
    const BodyId id = world.body_at(1);
    ASSERT_EQ(world.set_locks(id, AxisLocks::rotation), Status::ok);
    const BodyState before = world.state(id).value;
    for (int step_i = 0; step_i < 300; ++step_i) {
        if (step_i < 120) {
            EXPECT_EQ(world.add_force(id, {0, 0, 3000}, world.state(id).value.r_CM + Vector{0, scalar(0.8), 0}), Status::ok);
        }
        (void)ingot::step(world, scalar(1) / 60);
        ASSERT_TRUE(is_held(world, id, before)) << step_i;
    }
    EXPECT_NEAR(world.state(id).value.r_CM.y, 0.9, 2e-3);
    EXPECT_GT(world.state(id).value.r_CM.z, 1);
    EXPECT_LT(world.state(id).value.r_CM.x, 0) << "hit from the right";
}

/// Carried and pressed by what moves by itself.
TEST(AxisLocks, hold_against_kinematic_bodies) {
    for (unsigned locks = 0; locks < 64; locks += 3) {
        Thrown<LockedRoom> thrown(9.81, {0, 0.5});
        thrown.body_at(ingot::Box{{2, scalar(0.25), 2}}, {0, -0.25, 0}, Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Identity());
        thrown.body_at(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}, {0, 0.5, 0}, Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Identity());
        auto& world = *thrown.world;
        const BodyId lift = world.body_at(0), crate = world.body_at(1);
        ASSERT_EQ(world.set_kinematic(lift), Status::ok);
        ASSERT_EQ(world.set_locks(crate, locks), Status::ok);
        const BodyState before = world.state(crate).value;
        for (int step_i = 0; step_i < 60; ++step_i) {
            BodyState state = world.state(lift).value;
            state.v_CM = {scalar(0.5), scalar(0.25), 0};
            state.L = {0, 1, 0};
            ASSERT_EQ(world.set_state(lift, state), Status::ok);
            (void)ingot::step(world, scalar(1) / 60);
            ASSERT_TRUE(is_held(world, crate, before)) << locks;
        }
        if (locks == AxisLocks::all) {
            for (const ingot::ContactInfo& contact : world.contacts()) EXPECT_EQ(contact.j, 0) << "what cannot part is left alone";
        }
        const BodyState after = world.state(crate).value;
        if (!is_locked(locks, 1)) {
            EXPECT_NEAR(after.r_CM.y, 0.75, 2e-3) << locks;
        }
        EXPECT_LT(std::abs(after.r_CM.x), 1);
    }
}

/// Fast ones keep their energy from wall to wall, where impacts take none: also within a step they are bodies of fewer degrees of freedom.
TEST(AxisLocks, keep_their_energy_from_wall_to_wall) {
    for (int case_i = 0; case_i < draws(24); ++case_i) {
        RandomInput random(static_cast<std::uint64_t>(110 + case_i));
        Thrown<WithMaterials> thrown(0, {1, 0});
        close_room(thrown, 2);
        const unsigned locks = case_i % 3 == 0 ? AxisLocks::rotation : case_i % 3 == 1 ? AxisLocks::to_plane_xy : 8u << random.integer(0, 2);
        thrown.body(any_shape(1 + case_i % 3, 0.4, random), any_vector(1, random), any_vector(60, random), any_vector(3, random), random);
        ASSERT_EQ(thrown.world->set_locks(thrown.world->body_at(6), locks), Status::ok);
        const double energy = thrown.energy();
        for (int step_i = 0; step_i < 30; ++step_i) (void)ingot::step(*thrown.world, scalar(1) / 60);
        EXPECT_NEAR(thrown.energy(), energy, 2e-3 * energy) << case_i << " locks " << locks;
    }
}

/// A ball that turns about one axis of the world, whatever its moments, turns on at its speed from wall to wall: nothing there has a lever. So it has
/// turned by the angle that is due, also within the steps in which it meets a wall.
TEST(AxisLocks, turn_on_at_their_speed_from_wall_to_wall) {
    double worst = 0;
    int impacts = 0;
    for (int case_i = 0; case_i < draws(48); ++case_i) {
        RandomInput random(static_cast<std::uint64_t>(310 + case_i));
        Thrown<WithMaterials> thrown(0, {1, 0});
        close_room(thrown, 2);
        const int axis = case_i % 3, rate = case_i % 2 == 0 ? 60 : 240;
        BodyDef def = any_body(random, static_cast<unsigned>(AxisLocks::rotation) & ~(8u << axis));
        const double spin = random.real(-20, 20);
        def.state.r_CM = to_vector(random.vector(1));
        def.state.v_CM = to_vector(random.direction() * random.real(40, 120));
        def.state.L = to_vector(inertia_of(def)(axis, axis) * spin * Vector3d::Unit(axis));
        def.shape = ingot::Sphere{scalar(0.2)};
        def.restitution = 1;
        def.friction = 0;
        const BodyId ball = thrown.world->add(def).value;
        for (int step_i = 0; step_i < rate / 2; ++step_i) {
            const Vector v = thrown.world->state(ball).value.v_CM;
            (void)ingot::step(*thrown.world, scalar(1) / static_cast<scalar>(rate));
            impacts += !same(v, thrown.world->state(ball).value.v_CM);
        }
        const Matrix3d due = Eigen::AngleAxisd(spin / 2, Vector3d::Unit(axis)).toRotationMatrix() * to_eigen(def.state.A);
        const double off = Eigen::AngleAxisd(to_eigen(thrown.world->state(ball).value.A).transpose() * due).angle();
        worst = std::max(worst, off / rate);
        EXPECT_LE(off, 8 * static_cast<double>(ingot::epsilon) * rate) << case_i << ", of " << spin / 2;  // a rounding of each part of a step
    }
    std::printf("    off by %.2g roundings a step\n", worst / static_cast<double>(ingot::epsilon));
    EXPECT_GT(impacts, draws(48) * 5);
}

}  // namespace
