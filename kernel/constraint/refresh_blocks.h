// SPDX-License-Identifier: MIT
// Rows of the moment, where capsules and cylinders turn far within a step. Of other bodies that do, what they answer to impulses.
//
// A substep of such a body is flight for half of it, impulses, and flight for the other half. So rows are those of its middle: J, n and s of
// moved_manifold.h. Between x_0, x_1/2 and x_1 the speed along a row is, with c the change that the turning makes of it in half a substep,
//
//     u_0 = J_0 v_0,   u_b = J_1/2 v_0 = u_0 + c,   u_a = J_1/2 v_1,   u_1 = J_1 v_1 = u_a + c
//
// A contact that stays leaves with u_1 = 0 and came with u_0 = 0, so u_a = -c and u_b = c: its impulse does the work j (u_a + u_b) / 2 = 0, whatever
// c is. What rolls or tumbles about a point then keeps its energy to the rounding of the sweeps. Asking u_a = 0 of it instead, it gains or
// loses j c / 2 in each substep. Where the impulse stops an approach the same target takes energy, and where points part it is lower by u_0, so that
// it gives none. Friction has the same shift.
//
// What is about to be hit gets its impulses at the begin of the substep: then nothing flies into what it meets.
// Source: the flight in two halves is Verlet's ("drift, kick, drift"); targets that do no work, ours.
#pragma once

#include "material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Contacts go along with capsules and cylinders that turn far: not where all that moves is balls.
template <class View>
inline constexpr bool moves_contacts = View::points_max > 1;

/// Before the bodies fly, of the first block_count blocks: which lanes have a body that turns far, how fast their points part by the rows as they
/// are, and which lanes are about to meet by an impact. h: s, of the substep.
/// View: SolverView, or one with locks.
template <class View>
void note_turning_speeds(const View& solver, int block_count, scalar h);
/// After it: bodies that are about to be hit, turns_into_impact.
void mark_hit_bodies(const SolverView& solver, int block_count);

/// Once bodies are where contacts act, see turning_bodies.h: rows, separations and shifts of these lanes. Others keep all they have.
/// Blocks of bodies with joints are left out: see refresh_jointed_blocks. View: SolverView, or a MaterialView. Cost: of blocks in which something
/// turns far, that of prepare_blocks; and about 800 flops a manifold of something round that does.
template <class View>
void refresh_blocks(const View& solver, const BodyView& bodies, scalar h);

/// After the speeds that points may approach with have been set by their gaps: those of the shifts.
void shift_targets(const SolverView& solver);

/// After the second half of the flight, where contacts move: separations as they are.
void separate_turned(const SolverView& solver, const BodyView& bodies);

} }  // namespace ingot
