// SPDX-License-Identifier: MIT
#pragma once

#include "../base/report.h"
#include "../base/work_budget.h"
#include "impact_step.h"

namespace ingot { inline namespace INGOT_ABI {

/// Resolves the impacts of one time, `now`, s from the begin of the step: every contact that is not aside and approaches leaves with -e times its
/// speed.
///
/// Contacts that approach at the same time are solved together (Hecker 1997, Fig. 4, as one complementarity problem), so a
/// box dropped flat does not begin to turn. What those impulses make approach is the next wave: a row of touching balls
/// passes the impact on, ball by ball. Without friction, j > 0 only where the speed is reversed to -e times itself, so the
/// energy of a wave changes by -(1 - e) j |u| / 2 summed: it never grows, and stays for e = 1.
///
/// Contacts slower than rest_speed are at rest: they take e = 0; so do all in the second half of the waves, and all where `bounce` is false.
/// One that has had its last impact is solved with those that approach, in all waves.
/// Bound: limits::impact_waves_max waves, as many visits to contacts as are left, and limits::impact_visits_max to each contact in the step: then it
///        is left out. Contacts that still approach count in impacts_deferred, as do those that would bounce in the second half, and those left out.
template <class Left>
void solve_impacts(const ImpactStep& step, const ContactView& contacts, scalar now, bool bounce, Left& left, StepReport& report);

} }  // namespace ingot
