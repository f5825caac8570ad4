// SPDX-License-Identifier: MIT
// Prints the states of random figures, some of one form, some not, swinging and in a heap: the same with any number of lanes.
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "cars.h"
#include "figures.h"

namespace {

using namespace figures;

struct Pit : ingot::Scene {
    static constexpr int max_bodies = 130, max_joints = 110, max_manifolds = 500, max_pairs = 2000;
    static constexpr bool translates = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

struct SwingingPit : Pit {
    using figure_motion = ingot::EnergyMomentum<>;
};
/// And fall fast.
struct LimitedPit : Pit {
    static constexpr bool continuous = true;
    using joints = AllJointsWith<ingot::WithLimits>;
};

struct DrivenPit : Pit {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};

struct LoopedPit : Pit {
    static constexpr int max_loops = 3;
};

/// What is joined breaks.
struct BreakingPit : Pit {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithBreaking>;
};
struct BreakingSwings : SwingingPit {
    using joints = AllJointsWith<ingot::WithBreaking>;
};
struct BreakingLoops : LoopedPit {
    using joints = AllJointsWith<ingot::WithBreaking>;
};
template <class World>
void weaken(World& world, RandomInput& random, const Built& built) {
    for (const ingot::JointId id : built.joints)
        (void)world.set_joint_strength(id, {static_cast<scalar>(random.real(100, 2000)), static_cast<scalar>(random.real(50, 1000))});
}
template <class World>
void print_breaks(const World& world) {
    for (const ingot::JointBreak& broken : world.broken_joints())
        std::printf("    joint %d: %a N, %a N m\n", broken.joint.slot, static_cast<double>(broken.reaction.force.z),
                    static_cast<double>(broken.reaction.torque.x));
}

struct TiedPit : LoopedPit {
    static constexpr int max_joints = 140, max_loops = 30;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint>;
};

/// Ragdolls hang together by the head, some by rods, some by ropes; and pairs of bodies fly on a rod.
template <class World>
void tie_some(World& world, Built& built) {
    const auto tie = [&](ingot::BodyId A, ingot::BodyId B, const ingot::Joint& kind) {
        ingot::JointDef def;
        def.body_A = A;
        def.body_B = B;
        def.joint = kind;
        def.P = world.state(A).value.r_CM;
        def.P_B = world.state(B).value.r_CM;
        built.sound = built.sound && world.add_joint(def).ok();
    };
    for (size_t i = 0; i < 4; ++i) {
        const ingot::BodyId A = built.bodies[i * parts_of_ragdoll], B = built.bodies[(i + 1) * parts_of_ragdoll];
        if (i % 2 == 0)
            tie(A, B, ingot::RodJoint{});
        else
            tie(A, B, ingot::RopeJoint{scalar(1.5)});
    }
    for (int i = 0; i < 9; ++i) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(100 * (i + 1)), {scalar(0.1), scalar(0.1), scalar(0.1)})).value;
        def.state.r_CM = {static_cast<scalar>(i), 100, 50};
        const ingot::BodyId A = world.add(def).value;
        def.state.r_CM.z = 51;
        def.state.v_CM = {1, static_cast<scalar>(i), 0};
        tie(A, world.add(def).value, ingot::RodJoint{});
    }
}

/// Two of the ragdolls hold their own hands, and a figure that swings is tied once more.
template <class World>
void close_some_loops(World& world, Built& built) {
    for (const size_t first : {size_t{0}, size_t{2} * parts_of_ragdoll}) {
        ingot::JointDef hands;
        hands.body_A = built.bodies[first + 4];
        hands.body_B = built.bodies[first + 6];
        hands.joint = ingot::BallJoint{};
        hands.P = (world.state(hands.body_A).value.r_CM + world.state(hands.body_B).value.r_CM) * scalar(0.5);
        built.sound = built.sound && world.add_joint(hands).ok();
    }
    ingot::JointDef tie;
    tie.body_A = built.bodies.back();
    tie.joint = ingot::HingeJoint{};
    tie.P = world.state(tie.body_A).value.r_CM;
    built.sound = built.sound && world.add_joint(tie).ok();
}

template <class Scene>
bool run(const char* name) {
    const auto world = std::make_unique<ingot::World<Scene>>();
    RandomInput random(11);
    Built built;
    built.sound = add_ground(*world) && weigh(*world);
    for (int i = 0; i < 5; ++i)
        add_ragdoll(*world, {scalar(0.3) * static_cast<scalar>(i % 2), 0, scalar(0.3) + static_cast<scalar>(i)},
                    ingot_reference::to_matrix(random.rotation()), built);
    for (int i = 0; i < 5; ++i) add_figure(*world, random, {2 + 2 * i, 0.4, 100, 3, i % 2 == 0}, {0, 20.0 * i + 20, 60}, built);
    if constexpr (Scene::continuous)
        for (const ingot::BodyId id : built.bodies)
            (void)world->apply_central_impulse(id, {0, world->mass(id).value * 5, world->mass(id).value * -40});
    if constexpr (Scene::joints::has_drives)
        for (const ingot::JointId id : built.joints) {
            const ingot::JointDrive drive = ingot::SpringDrive{200, 5, 0, 0, 0, 50};
            if (world->set_joint_drive(id, drive) != ingot::Status::ok) (void)world->set_ball_drive(id, drive);
        }
    if constexpr (Scene::max_loops > 0) close_some_loops(*world, built);
    if constexpr (Scene::joints::may_break) weaken(*world, random, built);
    if constexpr (Scene::joints::has_ties) tie_some(*world, built);
    for (int step_i = 0; step_i < 120; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        if constexpr (Scene::joints::may_break) print_breaks(*world);
        std::printf("%s %d %016" PRIx64 "\n", name, step_i, world->state_hash());
    }
    return built.sound;
}

/// Five cars, of which one is longer, and each is driven, braked or steered otherwise.
struct CarPark : ingot::Scene {
    static constexpr int max_bodies = 26, max_joints = 20, max_manifolds = 100, max_pairs = 400;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::WheelJoint, ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
bool run_cars() {
    const auto world = std::make_unique<ingot::World<CarPark>>();
    bool sound = add_ground(*world) && weigh(*world);
    for (int i = 0; i < 5; ++i) {
        cars::CarSize size;
        size.base += i == 3 ? 0.5 : 0;
        const cars::Car car = cars::add_car(*world, size, 2 * i, 0.1 * i, 8 * i);
        sound = sound && car.sound && cars::steer_car(*world, car, 10 + 5 * i);
        if (i % 2 == 0) sound = sound && cars::drive_wheels(*world, car, ingot::MotorDrive{static_cast<scalar>(2 * i)}, 2);
    }
    for (int step_i = 0; step_i < 120; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        std::printf("cars %d %016" PRIx64 "\n", step_i, world->state_hash());
    }
    return sound;
}

}  // namespace

int main() {
    const bool plain = run<Pit>("substeps"), limited = run<LimitedPit>("limits"), driven = run<DrivenPit>("drives"),
               looped = run<LoopedPit>("loops"), tied = run<TiedPit>("ties"), swinging = run<SwingingPit>("energy_momentum");
    const bool breaking = run<BreakingPit>("breaking"), swings = run<BreakingSwings>("breaking swings"), loops = run<BreakingLoops>("breaking loops");
    return plain && limited && driven && looped && tied && swinging && breaking && swings && loops && run_cars() ? 0 : 1;
}
