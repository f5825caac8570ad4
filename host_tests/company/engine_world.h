// SPDX-License-Identifier: MIT
// AnyWorld for a scene type. Included by engines_*.cpp alone: each line there compiles a step.
#pragma once

#include "engine.h"

namespace company {

template <class S>
class EngineWorld final : public AnyWorld {
public:
    EngineWorld() {
        if constexpr (ingot::has_field<S>) {
            world_.force_field().c = scalar(0.01);
            world_.force_field().c_turn = scalar(1e-5);  // more would turn the smallest bodies round in a step
        }
    }

    ingot::Result<ingot::BodyId> add(const Member& member, const Vector& place) override {
        ingot::BodyDef def = member.body.def;
        def.state.r_CM = def.state.r_CM + place;
        def.friction = member.body.mu;
        if (!S::bounces) def.restitution = 0;
        if (!S::filters) def.filter = ingot::meets_all;
        const ingot::Result<ingot::BodyId> id = add_shapes(member, def);
        if constexpr (S::rolling_resistance)
            if (id.ok() && member.rolling_lever != 0) expect_ok(world_.set_rolling_resistance(id.value, member.rolling_lever));
        if constexpr (S::surface_velocities)
            if (id.ok() && ingot::length_sq(member.surface_velocity) > 0) expect_ok(world_.set_surface_velocity(id.value, member.surface_velocity));
        return id;
    }

    void edit(ingot::BodyId id, const Edit& edit, const Vector& place) override {
        switch (edit.kind) {
            case Edit::impulse: expect_ok(world_.apply_central_impulse(id, edit.v)); break;
            case Edit::angular_impulse: expect_ok(world_.apply_angular_impulse(id, edit.v)); break;
            case Edit::force: (void)world_.add_central_force(id, edit.v); break;  // refused, once it is frozen
            case Edit::put: {
                ingot::BodyState state{};
                state.r_CM = edit.v + place;
                expect_ok(world_.set_state(id, state));
                break;
            }
            case Edit::remove: expect_ok(world_.remove(id)); break;
            case Edit::wake:
                if constexpr (S::sleeps) expect_ok(world_.wake(id));
                break;
            case Edit::sleep:
                if constexpr (S::sleeps) expect_ok(world_.sleep(id));
                break;
            case Edit::filter:
                if constexpr (S::filters) expect_ok(world_.set_filter(id, {static_cast<uint16_t>(edit.v.x), static_cast<uint16_t>(edit.v.y)}));
                break;
        }
    }

    ingot::Status set_gravity(const Vector& gravity) override { return world_.set_gravity(gravity); }
    ingot::StepReport step(scalar h) override { return ingot::step(world_, h); }
    ingot::Result<ingot::BodyState> state(ingot::BodyId id) const override { return world_.state(id); }
    bool is_asleep([[maybe_unused]] ingot::BodyId id) const override {
        if constexpr (S::sleeps)
            return world_.is_asleep(id);
        else
            return false;
    }
    ingot::EventView events() const override {
        if constexpr (S::max_events > 0)
            return world_.events();
        else
            return {nullptr, 0};
    }

    /// A sensor in a scene without sensors would be solid: whoever brings one is not taken.
    static bool takes(const Party& party) {
        if (party.is_fast && !S::continuous) return false;
        for (const Member& member : party.members) {
            if (!member.parts.empty() && S::max_shapes_of_body == 1) return false;
            if (member.parts.empty() && !S::shapes::has(member.body.def.shape.kind)) return false;
            if (member.body.def.sensor && S::max_overlaps == 0) return false;
        }
        return true;
    }

private:
    ingot::Result<ingot::BodyId> add_shapes(const Member& member, const ingot::BodyDef& def) {
        if constexpr (S::max_shapes_of_body > 1)
            if (!member.parts.empty()) return world_.add(def, member.parts.data(), static_cast<int>(member.parts.size()));
        return world_.add(def);
    }
    static void expect_ok(ingot::Status status);

    ingot::World<S> world_ = {};
};

/// Ends the run: an edit that is refused tests nothing.
void refuse(ingot::Status status);

template <class S>
void EngineWorld<S>::expect_ok(ingot::Status status) {
    if (status != ingot::Status::ok) refuse(status);
}

template <class S>
Engine engine(const char* name) {
    return {name, [] { return std::unique_ptr<AnyWorld>(new EngineWorld<S>()); }, &EngineWorld<S>::takes, S::sleeps, S::max_manifolds > 0};
}

/// What they share: room for a crowd, and then some.
struct Roomy : ingot::Scene {
    static constexpr int max_bodies = 760;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 3600;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};
/// Sleep comes soon, or tests of it would last.
struct Sleepy : Roomy {
    static constexpr bool sleeps = true;
    static constexpr scalar sleep_speed = scalar(0.01), sleep_time = scalar(0.125);
};

}  // namespace company
