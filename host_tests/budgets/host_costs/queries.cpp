// SPDX-License-Identifier: MIT
// What queries cost among bodies that lie as in a heap: boxes, balls and capsules of 0.3 to 0.9 m, 1.1 m from each other, on a ground.
#include "queries.h"

#include <ingot/ingot.h>
#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

namespace {

using ingot::BodyId;
using ingot::scalar;
using ingot::Vector;

constexpr int queries_of_a_step = 64, steps = 15;
constexpr scalar apart = scalar(1.1);  // m

template <class Search>
struct Heap : ingot::Scene {
    static constexpr int max_bodies = 10001, max_manifolds = 30000, max_pairs = 65535;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using broad_phase = Search;
};

/// The same numbers on every machine.
class Numbers {
public:
    scalar between(scalar low, scalar high) { return low + (high - low) * static_cast<scalar>(next() >> 8) / scalar(1 << 24); }
    Vector in(scalar side) {
        const scalar x = between(0, side), y = between(0, side);
        return {x, y, between(0, side)};
    }
    Vector direction() {
        const Vector v = in(2) - Vector{1, 1, 1};
        return v * (1 / ingot::sqrt(ingot::length_sq(v)));
    }

private:
    std::uint32_t next() { return state_ = state_ * 1664525u + 1013904223u; }
    std::uint32_t state_ = 1;
};

int side_of(int count) {
    int side = 1;
    while (side * side * side < count) ++side;
    return side;
}

template <class S>
void heap_up(ingot::World<S>& world, Numbers& numbers, int count) {
    bool good = true;
    const auto add = [&](const ingot::BodyDef& def) { good = world.add(def).ok() && good; };
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, -1};
    add(ground);
    const int side = side_of(count);
    for (int i = 0; i < count; ++i) {
        ingot::BodyDef def;
        def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        const scalar size = numbers.between(scalar(0.15), scalar(0.45));
        if (i % 3 == 0) def.shape = ingot::Sphere{size};
        else if (i % 3 == 1) def.shape = ingot::Capsule{size / 2, size / 2};
        else def.shape = ingot::Box{{size, size * scalar(0.75), size / 2}};
        def.state.r_CM = Vector{scalar(i % side), scalar(i / side % side), scalar(i / side / side)} * apart + numbers.in(scalar(0.2));
        add(def);
    }
    good = ingot::step(world, scalar(1) / 60).status == ingot::Status::ok && good;
    if (good) return;
    std::fprintf(stderr, "host_costs: there is no heap\n");
    std::exit(1);
}

/// A query of a kind: from within the heap or from beside it, as far as it is wide; of a ball of 0.2 m.
template <class S>
__attribute__((noinline)) int ask(const ingot::World<S>& world, char kind, const Vector& from, const Vector& way) {
    const ingot::PlacedShape ball = {ingot::Sphere{scalar(0.2)}, from, ingot::identity_matrix<scalar>(), nullptr};
    BodyId found[32];
    switch (kind) {
        case 'r': return world.cast_ray(from, way).value.body.slot;
        case 'c': return world.cast_shape(ball, way).value.body.slot;
        case 'o': return world.find_overlaps(ball, found, 32).value;
        default: return world.find_nearest(from, apart).value.body.slot;
    }
}

template <class S>
void count_queries(char kind, int bodies) {
    static ingot::World<S> world;
    Numbers numbers;
    heap_up(world, numbers, bodies);
    const scalar side = apart * static_cast<scalar>(side_of(bodies));
    int sum = 0;
    CALLGRIND_START_INSTRUMENTATION;
    for (int step_i = 0; step_i < steps; ++step_i) {
        Vector from[queries_of_a_step], way[queries_of_a_step];
        for (int i = 0; i < queries_of_a_step; ++i) {
            from[i] = numbers.in(side);
            way[i] = numbers.direction() * side;
            if (i % 2 == 0 && kind != 'o' && kind != 'n') from[i] = from[i] - way[i];
        }
        CALLGRIND_TOGGLE_COLLECT;
        for (int i = 0; i < queries_of_a_step; ++i) sum += ask(world, kind, from[i], way[i]);
        CALLGRIND_TOGGLE_COLLECT;
        CALLGRIND_DUMP_STATS;
    }
    std::fprintf(stderr, "%s", sum == 0 ? "host_costs: nothing was found\n" : "");
}

}  // namespace

bool ask_queries(const char* name) {
    for (const char* kind : {"rays", "casts", "overlaps", "nearest"})
        for (const int bodies : {100, 1000, 10000}) {
            char all[32], by_tree[40];
            std::snprintf(all, sizeof all, "%s_%d", kind, bodies);
            std::snprintf(by_tree, sizeof by_tree, "%s_by_tree", all);
            if (std::strcmp(name, all) == 0) return count_queries<Heap<ingot::SortedTree>>(kind[0], bodies), true;
            if (std::strcmp(name, by_tree) == 0) return count_queries<Heap<ingot::QueryTree>>(kind[0], bodies), true;
        }
    return false;
}
