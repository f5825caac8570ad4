// SPDX-License-Identifier: MIT
// In the place of suite_contact_peers.cpp where no other engine is given.
#include <cstdio>

#include "contact_peers.h"
#include "suites.h"

namespace report {

std::vector<PeerEngine> contact_peers() { return {}; }

void run_peers(const Settings& settings, const std::vector<Variant>&, Rows&) {
    if (!settings.suites.empty())
        std::fprintf(stderr, "this build has no peers: configure with -DINGOT_PEERS=ON, -DINGOT_BOX3D=DIR or -DINGOT_JOLT=DIR\n");
}

}  // namespace report
