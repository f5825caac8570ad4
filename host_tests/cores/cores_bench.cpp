// SPDX-License-Identifier: MIT
// What several cores are worth: cores_bench [steps]. Worlds of the same bits take turns, ten steps each, on one core and on several, so that whatever
// else the machine does hits all of them, and threads need not wake up for each step. Times are ratios within the run. What a step does outside of
// its tasks is measured where these are done one after the other, and says what more cores could give.
#include <ingot/platform/host_threads.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "scenes/contact/stacks.h"
#include "scenes/random.h"

namespace {

using ingot::scalar;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double, std::micro>(Clock::now() - begin).count(); }

/// Tasks one after the other, as many as for two workers; measured.
struct InTurn {
    static constexpr int workers = 2;
    static inline double us = 0;
    static inline int joins = 0;
    template <class Task>
    static void run(int count, Task& task) {
        const Clock::time_point begin = Clock::now();
        for (int task_i = 0; task_i < count; ++task_i) task(task_i);
        us += since(begin);
        ++joins;
    }
};

template <class Workers>
struct Yard : ingot::Scene {
    static constexpr int max_bodies = 8200, max_manifolds = 32000, max_pairs = 60000;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
    using workers = Workers;
};

template <class World>
void add(World& world, const scenes::PlacedBody& body) {
    ingot::BodyDef def = body.def;
    def.friction = body.mu;
    if (!world.add(def).ok()) std::abort();
}
template <class World>
void begin(World& world) {
    if (world.set_gravity({0, 0, -scenes::standard_gravity}) != ingot::Status::ok) std::abort();
    add(world, scenes::half_space({0, 0, 1}, 0, scalar(0.6)));
}
constexpr scalar half = scalar(0.5);

struct ManyPiles {
    static const char* name() { return "64 pyramids of 15"; }
    template <class World>
    static void build(World& world) {
        begin(world);
        for (int pile_i = 0; pile_i < 64; ++pile_i)
            for (int row = 0; row < 5; ++row)
                for (int k = 0; k < 5 - row; ++k) {
                    const scalar x = scalar(12 * (pile_i % 8)) + scalar(1.05) * scalar(k) + scalar(0.525) * scalar(row);
                    add(world, scenes::solid_box(1, {half, half, half}, {x, scalar(4 * (pile_i / 8)), half + scalar(row)}, scalar(0.6)));
                }
    }
};
struct ManyHeaps {
    static const char* name() { return "64 heaps of 16 that fall"; }
    template <class World>
    static void build(World& world) {
        begin(world);
        scenes::Random random(1);
        for (int heap_i = 0; heap_i < 64; ++heap_i)
            for (int i = 0; i < 16; ++i) {
                const ingot::Vector place = {scalar(9 * (heap_i % 8)), scalar(9 * (heap_i / 8)), 1 + scalar(i)};
                const ingot::Vector at = place + ingot::Vector{random.symmetric(), random.symmetric(), 0};
                const scalar size = scalar(0.4) + scalar(0.1) * random.symmetric();
                add(world, i % 3 == 0 ? scenes::solid_ball(1, size, at, scalar(0.6)) : scenes::solid_box(1, {size, size, half}, at, scalar(0.6)));
            }
    }
};
/// A pile of boxes of chance in a pit: all of it is one island.
template <int wide, int high>
struct OnePile {
    static constexpr int count = wide * wide * high;
    static const char* name() { return count > 4000 ? "one pile of 8000 boxes" : "one pile of 2048 boxes"; }
    template <class World>
    static void build(World& world) {
        begin(world);
        scenes::Random random(1);
        const scalar out = scalar(0.6) * wide + scalar(0.7);
        for (const int side : {0, 1, 2, 3}) {
            const scalar at = side % 2 == 0 ? out : -out;
            const bool along_x = side < 2;
            add(world, scenes::fixed_box(along_x ? ingot::Vector{half, out + 1, 20} : ingot::Vector{out + 1, half, 20},
                                         along_x ? ingot::Vector{at, 0, 20} : ingot::Vector{0, at, 20}, scalar(0.6)));
        }
        for (int i = 0; i < count; ++i) {
            const int x = i % wide, y = i / wide % wide, z = i / (wide * wide);
            const ingot::Vector cell = {scalar(x) - half * (wide - 1), scalar(y) - half * (wide - 1), 1 + scalar(z)};
            scenes::PlacedBody box = scenes::solid_box(1, {half + scalar(0.1) * random.symmetric(), half, half + scalar(0.1) * random.symmetric()},
                                                       cell * scalar(1.2) + random.symmetric_vector() * scalar(0.3), scalar(0.6));
            box.def.state.L = random.symmetric_vector();
            add(world, box);
        }
    }
};
/// One island, whose contacts are of many levels: there are few that could be visited side by side.
struct Wall {
    static const char* name() { return "pyramid of 820"; }
    template <class World>
    static void build(World& world) {
        begin(world);
        for (int row = 0; row < 40; ++row)
            for (int k = 0; k < 40 - row; ++k)
                add(world, scenes::solid_box(1, {half, half, half}, {scalar(1.05) * scalar(k) + scalar(0.525) * scalar(row), 0, half + scalar(row)},
                                             scalar(0.6)));
    }
};
struct Small {
    static const char* name() { return "10 boxes"; }
    template <class World>
    static void build(World& world) {
        begin(world);
        for (int i = 0; i < 10; ++i) add(world, scenes::solid_box(1, {half, half, half}, {scalar(2 * i), 0, half}, scalar(0.6)));
    }
};

constexpr int steps_of_turn = 10;

template <class World>
double time_turn(World& world) {
    const Clock::time_point begun = Clock::now();
    for (int step_i = 0; step_i < steps_of_turn; ++step_i) (void)step(world, scenes::display_rate_h);
    return since(begun);
}

/// Median of the ratios of a turn, on one core and on several.
template <class Scene, int count>
double ratio(int steps) {
    const auto one = std::make_unique<ingot::World<Yard<ingot::OneCore>>>();
    const auto many = std::make_unique<ingot::World<Yard<ingot::platform::HostThreads<count>>>>();
    Scene::build(*one);
    Scene::build(*many);
    std::vector<double> ratios;
    for (int step_i = 0; step_i < steps; step_i += steps_of_turn) {
        const double alone = time_turn(*one);
        ratios.push_back(alone / time_turn(*many));
    }
    if (one->state_hash() != many->state_hash()) std::abort();
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<long>(ratios.size() / 2), ratios.end());
    return ratios[ratios.size() / 2];
}

template <class Scene>
void measure(int steps) {
    const auto in_turn = std::make_unique<ingot::World<Yard<InTurn>>>();
    const auto plain = std::make_unique<ingot::World<Yard<ingot::OneCore>>>();
    Scene::build(*in_turn);
    Scene::build(*plain);
    InTurn::us = 0;
    InTurn::joins = 0;
    double cut = 0, whole = 0;
    for (int step_i = 0; step_i < steps; ++step_i) {
        Clock::time_point begun = Clock::now();
        (void)step(*in_turn, scenes::display_rate_h);
        cut += since(begun);
        begun = Clock::now();
        (void)step(*plain, scenes::display_rate_h);
        whole += since(begun);
    }
    const double outside = (cut - InTurn::us) / whole, inside = InTurn::us / whole;
    const auto with = [&](int workers) { return 1 / (outside + inside / workers); };
    std::printf("%-26s %6.1f joins a step, %4.1f %% outside of tasks: 2, 4, 6, 8 cores at most %.2f %.2f %.2f %.2f; measured: 2 %.2f\n",
                Scene::name(), static_cast<double>(InTurn::joins) / steps, 100 * outside, with(2), with(4), with(6), with(8), ratio<Scene, 2>(steps));
}

}  // namespace

int main(int argument_count, char** arguments) {
    const int steps = argument_count > 1 ? std::atoi(arguments[1]) : 300;
    measure<ManyPiles>(steps);
    measure<ManyHeaps>(steps);
    measure<OnePile<16, 8>>(steps);
    measure<OnePile<20, 20>>(steps / 4);
    measure<Wall>(steps);
    measure<Small>(steps);
    return 0;
}
