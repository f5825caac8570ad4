// SPDX-License-Identifier: MIT
// A lift with a stack of three crates follows its timetable: up by 3 m, softly, and down again. The crates stay where they stand on it.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

struct Shaft : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Box>;
};
static ingot::World<Shaft> world;

/// m; one way takes 4 s, with no more than 0.93 m/s^2.
static ingot::scalar height_at(double t) { return static_cast<ingot::scalar>(1.5 - 1.5 * std::cos(t * 3.14159265358979 / 4)); }

int main() {
    ingot::BodyDef platform;
    platform.kinematic = true;
    platform.shape = ingot::Box{{1, 1, 0.05f}};
    platform.state.r_CM = {0, 0, -0.05f};
    ingot::BodyDef crate;
    const ingot::Vector half_extents = {0.3f, 0.3f, 0.3f};
    crate.mass = ingot::principal(ingot::solid_box(200, half_extents)).value;
    crate.shape = ingot::Box{half_extents};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok;
    const ingot::BodyId lift = world.add(platform).value;
    ingot::BodyId crates[3];
    for (int i = 0; i < 3; ++i) {
        crate.state.r_CM = {0.01f * static_cast<ingot::scalar>(i), 0, 0.3f + 0.6f * static_cast<ingot::scalar>(i)};
        crates[i] = world.add(crate).value;
    }
    double worst = 0;
    for (int step_i = 1; good && step_i <= 480; ++step_i) {
        const ingot::scalar z = height_at(step_i / 60.0);
        good = world.move_to(lift, {0, 0, z - 0.05f}, ingot::identity_matrix<ingot::scalar>()) == ingot::Status::ok;
        good = good && ingot::step(world, 1.0f / 60).clean();
        for (int i = 0; i < 3; ++i) {
            const ingot::Vector r = world.state(crates[i]).value.r_CM;
            const ingot::scalar k = static_cast<ingot::scalar>(i);
            worst = std::fmax(worst, std::fabs(static_cast<double>(r.z - z - 0.3f - 0.6f * k)));
            worst = std::fmax(worst, std::fabs(static_cast<double>(r.x - 0.01f * k)));
        }
    }
    std::printf("lift: up 3 m and down, crates off their places by %.2f mm at most\n", worst * 1000);
    return good && worst < 0.001 ? 0 : 1;
}
