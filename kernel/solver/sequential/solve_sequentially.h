// SPDX-License-Identifier: MIT
#pragma once

#include "../conduct_substeps.h"
#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// The scheme of BlockSweeps, point by point and without its matrices: a batch is one island.
///
/// Friction is a cone at the middle of the points; torsion is resisted as the area resists it. Rolling resistance, surfaces that move and restitution
/// are those of BlockSweeps, where a scene names them. But an impact that another impact causes waits for the next substep, unless this one stops it.
/// All of it is scalar, in the order of pairs and against it in turn: so bits do not depend on lanes, and towers stand from whichever end they were
/// built.
///
/// Bound:  substeps * sweeps_of_points visits a manifold, of rounds_of_points rounds over its points each; and rounds_of_pushes a substep.
/// Cost:   on a Cortex-M4F, 5000 to 8000 instructions a manifold and step at rest, and 100000 a substep at the bound; and for each island a
///         look at all manifolds and bodies.
template <bool notes_impulses, class View>
void solve_sequentially(View& solver, const ContactStep& step, StepReport& report);

/// The same where bodies may be kinematic.
template <bool notes_impulses, class View>
void solve_kinematic_sequentially(KinematicPointViewOf<View>& solver, const ContactStep& step, StepReport& report);
template <bool notes_impulses, class View>
void solve_sequentially(KinematicPointViewOf<View>& solver, const ContactStep& step, StepReport& report) {
    solve_kinematic_sequentially<notes_impulses>(solver, step, report);
}

} }  // namespace ingot
