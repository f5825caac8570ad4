// SPDX-License-Identifier: MIT
// The contacts of a step in parts that may be solved side by side. What an island does depends on nothing beside it, so a part, which has whole
// islands, is solved as if there were no other, in its own part of each array, and the bits are those of one solve for all.
#pragma once

#include "../../base/report.h"
#include "../../constraint/impact_note.h"
#include "../../constraint/kinematic_view.h"
#include "../../constraint/locked_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a part has its own in the arrays of the whole.
struct SolverPart {
    int pair_begin, pair_count;
    int body_begin, body_count;    ///< of what is by solver body, and the bodies that can move: [body_begin] stands for all that cannot
    int block_begin, block_count;
    int island_begin, island_count;
    int kinematic_before;          ///< room for contacts with kinematic bodies, of the parts before
};

/// Beside the arrays of the solver: its pairs in the order of parts. What a scene has not is null.
struct PartRoom {
    BodyPair* pairs;         ///< by manifold, as SolverView::pairs
    BodyPair* shape_pairs;   ///< as SolverView::shape_pairs, where these are others than pairs
    Index* manifold_of;             ///< by pair of a part: which of the whole it is
    ImpactNote* notes;              ///< as StepNotes::impacts
};

/// Cuts the islands of the whole into at most `most` parts with as many contacts each as can be, those with most of them first; returns how many
/// there are, 1 where it is not worth it: then nothing is in room or parts.
/// capacity: blocks there are. has_kinematic: contacts with kinematic bodies need solver bodies.
/// Cost: five walks along the contacts.
int cut_into_parts(const SolverView& whole, const BodyView& bodies, int most, const PartRoom& room, const ImpactNote* notes, bool has_kinematic,
                   SolverPart* parts);

/// What a step tells of its impacts, from the order of a part to that of the whole.
void give_back_notes(const SolverPart& part, const PartRoom& room, ImpactNote* notes);

/// The report of a part joins that of the step.
void add_report(StepReport& report, const StepReport& of_part);

/// The whole is told of the bodies of a part, one part after the other: see takes_part. Before the first it has none.
void find_bodies_of_part(SolverView& whole, const SolverView& of_part, const SolverPart& part);

/// The view of the whole becomes that of a part.
inline void become_part(SolverView& view, const SolverPart& part, const PartRoom& room) {
    const bool has_shape_pairs = view.shape_pairs != nullptr;
    view.pairs = room.pairs + part.pair_begin;
    if (has_shape_pairs) view.shape_pairs = room.shape_pairs != nullptr ? room.shape_pairs + part.pair_begin : view.pairs;
    view.manifold_count = part.pair_count;
    view.side_by_side = true;
    const int body_begin = part.body_begin + part.kinematic_before;
    view.bodies += body_begin;
    view.histories += body_begin;
    view.colours_of_body += body_begin;
    view.slot_of += part.body_begin;
    view.level_of_body += part.body_begin;
    view.island_of += part.body_begin;
    view.batch_bodies += part.body_begin;
    view.islands += part.island_begin;
    view.island_at += part.pair_begin;
    view.level += part.pair_begin;
    view.members += part.pair_begin;
    view.sorted += part.pair_begin;
    view.colour += part.pair_begin;
    view.blocks += part.block_begin;
    view.visits += part.pair_begin + part.block_begin;
    view.some_visits += part.pair_begin + part.block_begin;
    view.lane_capacity = part.block_count * lanes;
}
template <bool rolls, bool has_belts>
void become_part(MaterialView<rolls, has_belts>& view, const SolverPart& part, const PartRoom& room) {
    become_part(static_cast<SolverView&>(view), part, room);
    if (view.rolling != nullptr) view.rolling += part.block_begin;
    if (view.belts != nullptr) view.belts += part.block_begin;
}
template <class View>
void become_part(KinematicViewOf<View>& view, const SolverPart& part, const PartRoom& room) {
    become_part(static_cast<View&>(view), part, room);
    view.kinematic.contacts += part.pair_begin;
    view.kinematic.body_begin = part.body_count + 1;
}

} }  // namespace ingot
