// SPDX-License-Identifier: MIT
// Where a solver body is within a step, if it turns far.
#pragma once

#include "../math/quaternion.h"
#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

inline Matrix attitude_of(const SolverBodyHistory& history) {
    const scalar(&q)[4] = history.attitude;
    return quaternions::to_rotation({q[0], q[1], q[2], q[3]});
}
inline void set_attitude(SolverBodyHistory& history, const Matrix& A) {
    const Quaternion q = quaternions::from_rotation(A);
    history.attitude[0] = q.w;
    history.attitude[1] = q.x;
    history.attitude[2] = q.y;
    history.attitude[3] = q.z;
}

/// Whether a solver body turns far in this step. What cannot move does not, nor does one that stands for a kinematic body.
inline bool is_turning(const SolverView& solver, Index body_i) { return solver.bodies[body_i].dth[3] > turns_little; }

/// Whether the contacts of the batch go along with what turns far. Those of bodies with joints do not: they know their bodies by small displacements
/// from the begin of the step.
inline bool takes_contacts_along(const SolverView& solver) { return solver.shape_pairs != nullptr && !is_of_joints(solver.plan); }

/// What has turned a body beyond its attitude, rad: pushes of the substep before.
inline Vector turned_by_pushes(const SolverBody& body, const SolverBodyHistory& history) { return three_of(body.dth) - three_of(history.turn); }

} }  // namespace ingot
