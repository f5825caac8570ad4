// SPDX-License-Identifier: MIT
// What the solver works on in scenes whose surfaces resist being rolled, or move by themselves. Stages are templates over the view: a scene without
// such surfaces compiles nothing of this.
#pragma once

#include "../base/if.h"
#include "belts.h"
#include "rolling.h"
#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool surfaces_roll, bool surfaces_move>
struct MaterialView : SolverView {
    static constexpr bool rolls = surfaces_roll, has_belts = surfaces_move;

    RollingRows* rolling;           ///< by block; null where the scene has none
    RollingRecord* rolling_records; ///< by record
    BeltRows* belts;                ///< by block; null where the scene has none
    const Vector* belt_velocities;  ///< by record, m/s, world
};
template <bool rolls, bool has_belts>
using MaterialViewOf = If<rolls || has_belts, MaterialView<rolls, has_belts>, SolverView>;
/// The view for stages to which belts are nothing: fewer of them are compiled.
template <class View>
INGOT_INLINE const If<View::has_belts && !View::rolls && !View::articulates, SolverView, View>& without_belts(const View& solver) {
    return solver;
}
/// The view for stages to which belts are something and rolling resistance nothing.
template <class View>
INGOT_INLINE const If<View::has_belts, View, SolverView>& with_belts(const View& solver) {
    return solver;
}
/// The same for those to which materials are nothing.
template <class View>
INGOT_INLINE const If<View::points_max == 1, BallView, If<View::articulates || View::locks_axes, View, SolverView>>& of_points(const View& solver) {
    return solver;
}
using RollingView = MaterialView<true, false>;
using BeltView = MaterialView<false, true>;
using RollingBeltView = MaterialView<true, true>;

} }  // namespace ingot
