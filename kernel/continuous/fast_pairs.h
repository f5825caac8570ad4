// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../broad_phase/body_pairs.h"
#include "../narrow_phase/manifold_record.h"
#include "body_path.h"

namespace ingot { inline namespace INGOT_ABI {

/// Pairs of shapes with a body that is too fast for the step, as the search for manifolds asks for them.
struct FastPairs {
    static constexpr bool leads_figures = false;
    BodyView bodies;
    BodyShapes shapes;
    BodyPath* paths;  ///< by body slot; before paths begin, leave_to_flights has its sets of bodies in them
    scalar h;

    bool has(const BodyPair& pair) const { return is_fast({pair.body_A}) || is_fast({pair.body_B}); }
    /// Whether touching bodies would get through each other's skin in the step, or would turn away the faces with which they touch: what they do is
    /// over in a moment of it. Others slide or rest, or a slow body is hit: they are solved together.
    bool meets_hard(const BodyPair& pair, const Manifold& manifold) const;

private:
    bool is_fast(ShapeSlot shape) const { return paths[shapes.body_of(shape)].fast; }
};

/// Ends the manifolds of pairs that meet hard: what they do is seen to in flight.
///
/// But for bodies that have soft contacts with others that can move, directly or through others that they meet hard: these are solved together with
/// all that they touch, or some of their impulses would count and others not. found: the list that the manifolds are from.
/// Cost: three walks over the manifolds, where some body is fast.
void leave_to_flights(const FastPairs& fast, const PairList& found, const ManifoldView& manifolds);

} }  // namespace ingot
