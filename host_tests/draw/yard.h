// SPDX-License-Identifier: MIT
// A yard with one of everything that can be drawn, and a pen that notes what it is asked for.
#pragma once

#include <ingot/ingot.h>

#include <array>
#include <memory>
#include <vector>

namespace draw_yard {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::DrawColor;
using ingot::scalar;
using ingot::Vector;

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 60, max_joints = 8, max_overlaps = 4;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true, reads_contacts = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};
using World = ingot::World<Yard>;

struct NotingPen {
    struct Stroke {
        Vector a, b;
        DrawColor color;
    };
    std::vector<Stroke> strokes;

    void line(const Vector& a, const Vector& b, DrawColor color) { strokes.push_back({a, b, color}); }

    std::vector<Stroke> of(DrawColor color) const {
        std::vector<Stroke> found;
        for (const Stroke& stroke : strokes)
            if (stroke.color == color) found.push_back(stroke);
        return found;
    }
};

inline BodyDef solid(const ingot::Shape& shape, const Vector& r_CM) {
    BodyDef def;
    def.mass = ingot::principal(ingot::solid_of_shape(500, shape)).value;
    def.shape = shape;
    def.state.r_CM = r_CM;
    return def;
}

/// Three columns of crates, a ball that flies, a chain of capsules, a turntable, a sensor, on the ground.
inline std::unique_ptr<World> yard() {
    auto world = std::make_unique<World>();
    bool good = world->set_gravity({0, 0, scalar(-9.81)}) == ingot::Status::ok;
    const auto add = [&](const BodyDef& def) {
        const ingot::Result<BodyId> id = world->add(def);
        good = good && id.ok();
        return id.value;
    };
    BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    add(ground);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row <= column; ++row)
            add(solid(ingot::Box{{scalar(0.5), scalar(0.4), scalar(0.5)}}, {scalar(3 * column), 0, scalar(0.5) + scalar(row)}));
    BodyDef ball = solid(ingot::Sphere{scalar(0.3)}, {-3, 0, 4});
    ball.state.L = {0, 1, 2};
    add(ball);
    add(solid(ingot::Cylinder{scalar(0.3), scalar(0.5)}, {-6, 0, scalar(0.5)}));
    BodyDef table;
    table.kinematic = true;
    table.shape = ingot::Box{{1, 1, scalar(0.1)}};
    table.state.r_CM = {0, 6, 1};
    table.state.L = {0, 0, 1};
    add(table);
    BodyDef gate;
    gate.immovable = gate.sensor = true;
    gate.shape = ingot::Sphere{1};
    gate.state.r_CM = {-3, 0, 1};
    add(gate);
    BodyId before{};
    for (int link = 0; link < 4; ++link) {
        const BodyId id = add(solid(ingot::Capsule{scalar(0.1), scalar(0.2)}, {0, -6, scalar(5) - scalar(0.8) * scalar(link)}));
        ingot::JointDef joint;
        joint.body_A = before;
        joint.body_B = id;
        joint.P = {0, -6, scalar(5.4) - scalar(0.8) * scalar(link)};
        joint.axis = {0, 1, 0};
        if (link % 2 == 0)
            joint.joint = ingot::BallJoint{};
        else
            joint.joint = ingot::HingeJoint{};
        good = good && world->add_joint(joint).ok();
        before = id;
    }
    return good ? std::move(world) : nullptr;
}

}  // namespace draw_yard
