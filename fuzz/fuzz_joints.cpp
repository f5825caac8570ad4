// SPDX-License-Identifier: MIT
// Bodies with joints of every kind: trees that grow, swing, touch, sleep, break, lose joints and bodies, are saved and copied; and calls about joints
// with any numbers at all.
//
//   A refused call leaves the world bitwise unchanged.
//   Whatever the calls were: no number that is not finite, orientations orthonormal.
//   Of sane figures, which are trees of bodies of one size and of masses within a thousand of each other, turning by no more than two radians a step:
//     joints are closed to gap_max, and to gap_in_contact where bodies touch;
//     nobody gives them energy. What a limit takes in one step it may give back in the next, and overlaps that are pushed out, and second orders of
//       turns, are allowed a hundredth of what the figure has when it falls a metre, beside its motion: the law of joint_energy_test.
//   What floats keeps its momentum to rounding: each of the 36 substeps there can be adds one for each way up and down, of what the fastest carries.
//   A copy, and a world loaded from a snapshot, step to the same bytes.
//
// INGOT_FUZZ_RUN names the function; fuzz_fault breaks a promise on purpose.
#include "figure_calls.h"

namespace {

using namespace fuzz;

using ingot::Joints;

/// Every kind of tree, and nothing touches.
struct Mobile : ingot::Scene {
    static constexpr int max_bodies = 7, max_joints = 8;
    static constexpr bool translates = true;
    using joints = Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint>;
};
/// The same with rods, ropes and what else stands beside a tree.
struct Machines : Mobile {
    static constexpr int max_loops = 3;
    using joints = Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::RodJoint,
                          ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint>;
};
/// On the ground and against each other, asleep in the end; limits, and joints that break.
struct Puppets : Mobile {
    static constexpr int max_manifolds = 24, max_pairs = 40;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using joints = Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::WithLimits,
                          ingot::WithBreaking>;
};
/// Arrays that fill.
struct Crowd : Puppets {
    static constexpr int max_manifolds = 6, max_pairs = 8, max_joints = 3;
    static constexpr bool filters = true, rolling_resistance = true;
    using joints = Mobile::joints;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 8u) {
        case 0: case 1: case 2: return Figures<Mobile>().run(in);
        case 3: return Figures<Machines>().run(in);
        case 4: case 5: case 6: return Figures<Puppets>().run(in);
        default: return Figures<Crowd>().run(in);
    }
}
