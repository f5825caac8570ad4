// SPDX-License-Identifier: MIT
#include "at_rest.h"

namespace ingot { inline namespace INGOT_ABI {

void make_all_bounds(const SearchView& search, const RestView& rest, SensorMarks is_sensor, scalar h) {
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
    for (int slot = 0; slot < search.shapes.tile_count * lanes; ++slot) {
        if (slot >= search.surfaces.slot_count) {
            empty_bounds(search.bounds, slot);
            continue;
        }
        (void)refresh_bounds_of(search, h, slot);
        fatten_bounds_of(search, slot);
        if (rest.is_active(rest.body_of(slot)) || (is_sensor != nullptr && is_sensor[slot] != 0)) search.set(slot, SearchFlag::searched);
    }
}

void bound_active_shapes(const SearchView& search, const RestView& rest, scalar h, const TaskRange& tiles) {
    for_active(rest, [&](int body_i) {
        if (const int tile_i = place_of(body_i).tile; tile_i < tiles.begin || tile_i >= tiles.end) return;
        // bound: max_shapes_of_body
        for (int slot = body_i * rest.shapes_of_body; slot < (body_i + 1) * rest.shapes_of_body; ++slot) bound_shape(search, h, slot);
    });
}

int refresh_active_bounds(const SearchView& search, const RestView& rest, scalar h, uint32_t* due, bool bounded) {
    int count = 0;
    for_active(rest, [&](int body_i) {
        const int first = body_i * rest.shapes_of_body;
        // bound: max_shapes_of_body
        for (int slot = first; slot < first + rest.shapes_of_body; ++slot) {
            const bool left = bounded ? has_left_bounds(search, slot) : refresh_bounds_of(search, h, slot);
            if (!left && search.has(slot, SearchFlag::searched)) continue;
            search.set(slot, SearchFlag::searched);
            fatten_bounds_of(search, slot);
            if (due != nullptr) {
                search.set(slot, SearchFlag::due);
                due[count] = static_cast<uint32_t>(slot);
            }
            ++count;
        }
    });
    return count;
}

bool end_settling(const SearchView& search, const RestView& rest, SensorMarks is_sensor) {
    bool some = false;
    rest.active.for_each([&](int tile_i) {
        const unsigned settled = rest.settling[tile_i] & ~static_cast<unsigned>(rest.awake[tile_i]);
        some = some || settled != 0;
        for_lanes(tile_i, settled, [&](int body_i) {
            const int first = body_i * rest.shapes_of_body;
            for (int slot = first; slot < first + rest.shapes_of_body; ++slot)
                if (is_sensor == nullptr || is_sensor[slot] == 0) search.clear(slot, SearchFlag::searched);
        });
        rest.settling[tile_i] = 0;
        if (rest.awake[tile_i] == 0) rest.active.drop(tile_i);
    });
    return some;
}

void drop_resting_pairs(const SearchView& search, const PairList& pairs) {
    int kept = 0;
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *pairs.count; ++pair_i) {
        const BodyPair pair = pairs.pairs[pair_i];
        if (search.has(pair.body_A, SearchFlag::searched) || search.has(pair.body_B, SearchFlag::searched)) pairs.pairs[kept++] = pair;
    }
    *pairs.count = static_cast<Index>(kept);
}

void spread_notes(const ManifoldView& manifolds, const BodyPair* awake_pairs, int awake_count, ImpactNote* notes) {
    int awake_i = awake_count - 1;
    // bound: max_manifolds
    for (int manifold_i = *manifolds.count - 1; manifold_i >= 0; --manifold_i) {
        const bool solved = awake_i >= 0 && awake_pairs[awake_i].record == manifolds.pairs[manifold_i].record;
        write_note(notes[manifold_i], solved ? notes[awake_i--] : ImpactNote{});
    }
}

} }  // namespace ingot
