// SPDX-License-Identifier: MIT
#pragma once

#define INGOT_VERSION_MAJOR 0
#define INGOT_VERSION_MINOR 1
#define INGOT_VERSION_PATCH 0

/// Raised whenever a golden hash changes: recordings of another number do not replay to the bit.
#define INGOT_DETERMINISM_VERSION 27
