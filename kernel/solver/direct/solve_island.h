// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves the velocities of the island that is loaded, from the free motion of its bodies and the impulses in the blocks as
/// first guess.
///
/// An active set: normals that push are equations, at most three of a manifold (a fourth depends on them, and rounding would
/// make huge forces of that); friction, twist and rolling resistance are equations where they stick, and follow the normals and the slip where they
/// slide. The set is solved by factor_rows, refined with speeds taken from the bodies, and corrected until nothing leaves or
/// enters. Sliding friction turns with the slip, and follows the load: Newton's method, with a matrix that is not symmetric.
///
/// Returns: `solved`, to limits::direct_settled_speed, and written to the blocks and bodies. Else nothing is written: `chosen`
/// where it does not settle, `struck` where an impact of bodies of like masses is the sweeps'. `after_sweeps`, with their result
/// as the guess: to limits::settled_speed, and better than they have it. Energy: a solution has none that the free motion had
/// not, but for bounces.
/// Bound:   work_left multiplications in factors; direct_sets_max sets of direct_newton_steps_max steps, each of
/// direct_refinements_max solves.
template <class View, class Direct>
IslandState solve_island(const View& solver, Direct& island, scalar h, bool after_sweeps);

/// The same for displacements: of overlaps, 0.4 are taken back, of points that carry a load gaps too; normals only. False:
/// nothing is written.
template <class Direct>
bool place_island(const SolverView& solver, Direct& island, scalar h);

} }  // namespace ingot
