// SPDX-License-Identifier: MIT
// A contact scene in other engines: those the report is built with.
//
// Each engine as it comes, with the settings its documents call defaults; no damping, no sleeping, one thread, one step call of
// 1/rate s. Friction and restitution are set so that every pair has those of the scene, whatever the engine's rule of mixing.
// Ground and walls are slabs 2 m thick, as games build them: boxes rest on them with four points at once. In ODE they are planes.
//
// Adapters include no Eigen: the one of an engine that is built for other instructions than the report would bring its own.
#pragma once

#include "contact_case.h"

namespace report {

struct PeerEngine {
    std::string name, scalar;
    std::function<std::unique_ptr<ContactRun>(const ContactCase&)> begin;
};

/// Bullet and ODE (INGOT_PEERS), Box3D (INGOT_BOX3D), Jolt (INGOT_JOLT): in this order, those the report is built with.
std::vector<PeerEngine> contact_peers();

/// Piles that only peers and the kernel in float run side by side, for a build of so many lanes; empty where there is none.
std::vector<ContactCase> pile_cases(int lanes);

}  // namespace report
