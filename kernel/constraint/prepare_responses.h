// SPDX-License-Identifier: MIT
#pragma once

#include "jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the bodies of a block of manifolds answer with their figures: see JointedBlock. Needs: responses of the figures, body_A and body_B.
template <class Loops>
void prepare_responses(const SolverView& solver, const JointedBodies& jointed, const Loops& loops, const BodyView& bodies, int block_i);

template <class View>
INGOT_INLINE void prepare_responses(const View& solver, const BodyView& bodies, int block_i) {
    prepare_responses(solver, solver.jointed, solver.loops, bodies, block_i);
}

} }  // namespace ingot
