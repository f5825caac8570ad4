// SPDX-License-Identifier: MIT
// Walkers and an arm in one build of the kernel. Compiled for float and for double, each in a namespace of its own.
#include <ingot/ingot.h>
#define scenes INGOT_JOIN(scenes_, INGOT_ABI, )

#include "control_cases.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "scenes/arm_paths.h"
#include "scenes/servo_steps.h"
#include "scenes/walker_in_space.h"

namespace report {

namespace {

using ingot::scalar;
using ingot::Status;
using Found = std::vector<OfMachine>;

struct InPlane {
    using Scene = scenes::WalkingInPlane;
    scenes::Walker walker;
    scenes::Gait gait;
    static constexpr const char* name = "walker in the plane";
    bool add(ingot::World<Scene>& world) { return scenes::add_walker(world, {0, 0, 0}, scalar(0.8), walker) == Status::ok; }
    ingot::BodyId body() const { return walker.trunk; }
};
struct InSpace {
    using Scene = scenes::WalkingInSpace;
    scenes::SpatialWalker walker;
    scenes::SpatialGait gait;
    static constexpr const char* name = "walker in space";
    bool add(ingot::World<Scene>& world) { return scenes::add_walker(world, scalar(0.6), walker) == Status::ok; }
    ingot::BodyId body() const { return walker.pelvis; }
};

/// A walker for so many seconds, or until it falls, with torques of `most` N m; 0: as many as it likes.
template <class Machine>
void walk(double seconds, int rate, int most, Found& found) {
    Machine machine;
    if (most > 0) machine.gait.max_torque = static_cast<scalar>(most);
    const std::string name = most > 0 ? std::string(Machine::name) + ", " + std::to_string(most) + " N m" : Machine::name;
    const auto world = std::make_unique<ingot::World<typename Machine::Scene>>();
    scenes::WalkState state;
    bool sound = scenes::add_ground(*world) == Status::ok && machine.add(*world);
    const scalar h = 1 / static_cast<scalar>(rate), begin = world->state(machine.body()).value.r_CM.z;
    const int steps = static_cast<int>(seconds * rate + 0.5);
    int walked = 0, unsettled = 0;
    double ns = 0, gap = 0, depth = 0;
    for (; sound && walked < steps && world->state(machine.body()).value.r_CM.z > scalar(0.7) * begin; ++walked) {
        const auto from = std::chrono::steady_clock::now();
        sound = scenes::walk(*world, machine.walker, machine.gait, state, h) == Status::ok;
        unsettled += ingot::step(*world, h).clean() ? 0 : 1;
        ns += std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - from).count();
        for (int side = 0; side < 2; ++side)
            for (const ingot::JointId id : {machine.walker.hip[side], machine.walker.knee[side], machine.walker.ankle[side]})
                gap = std::max(gap, static_cast<double>(world->joint_gap(id).value));
        for (const ingot::BodyId foot : machine.walker.foot)
            for (const ingot::ContactInfo& contact : world->contacts_of(foot)) depth = std::max(depth, -static_cast<double>(contact.separation));
    }
    const auto add = [&](const char* metric, double value, const char* unit) {
        found.push_back({name, static_cast<double>(rate), metric, value, unit});
    };
    add("walked", walked / static_cast<double>(rate), "s");
    add("distance", static_cast<double>(world->state(machine.body()).value.r_CM.x), "m");
    add("unsettled", unsettled, "1");
    add("gap", gap, "m");
    add("depth", depth, "m");
    add("us_per_step", ns / 1000 / std::max(1, walked), "us");
}

/// What a servo does with a step of its target.
void turn(int rate, Found& found) {
    const auto add = [&](const char* metric, double value, const char* unit) {
        found.push_back({"servo", static_cast<double>(rate), metric, value, unit});
    };
    add("off_after_four_steps", scenes::off_after_four_steps(rate), "rad");
    add("ball_off_after_four_steps", scenes::ball_off_after_four_steps(rate), "rad");
    double settling = 0, tuned = 0;
    for (const double most : {0.1, 1.0, 10.0}) settling = std::max(settling, scenes::settling_ratio(rate, most));
    for (const double hertz : {1.0, 2.0, 5.0})
        for (const double ratio : {0.1, 0.5, 1.0, 2.0}) tuned = std::max(tuned, scenes::tuned_off(rate, hertz, ratio, true));
    add("settling_ratio", settling, "1");
    add("tuned_off", tuned, "rad");
    add("motor_off", scenes::motor_off(rate), "1");
    add("load_off", scenes::load_off(rate), "1");
    add("momentum_off", scenes::momentum_off(rate, 0), "1");
}

void follow(int paths, int rate, Found& found) {
    ingot_reference::RandomInput random(1);
    double by_torques = 0, by_servos = 0;
    for (int path_i = 0; path_i < paths; ++path_i) {
        const scenes::Waves waves(random);
        by_torques = std::max(by_torques, scenes::off_by_torques(waves, rate));
        by_servos = std::max(by_servos, scenes::off_by_servos(waves, rate));
    }
    found.push_back({"arm of six hinges", static_cast<double>(rate), "off_by_torques", by_torques, "rad"});
    found.push_back({"arm of six hinges", static_cast<double>(rate), "off_by_servos", by_servos, "rad"});
}

ControlFigures figures(double seconds, int paths) {
    ControlFigures all;
    all.scalar = sizeof(scalar) == 4 ? "float" : "double";
    all.lanes = ingot::lanes;
    for (const int rate : {30, 60, 120, 240}) turn(rate, all.of);
    for (const int most : {0, 100, 150, 200}) {
        for (const int rate : {30, 60, 120, 240}) walk<InPlane>(seconds, rate, most, all.of);
        for (const int rate : {30, 60, 120}) walk<InSpace>(seconds, rate, most, all.of);
    }
    for (const int rate : {30, 60, 120, 240}) follow(paths, rate, all.of);
    return all;
}

}  // namespace

#if INGOT_DOUBLE
ControlFigures control_figures_of_double(double seconds, int paths) { return figures(seconds, paths); }
#else
ControlFigures control_figures_of_float(double seconds, int paths) { return figures(seconds, paths); }
#endif

}  // namespace report
