// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "collide/placed.h"
