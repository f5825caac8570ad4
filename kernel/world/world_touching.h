// SPDX-License-Identifier: MIT
// The part of World that tells who touched whom in the last step, and with what impulses.
#pragma once

#include "contact_info.h"
#include "world_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldTouching : public WorldBodies<S> {
protected:
    using Base = WorldBodies<S>;
    using Base::storage_;
    using Base::shapes_only;
    using Base::find;

public:
    // Contacts of the last step, whatever solves them: see ContactInfo. They stand in the order of slots, those of bodies that sleep behind the
    // others, until the next step; what is removed or edited meanwhile takes its contacts along.

    /// Of the last step, those of bodies that sleep among them.
    int contact_count() const {
        static_assert(shapes_only());
        if constexpr (collides<S>)
            return storage_.contact_count;
        else if constexpr (S::sleeps)
            return storage_.manifold_count + storage_.aside_count;
        else
            return storage_.manifold_count;
    }

    /// 0 <= index < contact_count(), else out_of_range.
    /// Cost: O(1); O(max_manifolds) for one of bodies that sleep: go over contacts() to see them all.
    Result<ContactInfo> contact(int index) const {
        static_assert(shapes_only());
        if (index < 0 || index >= contact_count()) return {Status::out_of_range, {}};
        const ContactPlaces<S> places{storage_};
        int place = index;
        if constexpr (S::sleeps)
            if (index >= storage_.manifold_count) {
                place = places.next(storage_.manifold_count, -1);
                // bound: max_manifolds: contacts that are put aside
                for (int before = storage_.manifold_count; before < index; ++before) place = places.next(place + 1, -1);
            }
        return {Status::ok, places.info_at(place)};
    }

    /// All of them: for (const ContactInfo& contact : world.contacts()).
    ContactRange<S> contacts() const {
        static_assert(shapes_only());
        return {storage_, -1, true};
    }
    /// Those of one body, as A or as B; none for an id of none. Cost: a look at all.
    ContactRange<S> contacts_of(BodyId id) const {
        static_assert(shapes_only());
        const Result<int> slot = find(id);
        return {storage_, slot.value, slot.ok()};
    }
};

} }  // namespace ingot
