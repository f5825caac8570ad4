// SPDX-License-Identifier: MIT
#include "at_rest.h"

namespace ingot { inline namespace INGOT_ABI {

bool all_at_rest(const RestView& rest, const BoundsTile* bounds, int tile_count) {
    bool some_active = false;
    // bound: max_bodies / lanes, rounded up
    for (int tile_i = 0; tile_i < tile_count; ++tile_i) some_active = some_active || rest.tile_is_active(tile_i) || is_blank(bounds[tile_i]);
    return !some_active;
}

bool refresh_active_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, const RestView& rest, BoundsTile* bounds) {
    bool left = false;
    over_runs(bodies, [&](int tile_i) { return rest.tile_is_active(tile_i) || is_blank(bounds[tile_i]); }, [&](int first, const BodyView& run) {
        left = refresh_bounds(run, {surfaces.surfaces + first * lanes, surfaces.slot_count - first * lanes}, h, bounds + first) || left;
    });
    if (left) fatten_bounds(bodies, bounds);  // of all, whichever tiles were in a run: the pairs of a search are the same for every lane count
    return left;
}

void spread_notes(const ManifoldView& manifolds, const BodyPair* awake_pairs, int awake_count, ImpactNote* notes) {
    int awake_i = awake_count - 1;
    for (int manifold_i = *manifolds.count - 1; manifold_i >= 0; --manifold_i) {  // bound: max_manifolds
        const bool solved = awake_i >= 0 && awake_pairs[awake_i].key() == manifolds.pairs[manifold_i].key();
        write_note(notes[manifold_i], solved ? notes[awake_i--] : ImpactNote{});
    }
}

} }  // namespace ingot
