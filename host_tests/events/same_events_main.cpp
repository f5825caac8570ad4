// SPDX-License-Identifier: MIT
// Prints a hash of all events of a crowd: one line, the same for every lane count.
#include <cinttypes>
#include <cstdio>

#include "crowd.h"

int main() {
    std::uint64_t hash = ingot::state_hash_seed;
    const auto add = [&](const void* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i) hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
    };
    int count = 0;
    events_stage::run_crowd([&](const auto& world, const auto&) {
        for (const ingot::Event& event : world.events()) {
            const std::uint32_t names[5] = {static_cast<std::uint32_t>(event.kind), event.A.slot, event.A.generation, event.B.slot,
                                            event.B.generation};
            const ingot::scalar numbers[7] = {event.P.x, event.P.y, event.P.z, event.n.x, event.n.y, event.n.z, event.speed};
            add(names, sizeof names);
            add(numbers, sizeof numbers);
            ++count;
        }
    });
    std::printf("%d events, %016" PRIx64 "\n", count, hash);
    return count > 1000 ? 0 : 1;
}
