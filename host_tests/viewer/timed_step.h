// SPDX-License-Identifier: MIT
// The kernel's step as it is written, which tells the page between stages what has passed. The kernel measures nothing itself: here, where
// step.h is read, some of its lines say one word more.
#pragma once

#include <ingot/world/schemes.h>
#include <ingot/world/stages.h>

/// Of what is past now. 0: pairs that are near; 1: where they touch; 2: solving and moving; 3: all else.
extern "C" __attribute__((import_module("ingot"), import_name("past"))) void viewer_past(int part);

#define find_pairs(now) find_pairs(now), viewer_past(0)
#define find_manifolds(now) find_manifolds(now), viewer_past(1)
#define begin_paths(now) begin_paths(now), viewer_past(3)
#define advance(now) advance(now), viewer_past(2)
#define finish_step(now) finish_step(now), viewer_past(3)
#include <ingot/world/step.h>
#undef find_pairs
#undef find_manifolds
#undef begin_paths
#undef advance
#undef finish_step
