// SPDX-License-Identifier: MIT
#include <iostream>

#include "level_tool.h"

int main(int count, char** words) { return static_cast<int>(level_tool::run(std::vector<std::string>(words + 1, words + count), std::cerr)); }
