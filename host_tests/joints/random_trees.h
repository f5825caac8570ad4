// SPDX-License-Identifier: MIT
// Scenes of figures drawn at random, each a tree of boxes.
#pragma once

#include <cmath>
#include <utility>

#include "joints/figure_scenes.h"
#include "reference/random_input.h"

namespace ingot_figures {

using ingot_reference::RandomInput;

/// What a tree is drawn from.
struct DrawnTree {
    int bodies;
    double mass_ratio;  ///< of any two, at most
    double spin;        ///< rad/s, of a body, before its joints have their say
    bool tied;          ///< to the world by its first body, and it has weight; else it floats without any
};
/// Each body is joined, by a joint of any kind of the five, A and B either way round, to one before it.
inline FigureScene random_tree(RandomInput& random, const DrawnTree& drawn) {
    constexpr FigureJointKind kinds[] = {FigureJointKind::ball, FigureJointKind::hinge, FigureJointKind::slider, FigureJointKind::universal,
                                         FigureJointKind::fixed};
    FigureScene scene;
    scene.name = "random tree";
    if (!drawn.tied) scene.g.setZero();
    for (int body_i = 0; body_i < drawn.bodies; ++body_i) {
        const double size = random.real(0.1, 0.4), M = std::exp(random.real(0, std::log(drawn.mass_ratio)));
        const auto side = [&] { return size * random.real(0.2, 1); };
        const Vector3d half_extents(side(), side(), side());
        const int parent = body_i == 0 ? the_world : random.integer(0, body_i - 1);
        const Vector3d anchor = parent == the_world ? Vector3d(Vector3d::Zero()) : Vector3d(scene.body(parent).r_CM + size * random.direction());
        FigureBody body = box(M, half_extents, anchor + size * random.direction(), random.rotation());
        body.omega = random.vector(drawn.spin);
        scene.add(body);
        if (body_i == 0 && !drawn.tied) continue;
        const FigureJointKind kind = kinds[random.integer(0, 4)];
        const Vector3d axis = random.direction(), across = axis.cross(Vector3d(random.direction())).normalized();
        const bool turned = parent != the_world && random.integer(0, 1) == 1;
        scene.join(
            joint_of(kind, turned ? body_i : parent, turned ? parent : body_i, anchor, axis, kind == FigureJointKind::universal ? across : axis));
    }
    hold_joints(scene);
    return scene;
}

/// A tree of 2 to most_bodies, tied by its first body or floating, which turns as a whole by up to `spin` rad/s. Its joints are of the first few of
/// ball, hinge, slider and universal; finish(joint): what else they have.
template <class Finish>
FigureScene turning_tree(RandomInput& random, int most_bodies, bool tied, double spin, int kind_count, const Finish& finish) {
    constexpr FigureJointKind kinds[] = {FigureJointKind::ball, FigureJointKind::hinge, FigureJointKind::slider, FigureJointKind::universal};
    FigureScene scene;
    const int count = random.integer(2, most_bodies);
    for (int body_i = 0; body_i < count; ++body_i) {
        const int parent = body_i == 0 ? the_world : random.integer(0, body_i - 1);
        const Vector3d P = parent == the_world ? Vector3d(0, 0, 0) : Vector3d(scene.body(parent).r_CM + random.direction() * 0.4);
        scene.add(box(random.real(1, 20), Vector3d(random.real(0.1, 0.3), random.real(0.1, 0.3), random.real(0.1, 0.3)), P + random.direction() * 0.4,
                      random.rotation()));
        if (parent == the_world && !tied) continue;
        FigureJoint joint;
        joint.kind = kinds[random.integer(0, kind_count - 1)];
        joint.body_A = parent;
        joint.body_B = body_i;
        joint.anchor = P;
        joint.axis_A = joint.axis_B = random.direction();
        if (joint.kind == FigureJointKind::universal) joint.axis_B = square_to(joint.axis_A);
        finish(joint);
        scene.join(joint);
    }
    add_motion(scene, {0, 0, 0}, random.direction() * random.real(0, spin));
    return scene;
}

/// The same whose joints all have limits, at the start between them.
inline FigureScene limited_tree(RandomInput& random, int most_bodies, bool tied, double spin) {
    return turning_tree(random, most_bodies, tied, spin, 4, [&](FigureJoint& joint) {
        joint.lower = -random.real(0.02, 0.5);
        joint.upper = random.real(0.02, 0.5);
        joint.cone = random.real(0.1, 0.6);
        joint.twist_lower = -random.real(0.02, 0.5);
        joint.twist_upper = random.real(0.02, 0.5);
        joint.restitution = random.integer(0, 2) * 0.4;
    });
}
/// One of balls and hinges, tied or not, that turns slowly.
inline FigureScene plain_tree(RandomInput& random) {
    return turning_tree(random, 8, random.integer(0, 1) == 1, 2, 2, [](FigureJoint&) {});
}
/// The last body of a tree hangs on its first by a ball, too.
inline void close_ring(RandomInput& random, FigureScene& scene) {
    FigureJoint last;
    last.kind = FigureJointKind::ball;
    last.body_A = 0;
    last.body_B = scene.body_count() - 1;
    last.anchor = scene.body(last.body_B).r_CM + random.direction() * 0.3;
    if (scene.body_count() > 2) scene.join(last);
}
inline FigureScene ring_and_tree(RandomInput& random) {
    FigureScene scene = plain_tree(random);
    close_ring(random, scene);
    return scene;
}
/// With limits, the ball that closes it in any place among the joints: so another may close it.
inline FigureScene limited_ring(RandomInput& random, int most_bodies, bool tied, double spin) {
    FigureScene scene = limited_tree(random, most_bodies, tied, spin);
    close_ring(random, scene);
    if (!scene.joints.empty()) std::swap(scene.joints.back(), scene.joints[static_cast<std::size_t>(random.integer(0, scene.joint_count() - 1))]);
    return scene;
}

}  // namespace ingot_figures
