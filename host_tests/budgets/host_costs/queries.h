// SPDX-License-Identifier: MIT
#pragma once

/// Counts the queries of a name: {rays, casts, overlaps, nearest} _ {100, 1000, 10000} among so many bodies, and _by_tree where these go through it;
/// 64 of them count as one step. False for any other name.
bool ask_queries(const char* name);
