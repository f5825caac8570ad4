// SPDX-License-Identifier: MIT
// A world in a frame buffer of 320 x 240 words, as small consoles have it: shapes, contacts and impulses in perspective, a colour for each meaning.
#include <ingot/ingot.h>

#include <cstdint>
#include <cstdio>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world;

static std::uint16_t color_of(ingot::DrawColor color) {
    switch (color) {
        case ingot::DrawColor::awake: return 0x5d9f;
        case ingot::DrawColor::immovable: return 0x4208;
        case ingot::DrawColor::contact: return 0xf800;
        case ingot::DrawColor::impulse: return 0xfd20;
        default: return 0xffff;
    }
}

struct FrameBuffer {
    std::uint16_t at[240][320] = {};

    /// From an eye 10 m in front of the origin and 2 m high, along y. What is behind the eye has no place: such lines are left out.
    void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor color) {
        const ingot::scalar depth_a = a.y + 10, depth_b = b.y + 10;
        if (depth_a < 0.1f || depth_b < 0.1f) return;
        const ingot::scalar x = 160 + 240 * a.x / depth_a, y = 120 - 240 * (a.z - 2) / depth_a;
        const ingot::scalar dx = 160 + 240 * b.x / depth_b - x, dy = 120 - 240 * (b.z - 2) / depth_b - y;
        const ingot::scalar longest = ingot::max(ingot::abs(dx), ingot::abs(dy));
        const int dots = longest < 1000 ? static_cast<int>(longest) + 1 : 1000;
        for (int i = 0; i <= dots; ++i) {
            const ingot::scalar share = static_cast<ingot::scalar>(i) / static_cast<ingot::scalar>(dots);
            const ingot::scalar column = x + dx * share, row = y + dy * share;
            if (column >= 0 && column < 320 && row >= 0 && row < 240) at[static_cast<int>(row)][static_cast<int>(column)] = color_of(color);
        }
    }
};
static FrameBuffer frame;

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(10, {0.5f, 0.5f, 0.5f})).value;
    crate.shape = ingot::Box{{0.5f, 0.5f, 0.5f}};
    for (int i = 0; i < 3; ++i) {
        crate.state.r_CM = {0, 0, 0.5f + static_cast<ingot::scalar>(i)};
        good = good && world.add(crate).ok();
    }
    for (int step_i = 0; good && step_i < 30; ++step_i) good = ingot::step(world, 1.0f / 60).clean();
    ingot::DrawScale scale;
    scale.impulse = 1;
    ingot::draw<ingot::Draw::shapes | ingot::Draw::contacts | ingot::Draw::impulses>(world, frame, scale);

    int shapes = 0, contacts = 0, impulses = 0;
    for (const auto& row : frame.at)
        for (const std::uint16_t dot : row) {
            shapes += dot == color_of(ingot::DrawColor::awake) ? 1 : 0;
            contacts += dot == color_of(ingot::DrawColor::contact) ? 1 : 0;
            impulses += dot == color_of(ingot::DrawColor::impulse) ? 1 : 0;
        }
    std::printf("frame buffer: %d dots of crates, %d of contacts, %d of impulses\n", shapes, contacts, impulses);
    return good && shapes > 200 && contacts > 10 && impulses > 10 ? 0 : 1;
}
