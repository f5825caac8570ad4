// SPDX-License-Identifier: MIT
// How blocks are prepared, for the files that are compiled for some of the views: what is small for balls is fast for others.
#pragma once

#include "prepare_blocks.h"

#include "collect_blocks.h"
#include "contact.h"
#include "jointed_response.h"
#include "locked_view.h"
#include "prepare_responses.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr ManifoldRecord no_contact = {{{0, 0, 1}, 0, 0, 0, {}}, 0, 0, {}, {}, {}, 0, 0, 0};

/// What is on record of one lane's manifold. Impulses become `share` times as much: see shares_of_substep.
struct KeptOfLane {
    const ManifoldRecord& record;
    int record_i;  ///< -1: a spare lane
    scalar share;
};
inline KeptOfLane kept_of(const SolverView& solver, Index manifold_i) {
    if (is_spare(manifold_i)) return {no_contact, -1, 0};
    const int record_i = solver.pairs[manifold_i].record;
    return {solver.records[record_i], record_i, shares_of_substep(solver)};
}

/// What the rows of a block are made of, from the tiles of its bodies as they are now.
template <class Contacts, bool have_joints, class View>
Contacts collected(const View& solver, const BodyView& bodies, ContactBlock& block) {
    Collected in{};
    if constexpr (have_joints)
        collect(solver, bodies, block, in);
    else
        collect_free(solver, bodies, block, in);
    if constexpr (View::locks_axes) block.rows = block_rows;
    return vectors_of<Contacts>(solver, block, in);
}

inline void name_bodies(const SolverView& solver, ContactBlock& block, int lane_i) {
    const Index manifold_i = block.manifold[lane_i];
    block.body_A[lane_i] = is_spare(manifold_i) ? Index(0) : solver.local_of[solver.pairs[manifold_i].body_A];
    block.body_B[lane_i] = is_spare(manifold_i) ? Index(0) : solver.local_of[solver.pairs[manifold_i].body_B];
}

/// Calls prepare(contacts) with what the bodies of a block answer: by themselves, or with their figures.
template <class View, class Prepare>
void with_contacts(const View& solver, const BodyView& bodies, int block_i, const Prepare& prepare) {
    if constexpr (View::articulates)
        if (is_jointed(solver.jointed, block_i)) {
            prepare_responses(solver, bodies, block_i);
            auto contacts = collected<JointedLaneContacts, true>(solver, bodies, solver.blocks[block_i]);
            contacts.response.block = &solver.jointed.blocks[block_i - solver.jointed.first_block];
            const mask held = contacts.response.held_fast(contacts.P[0], contacts.n);
            for (int row = 0; row < solver.blocks[block_i].rows; ++row) contacts.used[row] = select(held, lane{}, contacts.used[row]);  // bound: 4
            return prepare(contacts);
        }
    auto contacts = collected<LaneContactsOfView<View>, false>(solver, bodies, solver.blocks[block_i]);
    see_locks(solver, solver.blocks[block_i], contacts);
    prepare(contacts);
}

template <class View, class Contacts>
void prepare_block(const View& solver, int block_i, Contacts& contacts) {
    ContactBlock& block = solver.blocks[block_i];
    block.turning = block.moving = 0;
    store(block.refreshed_at, lane{});
    store(block.inv_M_A, contacts.response.A.inv_M);
    store(block.inv_M_B, contacts.response.B.inv_M);
    store(block.n, contacts.n);
    store(block.t_1, contacts.t_1);
    store(block.t_2, contacts.t_2);

    ContactConstraint<View>::Given::prepare(solver, block_i, contacts);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const KeptOfLane kept = kept_of(solver, block.manifold[lane_i]);
        block.substeps[lane_i] = static_cast<scalar>(age_of(kept.record));
        ContactConstraint<View>::Given::recall(solver, block_i, lane_i, kept);
    }
    block.noted = bits(contacts.central);
}

template <class View>
void prepare_blocks(const View& solver, const BodyView& bodies) {
    // bound: max_manifolds, rounded up to whole blocks
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        for (int lane_i = 0; lane_i < lanes; ++lane_i) name_bodies(solver, solver.blocks[block_i], lane_i);
        with_contacts(solver, bodies, block_i, [&](auto& contacts) { prepare_block(solver, block_i, contacts); });
    }
}

template <class View>
void remember_impulses(const View& solver) {
    constexpr scalar substeps_max = limits::substeps_kept;
    const scalar part = 1 / shares_of_substep(solver);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const Index manifold_i = block.manifold[lane_i];
            if (is_spare(manifold_i) || solver.islands[block.island[lane_i]].begins_again) continue;
            const int record_i = solver.pairs[manifold_i].record;
            const scalar substeps = block.substeps[lane_i];
            const auto age = static_cast<uint16_t>(substeps < substeps_max ? substeps : substeps_max);
            solver.records[record_i].substeps = solver.islands[block.island[lane_i]].steady ? static_cast<uint16_t>(age | steady_bit) : age;
            ContactConstraint<View>::Given::remember(solver, block_i, lane_i, record_i, part);
        }
    }
}

} }  // namespace ingot
