// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// Of scenes in which things hit each other: islands that are hit are not settled in the same step, and nothing else is amiss.
inline bool well_but_for_impacts(ingot::StepReport report) {
    report.sweeps_unfinished = 0;
    return report.clean();
}

}  // namespace scenes
