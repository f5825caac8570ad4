// SPDX-License-Identifier: MIT
// Joints: what two bodies, or a body and the world, may still do against each other.
#pragma once

#include "../base/ids.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

enum class JointKind : uint8_t { none, ball, hinge, slider, universal, fixed };

/// Of any kind; the kinds below convert to it.
struct Joint {
    JointKind kind{};
};

/// Free in all turns about P: a shoulder, a link of a chain.
struct BallJoint {
    static constexpr JointKind kind = JointKind::ball;
    constexpr operator Joint() const { return {kind}; }
};
/// Turns about an axis: a door, an elbow.
struct HingeJoint {
    static constexpr JointKind kind = JointKind::hinge;
    constexpr operator Joint() const { return {kind}; }
};
/// Goes along an axis, and does not turn: a piston.
struct SliderJoint {
    static constexpr JointKind kind = JointKind::slider;
    constexpr operator Joint() const { return {kind}; }
};
/// Turns about an axis of A and about an axis of B, which stay at right angles: a cardan.
struct UniversalJoint {
    static constexpr JointKind kind = JointKind::universal;
    constexpr operator Joint() const { return {kind}; }
};
/// Neither turns nor goes: two bodies that are one.
struct FixedJoint {
    static constexpr JointKind kind = JointKind::fixed;
    constexpr operator Joint() const { return {kind}; }
};

/// `using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;` of a scene: the kinds it has.
template <class... Kinds>
struct Joints {
    static constexpr bool has([[maybe_unused]] JointKind kind) { return ((Kinds::kind == kind) || ...); }
    /// Whether some are no balls: their free directions are eliminated one by one.
    static constexpr bool has_axes = ((Kinds::kind != JointKind::ball) || ...);
};

/// What World::add_joint needs to know. The bodies are joined as they are now: a hinge has the angle 0.
struct JointDef {
    BodyId body_A{}, body_B{};     ///< the null id: the world
    Joint joint{};
    Vector P{};                    ///< m, world
    Vector axis = {0, 0, 1};       ///< unit, world: of a hinge, a slider, of A of a universal joint
    Vector axis_B = {1, 0, 0};     ///< unit, world, at right angles to axis: of B of a universal joint
    bool bodies_meet = false;      ///< the two may touch each other
};

/// Names one joint of one world for as long as it is there, as BodyId does a body.
struct JointId {
    Index slot{};
    uint16_t world_tag{};
    uint32_t generation{};

    constexpr bool operator==(const JointId& other) const {
        return slot == other.slot && world_tag == other.world_tag && generation == other.generation;
    }
    constexpr bool operator!=(const JointId& other) const { return !(*this == other); }
};

} }  // namespace ingot
