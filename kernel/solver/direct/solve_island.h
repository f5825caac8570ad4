// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves the velocities of the island that is loaded, from the free motion of its bodies and the impulses in the blocks as
/// first guess.
///
/// An active set. Normals that push are equations, at most three of a manifold: a fourth depends on them, and rounding would make huge forces of
/// that. Friction, torsion and rolling resistance are equations where they stick; where they slide they follow the normals and the slip. The set is
/// solved by factor_rows, refined with speeds taken from the bodies, and corrected until no row leaves or enters. Sliding friction turns with the
/// slip, and follows the load: Newton's method, with a matrix that is not symmetric.
///
/// Returns: `solved` to limits::direct_settled_speed, and written to the blocks and bodies. Else nothing is written: `chosen` where it does not
/// settle, `left_to_sweeps` where bodies of like masses hit each other. after_sweeps: begins with the result of the sweeps, and has to settle to
/// limits::settled_speed and to be better than they are. Energy: a solution has no more than the free motion, except by bounces.
/// Bound:   work_left multiplications in factors; direct_sets_max sets of direct_newton_steps_max steps, each of
/// direct_refinements_max solves.
template <class View, class Direct>
IslandState solve_island(const View& solver, Direct& island, scalar h, bool after_sweeps);

/// The same for displacements, with normals only: 0.4 of each overlap is taken back, and of a gap between points that carry a load. False: nothing is
/// written.
template <class View, class Direct>
bool place_island(const View& solver, Direct& island, scalar h);

} }  // namespace ingot
