// SPDX-License-Identifier: MIT
// Figures with their controllers, for firmware, golden hashes and counts: they walk in the plane and in space, balance on two wheels, turn in the
// air; and vehicles.
//
// Each has what its controller keeps between two steps: begin sets up, steer is called before each step of 1/60 s.
#pragma once

#include "balancing.h"
#include "quadrotor.h"
#include "tank.h"
#include "vehicle.h"
#include "walker_in_space.h"

namespace scenes {

inline constexpr ingot::scalar sixtieth = ingot::scalar(1) / 60;  ///< s

/// With a cap on what a step costs, to which the first one comes, in which both feet land.
struct PlanarWalk {
    struct Scene : WalkingInPlane {
        static constexpr int work_budget = 84;
    };
    static constexpr const char* name = "walker";
    static constexpr int golden_steps = 300;
    Walker walker{};
    Gait gait{};
    WalkState state{};

    ingot::Status begin(ingot::World<Scene>& world) {
        const ingot::Status status = add_ground(world);
        return status == ingot::Status::ok ? add_walker(world, {0, 0, 0}, ingot::scalar(0.8), walker) : status;
    }
    ingot::Status steer(ingot::World<Scene>& world) { return walk(world, walker, gait, state, sixtieth); }
    bool is_well(const ingot::World<Scene>& world) const { return height_of(world, walker) > ingot::scalar(0.9) && state.steps > 10; }
};

struct SpatialWalk {
    using Scene = WalkingInSpace;
    static constexpr const char* name = "walker_in_space";
    static constexpr int golden_steps = 300;
    SpatialWalker walker{};
    SpatialGait gait{};
    WalkState state{};

    ingot::Status begin(ingot::World<Scene>& world) {
        const ingot::Status status = add_ground(world);
        return status == ingot::Status::ok ? add_walker(world, ingot::scalar(0.6), walker) : status;
    }
    ingot::Status steer(ingot::World<Scene>& world) { return walk(world, walker, gait, state, sixtieth); }
    bool is_well(const ingot::World<Scene>& world) const { return world.state(walker.pelvis).value.r_CM.z > ingot::scalar(0.7) && state.steps > 10; }
};

/// The gains are those of an LQR for 60 steps a second: host_tests/control/balance_test.cpp.
struct BalancedWalk {
    using Scene = TwoWheels;
    static constexpr const char* name = "two_wheels";
    static constexpr int golden_steps = 300;
    TwoWheelsIds ids{};
    BalanceGains gains = {ingot::scalar(-2.06261972), ingot::scalar(-19.3950659), ingot::scalar(-3.64005284), ingot::scalar(-3.98430026)};

    ingot::Status begin(ingot::World<Scene>& world) { return set_up(world, ids, ingot::scalar(0.05)); }
    ingot::Status steer(ingot::World<Scene>& world) { return turn_wheels(world, ids, answer(gains, balance_of(world, ids))); }
    bool is_well(const ingot::World<Scene>& world) const { return ingot::abs(balance_of(world, ids).tilt) < ingot::scalar(0.01); }
};

struct UprightFlight {
    using Scene = Quadrotor;
    static constexpr const char* name = "quadrotor";
    static constexpr int golden_steps = 300;
    ingot::BodyId id{};

    ingot::Status begin(ingot::World<Scene>& world) {
        ingot::BodyDef def;
        def.mass = {1, quadrotor_moments, {}, ingot::identity_matrix<ingot::scalar>()};
        def.state.A = {{ingot::scalar(0.6), 0, ingot::scalar(-0.8)}, {0, 1, 0}, {ingot::scalar(0.8), 0, ingot::scalar(0.6)}};
        def.state.L = ingot::scaled(quadrotor_moments, ingot::Vector{2, -3, 1});
        const ingot::Result<ingot::BodyId> added = world.add(def);
        id = added.value;
        return added.status;
    }
    ingot::Status steer(ingot::World<Scene>& world) { return hold_attitude(world, id, ingot::identity_matrix<ingot::scalar>()); }
    bool is_well(const ingot::World<Scene>& world) const { return world.state(id).value.A.c2.z > ingot::scalar(0.999); }
};

/// With tyres by the slip law: off, round a bend, braked.
struct CarDrive {
    struct Scene : OnRoad {
        static constexpr int max_bodies = 6, max_joints = 4, max_manifolds = 8, max_pairs = 16;
        using shapes = ingot::Shapes<ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    };
    static constexpr const char* name = "car";
    static constexpr int golden_steps = 300;
    Car car{};
    int steps = 0;

    ingot::Status begin(ingot::World<Scene>& world) {
        car.design.slips = true;
        const ingot::Status status = add_ground(world);
        return status == ingot::Status::ok ? add_car(world, {}, 10, car) : status;
    }
    ingot::Status steer(ingot::World<Scene>& world) {
        ++steps;
        Driving driving;
        driving.torque = steps < 60 ? 400 : 0;
        driving.curvature = steps > 60 && steps <= 150 ? ingot::scalar(0.03) : 0;
        driving.brake = steps > 150 ? 600 : 0;
        return drive_car(world, car, driving, sixtieth);
    }
    bool is_well(const ingot::World<Scene>& world) const {
        const ingot::BodyState now = world.state(car.chassis).value;
        return now.A.c2.z > ingot::scalar(0.999) && ingot::length_sq(now.v_CM) < 1 && now.r_CM.y > 1;
    }
};

/// Straight on, about itself, round.
struct TankDrive {
    struct Scene : OnTracks {
        static constexpr int max_bodies = 10, max_joints = 8, max_manifolds = 12, max_pairs = 45;
    };
    static constexpr const char* name = "tank";
    static constexpr int golden_steps = 300;
    Tank tank{};
    int steps = 0;

    ingot::Status begin(ingot::World<Scene>& world) {
        const ingot::Status status = add_ground(world);
        return status == ingot::Status::ok ? add_tank(world, {}, tank) : status;
    }
    ingot::Status steer(ingot::World<Scene>& world) {
        ++steps;
        const ingot::scalar left = steps < 100 ? 2 : steps < 200 ? -1 : 1, right = steps < 100 ? 2 : steps < 200 ? 1 : 2;
        return drive_tank(world, tank, left, right);
    }
    bool is_well(const ingot::World<Scene>& world) const {
        const ingot::BodyState now = world.state(tank.hull).value;
        return now.A.c2.z > ingot::scalar(0.999) && now.r_CM.x > 2 && now.A.c0.y > ingot::scalar(0.3);
    }
};

}  // namespace scenes
