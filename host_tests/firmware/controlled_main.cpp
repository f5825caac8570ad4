// SPDX-License-Identifier: MIT
// Runs figures with their controllers and prints what they came to: the same source on the host and as firmware. With INGOT_CONTROLLED it holds one.
//
//     walker float steps 300 hash 0x0123456789abcdef
//     walker world_bytes 20480 instructions_per_step 1000000 worst_step 2000000 steering_per_step 20000           (where the clock counts them)
//     walker adds 100000 muls 100000 divs 1000 roots 100 mean 200000 worst 300000                           (with INGOT_COUNTS_OPERATIONS)
//
// INGOT_COUNTS_OPERATIONS is for cores without floating-point unit: each operation is a call there, which the linker leads through a counter
// (host_tests/report/firmware/flops_main.cpp), so that counts are exact, of the compiled program.
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>

#include "../scenes/controlled.h"

namespace {

struct Counts {
    uint64_t adds, muls, divs, roots;
    uint64_t all() const { return adds + muls + divs + roots; }
};
Counts counts;

}  // namespace

#ifdef INGOT_COUNTS_OPERATIONS
#define INGOT_COUNT(function, counter)          \
    float __real_##function(float, float);      \
    float __wrap_##function(float, float);      \
    float __wrap_##function(float a, float b) { \
        ++counts.counter;                       \
        return __real_##function(a, b);         \
    }
extern "C" {
INGOT_COUNT(__aeabi_fadd, adds)
INGOT_COUNT(__aeabi_fsub, adds)
INGOT_COUNT(__aeabi_frsub, adds)
INGOT_COUNT(__aeabi_fmul, muls)
INGOT_COUNT(__aeabi_fdiv, divs)
float __real__ZN5ingot5f32x114sqrt_by_digitsEf(float);
float __wrap__ZN5ingot5f32x114sqrt_by_digitsEf(float);
float __wrap__ZN5ingot5f32x114sqrt_by_digitsEf(float a) {
    ++counts.roots;
    return __real__ZN5ingot5f32x114sqrt_by_digitsEf(a);
}
}
#endif

namespace {

using namespace ingot::platform;

void write_number(const char* label, uint64_t value) {
    console_write(label);
    console_write_u64(value);
}

template <class Controlled>
bool run() {
    static ingot::World<typename Controlled::Scene> world;
    static Controlled controlled;
    if (controlled.begin(world) != ingot::Status::ok) return false;
    uint64_t steering = 0, stepping = 0, worst_ticks = 0, worst_count = 0;
    bool good = true;
    counts = {};
    for (int step_i = 0; step_i < Controlled::golden_steps && good; ++step_i) {
        const uint64_t begin = clock_ticks();
        good = controlled.steer(world) == ingot::Status::ok;
        const uint64_t middle = clock_ticks(), count = counts.all();
        (void)ingot::step(world, scenes::sixtieth);
        const uint64_t ticks = clock_ticks() - middle, counted = counts.all() - count;
        steering += middle - begin;
        stepping += ticks;
        worst_ticks = ticks > worst_ticks ? ticks : worst_ticks;
        worst_count = counted > worst_count ? counted : worst_count;
    }
    constexpr unsigned steps = Controlled::golden_steps;
    console_write(Controlled::name);
    console_write(sizeof(ingot::scalar) == 4 ? " float" : " double");
    write_number(" steps ", steps);
    console_write(" hash ");
    console_write_hex(world.state_hash(), 16);
    if (clock_counts_instructions()) {
        console_write("\n");
        console_write(Controlled::name);
        write_number(" world_bytes ", sizeof world);
        write_number(" instructions_per_step ", clock_ticks_to_instructions(stepping) / steps);
        write_number(" worst_step ", clock_ticks_to_instructions(worst_ticks));
        write_number(" steering_per_step ", clock_ticks_to_instructions(steering) / steps);
    }
    if (counts.all() > 0) {  // of the controller too
        console_write("\n");
        console_write(Controlled::name);
        write_number(" adds ", counts.adds / steps);
        write_number(" muls ", counts.muls / steps);
        write_number(" divs ", counts.divs / steps);
        write_number(" roots ", counts.roots / steps);
        write_number(" mean ", counts.all() / steps);
        write_number(" worst ", worst_count);
    }
    console_write("\n");
    if (!controlled.is_well(world)) console_write("    it is not where its controller wants it\n");
    return good && controlled.is_well(world);
}

}  // namespace

int main() {
    clock_start();
#ifdef INGOT_CONTROLLED
    return run<scenes::INGOT_CONTROLLED>() ? 0 : 1;
#else
    const bool results[] = {run<scenes::PlanarWalk>(),    run<scenes::SpatialWalk>(), run<scenes::BalancedWalk>(),
                            run<scenes::UprightFlight>(), run<scenes::CarDrive>(),    run<scenes::TankDrive>()};
    for (const bool result : results)
        if (!result) return 1;
    return 0;
#endif
}
