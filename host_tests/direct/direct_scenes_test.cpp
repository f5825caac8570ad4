// SPDX-License-Identifier: MIT
#include "direct/contact_run.h"
