// SPDX-License-Identifier: MIT
// One body turned by a rotation method: in a world, or by the stages alone where a world refuses the body.
#pragma once

#include <ingot/ingot.h>
#include <ingot/world/edit_bodies.h>

#include "reference/free_body_table.h"
#include "reference/kernel_types.h"

namespace report {
inline namespace INGOT_ABI {

template <class Rotation, int bodies = 1, bool moves = false>
struct SceneOf : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = moves;
    using rotation = Rotation;
};

inline ingot::BodyDef definition_of(const ingot_reference::FreeBodyCase& body) {
    ingot::BodyDef def = ingot_reference::definition(1, body.I);
    def.state.A = ingot_reference::to_matrix(body.A_0);
    def.state.L = ingot_reference::to_vector(body.L);
    return def;
}

template <class Rotation>
class FlyerInWorld {
public:
    explicit FlyerInWorld(const ingot_reference::FreeBodyCase& body) : id_(world_.add(definition_of(body)).value) {}

    static bool takes(const ingot_reference::FreeBodyCase& body) {
        ingot::World<SceneOf<Rotation>> world{};
        return world.add(definition_of(body)).ok();
    }

    void step(ingot::scalar h) { (void)ingot::step(world_, h); }
    ingot::BodyState state() const { return world_.state(id_).value; }

private:
    ingot::World<SceneOf<Rotation>> world_{};
    ingot::BodyId id_;
};

/// The stages ask nothing of a body's moments: near_separatrix has 1, 2 and 4, which no solid can have.
template <class Rotation>
class FlyerOnStage {
public:
    explicit FlyerOnStage(const ingot_reference::FreeBodyCase& body) {
        for (int lane_i = 0; lane_i < ingot::lanes; ++lane_i) ingot::set_identity_body(view(), lane_i);
        ingot::write_body(view(), 0, definition_of(body));
    }

    void step(ingot::scalar h) {
        if constexpr (Rotation::as_printed)
            ingot::integrate_A_listing1(view(), h);
        else
            (void)Rotation::integrate_A(view(), h, {steps_});
        ++steps_;
    }
    ingot::BodyState state() { return ingot::read_state(view(), 0); }

private:
    ingot::BodyView view() { return {&rotation_, &translation_, &compensation_, &energy_, 1}; }

    ingot::RotationTile rotation_{};
    ingot::TranslationTile translation_{};
    ingot::CompensationTile compensation_{};
    ingot::EnergyTile energy_{};
    std::uint32_t steps_ = 0;
};

}  // namespace INGOT_ABI
}  // namespace report
