// SPDX-License-Identifier: MIT
#include "contact_peers.h"

namespace report {

#define INGOT_PEER(engine) PeerEngine peer_##engine();
#define INGOT_PILES(abi, lane_count) std::vector<ContactCase> pile_cases_##abi();
#include "peer_list.inc"
#undef INGOT_PEER
#undef INGOT_PILES

std::vector<PeerEngine> contact_peers() {
    return {
#define INGOT_PEER(engine) peer_##engine(),
#define INGOT_PILES(abi, lane_count)
#include "peer_list.inc"
#undef INGOT_PEER
#undef INGOT_PILES
    };
}

std::vector<ContactCase> pile_cases([[maybe_unused]] int lanes) {
#define INGOT_PEER(engine)
#define INGOT_PILES(abi, lane_count) \
    if (lanes == (lane_count)) return pile_cases_##abi();
#include "peer_list.inc"
#undef INGOT_PEER
#undef INGOT_PILES
    return {};
}

}  // namespace report
