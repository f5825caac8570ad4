// SPDX-License-Identifier: MIT
// What equations of motion cost: of a chain of hinges, at its end, so that the way to the root is all of it.
#include "figure_dynamics.h"

#include <ingot/ingot.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

namespace {

using ingot::BodyId;
using ingot::scalar;

constexpr int most = 64;

struct Chain : ingot::Scene {
    static constexpr int max_bodies = most, max_joints = most;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::HingeJoint>;
};
ingot::World<Chain> world;
ingot::FigureDynamics<most> figure;
scalar numbers[most] = {}, torques[most] = {}, matrix[most * most] = {};

BodyId add_chain(int count) {
    BodyId last{};
    for (int i = 0; i < count; ++i) {
        ingot::BodyDef link;
        link.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
        link.state.r_CM = {scalar(i), 0, 0};
        const BodyId id = world.add(link).value;
        ingot::JointDef hinge;
        hinge.body_A = last;
        hinge.body_B = id;
        hinge.joint = ingot::HingeJoint{};
        hinge.P = {scalar(i) - scalar(0.5), 0, 0};
        hinge.axis = {0, i % 2 == 0 ? scalar(1) : scalar(0), i % 2 == 0 ? scalar(0) : scalar(1)};
        if (!world.add_joint(hinge).ok()) return {};
        last = id;
    }
    return last;
}

/// One of the calls of a name, by its first letters; articulated inertias are made anew in each.
bool ask(const char* what, BodyId end) {
    const int count = figure.direction_count();
    if (std::strncmp(what, "read", 4) == 0) return world.read_dynamics(end, figure) == ingot::Status::ok;
    if (std::strncmp(what, "inverse", 7) == 0) return figure.inverse_dynamics(numbers, torques, count) == ingot::Status::ok;
    if (std::strncmp(what, "gravity", 7) == 0) return figure.gravity_torques(torques, count) == ingot::Status::ok;
    if (std::strncmp(what, "inertia", 7) == 0) return figure.effective_inertia(count - 1).ok();
    if (std::strncmp(what, "transpose", 9) == 0) return figure.transpose_torques(end, {}, {1, 2, 3}, {}, torques, count) == ingot::Status::ok;
    return figure.mass_matrix(matrix, count * count) == ingot::Status::ok;
}

}  // namespace

bool ask_dynamics(const char* name) {
    for (const char* const what : {"read", "inverse", "gravity", "inertia", "transpose", "matrix"})
        for (const int count : {8, most}) {
            char called[32];
            std::snprintf(called, sizeof called, "%s_%d", what, count);
            if (std::strcmp(name, called) != 0) continue;
            const BodyId end = add_chain(count);
            bool good = world.read_dynamics(end, figure) == ingot::Status::ok && figure.body_count() == count;
            CALLGRIND_START_INSTRUMENTATION;
            CALLGRIND_TOGGLE_COLLECT;
            good = ask(what, end) && good;
            CALLGRIND_TOGGLE_COLLECT;
            CALLGRIND_DUMP_STATS;
            if (good) return true;
            std::fprintf(stderr, "host_costs: there is no chain\n");
            std::exit(1);
        }
    return false;
}
