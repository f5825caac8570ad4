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

    /// What all contacts of a body gave it: of a foot its load, and where it stands. As contacts tell: see ContactInfo. In scenes with max_contacts
    /// there are places, and so a P, where it names reads_contacts. Errors: those of ids. Cost: a look at all contacts.
    Result<ContactSum> contact_sum(BodyId id) const {
        static_assert(shapes_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, sum_of(contacts_of(id), id)};
    }

private:
    static ContactSum sum_of(const ContactRange<S>& contacts, BodyId id) {
        ContactSum sum;
        Vector first{}, moved{};  // places from the first one: far from the origin no digits are lost
        scalar of_points = 0;
        for (const ContactInfo& contact : contacts) {
            const scalar sign = contact.A == id ? scalar(1) : scalar(-1);
            if (contact.j > 0) ++sum.contact_count;
            sum.j = sum.j + (contact.n * contact.j + contact.j_friction) * sign;
            sum.j_normal += contact.j;
            for (int i = 0; i < contact.point_count; ++i) {  // bound: 4: Manifold::points_max
                const ContactPoint& point = contact.points[i];
                if (!(point.j > 0)) continue;
                if (!(of_points > 0)) first = point.P;
                moved = moved + (point.P - first) * point.j;
                of_points += point.j;
            }
        }
        const scalar share = 1 / of_points;  // of less than a normal number there is none: any of the places is as good
        if (of_points > 0) sum.P = share <= scalar_max ? first + moved * share : first;
        return sum;
    }
};

} }  // namespace ingot
