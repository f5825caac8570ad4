// SPDX-License-Identifier: MIT
// A step remembers nothing but what a snapshot holds: whatever the arrays of its solver hold of the steps before, it goes as in a world that is new.
#include "snapshot/life.h"

#include <gtest/gtest.h>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using namespace life;
using Bytes = std::vector<uint8_t>;
using ingot_reference::RandomInput;

template <class Solver, class BroadPhase, bool belts>
struct Fair : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 96, max_pairs = 400;
    static constexpr bool translates = true, kinematic_bodies = true, rolling_resistance = true, surface_velocities = belts;
    using solver = Solver;
    using broad_phase = BroadPhase;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

/// Who lies still falls asleep, and what happens is told.
struct Restful : Fair<ingot::BlockSweeps, ingot::SortedTree, false> {
    static constexpr int max_events = 300;
    static constexpr bool sleeps = true;
};

/// Bodies of every shape, from 10 g to 10 t, that fall on each other, spin and roll, on a floor and on plates that go up and down; they come and go.
template <class S>
class Bustle {
public:
    Bustle(uint64_t seed, World<S>& world) : random_(seed), world_(world) {
        clear(world);
        EXPECT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), Status::ok);
        BodyDef floor = ground();
        floor.friction = scalar(0.6);
        EXPECT_TRUE(world.add(floor).ok());
        for (int i = 0; i < 3; ++i) {
            BodyDef plate = plain_body({scalar(3 * i), 0, scalar(0.5)}, ingot::Box{{1, 1, scalar(0.25)}});
            plate.kinematic = true;
            plate.friction = scalar(0.6);
            plates_[i] = world.add(plate).value;
        }
        for (int i = 0; i < 12; ++i) come();
    }

    void act() {
        if (random_.integer(0, 9) == 0) come();
        if (random_.integer(0, 14) == 0) (void)world_.remove(world_.body_at(random_.integer(4, S::max_bodies - 1)));
        if (random_.integer(0, 19) == 0) {
            const Vector v = {scalar(random_.real(-0.5, 0.5)), 0, scalar(random_.real(-1, 1))};
            const Vector omega = {0, 0, scalar(random_.integer(0, 1) == 0 ? 0 : random_.real(-3, 3))};
            EXPECT_EQ(world_.set_velocity(plates_[random_.integer(0, 2)], v, omega), Status::ok);
        }
    }

private:
    void come() {
        const double M = std::exp(random_.real(-4.6, 9.2)), size = random_.real(0.1, 0.5);
        const scalar s = scalar(size), half = scalar(size * random_.real(0.5, 1));
        const int kind = random_.integer(0, 3);
        const Shape shapes[] = {ingot::Sphere{s}, ingot::Capsule{s, half}, ingot::Box{{s, half, half}}, ingot::Cylinder{s, half}};
        const double x = 3 * random_.integer(0, 2) + random_.real(-0.3, 0.3);
        BodyDef def = plain_body({scalar(x), scalar(random_.real(-0.3, 0.3)), scalar(random_.real(1, 4))}, shapes[kind]);
        const scalar I = scalar(0.4 * M * size * size);
        def.mass = mass_of(scalar(M), {I, I, kind == 2 ? I * scalar(1.2) : I});
        def.friction = scalar(random_.real(0.1, 1));
        def.state.A = ingot_reference::to_matrix(random_.rotation());
        def.state.v_CM = {scalar(random_.real(-1, 1)), scalar(random_.real(-1, 1)), scalar(random_.real(-6, 0))};
        if (random_.integer(0, 1) == 0) def.state.L = ingot_reference::to_vector(random_.vector(20)) * I;
        const auto id = world_.add(def);
        if (id.ok() && random_.integer(0, 1) == 0) (void)world_.set_rolling_resistance(id.value, scalar(size * random_.real(0, 0.02)));
    }

    RandomInput random_;
    World<S>& world_;
    BodyId plates_[3];
};

bool same(const ingot::Event& a, const ingot::Event& b) {
    const auto same_vector = [](const Vector& v, const Vector& w) { return v.x == w.x && v.y == w.y && v.z == w.z; };
    return a.kind == b.kind && a.A == b.A && a.B == b.B && a.speed == b.speed && same_vector(a.P, b.P) && same_vector(a.n, b.n);
}

template <class S>
void expect_forgetful(uint64_t seed) {
    static World<S> world, renewed;
    static Bytes bytes(ingot::snapshot_size<S>());
    int contacts = 0, events = 0;
    const int draws = ingot_reference::draws(64);
    for (int draw_i = 0; draw_i < draws; ++draw_i) {
        Bustle<S> bustle(seed * 1000 + static_cast<uint64_t>(draw_i), world);
        const scalar h = scalar(1) / (draw_i % 3 == 0 ? 30 : draw_i % 3 == 1 ? 60 : 240);
        for (int step_i = 0; step_i < 200; ++step_i) {
            bustle.act();
            const Result<size_t> size = ingot::save_snapshot(world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            ASSERT_EQ(ingot::load_snapshot(renewed, bytes.data(), size.value), Status::ok);
            contacts += ingot::step(world, h).contacts;
            (void)ingot::step(renewed, h);
            ASSERT_EQ(renewed.state_hash(), world.state_hash()) << "draw " << draw_i << ", step " << step_i;
            if constexpr (ingot::has_events<S>) {
                const ingot::EventView now = world.events(), anew = renewed.events();
                ASSERT_EQ(now.count, anew.count) << "draw " << draw_i << ", step " << step_i;
                for (int i = 0; i < now.count; ++i) ASSERT_TRUE(same(now[i], anew[i])) << "draw " << draw_i << ", step " << step_i << ", event " << i;
                events += now.count;
            }
        }
    }
    EXPECT_GT(contacts, 1000 * draws);
    EXPECT_EQ(events > 50 * draws, ingot::has_events<S>);
}

TEST(Forgetful, are_block_sweeps) { expect_forgetful<Fair<ingot::BlockSweeps, ingot::AllPairs, false>>(1); }
TEST(Forgetful, are_block_sweeps_by_the_tree) { expect_forgetful<Fair<ingot::BlockSweeps, ingot::SortedTree, true>>(2); }
TEST(Forgetful, are_hybrid_islands) { expect_forgetful<Fair<ingot::HybridIslands<>, ingot::SortedTree, false>>(3); }
TEST(Forgetful, are_sleep_and_events) { expect_forgetful<Restful>(5); }
TEST(Forgetful, are_sequential_impulses) { expect_forgetful<Fair<ingot::SequentialImpulses, ingot::AllPairs, false>>(4); }

}  // namespace
