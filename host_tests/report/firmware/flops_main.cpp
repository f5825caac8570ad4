// SPDX-License-Identifier: MIT
// Counts the operations on floating-point numbers that a step takes: every one is a call on a core without floating-point
// unit, and the linker leads each call through a counter (--wrap). Exact, of the compiled program, and the same on every
// target because the bits are. Prints, for each method and rate,
//
//     <method> <rate> adds <n> muls <n> divs <n> roots <n>          sums over `steps` steps of the book case
#include <ingot/ingot.h>
#include <ingot/platform/console.h>

namespace {

struct Counts {
    uint32_t adds, muls, divs, roots;
};
Counts counts;

}  // namespace

#if INGOT_DOUBLE
using Real = double;
#define INGOT_SOFT(name) __aeabi_d##name
#define INGOT_ROOT _ZN5ingot5f64x114sqrt_by_digitsEd
#else
using Real = float;
#define INGOT_SOFT(name) __aeabi_f##name
#define INGOT_ROOT _ZN5ingot5f32x114sqrt_by_digitsEf
#endif
#define INGOT_PASTE_(a, b) a##b
#define INGOT_PASTE(a, b) INGOT_PASTE_(a, b)
#define INGOT_COUNT(function, counter)                    \
    Real INGOT_PASTE(__real_, function)(Real, Real);      \
    Real INGOT_PASTE(__wrap_, function)(Real, Real);      \
    Real INGOT_PASTE(__wrap_, function)(Real a, Real b) { \
        ++counts.counter;                                 \
        return INGOT_PASTE(__real_, function)(a, b);      \
    }

extern "C" {
INGOT_COUNT(INGOT_SOFT(add), adds)
INGOT_COUNT(INGOT_SOFT(sub), adds)
INGOT_COUNT(INGOT_SOFT(rsub), adds)
INGOT_COUNT(INGOT_SOFT(mul), muls)
INGOT_COUNT(INGOT_SOFT(div), divs)

Real INGOT_PASTE(__real_, INGOT_ROOT)(Real);
Real INGOT_PASTE(__wrap_, INGOT_ROOT)(Real);
Real INGOT_PASTE(__wrap_, INGOT_ROOT)(Real a) {
    ++counts.roots;
    return INGOT_PASTE(__real_, INGOT_ROOT)(a);
}
}

namespace {

using namespace ingot::platform;

constexpr int steps = 128;  // of 15 Hz: a whole round of the polhode; eight polar steps
constexpr int rates[] = {15, 30, 60, 120, 240, 960};

template <class Rotation, bool moves>
struct Book : ingot::Scene {
    static constexpr bool translates = moves;
    using rotation = Rotation;
};

void write(const char* label, uint32_t value) {
    console_write(label);
    console_write_u64(value);
}

template <class Rotation, bool moves = false>
bool count(const char* name) {
    for (const int rate : rates) {
        static ingot::World<Book<Rotation, moves>> world;
        world = {};
        ingot::BodyDef def{};
        def.mass = {1, {1, 2, 3}, {}, ingot::identity_matrix<ingot::scalar>()};
        def.state.A = ingot::identity_matrix<ingot::scalar>();
        def.state.L = {ingot::scalar(0.5), 2, ingot::scalar(2.25)};
        bool clean = world.add(def).ok();
        const ingot::scalar h = ingot::scalar(1) / static_cast<ingot::scalar>(rate);
        counts = {};
        for (int step_i = 0; step_i < steps; ++step_i) clean = ingot::step(world, h).clean() && clean;
        const Counts taken = counts;
        if (!clean) return false;
        console_write(name);
        write(" ", static_cast<uint32_t>(rate));
        write(" adds ", taken.adds);
        write(" muls ", taken.muls);
        write(" divs ", taken.divs);
        write(" roots ", taken.roots);
        console_write("\n");
    }
    return true;
}

}  // namespace

int main() {
    using namespace ingot;
    bool good = true;
    write("steps ", steps);
    console_write("\n");
    good = count<MoserVeselov, true>("default_moving") && good;
#define INGOT_METHOD(name, order, angle_max, symmetric_only, ...) good = count<__VA_ARGS__>(#name) && good;
#include "../methods.def"
#undef INGOT_METHOD
    return good ? 0 : 1;
}
