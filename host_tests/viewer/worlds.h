// SPDX-License-Identifier: MIT
// The worlds of the page. A scene is data; these few types are what all of them run in, for each of them is a step of its own in the module.
#pragma once

#include <ingot/ingot.h>

namespace viewer {

using ingot::scalar;
using ingot::Vector;

/// What those with shapes share.
struct Things : ingot::Scene {
    static constexpr int max_bodies = 640, max_manifolds = 4096, max_pairs = 12288;
    static constexpr bool translates = true, sleeps = true;
    static constexpr bool hides_internal_edges = false,
                          holds_crowds = false;  // no floor of several boxes, and room for all there is: 20 KB of module
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

/// Sweeps, and joints that close loops: bridges, ropes, and a target that a body is drawn to, which is what the mouse is.
struct Swept : Things {
    static constexpr int max_joints = 96, max_loops = 32;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RopeJoint, ingot::TargetJoint>;
};
/// A solver that picks itself, and fast bodies followed within a step.
struct Chosen : Things {
    static constexpr bool continuous = true;
    using solver = ingot::HybridIslands<>;
};
/// Joints with limits and drives: ragdolls, cars.
struct Machines : Things {
    static constexpr int max_joints = 128;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::WheelJoint, ingot::WithLimits, ingot::WithDrives>;
};
/// Sweeps again, with less and with more effort.
struct Coarse : Things {
    static constexpr ingot::Effort effort = ingot::low_effort;
};
struct Fine : Things {
    static constexpr ingot::Effort effort = ingot::high_effort;
};

/// One body that turns, by a method.
template <class Method>
struct Turning : ingot::Scene {
    using rotation = Method;
};

/// In the order of the page's list of methods.
enum Kind {
    swept,
    chosen,
    machines,
    turn_moser_veselov,
    turn_order_4,
    turn_runge_kutta,
    turn_lie_midpoint,
    turn_listing_1,
    coarse,
    fine,
    kind_count
};

template <class S>
struct Named {
    using scene = S;
};
/// Asks with the scene of a kind, as a type.
template <class Answer, class Ask>
Answer for_kind(int kind, Answer none, const Ask& ask) {
    switch (kind) {
        case swept: return ask(Named<Swept>{});
        case chosen: return ask(Named<Chosen>{});
        case machines: return ask(Named<Machines>{});
        case turn_moser_veselov: return ask(Named<Turning<ingot::MoserVeselov>>{});
        case turn_order_4: return ask(Named<Turning<ingot::DiscreteMoserVeselov<4, false, false, 1>>>{});
        case turn_runge_kutta: return ask(Named<Turning<ingot::Rk4Polar>>{});
        case turn_lie_midpoint: return ask(Named<Turning<ingot::LieMidpoint>>{});
        case turn_listing_1: return ask(Named<Turning<ingot::Listing1Euler>>{});
        case coarse: return ask(Named<Coarse>{});
        case fine: return ask(Named<Fine>{});
        default: return none;
    }
}

}  // namespace viewer
