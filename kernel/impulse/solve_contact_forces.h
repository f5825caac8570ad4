// SPDX-License-Identifier: MIT
#pragma once

#include "../base/report.h"
#include "../base/work_budget.h"
#include "../body/body_tiles.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Adds the forces with which touching bodies hold each other up during the step: after them no contact approaches. Bodies that touch only since a
/// time within the step get to where forces from then on would take them.
///
/// Comes after integrate_v and integrate_L. The impulses found change v_CM and L, and enter F_T and tau_T divided by h, so
/// that integrate_r and the rotation take them for what they are: forces that acted all step long.
/// Units: h in s. Bound: limits::contact_sweeps_max sweeps, and the visits to contacts that are left; a solve that stops there counts in
/// sweeps_unfinished.
template <class Left>
void solve_contact_forces(const ContactView& contacts, const BodyView& bodies, scalar h, Left& left, StepReport& report);

} }  // namespace ingot
