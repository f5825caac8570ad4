// SPDX-License-Identifier: MIT
#pragma once

/// Bodies on a slab, on a mesh and on a field of heights, and piles on a slab and on hills; their steps are counted. False: no such world.
bool stand_on_levels(const char* name);
