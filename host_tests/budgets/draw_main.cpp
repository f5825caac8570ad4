// SPDX-License-Identifier: MIT
// What draw() takes of the flash: a firmware that steps a world, and draws nothing of it, its shapes, or all there is, by a
// pen of lines.
#include <ingot/ingot.h>

namespace {

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 8, max_manifolds = 16, max_joints = 2;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};
ingot::World<Yard> world;

struct Pen {
    ingot::Vector sum{};
    int lines = 0;
    __attribute__((noinline)) void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor) {
        sum += a - b;
        ++lines;
    }
} pen;

}  // namespace

int main() {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(500, {1, 1, 1})).value;
    def.shape = ingot::Box{{1, 1, 1}};
    const bool good = world.add(def).ok() && ingot::step(world, ingot::scalar(1) / 60).clean();
#if INGOT_DRAWS == 2
    ingot::draw<ingot::Draw::all>(world, pen);
    return good && pen.lines == ingot::lines_of_box * 2 + 3 + 3 + 2 ? 0 : 1;
#elif INGOT_DRAWS == 1
    ingot::draw(world, pen);
    return good && pen.lines == ingot::lines_of_box ? 0 : 1;
#else
    pen.line({}, {}, ingot::DrawColor::awake);
    return good && pen.lines == 1 ? 0 : 1;
#endif
}
