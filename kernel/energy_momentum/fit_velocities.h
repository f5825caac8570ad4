// SPDX-License-Identifier: MIT
// Places and velocities that joints do not allow.
#pragma once

#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

/// Takes a figure that was moved otherwise onto its joints: bodies by displacements that no velocity sees, and velocities by the impulses of joints,
/// which takes energy and gives none.
template <unsigned width>
void fit_to_joints(const FigureView& view, const FigureRows<width>& figures);

/// After a step: where more than limits::hidden_share of the kinetic energy is in velocities that joints do not allow, it is taken out of them.
/// Snap::keep: all others become faster by as much, but for the motion of the figure as a whole. A figure on ground that moves gets nothing back.
///
/// The step keeps energy whatever happens, and after a snap it would be hidden there, half of all there is. In every step, this would damp what is no
/// snap: a heavy top falls.
template <unsigned width>
void take_hidden_energy(const FigureView& view, const FigureRows<width>& figures, Snap snap);

/// Puts bodies, root first, to where their joints want them: by roundings of r and A, which no velocity sees.
template <unsigned width>
void take_up_roundings(const FigureRows<width>& figures);

} }  // namespace ingot
