// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Friction can turn a bounce into a gain: Newton's law fixes how fast a point leaves, whatever friction does meanwhile, and where that reverses the
/// slip it works on the body (Kane and Levinson 1985). Here a manifold's bounce is lowered until normals, friction and torsion together take energy:
///
///     sum of j (u_before + u_after) / 2 <= 0      of its rows: what these impulses change of the energy
///
/// True where some were lowered: then their islands are to be solved again. h: s, of the substep, whose velocities are solved.
template <class View>
bool lower_bounces(const View& solver, scalar h);

/// Impulses of bounces act from the time of impact on, and are given at the begin of the substep: takes the displacement before that back. The place
/// at which a point lands says so for its normal alone; what friction turns would be pushed there against gravity. Not of bodies that lean on others,
/// whose supports push as long as the impact lasts.
template <class View>
void take_back_bounces(const View& solver, scalar h);

/// lower_bounces of the manifold of one lane, whose impact is at hand `now` seconds into the substep: see sequence_impacts. The motion before it is
/// in v_sweep and L_sweep.
template <class View>
bool lower_impact(const View& solver, int block_i, int lane_i, scalar now, scalar h);

} }  // namespace ingot
