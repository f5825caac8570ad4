// SPDX-License-Identifier: MIT
// Places and velocities that joints do not allow.
#pragma once

#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

/// Takes a figure onto its joints that something else has moved: bodies by displacements that no velocity sees, velocities by impulses of its joints.
/// It loses energy by that and gains none. Returns a bit a lane: it is on its joints. What is not, as bodies were put too far apart, is for the
/// substeps.
template <unsigned width>
unsigned fit_to_joints(const FigureView& view, const FigureRows<width>& figures);

/// After a step: where more than limits::hidden_share of the kinetic energy is in velocities that joints do not allow, these velocities are taken
/// out.
/// Snap::keep: the others become faster by as much energy, the motion of the figure as a whole excepted. A figure on ground that moves gets none
/// back.
///
/// The step keeps energy whatever happens. After a snap half of it may hide in such velocities. Taken out in every step, what is no snap would be
/// damped: a heavy top would fall.
template <unsigned width>
void take_hidden_energy(const FigureView& view, const FigureRows<width>& figures, Snap snap);

/// Puts bodies to where their joints want them, the root first. They are off by roundings of r and A, and no velocity sees it.
template <unsigned width>
void take_up_roundings(const FigureRows<width>& figures);

} }  // namespace ingot
