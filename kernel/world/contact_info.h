// SPDX-License-Identifier: MIT
// Contacts of the last step, as World tells them.
#pragma once

#include "../base/ids.h"
#include "storage.h"

namespace ingot { inline namespace INGOT_ABI {

/// One point of a contact.
struct ContactPoint {
    Vector P{};           ///< m, world, half-way between the two surfaces
    scalar separation{};  ///< m; negative where the shapes overlap
    scalar j{};           ///< N s, given to A along n, and to B against it
};

/// A contact of two shapes, as it was found at the begin of the last step, and what it gave in it.
///
/// The impulses are those of the whole step, the sum over its substeps, in scenes with reads_contacts and with max_contacts. Other scenes keep those
/// of the last substep: they are told as if all substeps had given as much, which is so where bodies rest, slide or roll, and not where they hit. Of
/// a body at rest the normals sum up to its weight times h. Bodies that sleep have what they had in their last step.
/// Not among them: impacts within the step, see Scene::continuous.
struct ContactInfo {
    BodyId A{}, B{};          ///< with max_manifolds A has the lower slot; with max_contacts a half space is B
    Vector n{};               ///< unit normal from B to A, world
    scalar separation{};      ///< m, of the deepest point; up to the margin above 0 where the shapes may meet and do not touch
    scalar j{};               ///< N s, of all points: given to A along n, and to B against it
    Vector j_friction{};      ///< N s, given to A, and to B against it; at the middle of the points
    int shape_A{}, shape_B{};  ///< which of their shapes, where a body has several; else 0
    int material{};           ///< of what is touched of a level, where the level has materials; else 0
    int point_count{};        ///< 1 .. 4; in scenes with max_contacts each point is a contact, and 0 unless the scene names reads_contacts
    ContactPoint points[Manifold::points_max]{};  ///< point_count of them
};

/// What contacts gave a body in the last step, all together: divided by its h, the mean force on it.
struct ContactSum {
    int contact_count{};  ///< of those that gave something: 0: it touched nothing, or did not need to be held
    Vector j{};           ///< N s, on the body, world, with friction
    scalar j_normal{};    ///< N s, of all normals, by size
    Vector P{};           ///< m, world: the centre of pressure, the mean place of the normals by what they gave; 0 where none did
};

/// Where contacts of the last step stand in storage: those of the step in the order of slots, then those of bodies that sleep.
template <class S>
struct ContactPlaces {
    const Storage<S>& storage;

    /// One beyond the last.
    int end() const {
        if constexpr (collides<S>)
            return storage.contact_count;
        else if constexpr (S::sleeps)
            return storage.manifold_count + storage.records_used;
        else
            return storage.manifold_count;
    }
    /// The shapes of a place, and the record; a record above all others: there is no contact.
    BodyPair pair_at(int place) const {
        if constexpr (collides<S>) {
            const Contact& c = storage.contacts[place];
            return {c.body_A, c.body_B, 0};
        } else {
            if (place < storage.manifold_count) return storage.pairs[place];
            if constexpr (S::sleeps) {
                const int record_i = place - storage.manifold_count;
                const BodyPair& aside = storage.pairs_aside[record_i];
                if (aside.record != 0) return {aside.body_A, aside.body_B, static_cast<Index>(record_i)};
            }
            return {0, 0, no_record};
        }
    }
    /// The first place from this one on with a contact of the body of a slot; of any body, where slot is below zero.
    int next(int place, int slot) const {
        for (; place < end(); ++place) {  // bound: max_manifolds, twice where bodies sleep, or max_contacts
            const BodyPair pair = pair_at(place);
            const bool of_body = slot < 0 || storage.owner_of(pair.body_A / S::max_shapes_of_body) == slot ||
                                 storage.owner_of(pair.body_B / S::max_shapes_of_body) == slot;
            if (pair.record != no_record && of_body) break;
        }
        return place;
    }
    ContactInfo info_at(int place) const {
        const BodyPair pair = pair_at(place);
        const auto id_of = [this](int slot) {
            const int owner = storage.owner_of(slot);
            return BodyId{static_cast<Index>(owner), storage.world_tag, storage.generation[owner]};
        };
        ContactInfo info;
        info.A = id_of(pair.body_A / S::max_shapes_of_body);
        info.B = id_of(pair.body_B / S::max_shapes_of_body);
        info.shape_A = pair.body_A % S::max_shapes_of_body;
        info.shape_B = pair.body_B % S::max_shapes_of_body;
        if constexpr (collides<S>)
            tell_impact(storage.contacts[place], place, info);
        else
            tell_manifold(pair.record, info);
        if constexpr (has_levels<S>) info.material = storage.records[pair.record].manifold.material;
        return info;
    }

private:
    void tell_impact(const Contact& c, [[maybe_unused]] int place, ContactInfo& info) const {
        info.n = c.n;
        info.separation = c.separation;
        info.j = c.j_total;
        if constexpr (S::reads_contacts) {
            info.point_count = 1;
            info.points[0] = {storage.contact_places[place], c.separation, c.j_total};
        }
    }
    void tell_manifold(int record_i, ContactInfo& info) const {
        const ManifoldRecord& record = storage.records[record_i];
        info.n = record.manifold.n;
        info.point_count = record.manifold.count;
        info.separation = record.manifold.points[0].separation;
        constexpr scalar substeps = S::effort.substeps;
        info.j_friction = record.j_friction * substeps;
        if constexpr (S::reads_contacts) info.j_friction = storage.impulse_sums[record_i].friction;
        for (int point_i = 0; point_i < info.point_count; ++point_i) {  // bound: 4: Manifold::points_max
            const ManifoldPoint& point = record.manifold.points[point_i];
            scalar j = record.j[point_i] * substeps;
            if constexpr (S::reads_contacts) j = storage.impulse_sums[record_i].j[point_i];
            info.points[point_i] = {point.P, point.separation, j};
            info.separation = min(info.separation, point.separation);
            info.j += j;
        }
    }
};

/// What a `for` goes over: ContactInfo by ContactInfo, without memory of its own. Until the world is changed.
template <class S>
class ContactRange {
public:
    ContactRange(const Storage<S>& of, int slot, bool any) : places_{of}, slot_(slot), end_(any ? places_.end() : 0) {}

    class Iterator {
    public:
        Iterator(const ContactRange& of, int place) : of_(of), place_(place) {}
        ContactInfo operator*() const { return of_.places_.info_at(place_); }
        Iterator& operator++() {
            place_ = of_.places_.next(place_ + 1, of_.slot_);
            return *this;
        }
        bool operator!=(const Iterator& other) const { return place_ != other.place_; }

    private:
        const ContactRange& of_;
        int place_;
    };
    Iterator begin() const { return {*this, end_ == 0 ? 0 : places_.next(0, slot_)}; }  ///< for a range for
    Iterator end() const { return {*this, end_}; }  ///< for a range for

private:
    ContactPlaces<S> places_;
    int slot_, end_;
};

} }  // namespace ingot
