// SPDX-License-Identifier: MIT
// One body that turns, by each method: instructions of the whole step, as firmware. Lines of `method mean worst`.
#include <ingot/ingot.h>
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>

namespace {

using namespace ingot::platform;
using ingot::scalar;

template <class Rotation>
struct Alone : ingot::Scene {
    using rotation = Rotation;
};

template <class Rotation>
ingot::World<Alone<Rotation>> world;

template <class Rotation>
void run(const char* name, const ingot::Vector& I) {
    constexpr int steps = 480;
    ingot::BodyDef def;
    def.mass = {4, I, {}, ingot::identity_matrix<scalar>()};
    def.state.L = ingot::scaled(I, {1, scalar(0.5), scalar(0.25)});
    (void)world<Rotation>.add(def);
    uint64_t sum = 0, worst = 0;
    for (int step_i = 0; step_i < steps; ++step_i) {
        const uint64_t begin = clock_ticks();
        (void)ingot::step(world<Rotation>, scalar(1) / 60);
        const uint64_t ticks = clock_ticks() - begin;
        sum += ticks;
        worst = ticks > worst ? ticks : worst;
    }
    console_write(name);
    console_write(" ");
    console_write_u64(clock_ticks_to_instructions(sum) / steps);
    console_write(" ");
    console_write_u64(clock_ticks_to_instructions(worst));
    console_write("\n");
}

}  // namespace

int main() {
    using namespace ingot;
    clock_start();
    const Vector book = {1, 2, 3}, top = {1, 1, scalar(1.75)};
    run<MoserVeselov>("default", book);
    run<Listing1Euler>("listing1_euler", book);
    run<LieMidpoint>("lie_midpoint", book);
    run<Rk4Polar>("rk4_polar", book);
    run<DiscreteMoserVeselov<2>>("moser_veselov_2", book);
    run<DiscreteMoserVeselov<4>>("moser_veselov_4", book);
    run<DiscreteMoserVeselov<4, false, false, 1>>("moser_veselov_4_plain", book);
    run<DiscreteMoserVeselov<6, false, false>>("moser_veselov_6_plain", book);
    run<DiscreteMoserVeselov<8>>("moser_veselov_8", book);
    run<DiscreteMoserVeselov<10>>("moser_veselov_10", book);
    run<SymmetricTopSplitting<2>>("symmetric_top_splitting_2", book);
    run<SymmetricTopSplitting<6>>("symmetric_top_splitting_6", book);
    run<ExactElliptic>("exact_elliptic", book);
    run<SymmetricTop>("symmetric_top", top);
    return 0;
}
