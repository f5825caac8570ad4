// SPDX-License-Identifier: MIT
// Some steps under callgrind, for kernels with and without words beyond C++17: plain_costs.py compares what they cost. Without an argument, the hash
// that each scene ends with: it is the same of all.
#include <ingot/ingot.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstring>

namespace {

using ingot::scalar;
using ingot::Vector;

struct Flying : ingot::Scene {
    static constexpr int max_bodies = 64;
    static constexpr bool translates = true;
};
struct Piled : ingot::Scene {
    static constexpr int max_bodies = 70, max_manifolds = 400;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::Sphere, ingot::HalfSpace>;
};
struct Hanging : ingot::Scene {
    static constexpr int max_bodies = 64, max_joints = 64;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};

ingot::BodyDef body(const ingot::Shape& shape, const Vector& r) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::solid_of_shape(200, shape)).value;
    def.shape = shape;
    def.state.r_CM = r;
    return def;
}
/// Bodies that turn, each in its own way.
bool set_up(ingot::World<Flying>& world) {
    bool good = world.set_gravity({0, 0, scalar(-9.81)}) == ingot::Status::ok;
    for (int i = 0; i < 64; ++i) {
        ingot::BodyDef def = body(ingot::Box{{scalar(0.5), scalar(0.3), scalar(0.1)}}, {static_cast<scalar>(i), 0, 0});
        def.shape = {};
        def.state.L = {scalar(0.01) * static_cast<scalar>(i), 1, scalar(0.1)};
        good = world.add(def).ok() && good;
    }
    return good;
}
/// Half boxes, half balls, which fall on each other: sixteen columns of four.
bool set_up(ingot::World<Piled>& world) {
    bool good = world.set_gravity({0, 0, scalar(-9.81)}) == ingot::Status::ok;
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    good = world.add(ground).ok() && good;
    for (int i = 0; i < 64; ++i) {
        const Vector at = {static_cast<scalar>(i % 4), static_cast<scalar>(i / 4 % 4), scalar(0.6) + static_cast<scalar>(i / 16)};
        ingot::Shape shape = ingot::Sphere{scalar(0.45)};
        if (i % 2 == i / 16 % 2) shape = ingot::Box{{scalar(0.45), scalar(0.45), scalar(0.45)}};
        good = world.add(body(shape, at)).ok() && good;
    }
    return good;
}
/// Sixteen chains of four.
bool set_up(ingot::World<Hanging>& world) {
    bool good = world.set_gravity({0, 0, scalar(-9.81)}) == ingot::Status::ok;
    for (int i = 0; i < 64; ++i) {
        const Vector at = {scalar(0.4) * static_cast<scalar>(i % 4), static_cast<scalar>(i / 4), 0};
        ingot::BodyDef link = body(ingot::Box{{scalar(0.2), scalar(0.05), scalar(0.05)}}, at + Vector{scalar(0.2), 0, 0});
        link.shape = {};
        const ingot::Result<ingot::BodyId> id = world.add(link);
        ingot::JointDef def;
        if (i % 4 > 0) def.body_A = world.body_at(i - 1);
        def.body_B = id.value;
        def.P = at;
        def.axis = {0, 1, 0};
        def.joint = ingot::HingeJoint{};
        if (i % 2 == 0) def.joint = ingot::BallJoint{};
        good = id.ok() && world.add_joint(def).ok() && good;
    }
    return good;
}

template <class S>
ingot::World<S> world_of{};
/// 60 steps of 1/60 s, of which callgrind is told the last 20.
template <class S>
bool run(const char* name, const char* asked) {
    if (asked && std::strcmp(name, asked) != 0) return true;
    ingot::World<S>& world = world_of<S>;
    bool good = set_up(world);
    for (int step_i = 0; step_i < 60; ++step_i) {
        if (step_i == 40) {
            CALLGRIND_START_INSTRUMENTATION;
            CALLGRIND_TOGGLE_COLLECT;
        }
        good = ingot::step(world, scalar(1) / 60).status == ingot::Status::ok && good;
    }
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS;
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(world.state_hash()));
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    const char* const asked = argc > 1 ? argv[1] : nullptr;
    const bool good = run<Flying>("flying", asked) && run<Piled>("piled", asked) && run<Hanging>("hanging", asked);
    return good ? 0 : 1;
}
