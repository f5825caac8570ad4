// SPDX-License-Identifier: MIT
// Which figures have universal joints: what these ask for is in hold_targets.h and keep_figures.cpp.
#pragma once

#include "figure_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// False for scenes that name hinges alone, which link nothing of it.
template <class Kinds>
inline constexpr bool may_be_universal = Kinds::of(JointKind::universal) == JointKind::universal;

template <unsigned width, class Kinds>
bool has_universal_joint(const FigureRows<width, Kinds>& rows) {
    for (int row_i = 0; row_i < rows.count(); ++row_i)  // bound: max_bodies
        if (rows.kind(row_i) == JointKind::universal) return true;
    return false;
}

} }  // namespace ingot
