// SPDX-License-Identifier: MIT
// Compiled once for each lane count; INGOT_LANES_KERNEL names the function. The namespaces that come with life.h get names of their
// own by macro (CMakeLists.txt), so that three of each fit into one program.
#include "snapshot/lanes.h"

#include "snapshot/life.h"

namespace lanes_test {

namespace {

using namespace life;

World<Tide> tide;
World<Yard> crates;

/// Even seeds live in a field, odd ones in a yard.
template <class S>
std::vector<uint8_t> begin_in(World<S>& world, uint64_t seed, int before) {
    clear(world);
    Life life(seed);
    for (int call_i = 0; call_i < before; ++call_i) life.live(world);
    return saved(world);
}

template <class S>
Trace go_on_in(World<S>& world, const std::vector<uint8_t>& from, uint64_t seed, int before, int after) {
    clear(world);
    Life life(seed);
    for (int call_i = 0; call_i < before; ++call_i) life.live(world);  // brings the stream of random numbers to where it was
    Trace trace{};
    trace.loaded = ingot::load_snapshot(world, from.data(), from.size()) == Status::ok;
    for (int call_i = 0; call_i < after; ++call_i) {
        life.live(world);
        trace.hashes.push_back(world.state_hash());
    }
    trace.bytes = saved(world);
    return trace;
}

std::vector<uint8_t> begin(uint64_t seed, int before) {
    return seed % 2 == 0 ? begin_in(tide, seed, before) : begin_in(crates, seed, before);
}
Trace go_on(const std::vector<uint8_t>& from, uint64_t seed, int before, int after) {
    return seed % 2 == 0 ? go_on_in(tide, from, seed, before, after) : go_on_in(crates, from, seed, before, after);
}

struct Landing : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 12;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
World<Landing> landing;

std::vector<uint64_t> land() {
    constexpr scalar tenth = scalar(0.1);
    clear(landing);
    std::vector<uint64_t> hashes;
    BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    bool sound = landing.set_gravity({0, 0, -10}) == Status::ok && landing.add(ground).ok();
    for (int body_i = 0; body_i < 8; ++body_i) {
        const auto i = static_cast<scalar>(body_i);
        BodyDef def;
        def.mass = {1 + i, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        def.restitution = body_i % 2 == 0 ? scalar(0.75) : scalar(0.25);
        if (body_i % 2 == 0)
            def.shape = ingot::Sphere{tenth + i * tenth};
        else
            def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.25)}};
        def.state.r_CM = {4 * i, 0, 1 + i * tenth};
        def.state.v_CM = {i * tenth, 0, -i};
        sound = sound && landing.add(def).ok();
    }
    for (int step_i = 0; sound && step_i < 300; ++step_i) {
        sound = ingot::step(landing, scalar(1) / 30).status == Status::ok;
        hashes.push_back(landing.state_hash());
    }
    return hashes;
}

}  // namespace

Kernel INGOT_LANES_KERNEL() { return {ingot::lanes, begin, go_on, land}; }

}  // namespace lanes_test
