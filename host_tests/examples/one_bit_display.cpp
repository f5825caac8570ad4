// SPDX-License-Identifier: MIT
// A world on a display of 128 x 64 dots, such as an SSD1306: a pen that sets dots in the 1024 bytes that are sent to it. Here they are printed.
#include <ingot/ingot.h>

#include <cstdint>
#include <cstdio>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;

struct Display {
    std::uint8_t pages[8][128] = {};  // as the display has them: eight rows of bytes, the lowest bit on top

    bool is_set(int x, int y) const { return (pages[y / 8][x] >> (y % 8) & 1) != 0; }
    void set(int x, int y) {
        if (x >= 0 && x < 128 && y >= 0 && y < 64) pages[y / 8][x] = static_cast<std::uint8_t>(pages[y / 8][x] | 1 << (y % 8));
    }
    /// Seen along y: ten dots for a metre, the ground in row 60.
    void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor) {
        const int x_0 = static_cast<int>(64 + a.x * 10), y_0 = static_cast<int>(60 - a.z * 10), x_1 = static_cast<int>(64 + b.x * 10),
                  y_1 = static_cast<int>(60 - b.z * 10);
        const int dx = x_1 - x_0, dy = y_1 - y_0, wide = dx < 0 ? -dx : dx, high = dy < 0 ? -dy : dy, dots = wide > high ? wide : high;
        for (int i = 0; i <= dots && dots < 1000; ++i) set(x_0 + (dots > 0 ? dx * i / dots : 0), y_0 + (dots > 0 ? dy * i / dots : 0));
    }
};
static Display display;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, {1, 1, 1})).value;
    crate.shape = ingot::Box{{1, 1, 1}};
    crate.state.r_CM = {-2, 0, 1};
    ingot::BodyDef ball;
    ball.mass = ingot::principal(ingot::solid_sphere(200, 1)).value;
    ball.shape = ingot::Sphere{1};
    ball.state.r_CM = {2, 0, 4};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok() && world.add(crate).ok() && world.add(ball).ok();
    for (int step_i = 0; good && step_i < 30; ++step_i) good = ingot::step(world, 1.0f / 60).clean();
    ingot::draw(world, display);

    int dots = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            dots += display.is_set(x, y) ? 1 : 0;
            if (y >= 16) std::putchar(display.is_set(x, y) ? '#' : ' ');
        }
        if (y >= 16) std::putchar('\n');
    }
    // The upper edge of the crate, 2 m above the ground; nothing beside it, above the ground.
    const bool crate_there = display.is_set(44, 40) && display.is_set(54, 40) && !display.is_set(20, 40);
    return good && crate_there && display.is_set(16, 60) && dots > 200 && dots < 1500 ? 0 : 1;
}
