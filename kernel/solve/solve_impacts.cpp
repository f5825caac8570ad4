// SPDX-License-Identifier: MIT
#include "solve_impacts.h"

#include "../base/limits.h"
#include "contact_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Makes the contacts that approach the next wave; returns how many there are.
int begin_wave(const ContactView& contacts, const BodyView& bodies, scalar rest_speed) {
    int approaching = 0;
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {
        Contact& c = contacts.contacts[contact_i];
        const NormalSpeed speed = normal_speed(c, bodies);
        c.tolerance = limits::contact_roundings * epsilon * speed.magnitude;
        c.active = speed.u < -c.tolerance;
        c.target = -speed.u > rest_speed ? -c.e * speed.u : 0;
        c.j = 0;
        approaching += c.active ? 1 : 0;
    }
    return approaching;
}

}  // namespace

void solve_impacts(const ContactView& contacts, const BodyView& bodies, scalar rest_speed, StepReport& report) {
    int approaching = begin_wave(contacts, bodies, rest_speed);
    for (int wave_i = 0; approaching > 0 && wave_i < limits::impact_waves_max; ++wave_i) {
        const SweepOutcome outcome = solve_active_contacts(contacts, bodies);
        count(report.sweeps, outcome.sweeps);
        if (!outcome.finished) count(report.sweeps_unfinished);
        count(report.impact_waves);
        for (int contact_i = 0; contact_i < *contacts.count; ++contact_i)
            contacts.contacts[contact_i].j_total += contacts.contacts[contact_i].j;
        approaching = begin_wave(contacts, bodies, rest_speed);
    }
    count(report.impacts_left, approaching);
}

} }  // namespace ingot
