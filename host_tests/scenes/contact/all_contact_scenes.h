// SPDX-License-Identifier: MIT
// The contact scenes by family; see placed_body.h for what a scene is.
#pragma once

#include "bullets.h"
#include "impacts.h"
#include "inclines.h"
#include "leaning.h"
#include "materials.h"
#include "piles.h"
#include "simbenchmark.h"
#include "stacks.h"
