// SPDX-License-Identifier: MIT
// Stages work on views of tiles: a run of tiles is a view too, so no stage knows of sleep.
#pragma once

#include "rest_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE BodyView tiles_of(const BodyView& bodies, int first, int count) {
    return {bodies.rotation + first, bodies.translation + first, bodies.compensation == nullptr ? nullptr : bodies.compensation + first,
            bodies.energy == nullptr ? nullptr : bodies.energy + first, count};
}

/// Calls stage(view) for each run of tiles that are active and chosen.
template <class Chosen, class Stage>
void over_active_runs(const BodyView& bodies, const RestView& rest, const Chosen& chosen, const Stage& stage) {
    int first = 0, end = 0;
    rest.active.for_each([&](int tile_i) {
        if (!chosen(tile_i)) return;
        if (tile_i != end) {
            if (first != end) stage(tiles_of(bodies, first, end - first));
            first = tile_i;
        }
        end = tile_i + 1;
    });
    if (first != end) stage(tiles_of(bodies, first, end - first));
}

/// Calls stage(view) until it has seen every tile with an active body once. Such a tile may hold bodies at rest too: this is for stages that look,
/// or clear what those have clear already.
template <class Stage>
void over_active_tiles(const BodyView& bodies, const RestView& rest, const Stage& stage) {
    over_active_runs(bodies, rest, [](int) { return true; }, stage);
}

/// Lanes of a tile that sleep.
INGOT_INLINE unsigned sleepers_of(const BodyView& bodies, const RestView& rest, int tile_i) {
    const unsigned free_lanes = bits(load(bodies.translation[tile_i].inv_M) > lane{});
    return free_lanes & ~static_cast<unsigned>(rest.awake[tile_i]);
}

/// A copy of what stages of motion write to a tile: lanes that sleep get it back.
class KeptTile {
public:
    KeptTile(const BodyView& bodies, int tile_i) : rotation_(bodies.rotation[tile_i]), translation_(bodies.translation[tile_i]) {
        if (bodies.compensation != nullptr) compensation_ = bodies.compensation[tile_i];
        if (bodies.energy != nullptr) energy_ = bodies.energy[tile_i];
    }
    void give_back(const BodyView& bodies, int tile_i, unsigned lane_bits) const {
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if ((lane_bits >> lane_i & 1u) == 0) continue;
            set_lane(bodies.rotation[tile_i].A, lane_i, lane_of(rotation_.A, lane_i));
            set_lane(bodies.rotation[tile_i].L, lane_i, lane_of(rotation_.L, lane_i));
            set_lane(bodies.translation[tile_i].r_CM, lane_i, lane_of(translation_.r_CM, lane_i));
            set_lane(bodies.translation[tile_i].v_CM, lane_i, lane_of(translation_.v_CM, lane_i));
            if (bodies.compensation != nullptr) set_lane(bodies.compensation[tile_i].A_low, lane_i, lane_of(compensation_.A_low, lane_i));
            if (bodies.energy != nullptr) bodies.energy[tile_i].E_0[lane_i] = energy_.E_0[lane_i];
        }
    }

private:
    RotationTile rotation_;
    TranslationTile translation_;
    CompensationTile compensation_ = {};
    EnergyTile energy_ = {};
};

/// Calls stage(view) for each tile with a body that can move and is not among those `left_alone`, by tile, a bit a lane: these keep their bits.
template <class Stage>
void over_others(const BodyView& bodies, int tile_i, unsigned left_alone, const Stage& stage) {
    const unsigned moving = bits(load(bodies.translation[tile_i].inv_M) > lane{});
    if ((moving & ~left_alone) == 0) return;
    if ((moving & left_alone) == 0) return stage(tiles_of(bodies, tile_i, 1));
    const KeptTile kept(bodies, tile_i);
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if ((left_alone >> lane_i & 1u) != 0) set_lane(bodies.rotation[tile_i].L, lane_i, Vector{});  // what it would do is not reported
    stage(tiles_of(bodies, tile_i, 1));
    kept.give_back(bodies, tile_i, left_alone);
}

/// Calls stage(view) until it has seen every chosen tile with an awake body once. Bodies that sleep keep their bits.
template <class Chosen, class Stage>
void over_awake_bodies_of(const BodyView& bodies, const RestView& rest, const Chosen& chosen, const Stage& stage) {
    const auto all_awake = [&](int tile_i) { return chosen(tile_i) && rest.awake[tile_i] != 0 && sleepers_of(bodies, rest, tile_i) == 0; };
    over_active_runs(bodies, rest, all_awake, stage);
    if constexpr (lanes == 1) return;
    rest.active.for_each([&](int tile_i) {
        if (!chosen(tile_i)) return;
        const unsigned sleepers = rest.awake[tile_i] != 0 ? sleepers_of(bodies, rest, tile_i) : 0;
        if (sleepers == 0) return;
        const KeptTile kept(bodies, tile_i);
        stage(tiles_of(bodies, tile_i, 1));
        kept.give_back(bodies, tile_i, sleepers);
    });
}
/// Of all tiles.
template <class Stage>
void over_awake_bodies(const BodyView& bodies, const RestView& rest, const Stage& stage) {
    over_awake_bodies_of(bodies, rest, [](int) { return true; }, stage);
}

} }  // namespace ingot

#pragma GCC diagnostic pop
