// SPDX-License-Identifier: MIT
// Bodies that turn so far within a substep that the energy feels it: their attitude is taken along, and with it their inertia and their contacts.
// With the inertia of the begin of the step a frictionless box with e = 1 gained an eighth of its energy in single steps; levers:
// constraint/refresh_blocks.h.
// View: SolverView, or one with locks.
#pragma once

#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a batch: those that turn so far in a substep of h seconds. Sets SolverView::some_turn.
/// Cost: a look at each body of the batch, ten flops for one that hardly spins.
template <class View>
void find_turning_bodies(View& solver, const BodyView& bodies, scalar h);

/// The first half of a substep of h seconds for those that nothing hits: their attitude, and their inertia in the tiles. Pushes of the substep before
/// have turned them, too. SolverBody::dth begins anew.
template <class View>
void turn_half_way(const View& solver, const BodyView& bodies, scalar h);

/// The rest of the substep, for one of them, whose impulses have been given; hit: they changed its motion by more than forces explain. Returns the
/// turn of the whole substep, rad.
template <class View>
Vector turn_on(const View& solver, const BodyView& bodies, int body_i, bool hit, scalar h);

/// A body that begins to turn so far, by `turn` in the next substep, rad. Its displacement is that of the end of this one.
template <class View>
void begin_turning(View& solver, const BodyView& bodies, int body_i);
/// Whether it does: limits::inertia_turn, turning_speed.
bool turns_so_far(const SolverView& solver, const BodyView& bodies, int body_i, const Vector& turn);

/// A at the end of the step, and the energy that its contacts left it.
template <class View>
Matrix attitude_at_end(const View& solver, const BodyView& bodies, int body_i);

} }  // namespace ingot
