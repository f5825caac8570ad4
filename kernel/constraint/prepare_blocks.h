// SPDX-License-Identifier: MIT
#pragma once

#include "material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Fills the rows of every manifold from its geometry and the bodies' masses, finds the impulses of the step before by the features of the
/// points, and notes which manifolds are central. View: SolverView, or a MaterialView.
/// Cost: about 900 flops and 11 divisions a manifold; with rolling resistance 150 and 4 more.
template <class View>
void prepare_blocks(const View& solver, const BodyView& bodies);
/// After it: how many manifolds of each island are central.
void count_central_manifolds(const SolverView& solver);

/// In a substep after the first, of contacts of bodies with joints: what bodies answer, whose figures have moved. Levers stay those of the begin of
/// the step, and so do impulses. for_pushes: normals alone, before figures are pushed; the next substep begins with all. View: a JointedView.
template <class View>
void refresh_jointed_blocks(const View& solver, const BodyView& bodies, bool for_pushes);
/// The same before islands of the batch are solved again in a substep, while others, that have left the batch, stand.
template <class View>
void refresh_in_solve(const View& solver, const BodyView& bodies);

/// Keeps the impulses for the next step, but for islands that begin again.
template <class View>
void remember_impulses(const View& solver);

} }  // namespace ingot
