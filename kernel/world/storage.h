// SPDX-License-Identifier: MIT
// The memory of a world, part by part: a part its scene does not name is an empty base and takes no room.
//
// No part holds a pointer to itself, all zero is the valid empty part, and nothing has a constructor that runs: a world
// lies in .bss and memcpy is its snapshot.
#pragma once

#include "../base/sort_in_tail.h"
#include "../body/body_tiles.h"
#include "../impulse/find_contacts.h"
#include "../constraint/material_view.h"
#include "../events/contact_events.h"
#include "../sleep/at_rest.h"
#include "../sleep/fall_asleep.h"
#include "../island/islands.h"
#include "../sleep/wake.h"
#include "../continuous/body_path.h"
#include "scene.h"

namespace ingot { inline namespace INGOT_ABI {

template <class S>
inline constexpr int pair_capacity = static_cast<int>(pairs_with_own<S>);

template <class S>
inline constexpr int tile_capacity = (S::max_bodies + lanes - 1) / lanes;

template <class S>
inline constexpr int shape_tile_capacity = (shape_capacity<S> + lanes - 1) / lanes;

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

    Forcing<typename S::force_field> forcing(const Vector& gravity) const { return {field, gravity, t}; }
    void advance_time(scalar h) {  // Kahan: rounding does not add up over the steps
        const scalar due = h + t_low, t_next = t + due;
        t_low = due - (t_next - t);
        t = t_next;
    }
};
template <class S>
struct FieldPart<S, false> {};

/// A field in which bodies sleep.
template <class S, bool present>
struct SteadyFieldPart {
    typename S::force_field field_before = {};              ///< of the last step
    scalar pull_sq[static_cast<unsigned>(S::max_bodies)] = {};  ///< (m s^-2)^2, of gravity and what the field and the user add, in this step
    uint8_t field_changed = 0;                              ///< since the last step of a world that was saved then

    const scalar* pull_of_bodies() const { return pull_sq; }
};
template <class S>
struct SteadyFieldPart<S, false> {
    static constexpr const scalar* pull_of_bodies() { return nullptr; }
};

template <class S, bool present>
struct ContactPart {
    Contact contacts[static_cast<unsigned>(S::max_contacts)] = {};
    uint16_t contact_count = 0;
};
template <class S>
struct ContactPart<S, false> {};

template <class S, bool present>
struct SurfacePart {
    Surface surfaces[static_cast<unsigned>(shape_capacity<S>)] = {};
};
template <class S>
struct SurfacePart<S, false> {};

/// Bodies of several shapes. Shapes as bodies are derived, and always where their bodies are.
template <class S, bool present>
struct CompoundPart {
    RotationTile shape_rotation[shape_tile_capacity<S>] = {};
    TranslationTile shape_translation[shape_tile_capacity<S>] = {};
    ShapePlace shape_places[static_cast<unsigned>(shape_capacity<S>)] = {};
    uint32_t shape_generation[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< of the body

    BodyView shape_view(const BodyView&, int slots_used) {
        return {shape_rotation, shape_translation, nullptr, nullptr, (slots_used * S::max_shapes_of_body + lanes - 1) / lanes};
    }
    const uint32_t* generation_of_shapes(const uint32_t*) const { return shape_generation; }
    void set_generation_of_shapes(int slot, uint32_t generation) {
        for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i) shape_generation[slot * S::max_shapes_of_body + shape_i] = generation;
    }
};
template <class S>
struct CompoundPart<S, false> {
    static BodyView shape_view(const BodyView& bodies, int) { return bodies; }
    static const uint32_t* generation_of_shapes(const uint32_t* of_bodies) { return of_bodies; }
};

template <class S, bool present>
struct BodyPairPart {
    BodyPair body_pairs[static_cast<unsigned>(S::max_manifolds)] = {};
    BodyPair* by_bodies(BodyPair*) { return body_pairs; }
};
template <class S>
struct BodyPairPart<S, false> {
    static BodyPair* by_bodies(BodyPair* pairs) { return pairs; }
};

template <class S, bool present>
struct AnchorPart {
    ManifoldAnchors anchors[static_cast<unsigned>(S::max_manifolds)] = {};
    ManifoldAnchors* manifold_anchors() { return anchors; }
};
template <class S>
struct AnchorPart<S, false> {
    ManifoldAnchors* manifold_anchors() { return nullptr; }
};

template <class S>
inline constexpr unsigned block_capacity_of = [] {  // see order_manifolds
    constexpr unsigned full = (static_cast<unsigned>(S::max_manifolds) + lanes - 1) / lanes;
    return lanes == 1 ? full : full + full / 2 + 2;
}();

template <class S, bool present>
struct RollingPart {
    scalar rolling_levers[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< m, by shape slot
    RollingRecord rolling_records[static_cast<unsigned>(S::max_manifolds)] = {};
    RollingRows rolling_rows[block_capacity_of<S>] = {};

    void reset_rolling(int shape_slot) { rolling_levers[shape_slot] = 0; }
    void mix_rolling(const ManifoldView& manifolds) { mix_rolling_levers(manifolds, rolling_levers, rolling_records); }
    void show_rolling(RollingRows*& rows, RollingRecord*& records) { rows = rolling_rows, records = rolling_records; }
};
template <class S>
struct RollingPart<S, false> {
    static void reset_rolling(int) {}
    static void mix_rolling(const ManifoldView&) {}
    static void show_rolling(RollingRows*&, RollingRecord*&) {}
};

template <class S, bool present>
struct BeltPart {
    Vector surface_velocities[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< m/s, in the shape's axes, by shape slot
    Vector belt_velocities[static_cast<unsigned>(S::max_manifolds)] = {};      ///< m/s, world, by record
    BeltRows belt_rows[block_capacity_of<S>] = {};

    void reset_belt(int shape_slot) { surface_velocities[shape_slot] = {}; }
    void turn_belts(const BodyView& shapes, const ManifoldView& manifolds) {
        turn_surface_velocities(shapes, manifolds, surface_velocities, belt_velocities);
    }
    void show_belts(BeltRows*& rows, const Vector*& velocities) { rows = belt_rows, velocities = belt_velocities; }
};
template <class S>
struct BeltPart<S, false> {
    static void reset_belt(int) {}
    static void turn_belts(const BodyView&, const ManifoldView&) {}
    static void show_belts(BeltRows*&, const Vector*&) {}
};

template <class S, bool sleeps>
struct BroadPhasePart : S::broad_phase::template AwakeMemory<shape_capacity<S>, pair_capacity<S>> {};
template <class S>
struct BroadPhasePart<S, false> : S::broad_phase::template Memory<shape_capacity<S>, pair_capacity<S>> {};

/// What other traits add to contacts.
template <class S>
struct ManifoldTraitsPart : AnchorPart<S, S::recycles_manifolds>, BodyPairPart<S, has_compounds<S> && !S::sleeps>, BroadPhasePart<S, S::sleeps>,
                            S::solver::template Memory<S::max_bodies, S::max_manifolds> {};

/// What a solver works in that solves manifolds as blocks. The light solver brings all it needs.
template <class S, bool present>
struct BlockPart : ManifoldTraitsPart<S> {
    static constexpr unsigned body_capacity = static_cast<unsigned>(S::max_bodies) + 1;

    ContactBlock blocks[block_capacity_of<S>] = {};
    SolverBody solver_bodies[body_capacity] = {};
    SolverBodyHistory histories[body_capacity] = {};
};
template <class S>
struct BlockPart<S, false> : ManifoldTraitsPart<S> {};

/// Between the two parts of blocks: after numbers of four bytes it leaves no gap.
template <class S>
struct ManifoldListPart : BlockPart<S, !S::solver::is_pointwise> {
    static constexpr unsigned manifold_capacity = static_cast<unsigned>(S::max_manifolds);

    BoundsTile bounds[shape_tile_capacity<S>] = {};
    BodyPair found_pairs[pair_capacity<S>] = {};
    BodyPair pairs[manifold_capacity] = {};
    ManifoldRecord records[manifold_capacity] = {};
};

/// The order in which blocks are visited.
template <class S, bool present>
struct BlockOrderPart : ManifoldListPart<S> {
    static constexpr unsigned manifold_capacity = static_cast<unsigned>(S::max_manifolds);
    static constexpr unsigned block_capacity = block_capacity_of<S>;
    static constexpr unsigned body_capacity = static_cast<unsigned>(S::max_bodies) + 1;

    uint32_t colours_of_body[body_capacity] = {};
    uint16_t level_of_body[body_capacity] = {}, slot_of[body_capacity] = {};
    uint16_t local_of[static_cast<unsigned>(tile_capacity<S> * lanes)] = {};
    uint16_t order[block_capacity * lanes] = {};
    uint16_t other_order[manifold_capacity] = {}, level_order[manifold_capacity] = {}, level[manifold_capacity] = {};
    Visit visits[manifold_capacity + block_capacity] = {};

    SolverView solver_of(const BodyPair* pairs_of_bodies, ManifoldRecord* records_of_pairs, int count) {
        constexpr int room = static_cast<int>(block_capacity * lanes);
        return {pairs_of_bodies, records_of_pairs, count, this->blocks, visits, order, level, other_order, level_order,
                this->solver_bodies, this->histories, slot_of, local_of, level_of_body, colours_of_body,
                0, 0, 0, 0, 0, 0, room, 0, false, limits::substeps, false};
    }
};
template <class S>
struct BlockOrderPart<S, false> : ManifoldListPart<S> {};

template <class S, bool present>
struct ManifoldPart : BlockOrderPart<S, !S::solver::is_pointwise> {
    uint16_t found_count = 0, pairs_lost = 0;
    uint16_t manifold_count = 0, records_used = 0, first_free_record = 0;

    PairList pair_list() { return {this->found_pairs, pair_capacity<S>, &found_count, &pairs_lost}; }
    ManifoldView manifold_view() {
        return {this->pairs, &manifold_count, this->records, this->manifold_anchors(), &records_used, &first_free_record, S::max_manifolds};
    }
    auto solver() { return this->solver_of(this->by_bodies(this->pairs), this->records, manifold_count); }
};
template <class S>
struct ManifoldPart<S, false> {};

template <class S, bool present>
struct FilterPart {
    BodyFilter filters[static_cast<unsigned>(S::max_bodies)] = {};
    FilterView<S::max_shapes_of_body> filter_view() const { return {filters}; }
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
    uint8_t is_sensor[static_cast<unsigned>(shape_capacity<S>)] = {};
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

/// Of scenes that sleep, too: the list of pairs that touch holds those of the step alone.
template <class S, bool present>
struct TouchAsidePart {
    uint8_t touches_aside[static_cast<unsigned>(S::max_manifolds)] = {};  ///< by record that is put aside: 1 where its bodies touch
};
template <class S>
struct TouchAsidePart<S, false> {};

template <class S, bool present>
struct EventPart : SensorEventPart<S, has_sensors<S>>, TouchAsidePart<S, S::sleeps> {
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

template <class S, bool present>
struct SleepPart {
    static constexpr unsigned tiles = static_cast<unsigned>(tile_capacity<S>);
    static constexpr unsigned shape_slots = static_cast<unsigned>(shape_tile_capacity<S> * lanes);
    static constexpr int tile_words = ActiveTiles::words_for(tile_capacity<S>), word_words = ActiveTiles::words_for(tile_words);

    uint32_t active_tiles[static_cast<unsigned>(tile_words)] = {}, active_words[static_cast<unsigned>(word_words)] = {};
    scalar rest_time[static_cast<unsigned>(S::max_bodies)] = {};
    uint16_t awake[tiles] = {}, settling[tiles] = {};
    uint16_t parent[tiles * lanes] = {}, next_body[tiles * lanes] = {}, aside[tiles * lanes] = {};
    BodyPair awake_pairs[static_cast<unsigned>(S::max_manifolds)] = {};  ///< between two steps: room to sort in
    BodyPair pairs_aside[static_cast<unsigned>(S::max_manifolds)] = {};
    uint16_t awake_pair_count = 0, aside_count = 0;
    uint8_t marks[tiles * lanes] = {};
    uint8_t search_flags[shape_slots] = {};
    uint8_t bounds_are_made = 0;  ///< 0: no step was taken since the world began or was loaded

    RestView rest_view() {
        return {awake, settling, {active_tiles, active_words, word_words}, rest_time, parent, next_body, marks, aside, pairs_aside, &aside_count,
                S::max_shapes_of_body};
    }
    bool is_awake(int slot) const { return RestView::has(awake, slot); }
};
template <class S>
struct SleepPart<S, false> {};

template <class S>
struct Storage : TranslationPart<S, S::translates>,
                 CompensationPart<S, S::rotation::compensates>,
                 EnergyPart<S, S::rotation::returns_energy>,
                 FieldPart<S, has_field<S>>,
                 SteadyFieldPart<S, has_field<S> && S::sleeps>,
                 SurfacePart<S, has_shapes<S>>,
                 CompoundPart<S, has_compounds<S>>,
                 ContactPart<S, collides<S>>,
                 ManifoldPart<S, stacks<S>>,
                 RollingPart<S, S::rolling_resistance>,
                 BeltPart<S, S::surface_velocities>,
                 FilterPart<S, S::filters>,
                 SensorPart<S, has_sensors<S>>,
                 PathPart<S, follows_fast_bodies<S>>,
                 EventPart<S, has_events<S>>,
                 SleepPart<S, S::sleeps> {
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
        using Rules = PairRules<decltype(this->filter_view()), decltype(this->sensor_view(generation, report))>;
        if constexpr (S::sleeps)
            return RulesOfRest<Rules>{{this->filter_view(), this->sensor_view(this->generation_of_shapes(generation), report)}, this->rest_view()};
        else
            return Rules{this->filter_view(), this->sensor_view(this->generation_of_shapes(generation), report)};
    }
    SurfaceView surface_view() const { return {this->surfaces, slots_used * S::max_shapes_of_body}; }

    /// All shapes, for search, narrow phase and queries; the bodies themselves, where each has one shape.
    BodyView shapes() { return this->shape_view(bodies(), slots_used); }
    BodyView shapes() const { return const_cast<Storage*>(this)->shapes(); }
    CompoundView compound_view() { return {this->surfaces, this->shape_places, shapes(), S::max_shapes_of_body}; }
    /// Shapes are where their bodies are.
    void place_all_shapes() {
        for (int slot = 0; slot < slots_used; ++slot) place_shapes(bodies(), compound_view(), slot);
    }
    /// The same for those of bodies that are awake or settling.
    void place_active_shapes() {
        for_active(this->rest_view(), [this](int slot) { place_shapes(bodies(), compound_view(), slot); });
    }
    SearchView search_view() { return {shapes(), surface_view(), this->bounds, this->search_flags}; }
    SensorMarks sensor_marks() const {
        if constexpr (has_sensors<S>) return this->is_sensor;
        return nullptr;
    }
    /// Manifolds that have come back behind the first `sorted` take their place among those of the step, and those that touch their place among these.
    void sort_in_woken(int sorted) {
        const ManifoldView manifolds = this->manifold_view();
        if constexpr (has_events<S>) {
            const PairOfBodiesList touch = this->touching_list();
            const uint32_t* generation_of = this->generation_of_shapes(generation);
            const int touched = *touch.count;
            for (int pair_i = sorted; pair_i < *manifolds.count; ++pair_i) {
                const BodyPair& pair = manifolds.pairs[pair_i];
                if (this->touches_aside[pair.record] == 0) continue;
                this->touches_aside[pair.record] = 0;
                write_pair(touch.pairs[(*touch.count)++],
                           {pair.body_A, pair.body_B, generation_of[pair.body_A], generation_of[pair.body_B], false});
            }
            sort_in_tail(touch.pairs, touched, *touch.count, this->touching_before);
        }
        sort_in_tail(manifolds.pairs, sorted, *manifolds.count, this->awake_pairs);
    }
    /// True where the numbers of the field are not those of the last step.
    bool has_new_field() const {
        return this->field_changed != 0 ||
               (this->bounds_are_made != 0 && __builtin_memcmp(&this->field, &this->field_before, sizeof this->field) != 0);
    }
    /// Manifolds of what rests leave the lists of the step; touches_aside keeps which of them touch.
    void put_aside() {
        int touching_i = 0, kept = 0;
        put_manifolds_aside(bodies(), this->rest_view(), this->manifold_view(), [&](int manifold_i, int record) {
            if constexpr (has_events<S>) {
                const PairOfBodiesList touch = this->touching_list();
                const uint32_t key = this->pairs[manifold_i].key();
                while (touching_i < *touch.count && touch.pairs[touching_i].key() < key)
                    copy_item(touch.pairs[kept++], touch.pairs[touching_i++]);
                const bool touches = touching_i < *touch.count && touch.pairs[touching_i].key() == key;
                this->touches_aside[record] = touches ? 1 : 0;
                if (touches) ++touching_i;
            }
        });
        if constexpr (has_events<S>) {
            const PairOfBodiesList touch = this->touching_list();
            while (touching_i < *touch.count) copy_item(touch.pairs[kept++], touch.pairs[touching_i++]);
            *touch.count = static_cast<uint16_t>(kept);
        }
    }
    /// Contacts of the step by the slots of bodies.
    ManifoldView manifolds_of_bodies() {
        ManifoldView manifolds = this->manifold_view();
        manifolds.pairs = this->by_bodies(manifolds.pairs);
        return manifolds;
    }
    /// Those that a step solves: all, or those of bodies that are awake.
    ManifoldView moving_manifolds() {
        ManifoldView manifolds = manifolds_of_bodies();
        if constexpr (S::sleeps) {
            manifolds.pairs = this->awake_pairs;
            manifolds.count = &this->awake_pair_count;
        }
        return manifolds;
    }
    /// What the contact solver works on; where surfaces have materials beside friction, with those of the pairs that touch now.
    auto contact_solver() {
        if constexpr (has_materials<S>) {
            MaterialView<S::rolling_resistance, S::surface_velocities> view{this->solver(), nullptr, nullptr, nullptr, nullptr};
            this->mix_rolling(this->manifold_view());
            this->turn_belts(shapes(), this->manifold_view());
            this->show_rolling(view.rolling, view.rolling_records);
            this->show_belts(view.belts, view.belt_velocities);
            return view;
        } else {
            return this->solver();
        }
    }
    void reset_materials(int shape_slot) {
        this->reset_rolling(shape_slot);
        this->reset_belt(shape_slot);
    }
    /// Bodies whose surfaces are solid to each other.
    bool can_meet(int slot_A, int slot_B) const {
        if constexpr (has_sensors<S>)
            if (this->is_sensor[slot_A] != 0 || this->is_sensor[slot_B] != 0) return false;
        return this->filter_view().let_meet(slot_A, slot_B);
    }
    ContactView contact_view() { return {this->contacts, &this->contact_count, S::max_contacts}; }
};

} }  // namespace ingot
