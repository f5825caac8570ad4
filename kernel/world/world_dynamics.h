// SPDX-License-Identifier: MIT
// The part of World that gives figures to who computes with them: controllers.
#pragma once

#include "../figure/read_dynamics.h"
#include "world_ties.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldDynamics : public WorldTies<S> {
protected:
    using Base = WorldTies<S>;
    using Base::joints_only;
    using Base::storage_;

public:
    // The equations of motion of a figure, in scenes with joints: see figure/dynamics.h.

    /// Reads the figure of a body, as it is now, with the forces that were added for the next step. A figure that floats has this body for its root;
    /// one that is tied by a joint to the world, or to another body that cannot move, the one that is tied.
    /// Errors: those of ids, immovable (also a kinematic body), frozen, no_room (it has more bodies than `to`), bad_joint (joints close a loop in it,
    ///         it is tied by two, or a rod or a parallel joint holds it: torques then do not follow from accelerations alone. But for one from
    ///         the root of what floats to what cannot move: the wrench of the root is what that one bears, too). `to` is then without bodies.
    /// Cost:   1250 instructions a body on x86-64, and a bit of each slot; stack: a bit for each body of the world.
    template <int bodies>
    Status read_dynamics(BodyId id, FigureDynamics<bodies>& to) const {
        static_assert(joints_only());
        const Dynamics of = to.view();
        of.size = {};
        const Result<int> slot = this->find_movable(id);
        if (!slot.ok()) return slot.status;
        const DynamicsSource from = dynamics_source();
        uint8_t bits[(static_cast<unsigned>(S::max_bodies) + 7) / 8] = {};
        const Result<DynamicsGround> ground = list_figure(of, from, static_cast<Index>(slot.value), bits);
        if (ground.ok()) read_motions(of, from, this->side_of(ground.value.slot));
        return ground.status;
    }

private:
    DynamicsSource dynamics_source() const {
        DynamicsSource from{};
        from.bodies = storage_.bodies();
        from.lists = const_cast<Storage<S>&>(storage_).joint_lists();  // lists that are only read
        from.generation = storage_.generation;
        from.joint_generation = storage_.joint_generation;
        from.world_tag = storage_.world_tag;
        from.gravity = storage_.gravity;
        if constexpr (S::gravity_shares) from.shares_of_gravity = storage_.shares_of_gravity;
        if constexpr (S::body_forces) from.body_forces = storage_.body_forces;
        return from;
    }
};

}}  // namespace ingot::INGOT_ABI
