// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace level_tool {

/// What ends a run: the exit code of the program.
enum class Outcome { done = 0, refused = 1, wrong_use = 2, no_file = 3 };

/// The tool: words behind its name. Progress and sentences go to messages.
Outcome run(const std::vector<std::string>& words, std::ostream& messages);

}  // namespace level_tool
