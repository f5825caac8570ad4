// SPDX-License-Identifier: MIT
// Figures that move by the energy-momentum step: energy_momentum/energy_momentum.h.
#pragma once

#include "../../energy_momentum/swing_freely.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Which bodies have a contact.
template <class S, bool present>
struct TouchingPart {
    uint16_t touching_lanes[tile_capacity<S>] = {};

    void mark_touching(const ManifoldView& manifolds, int tile_count) {
        for (int tile_i = 0; tile_i < tile_count; ++tile_i) touching_lanes[tile_i] = 0;  // bound: max_bodies / lanes, rounded up
        const auto mark = [this](Index slot) {
            const Place at = place_of(slot);
            touching_lanes[at.tile] = static_cast<uint16_t>(touching_lanes[at.tile] | 1u << at.lane);
        };
        for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {  // bound: max_manifolds
            mark(manifolds.pairs[pair_i].body_A);
            mark(manifolds.pairs[pair_i].body_B);
        }
    }
    const uint16_t* lanes_touching() const { return touching_lanes; }
};
template <class S>
struct TouchingPart<S, false> {
    static const uint16_t* lanes_touching() { return nullptr; }
};

struct FigureMotion : Feature {
    static constexpr uint32_t part = 1u << 22;
    template <class S>
    static constexpr bool named = swings_freely<S>;

    template <class S, bool present>
    struct Memory : TouchingPart<S, stacks<S>> {
        static constexpr unsigned node_capacity = Figures::Memory<S, true>::node_capacity;

        NewtonRow<1> newton_rows[node_capacity] = {};
        FigureMemory figure_memory[static_cast<unsigned>(S::max_bodies)] = {};
        uint16_t left_lanes[tile_capacity<S>] = {}, moved_lanes[tile_capacity<S>] = {};

        EnergyMomentumView energy_momentum_view() {
            return {newton_rows,
                    figure_memory,
                    left_lanes,
                    moved_lanes,
                    this->lanes_touching(),
                    S::effort.substeps,
                    S::figure_motion::snap,
                    S::figure_motion::order};
        }
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (S::figure_motion::is_implicit) {
            each(static_cast<int>(S::figure_motion::snap));
            each(S::figure_motion::order);
        }
    }
    template <class S>
    static constexpr bool check() {
        static_assert(has_joints<S> || !S::figure_motion::is_implicit,
                      "figures are bodies with joints: set joints and max_joints, or leave figure_motion out");
        static_assert(!has_joint_rows<S> || !S::figure_motion::is_implicit,
                      "the energy-momentum step has no limits and drives of joints: drop WithLimits and WithDrives, or leave figure_motion out");
        return true;
    }

    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.figure_memory[slot] = {};
    }

    struct OfBody : NoNumbers {
        FigureMemory memory;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("figure.torque", memory.torque);
            each("figure.seen", memory.seen);
            each("figure.halvings", memory.halvings);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            memory = storage.figure_memory[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.figure_memory[slot] = memory;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return is_finite(memory.torque) && memory.halvings <= limits::newton_halvings_max;
        }
    };
};

} } }  // namespace ingot::features
