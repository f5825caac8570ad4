// SPDX-License-Identifier: MIT
// Ground from tables: meshes and fields of heights. See level/level_table.h, World::add_level.
#pragma once

#include "sensors_and_events.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Tables are in flash, and a world keeps of a level no more than of any fixed body: so the record has no memory.
struct Levels : Feature {
    template <class S>
    static constexpr bool named = has_levels<S>;

    template <class S, bool present>
    struct Memory {};

    /// Tables may be loaded after the program has begun: so snapshots name them by their sums (Surfaces), and the signature counts them.
    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (has_levels<S>) each(levels_of<S>.count);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!has_levels<S> || stacks<S>, "levels are for contacts with friction: set max_manifolds, or leave levels out");
        static_assert(has_levels<S> == S::shapes::has(ShapeKind::level), "a scene with levels has Level among its shapes: set shapes, and levels");
        return true;
    }

    /// Events are told of the body that a level is, not of the slots that it takes.
    template <class S>
    static void name_bodies(const Storage<S>& storage, const EventList& events) {
        const auto name = [&storage](BodyId& id) {
            const int owner = storage.owner_of(id.slot);
            if (owner == id.slot || storage.generation[id.slot] != id.generation) return;  // one that is gone was told under its own
            id.slot = static_cast<Index>(owner);
            id.generation = storage.generation[owner];
        };
        for (int event_i = 0; event_i < *events.count; ++event_i) {  // bound: max_events
            name(events.events[event_i].A);
            name(events.events[event_i].B);
        }
    }
};

} } }  // namespace ingot::features
