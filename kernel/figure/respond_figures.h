// SPDX-License-Identifier: MIT
// What a body answers to an impulse with all of its figure.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// The twist of each body that is reached, at q, that a unit impulse on it gives: from the root to the leaves. Needs: factor_figures.
void respond_figures(const FigureView& view, Spatial6Rows<1>* responses);

/// The same at the centre of mass of one; with the loops of its figure closed. Loops: LoopView, or NoLoops.
template <class Loops>
Spatial6<scalar> response_of_centre(const FigureView& view, const Loops& loops, const Spatial6Rows<1>* responses, Index node);

/// kg m^2, world, about the centre of mass, of the body alone.
SymmetricMatrix inertia_of_node(const FigureView& view, Index node);

/// What one body of a figure answers to an impulse on another, both at their centres of mass: v += vv F + vw T, omega += wv F + ww T.
struct Across {
    Matrix vv, vw, wv, ww;
};
/// Of A to what acts on B. Cost: two visits for each joint between them.
template <class Loops>
Across response_across(const FigureView& view, const Loops& loops, const Spatial6Rows<1>* responses, Index node_A, Index node_B);

/// The twist of A, at its q, for an impulse on B at its, without loops: none where they are of different trees.
Spatial<scalar> twist_across(const FigureView& view, const Spatial6Rows<1>* responses, Index node_A, Index node_B, const Spatial<scalar>& on_B);

} }  // namespace ingot
