// SPDX-License-Identifier: MIT
// What the tool writes: a header of constants, and bytes that level_from_bytes takes.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "level_data.h"

namespace level_tool {

/// Constants of all levels, and an array `name` of their LevelTables. Remarks are comments at the top.
void write_header(std::ostream& out, const std::string& name, const std::vector<ingot::LevelTable>& levels, const std::vector<std::string>& remarks);

/// See ingot::LevelHeader.
std::string level_bytes(const ingot::LevelTable& level, bool big_endian);

}  // namespace level_tool
