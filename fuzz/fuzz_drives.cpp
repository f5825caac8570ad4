// SPDX-License-Identifier: MIT
// What fuzz_joints.cpp asks of trees, of figures that are driven, geared, served and closed to loops, that touch or do not: whatever drives do,
// numbers are finite and copies step to the same bytes; with brakes alone, which take and do not give, joints and gears are closed and energy does
// not rise.
#include "figure_calls.h"

namespace {

using namespace fuzz;

using ingot::Joints;

struct Driven : ingot::Scene {
    static constexpr int max_bodies = 7, max_joints = 10, max_loops = 4;
    static constexpr bool translates = true;
    using joints = Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::RodJoint,
                          ingot::RopeJoint, ingot::ParallelJoint, ingot::TargetJoint, ingot::ServoJoint, ingot::BallServoJoint, ingot::GearJoint,
                          ingot::WithLimits, ingot::WithDrives, ingot::WithBreaking>;
};
/// On the ground and against each other, asleep in the end.
struct Robots : Driven {
    static constexpr int max_manifolds = 24, max_pairs = 40;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
/// Trees alone: drives stand in their factors.
struct Arms : Driven {
    static constexpr int max_loops = 1;
    using joints = Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint, ingot::GearJoint,
                          ingot::WithLimits, ingot::WithDrives>;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 4u) {
        case 0: case 1: return Figures<Driven>().run(in);
        case 2: return Figures<Robots>().run(in);
        default: return Figures<Arms>().run(in);
    }
}
