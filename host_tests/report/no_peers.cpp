// SPDX-License-Identifier: MIT
// In the place of peers.cpp where INGOT_PEERS is OFF.
#include <cstdio>

#include "suites.h"

namespace report {

void run_peers(const Settings& settings, const std::vector<Variant>&, Rows&) {
    if (!settings.suites.empty()) std::fprintf(stderr, "this build has no peers: configure with -DINGOT_PEERS=ON\n");
}

}  // namespace report
