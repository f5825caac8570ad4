// SPDX-License-Identifier: MIT
#include "read_joint.h"

#include "../math/sqrt.h"
#include "driven_motion.h"
#include "measure_joint.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A as the parent, B as the child.
JointSides<scalar> sides_of(const JointRecord& joint, const JointPair& bodies) {
    const auto motion_of = [](const JointBody& body) { return SideMotion<scalar>{body.r_CM, body.A, body.v_CM, body.omega, {}}; };
    return sides_at(motion_of(bodies.B), joint.frame_B, motion_of(bodies.A), joint.frame_A);
}

}  // namespace

JointReading joint_values(const JointRecord& joint, const JointPair& bodies) {
    const JointValues<scalar> values = measure(joint.kind, sides_of(joint, bodies));
    return {{values.of[0], values.of[1]}};
}

Vector ball_turn(const JointRecord& joint, const JointPair& bodies) {
    const JointSides<scalar> sides = sides_of(joint, bodies);
    const Matrix of_A = triad_of(sides.axis_of_parent, sides.side_of_parent), of_B = triad_of(sides.axis, sides.side);
    return transpose_times(bodies.A.A, rotation_vector_of(times_transposed(of_B, of_A)));
}

Vector ball_rate(const JointPair& bodies) { return transpose_times(bodies.A.A, bodies.B.omega - bodies.A.omega); }

scalar angle_over_turns(scalar angle, const AngleRecord& last) {
    int32_t turns = 0;
    return nearest_turn(angle, last.angle + static_cast<scalar>(last.turns) * whole_turn, turns);
}

scalar misfit_of(const JointRecord& joint, const JointPair& bodies) {
    const JointSides<scalar> sides = sides_of(joint, bodies);
    const bool is_parallel = joint.kind == JointKind::parallel;
    const bool holds_axis = joint.kind == JointKind::hinge || is_parallel || locks_turns(joint.kind);
    if (holds_axis && !(dot(sides.axis, sides.axis_of_parent) > 0)) return scalar_max;
    if (locks_turns(joint.kind) && !(dot(sides.side, sides.side_of_parent) > 0)) return scalar_max;
    const Spatial<scalar> back = twist_back(is_parallel ? JointKind::hinge : joint.kind, sides);
    return sqrt(max(is_parallel ? scalar(0) : length_sq(back.v), length_sq(back.w)));
}

scalar steering_angle(const JointRecord& joint, const JointPair& bodies) { return steering_of(joint.kind, sides_of(joint, bodies)); }

scalar steering_rate(const JointRecord& joint, const JointPair& bodies) {
    return dot(sides_of(joint, bodies).axis_of_parent, bodies.B.omega - bodies.A.omega);
}

JointReading joint_rates(const JointRecord& joint, const JointPair& bodies) {
    const JointSides<scalar> sides = sides_of(joint, bodies);
    const Vector w = bodies.B.omega - bodies.A.omega;
    const auto speed_along = [&](const Vector& n) {
        const Vector to_B = bodies.B.A * joint.frame_B.anchor, to_A = bodies.B.r_CM + to_B - bodies.A.r_CM;
        return dot(n, bodies.B.v_CM + cross(bodies.B.omega, to_B) - bodies.A.v_CM - cross(bodies.A.omega, to_A));
    };
    switch (joint.kind) {
        case JointKind::ball: return {{dot(along_direction(joint.kind, 0, sides), w), dot(along_direction(joint.kind, 1, sides), w)}};
        case JointKind::hinge: return {{dot(sides.axis, w), 0}};
        case JointKind::universal: return {{dot(sides.axis_of_parent, w), dot(sides.axis, w)}};
        case JointKind::slider: return {{speed_along(sides.axis_of_parent), 0}};
        case JointKind::wheel: return {{dot(sides.axis, w), speed_along(sides.axis_of_parent)}};
        default: return {};
    }
}

} }  // namespace ingot
