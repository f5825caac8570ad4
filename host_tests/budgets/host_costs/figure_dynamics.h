// SPDX-License-Identifier: MIT
#pragma once

/// Counts the calls of a name: {read, inverse, gravity, inertia, transpose, matrix} _ {8, 64} of a chain of so many hinges; a call counts as one
/// step. False for any other name.
bool ask_dynamics(const char* name);
