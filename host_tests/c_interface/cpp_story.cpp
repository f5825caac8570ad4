// SPDX-License-Identifier: MIT
// The stories of c_story.c: to the kernel by scenes of its own, and, as far as is_there goes, to the C interface from C++. Prints both hashes three
// times, as c_story does.
#include <ingot/ingot.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "ingot_c.h"

namespace {

using ingot::scalar;

/// As much as the stories need of what the catalogue's worlds have. Room for loops is part of it: figures of scenes that may close loops are solved
/// by other sums, whether there is one or not.
struct Own : ingot::Scene {
    static constexpr int max_bodies = 16, max_manifolds = 48, max_joints = 8, max_loops = 2;
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

struct Machines : Own {
    static constexpr int max_events = 8, max_overlaps = 4;
    static constexpr bool filters = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::FixedJoint, ingot::RodJoint, ingot::RopeJoint,
                                 ingot::WithLimits, ingot::WithDrives>;
};

/// What the second story puts and joins, and how it goes on.
class MachineStory {
public:
    unsigned long long told() {
        using ingot::Status;
        const scalar quarter = scalar(0.25), half = scalar(0.5);
        good = world->set_gravity({0, 0, scalar(-9.75)}) == Status::ok;
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        good = good && world->add(ground).ok();
        const ingot::BodyId arm = box({1, 0, 2}), bob = ball({0, 4, 2}), cart = box({0, 8, 1});
        const ingot::BodyId hung = ball({half, 12, 2}), roped = ball({half, 16, 2});
        const ingot::BodyId twin = box({half, 24, 2}), platform = box({0, 20, half}, true), rider = box({0, 20, 1}), ghost = box({8, 0, 1});
        const ingot::BodyId dropped = box({12, 0, 1});
        ingot::BodyDef sensor;
        sensor.immovable = sensor.sensor = true;
        sensor.shape = ingot::Sphere{1};
        sensor.state.r_CM = {12, 0, 0};
        good = good && world->add(sensor).ok();
        const ingot::JointId hinge = join(ingot::HingeJoint{-half, quarter}, arm, {0, 0, 2}, {0, 1, 0});
        ingot::BallJoint in_cone;
        in_cone.cone = half;
        const ingot::JointId shoulder = join(in_cone, bob, {0, 4, 3}, {0, 0, 1});
        const ingot::JointId slider = join(ingot::SliderJoint{0, quarter}, cart, {0, 8, 1}, {1, 0, 0});
        (void)join(ingot::RodJoint{}, hung, {0, 12, 3}, {0, 0, 1});
        const ingot::JointId rope = join(ingot::RopeJoint{}, roped, {0, 16, 3}, {0, 0, 1});
        (void)join(ingot::FixedJoint{}, twin, {0, 24, 2}, {0, 0, 1});
        ingot::TunedDrive servo;
        servo.hertz = 2;
        servo.target = scalar(0.125);
        must(world->set_joint_drive(hinge, servo));
        must(world->set_ball_drive(shoulder, ingot::SpringDrive{40, 4}, {quarter, 0, 0}));
        must(world->set_joint_drive(slider, ingot::MotorDrive{half, 4000}));
        must(world->set_joint_length(rope, scalar(1.25)));
        must(world->set_filter(ghost, {2, 0}));
        must(world->set_velocity(platform, {half, 0, 0}));
        must(world->apply_angular_impulse(hung, {0, 0, scalar(0.125)}));
        for (int step_i = 0; step_i < 90; ++step_i) {
            must(world->add_torque(bob, {0, 0, scalar(0.125)}));
            must(ingot::step(*world, scalar(0.015625)).status);
        }
        must(world->set_joint_target(hinge, 1));
        (void)world->sleep(rider);
        must(world->wake(rider));
        must(world->set_joint_limits(hinge, ingot::Joint(ingot::HingeJoint{-half, half}).limits));
        must(world->remove(dropped));
        for (int step_i = 0; step_i < 90; ++step_i) must(ingot::step(*world, scalar(0.015625)).status);
        return good ? world->state_hash() : 0;
    }

private:
    void must(ingot::Status status) { good = good && status == ingot::Status::ok; }
    ingot::BodyId added(const ingot::BodyDef& def) {
        const ingot::Result<ingot::BodyId> id = world->add(def);
        must(id.status);
        return id.value;
    }
    ingot::BodyId box(const ingot::Vector& r, bool kinematic = false) {
        const ingot::Vector half_extents = {scalar(0.25), scalar(0.25), scalar(0.25)};
        ingot::BodyDef def;
        def.kinematic = kinematic;
        if (!kinematic) def.mass = ingot::principal(ingot::solid_box(1000, half_extents)).value;
        def.shape = ingot::Box{half_extents};
        def.state.r_CM = r;
        return added(def);
    }
    ingot::BodyId ball(const ingot::Vector& r) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_sphere(1000, scalar(0.25))).value;
        def.shape = ingot::Sphere{scalar(0.25)};
        def.state.r_CM = r;
        return added(def);
    }
    ingot::JointId join(const ingot::Joint& joint, ingot::BodyId B, const ingot::Vector& P, const ingot::Vector& axis) {
        ingot::JointDef def;
        def.joint = joint;
        def.body_B = B;
        def.P = P;
        def.axis = axis;
        def.P_B = world->state(B).value.r_CM;
        const ingot::Result<ingot::JointId> id = world->add_joint(def);
        must(id.status);
        return id.value;
    }

    std::unique_ptr<ingot::World<Machines>> world = std::make_unique<ingot::World<Machines>>();
    bool good = true;
};

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
    const unsigned long long hash = told_to_kernel(), of_machines = MachineStory().told();
    for (int i = 0; i < 3; ++i) std::printf("%016llx\n%016llx\n", hash, of_machines);
    return hash != 0 && of_machines != 0 && is_there() ? 0 : 1;
}
