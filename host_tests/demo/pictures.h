// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace demo {

/// Runs the scenes that are for looking at, writes a picture of each as soon as it is done, and says where. False where anything went wrong.
bool write_pictures(const std::string& out_dir);

}  // namespace demo
