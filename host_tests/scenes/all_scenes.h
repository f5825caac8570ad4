// SPDX-License-Identifier: MIT
// The scenes of tests, demo, budgets and firmware: each one header, used by all of them.
#pragma once

#include "compounds.h"
#include "drop.h"
#include "hulls.h"
#include "jointed.h"
#include "methods.h"
#include "ragdolls.h"
#include "satellite.h"
#include "stacked.h"
#include "t_handle.h"
#include "terrain.h"
#include "tumblers.h"
