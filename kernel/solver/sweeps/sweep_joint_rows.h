// SPDX-License-Identifier: MIT
// Rows of joints in the sweeps of their islands, after the contacts.
#pragma once

#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// One visit to each row whose island is not settled yet; `up` or back.
template <class Rows>
void sweep_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows, bool up);
/// Adds what the sweep changed to what measure_sweep has found.
template <class Rows>
void measure_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows);
/// Impulses go on along the conjugate direction of their islands, as those of contacts do.
template <class Rows>
void extrapolate_joint_rows(const SolverView& solver, const JointedBodies& jointed, const Rows& rows);
/// Whether an island that is not settled has rows.
template <class Rows>
bool are_joint_rows_live(const SolverView& solver, const JointedBodies& jointed, const Rows& rows);

} }  // namespace ingot
