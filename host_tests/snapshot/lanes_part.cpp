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

}  // namespace

Kernel INGOT_LANES_KERNEL() { return {ingot::lanes, begin, go_on}; }

}  // namespace lanes_test
