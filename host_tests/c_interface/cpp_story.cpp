// SPDX-License-Identifier: MIT
// The story of c_story.c: to the C interface from C++, and to the kernel by a scene of its own. Prints the hash three times, as c_story does.
#include <ingot/ingot.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "ingot_c.h"

namespace {

using ingot::scalar;

struct Own : ingot::Scene {
    static constexpr int max_bodies = 16, max_manifolds = 48, max_joints = 8;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::HingeJoint>;
};

unsigned long long told_to_kernel() {
    const auto world = std::make_unique<ingot::World<Own>>();
    bool good = world->set_gravity({0, 0, scalar(-9.75)}) == ingot::Status::ok;
    ingot::BodyDef def;
    def.immovable = true;
    def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    good = good && world->add(def).ok();
    ingot::BodyId top;
    for (int i = 0; i < 5; ++i) {
        ingot::BodyDef box;
        const ingot::Vector half_extents = {scalar(0.25), scalar(0.25), scalar(0.25)};
        box.mass = ingot::principal(ingot::solid_box(500, half_extents)).value;
        box.shape = ingot::Box{half_extents};
        box.state.r_CM = {0, 0, scalar(0.25) + scalar(0.5) * static_cast<scalar>(i)};
        top = world->add(box).value;
    }
    ingot::BodyDef bob;
    bob.mass = ingot::principal(ingot::solid_sphere(1000, scalar(0.25))).value;
    bob.shape = ingot::Sphere{scalar(0.25)};
    bob.state = ingot::body_state(bob.mass, {{2, 0, 4}}, {{}, {0, scalar(0.5), 0}});
    ingot::JointDef hinge;
    hinge.body_B = world->add(bob).value;
    hinge.joint = ingot::HingeJoint{};
    hinge.P = {3, 0, 4};
    hinge.axis = {0, 1, 0};
    good = good && world->add_joint(hinge).ok();
    for (int i = 0; i < 60; ++i) good = good && ingot::step(*world, scalar(0.015625)).clean();
    const ingot::Vector P = world->cast_ray({0, 0, 10}, {0, 0, -20}).value.P;
    good = good && world->apply_impulse(top, {60, 20, 0}, P) == ingot::Status::ok;
    for (int i = 0; i < 60; ++i) good = good && ingot::step(*world, scalar(0.015625)).status == ingot::Status::ok;
    return good ? world->state_hash() : 0;
}

/// From C++ the interface is the same one: as far as it goes without the rest of the story.
bool is_there() {
    std::vector<unsigned char> memory(ingot_world_size(INGOT_SMALL) + ingot_world_alignment());
    void* at = memory.data();
    std::size_t room = memory.size();
    if (std::align(ingot_world_alignment(), ingot_world_size(INGOT_SMALL), at, room) == nullptr) return false;
    IngotWorld* const world = ingot_world_begin(INGOT_SMALL, at, room);
    IngotBodyDef def;
    ingot_body_def(&def);
    def.shape = INGOT_BOX;
    def.size[0] = def.size[1] = def.size[2] = 1;
    IngotBody body = 0;
    return ingot_add_body(world, &def, &body) == INGOT_OK && ingot_step(world, IngotScalar(0.01), nullptr) == INGOT_OK &&
           ingot_body_count(world) == 1 && ingot_determinism_version() == INGOT_DETERMINISM_VERSION;
}

}  // namespace

int main() {
    const unsigned long long hash = told_to_kernel();
    for (int i = 0; i < 3; ++i) std::printf("%016llx\n", hash);
    return hash != 0 && is_there() ? 0 : 1;
}
