// SPDX-License-Identifier: MIT
// A contact scene in Bullet and in ODE, as the distribution packages them.
#pragma once

#include "contact_race.h"

namespace report {

struct PeerEngine {
    std::string name, scalar;
    std::function<std::unique_ptr<ContactRun>(const ContactCase&)> begin;
};

/// Bullet: defaults, no sleeping. ODE: quick step, defaults. Only where the report is built with them.
std::vector<PeerEngine> contact_peers();

}  // namespace report
