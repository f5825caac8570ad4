// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "../../constraint/impact_note.h"
#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// In SolverView::colours_of_body, once find_impact_chains has run: the body is on something that does not bounce, or that bears load.
inline constexpr uint32_t leaning_body = 1u << 31;
/// Lanes of which a body leans so. Solver body 0, which stands for all that cannot move, has marks of others' contacts.
inline mask leaning_lanes(const SolverView& solver, const ContactBlock& block) {
    const auto leans = [&](Index body_i) { return body_i != 0 && (solver.colours_of_body[body_i] & leaning_body) != 0; };
    uint16_t leaning = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if (leans(block.body_A[lane_i]) || leans(block.body_B[lane_i])) leaning = static_cast<uint16_t>(leaning | 1u << lane_i);
    return mask_from_bits(leaning);
}

/// Looks once for each batch for contacts whose impacts may cause others: both bodies bounce off whatever they touch, and one of them
/// has another contact that bounces. Needs colours_of_body, which holds the answer for the substeps. Island::has_chains says
/// which islands have some. False if none has.
///
/// A body that leans on something without restitution is not among them: its support pushes while the impact lasts, and the two are solved as one. A
/// ball that hits a crate on the floor bounces as if off the floor; a ball that hits a row of balls bounces as if off the first of them.
bool find_impact_chains(SolverView& solver);

/// Island by island, at the begin of a substep of h seconds, after predict_contacts and before its forces: impacts of those contacts, one after
/// the other in the order of time, each leaving with -e times its speed. Those of one time are solved together, and what they
/// make approach comes next.
///
/// Between impacts bodies fly along parabolas. An impulse of the time t is given as if from the begin of the substep on, and -t times the velocity
/// that it makes is added to the displacements. So later impacts and the end of the substep are where they should be.
/// Energy: an impact changes it by -(1 - e) j |u| / 2, summed over its rows: it never grows, and stays for e = 1 without friction.
/// Bound: limits::impacts_of_contact impacts for each contact. A contact that still approaches then does not bounce in this substep, and counts in
/// impacts_deferred. notes: of the contacts that carried an impulse, where notes_impulses.
template <bool notes_impulses, class View>
void sequence_impacts(const View& solver, scalar h, const StepNotes& notes, StepReport& report);

} }  // namespace ingot
