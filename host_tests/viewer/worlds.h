// SPDX-License-Identifier: MIT
// The worlds of the page. A scene is data; these few types are what all of them run in, for each of them is a step of its own in the module.
#pragma once

#include <ingot/ingot.h>

#include "grounds.h"

namespace viewer {


/// What those with shapes share.
struct Things : ingot::Scene {
    static constexpr int max_bodies = 640, max_manifolds = 4096, max_pairs = 12288;
    static constexpr bool translates = true, sleeps = true;
    static constexpr bool hides_internal_edges = false,
                          holds_crowds = false;  // no floor of several boxes, and room for all there is: 20 KB of module
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

/// Sweeps.
struct Swept : Things {};
/// A solver that picks itself, and fast bodies followed within a step.
struct Chosen : Things {
    static constexpr bool continuous = true;
    using solver = ingot::HybridIslands<>;
};
#ifndef VIEWER_CONTACTS_ALONE
/// Joints, with limits and drives, that may close loops, and grounds of levels: the other half of the module.
struct Machines : Things {
    static constexpr int max_joints = 128, max_loops = 32;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace, ingot::Level>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::WheelJoint, ingot::RopeJoint, ingot::ParallelJoint,
                                 ingot::GearJoint, ingot::ServoJoint, ingot::TargetJoint, ingot::WithLimits, ingot::WithDrives>;
    static constexpr ingot::LevelTable levels[] = {ingot::with_materials(hills.value.view(), materials_of_hills), stairs.view()};
};
#endif
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
#ifndef VIEWER_CONTACTS_ALONE
        case machines: return ask(Named<Machines>{});
#endif
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
