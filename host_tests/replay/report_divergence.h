// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>

#include "replay/recording.h"

namespace replay {

/// Says in which step two recordings part, and in which numbers of which bodies as far as states were kept. One line each.
/// Returns: true if they part.
bool report_divergence(const Recording& a, const Recording& b, std::ostream& out);

}  // namespace replay
