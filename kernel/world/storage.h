// SPDX-License-Identifier: MIT
// The memory of a world: that of the features its scene names, one after the other, and of its slots. What a scene does not name is an empty base
// and takes no room.
//
// No part holds a pointer to itself, all zero is the valid empty part, and nothing has a constructor that runs: a world
// lies in .bss and memcpy is its snapshot.
#pragma once

#include "../broad_phase/hold_shapes.h"
#include "../broad_phase/part_leaves.h"
#include "../constraint/locked_view.h"
#include "features/features.h"

namespace ingot { inline namespace INGOT_ABI {

/// What joints of a scene have beside what they lock.
template <class S>
using JointRowViewOf = If<has_loops<S>, LoopedRowView, If<has_joint_drives<S>, DrivenRowView, JointRowView>>;

template <class S>
struct Storage : features::All::Memory<S> {
    RotationTile rotation[features::tile_capacity<S>] = {};
    uint32_t generation[static_cast<unsigned>(S::max_bodies)] = {};  ///< see BodyId: odd while a body lives in the slot
    uint32_t steps = 0;         ///< taken
    int32_t slots_used = 0;     ///< slots that hold or held a body
    int32_t free_hint = 0;      ///< no slot below it is free
    uint16_t world_tag = 0;

    bool lives(int slot) const { return (generation[slot] & 1u) != 0; }

    /// Of a level the slots that it takes; else the slot itself.
    template <class Each>
    void over_bodies_of(int slot, const Each& each) {
        each(slot);
        if constexpr (has_levels<S>)
            if (this->surfaces[slot * S::max_shapes_of_body].shape.kind == ShapeKind::level)
                for (int k = 1; k < bodies_of_level<S>; ++k) each(slot + k);  // bound: level_patches
    }
    /// The same of shapes: of one of a level all of them.
    template <class Each>
    void over_shapes_of(int shape_slot, const Each& each) {
        if constexpr (has_levels<S>) {
            if (const Shape& shape = this->surfaces[shape_slot].shape; shape.kind == ShapeKind::level) {
                const int first = shape_slot - patch_number(shape);
                for (int patch_i = 0; patch_i < level_patches; ++patch_i) each(first + patch_i);
                return;
            }
        }
        each(shape_slot);
    }
    /// The slot whose id is that of the body: of a level the first that it takes.
    int owner_of(int slot) const {
        if constexpr (has_levels<S>) {
            const Shape& shape = this->surfaces[slot * S::max_shapes_of_body].shape;
            if (shape.kind == ShapeKind::level) return slot - patch_number(shape) / S::max_shapes_of_body;
        }
        return slot;
    }

    BodyView bodies() {
        return {rotation, this->translation_tiles(), this->compensation_tiles(), this->energy_tiles(),
                (slots_used + lanes - 1) / lanes};
    }
    /// A view for reading; whoever holds it does not write.
    BodyView bodies() const { return const_cast<Storage*>(this)->bodies(); }

    /// Those that sleep too.
    FigureView all_figures() { return this->figure_view(bodies()); }
    FigureView figures(scalar h) {
        FigureView view = all_figures();
        if constexpr (S::sleeps) view.awake = this->awake;
        if constexpr (swings_freely<S>) view.awake = this->left_lanes;
        view.gravity = this->gravity;
        view.h = h;
        return view;
    }
    auto loop_view() {
        auto view = this->loops();
        this->show_ties(view);
        this->show_targets(view);
        this->show_gears(view);
        return view;
    }
    JointRowViewOf<S> joint_row_view() {
        JointRowViewOf<S> view{};
        view.angles = this->joint_angles;
        view.motions = this->joint_motions;
        view.list = this->joint_rows;
        view.responses = this->responses;
        this->show_limits(view);
        if constexpr (has_joint_drives<S>) this->show_drives(view);
        return view;
    }
    /// Who may meet whom, sensors apart: by filters, and by joints.
    auto meeting_view() const { return this->with_joints(this->filter_view()); }
    /// Which pairs may touch.
    auto pair_rules(StepReport& report) {
        using Rules = PairRules<decltype(meeting_view()), decltype(this->sensor_view(generation, report))>;
        if constexpr (S::sleeps)
            return RulesOfRest<Rules>{{meeting_view(), this->sensor_view(this->generation_of_shapes(generation), report)}, this->rest_view()};
        else
            return Rules{meeting_view(), this->sensor_view(this->generation_of_shapes(generation), report)};
    }
    SurfaceView surface_view() const { return {this->surfaces, slots_used * S::max_shapes_of_body, S::length_unit}; }

    /// All shapes, for search, narrow phase and queries; the bodies themselves, where each has one shape.
    BodyView shapes() { return this->shape_view(bodies(), slots_used); }
    BodyView shapes() const { return const_cast<Storage*>(this)->shapes(); }
    /// The shapes of bodies as they lie on them.
    BodyShapes body_shapes() const { return {surface_view(), this->places_of_shapes(), hulls_of<S>, S::max_shapes_of_body}; }
    /// What they have beside friction and restitution.
    ShapeMaterials shape_materials() const { return {this->levers_of_shapes(), this->velocities_of_shapes()}; }
    CompoundView compound_view() { return {this->surfaces, this->shape_places, shapes(), S::max_shapes_of_body}; }
    /// Shapes are where their bodies are.
    void place_all_shapes() {
        // bound: max_bodies
        for (int slot = 0; slot < slots_used; ++slot) place_shapes(bodies(), compound_view(), slot);
    }
    /// The same for those of bodies that are awake or settling.
    void place_active_shapes() {
        for_active(this->rest_view(), [this](int slot) { place_shapes(bodies(), compound_view(), slot); });
    }
    SearchView search_view() { return {shapes(), surface_view(), this->bounds, this->search_flags}; }
    /// Of scenes whose queries go through it. Nothing in it is a pointer to be kept; whoever asks a query does not write.
    SortedTreeView query_tree() const { return const_cast<Storage*>(this)->tree_of_bounds(); }
    /// Queries find the shapes of a body where they are now. Before the first search there is no tree, and they look at all.
    void hold_shapes([[maybe_unused]] int slot) {
        if constexpr (queries_by_tree<S>)
            ingot::hold_shapes(search_view(), query_tree(), slot * S::max_shapes_of_body, (slot + 1) * S::max_shapes_of_body);
    }
    /// The same after a step, of all bodies that it may have moved.
    void hold_moved_shapes() {
        if constexpr (queries_by_tree<S>) {
            const SearchView search = search_view();
            const SortedTreeView tree = query_tree();
            if (part_leaves(search, tree)) return;
            if constexpr (S::sleeps)
                for_active(this->rest_view(), [&](int slot) {
                    ingot::hold_shapes(search, tree, slot * S::max_shapes_of_body, (slot + 1) * S::max_shapes_of_body);
                });
            else
                ingot::hold_shapes(search, tree, 0, slots_used * S::max_shapes_of_body);
        }
    }
    SensorMarks sensor_marks() const {
        if constexpr (has_sensors<S>) return this->is_sensor;
        return nullptr;
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
    /// The same pairs by the slots of shapes.
    const BodyPair* moving_shape_pairs() {
        if constexpr (S::sleeps && has_compounds<S>)
            return nullptr;
        else if constexpr (S::sleeps)
            return this->awake_pairs;
        else
            return this->pairs;
    }
    /// What the contact solver works on; where surfaces have materials beside friction, with those of the pairs that touch now.
    auto contact_solver() {
        if constexpr (has_joints<S>) return jointed_contact_solver();
        else if constexpr (S::kinematic_bodies) {
            auto plain = plain_contact_solver();
            If<solves_pointwise<S>, KinematicPointViewOf<decltype(plain)>, KinematicViewOf<decltype(plain)>> view{};
            static_cast<decltype(plain)&>(view) = plain;
            this->show_kinematic(view, this->kinematic);
            return view;
        } else {
            return plain_contact_solver();
        }
    }
    /// The same where bodies have joints.
    auto jointed_contact_solver() {
        auto plain = plain_contact_solver();
        using Plain = decltype(plain);
        using Looped = If<has_joint_rows<S>, LoopedRowedViewOf<Plain>, LoopedViewOf<Plain>>;
        using Open = If<has_joint_rows<S>, RowedViewOf<Plain, JointRowViewOf<S>>, JointedViewOf<Plain>>;
        using Unread = If<has_loops<S>, Looped, Open>;
        using Jointed = If<has_joint_reactions<S>, ReactingViewOf<Unread>, Unread>;
        If<S::kinematic_bodies, KinematicViewOf<Jointed>, Jointed> view{};
        static_cast<Plain&>(view) = plain;
        view.jointed = this->jointed_bodies(figures(0));
        if constexpr (has_joint_rows<S>) view.joint_rows = joint_row_view();
        if constexpr (has_loops<S>) view.loops = loop_view();
        if constexpr (has_joint_reactions<S>) view.reactions = this->reactions();
        if constexpr (S::kinematic_bodies) this->show_kinematic(view, this->kinematic);
        return view;
    }
    /// Without materials. Blocks know the shapes that touch.
    auto swept_solver() {
        auto view = this->solver();
        if constexpr (!solves_pointwise<S>) {
            view.shapes = body_shapes();
            view.shape_pairs = this->moving_shape_pairs();
        }
        return view;
    }
    /// The same, which sees kinematic bodies as immovable ones.
    auto plain_contact_solver() {
        if constexpr (S::axis_locks && !solves_pointwise<S>) {
            auto unlocked = unlocked_contact_solver();
            LockedView view{};
            static_cast<decltype(unlocked)&>(view) = unlocked;
            if constexpr (!has_materials<S>) this->show_idle_materials(view);
            view.locks = this->locks;
            view.surfaces_move = S::surface_velocities;
            return view;
        } else {
            return unlocked_contact_solver();
        }
    }
    /// The same, which takes bodies for such that move along all axes.
    auto unlocked_contact_solver() {
        if constexpr (has_materials<S> || (solves_pointwise<S> && S::bounces)) {
            auto plain = swept_solver();
            constexpr bool both = features::solves_all_materials<S> && has_materials<S>;  // see StillBeltPart
            typename S::solver::template View<S::rolling_resistance || both, S::surface_velocities || both, S::bounces> view{};
            static_cast<decltype(plain)&>(view) = plain;
            this->mix_rolling(this->manifold_view());
            this->turn_belts(shapes(), this->manifold_view());
            this->show_rolling(view);
            this->show_belts(view);
            if constexpr (solves_pointwise<S>) this->show_landings(view);
            return view;
        } else {
            return swept_solver();
        }
    }
    /// Shapes that are solid to each other.
    bool can_meet(int shape_A, int shape_B) const {
        if constexpr (has_sensors<S>)
            if (this->is_sensor[shape_A] != 0 || this->is_sensor[shape_B] != 0) return false;
        return meeting_view().let_meet(shape_A, shape_B);
    }
    ContactView contact_view() {
        ContactView view = {this->contacts, &this->contact_count, S::max_contacts};
        if constexpr (S::reads_contacts) view.places = this->contact_places;
        return view;
    }
};

} }  // namespace ingot
