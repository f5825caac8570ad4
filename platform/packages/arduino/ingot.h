// SPDX-License-Identifier: MIT
// For sketches, which find a library by a header at its top: #include <ingot.h>, before all that computes.
#pragma once
#include "ingot/ingot.h"
