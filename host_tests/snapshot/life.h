// SPDX-License-Identifier: MIT
// The life of a world as a stream of random calls: bodies come and go, are moved, pushed and turned, and step.
#pragma once

#include "capacity/yard.h"
#include "scenes/random.h"

#include <vector>

namespace life {

using namespace yard;

struct PrintedYard : Yard {
    using rotation = ingot::Listing1Euler;
};
struct Tops : ingot::Scene {
    static constexpr int max_bodies = 9;
};
struct Tide : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
    using force_field = ingot::BothFields<ingot::PointMassGravity, ingot::ThrusterTable<2, 9>>;
    using flight = ingot::BlanesMoan4;
};

/// Numbers that are the same for every world that follows one life.
class Life {
public:
    explicit Life(uint64_t seed) : random_(seed) {}

    /// One call, or one step. What it does depends on the seed and on the world alone.
    template <class S>
    void live(World<S>& world) {
        const BodyId id = world.body_at(integer(S::max_bodies));
        switch (integer(12)) {
            case 0: case 1: (void)world.add(newcomer<S>()); break;
            case 2: if (integer(2) == 0) (void)world.remove(id); break;
            case 3: (void)world.set_state(id, newcomer<S>().state); break;
            case 4: (void)world.add_torque(id, random_.symmetric_vector()); break;
            case 5: (void)world.apply_angular_impulse(id, random_.symmetric_vector()); break;
            case 6: push(world, id); break;
            case 7: if constexpr (ingot::has_field<S>) set_field(world.force_field()); break;
            default: (void)ingot::step(world, integer(8) == 0 ? h / 2 : h); break;
        }
    }

private:
    int integer(int end) { return static_cast<int>((random_.symmetric() + 1) * scalar(0.5) * static_cast<scalar>(end)); }

    template <class S>
    BodyDef newcomer() {
        BodyDef def = plain_body({});
        def.state.A = ingot::axis_angle({0, scalar(0.6), scalar(0.8)}, 3 * random_.symmetric());
        def.state.L = random_.symmetric_vector() * scalar(4);
        if constexpr (S::translates) {
            def.state.r_CM = random_.symmetric_vector() * scalar(4);
            def.state.v_CM = random_.symmetric_vector();
        }
        if constexpr (ingot::collides<S>) {
            def.restitution = scalar(0.5);
            if (integer(2) == 0) def.shape = ingot::Sphere{scalar(0.5)};
            else def.shape = ingot::Box{{scalar(0.5), scalar(0.25), 1}};
        }
        if (integer(6) == 0) {
            def.immovable = true;
            def.state.v_CM = def.state.L = {};
            if constexpr (ingot::collides<S>) def.shape = ingot::HalfSpace{{0, 0, 1}, -3};
        } else if (S::translates && integer(10) == 0) {  // leaves the range at its next step, and freezes
            def.state.r_CM = {limits::position_max, 0, 0};
            def.state.v_CM = {limits::speed_max, 0, 0};
        }
        return def;
    }

    template <class Field>
    void set_field(Field& field) {
        field.first.mu = 4 + random_.symmetric();
        field.second.thruster[0].F_body = random_.symmetric_vector();
        field.second.thruster[1].r_body = random_.symmetric_vector();
        field.second.thruster[1].F_body = {0, 0, 1};
        for (auto& thruster : field.second.thruster) thruster.throttle[integer(Tide::max_bodies)] = (1 + random_.symmetric()) / 2;
    }

    template <class S>
    void push(World<S>& world, BodyId id) {
        const Vector F = random_.symmetric_vector(), P = random_.symmetric_vector();
        if constexpr (S::translates) {
            if (integer(3) == 0) (void)world.set_gravity(F * scalar(9));
            else if (integer(2) == 0) (void)world.add_force(id, F, P);
            else (void)world.apply_impulse(id, F, P);
        }
    }

    scenes::Random random_;
};

template <class S>
std::vector<uint8_t> saved(const World<S>& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<S>());
    const Result<size_t> size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    bytes.resize(size.ok() ? size.value : 0);
    return bytes;
}

}  // namespace life
