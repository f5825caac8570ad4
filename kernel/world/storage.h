// SPDX-License-Identifier: MIT
// The memory of a world, part by part: a part its scene does not name is an empty base and takes no room.
//
// No part holds a pointer to itself, all zero is the valid empty part, and nothing has a constructor that runs: a world
// lies in .bss and memcpy is its snapshot.
#pragma once

#include "../body/body_tiles.h"
#include "../collide/find_contacts.h"
#include "../blocks/solver_view.h"
#include "../contact/contact_events.h"
#include "../fast/body_path.h"
#include "scene.h"

namespace ingot { inline namespace INGOT_ABI {

template <class S>
inline constexpr int pair_capacity = S::max_pairs != 0 ? S::max_pairs : 2 * S::max_manifolds;

template <class S>
inline constexpr int tile_capacity = (S::max_bodies + lanes - 1) / lanes;

template <class S, bool present>
struct TranslationPart {
    TranslationTile translation[tile_capacity<S>] = {};
    Vector gravity = {};  ///< m s^-2
    TranslationTile* translation_tiles() { return translation; }
    Vector gravity_or_none() const { return gravity; }
};
template <class S>
struct TranslationPart<S, false> {
    TranslationTile* translation_tiles() { return nullptr; }
    Vector gravity_or_none() const { return {}; }
};

template <class S, bool present>
struct CompensationPart {
    CompensationTile compensation[tile_capacity<S>] = {};
    CompensationTile* compensation_tiles() { return compensation; }
};
template <class S>
struct CompensationPart<S, false> {
    CompensationTile* compensation_tiles() { return nullptr; }
};

template <class S, bool present>
struct EnergyPart {
    EnergyTile energy[tile_capacity<S>] = {};
    scalar h_before = 0;  ///< s, of the last step
    EnergyTile* energy_tiles() { return energy; }
    bool h_changes_to(scalar h) {
        const bool changed = h != h_before;
        h_before = h;
        return changed;
    }
};
template <class S>
struct EnergyPart<S, false> {
    EnergyTile* energy_tiles() { return nullptr; }
    bool h_changes_to(scalar) { return false; }
};

template <class S, bool present>
struct FieldPart {
    typename S::force_field field = {};
    scalar t = 0, t_low = 0;  ///< s; t + t_low is the time

    Drivers<typename S::force_field> drivers(const Vector& gravity) const { return {field, gravity, t}; }
    void advance_time(scalar h) {  // Kahan: rounding does not add up over the steps
        const scalar due = h + t_low, t_next = t + due;
        t_low = due - (t_next - t);
        t = t_next;
    }
};
template <class S>
struct FieldPart<S, false> {};

template <class S, bool present>
struct ContactPart {
    Contact contacts[static_cast<unsigned>(S::max_contacts)] = {};
    uint16_t contact_count = 0;
};
template <class S>
struct ContactPart<S, false> {};

template <class S, bool present>
struct SurfacePart {
    Surface surfaces[static_cast<unsigned>(S::max_bodies)] = {};
};
template <class S>
struct SurfacePart<S, false> {};

template <class S, bool present>
struct AnchorPart {
    ManifoldAnchors anchors[static_cast<unsigned>(S::max_manifolds)] = {};
    ManifoldAnchors* manifold_anchors() { return anchors; }
};
template <class S>
struct AnchorPart<S, false> {
    ManifoldAnchors* manifold_anchors() { return nullptr; }
};

template <class S, bool present>
struct ManifoldPart : AnchorPart<S, S::renews_manifolds>, S::broad_phase::template Memory<S::max_bodies, pair_capacity<S>> {
    static constexpr unsigned manifold_capacity = static_cast<unsigned>(S::max_manifolds);
    static constexpr unsigned full_blocks = (manifold_capacity + lanes - 1) / lanes;
    static constexpr unsigned block_capacity = lanes == 1 ? full_blocks : full_blocks + full_blocks / 2 + 2;  // see order_manifolds
    static constexpr unsigned body_capacity = static_cast<unsigned>(S::max_bodies) + 1;

    ContactBlock blocks[block_capacity] = {};
    SolverBody solver_bodies[body_capacity] = {};
    SolverBodyHistory histories[body_capacity] = {};
    BoundsTile bounds[tile_capacity<S>] = {};
    BodyPair found_pairs[pair_capacity<S>] = {};
    BodyPair pairs[manifold_capacity] = {};
    ManifoldRecord records[manifold_capacity] = {};
    uint32_t colours_of_body[body_capacity] = {};
    uint16_t level_of_body[body_capacity] = {}, slot_of[body_capacity] = {};
    uint16_t local_of[static_cast<unsigned>(tile_capacity<S> * lanes)] = {};
    uint16_t order[block_capacity * lanes] = {};
    uint16_t other_order[manifold_capacity] = {}, level_order[manifold_capacity] = {}, level[manifold_capacity] = {};
    Visit visits[manifold_capacity + block_capacity] = {};
    uint16_t found_count = 0, pairs_lost = 0;
    uint16_t manifold_count = 0, records_used = 0, first_free_record = 0;

    PairList pair_list() { return {found_pairs, pair_capacity<S>, &found_count, &pairs_lost}; }
    ManifoldView manifold_view() { return {pairs, &manifold_count, records, this->manifold_anchors(), &records_used, &first_free_record, S::max_manifolds}; }
    SolverView solver() {
        return {pairs, records, manifold_count, blocks, visits, order, level, other_order, level_order,
                solver_bodies, histories, slot_of, local_of, level_of_body, colours_of_body, 0, 0, 0, 0, static_cast<int>(block_capacity * lanes), 0, false, limits::substeps, false};
    }
};
template <class S>
struct ManifoldPart<S, false> {};

template <class S, bool present>
struct FilterPart {
    BodyFilter filters[static_cast<unsigned>(S::max_bodies)] = {};
    FilterView filter_view() const { return {filters}; }
};
template <class S>
struct FilterPart<S, false> {
    static constexpr NoFilters filter_view() { return {}; }
};

template <class S, bool present>
struct PathPart {
    BodyPath paths[static_cast<unsigned>(S::max_bodies)] = {};
};
template <class S>
struct PathPart<S, false> {};

template <class S, bool present>
struct SensorPart {
    uint8_t is_sensor[static_cast<unsigned>(S::max_bodies)] = {};
    PairOfBodies overlaps[static_cast<unsigned>(S::max_overlaps)] = {};
    uint16_t overlap_count = 0;

    PairOfBodiesList overlap_list() { return {overlaps, &overlap_count, S::max_overlaps}; }
    /// With an empty list of overlaps, for a step to fill.
    SensorView sensor_view(const uint32_t* generation, StepReport& report) {
        overlap_count = 0;
        return {is_sensor, generation, overlap_list(), &report.overlaps_lost};
    }
};
template <class S>
struct SensorPart<S, false> {
    static constexpr NoSensors sensor_view(const uint32_t*, StepReport&) { return {}; }
};

template <class S, bool present>
struct SensorEventPart {
    PairOfBodies overlaps_before[static_cast<unsigned>(S::max_overlaps)] = {};
    uint16_t overlap_count_before = 0;

    PairOfBodiesList overlap_list_before() { return {overlaps_before, &overlap_count_before, S::max_overlaps}; }
};
template <class S>
struct SensorEventPart<S, false> {};

template <class S, bool present>
struct EventPart : SensorEventPart<S, has_sensors<S>> {
    static constexpr unsigned touching_capacity = static_cast<unsigned>(S::max_manifolds);
    Event events[static_cast<unsigned>(S::max_events)] = {};
    ImpactNote notes[touching_capacity] = {};
    PairOfBodies touching[touching_capacity] = {}, touching_before[touching_capacity] = {};
    uint16_t event_count = 0, touching_count = 0, touching_count_before = 0;

    ImpactNote* impact_notes() { return notes; }
    PairOfBodiesList touching_list() { return {touching, &touching_count, S::max_manifolds}; }
    PairOfBodiesList touching_list_before() { return {touching_before, &touching_count_before, S::max_manifolds}; }
    /// Empty, for a step to fill.
    EventList begin_events(StepReport& report) {
        event_count = 0;
        return {events, &event_count, S::max_events, &report.events_lost};
    }
};
template <class S>
struct EventPart<S, false> {
    static constexpr ImpactNote* impact_notes() { return nullptr; }
};

template <class S>
struct Storage : TranslationPart<S, S::translates>,
                 CompensationPart<S, S::rotation::compensates>,
                 EnergyPart<S, S::rotation::returns_energy>,
                 FieldPart<S, has_field<S>>,
                 SurfacePart<S, has_shapes<S>>,
                 ContactPart<S, collides<S>>,
                 ManifoldPart<S, stacks<S>>,
                 FilterPart<S, S::filters>,
                 SensorPart<S, has_sensors<S>>,
                 PathPart<S, follows_fast_bodies<S>>,
                 EventPart<S, has_events<S>> {
    RotationTile rotation[tile_capacity<S>] = {};
    uint32_t generation[static_cast<unsigned>(S::max_bodies)] = {};  ///< see BodyId: odd while a body lives in the slot
    uint32_t steps = 0;         ///< taken
    int32_t slots_used = 0;     ///< slots that hold or held a body
    int32_t free_hint = 0;      ///< no slot below it is free
    uint16_t world_tag = 0;

    BodyView bodies() {
        return {rotation, this->translation_tiles(), this->compensation_tiles(), this->energy_tiles(),
                (slots_used + lanes - 1) / lanes};
    }
    /// A view for reading; whoever holds it does not write.
    BodyView bodies() const { return const_cast<Storage*>(this)->bodies(); }

    /// Which pairs may touch.
    auto pair_rules(StepReport& report) {
        return PairRules<decltype(this->filter_view()), decltype(this->sensor_view(generation, report))>{
            this->filter_view(), this->sensor_view(generation, report)};
    }
    /// Bodies whose surfaces are solid to each other.
    bool can_meet(int slot_A, int slot_B) const {
        if constexpr (has_sensors<S>)
            if (this->is_sensor[slot_A] != 0 || this->is_sensor[slot_B] != 0) return false;
        return this->filter_view().let_meet(slot_A, slot_B);
    }
    SurfaceView surface_view() const { return {this->surfaces, slots_used}; }
    ContactView contact_view() { return {this->contacts, &this->contact_count, S::max_contacts}; }
};

} }  // namespace ingot
