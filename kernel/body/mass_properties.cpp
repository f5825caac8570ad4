// SPDX-License-Identifier: MIT
#include "mass_properties.h"
