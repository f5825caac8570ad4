// SPDX-License-Identifier: MIT
// A satellite turns about its middle axis, and flips over again and again, as a wing nut in orbit does. Nothing touches it, so energy and angular
// momentum stay: to rounding, over ten minutes.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

static ingot::World<ingot::Scene> world;  // the least scene: one body that turns

int main() {
    ingot::BodyDef satellite;
    satellite.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {0.05f, 0.1f, 0.17f}), 4)).value;
    satellite.state = ingot::body_state(satellite.mass, {}, {{}, {0.001f, 1, 0.001f}});  // of a box, axes lie along its edges
    const ingot::Result<ingot::BodyId> id = world.add(satellite);
    bool good = id.ok();
    const double T = static_cast<double>(world.kinetic_energy()), L = std::sqrt(static_cast<double>(ingot::length_sq(satellite.state.L)));
    int flips = 0;
    double worst_T = 0, worst_L = 0;
    ingot::scalar side = 1;
    for (int step_i = 0; good && step_i < 36000; ++step_i) {
        good = ingot::step(world, 1.0f / 60).clean();
        const ingot::BodyState now = world.state(id.value).value;
        worst_T = std::fmax(worst_T, std::fabs(static_cast<double>(world.kinetic_energy()) / T - 1));
        worst_L = std::fmax(worst_L, std::fabs(std::sqrt(static_cast<double>(ingot::length_sq(now.L))) / L - 1));
        const ingot::scalar along = ingot::dot(now.A.c1, now.L);  // the middle axis and L: it flips where this changes its sign
        if (along * side < 0) {
            side = -side;
            ++flips;
        }
    }
    std::printf("satellite: %d flips in ten minutes, energy off by %.1e of itself, L by %.1e\n", flips, worst_T, worst_L);
    return good && flips > 10 && worst_T < 1e-5 && worst_L < 1e-6 ? 0 : 1;
}
