// SPDX-License-Identifier: MIT
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// push_figures of scenes with loops: figures of a machine are pushed as one, with their loops and ties closed.
void push_machines(const FigureView& view, const LoopView& loops, bool again);

} }  // namespace ingot
