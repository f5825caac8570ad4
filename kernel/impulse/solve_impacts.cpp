// SPDX-License-Identifier: MIT
#include "solve_impacts.h"

#include "../base/limits.h"
#include "contact_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Makes the contacts of one pair that approach part of the next wave; returns how many there are.
///
/// Whether the pair bounces is asked of its fastest contact: corners that land together bounce together or not at all.
int begin_wave_of_pair(Contact* first, int count, const BodyView& bodies, scalar rest_speed) {
    int approaching = 0;
    scalar fastest = 0;
    // bound: 4: contacts of one pair, Manifold::points_max a pair
    for (int contact_i = 0; contact_i < count; ++contact_i) {
        Contact& c = first[contact_i];
        const NormalSpeed speed = normal_speed(c, bodies);
        c.tolerance = tolerance_of(c, speed);
        c.active = speed.u < -c.tolerance;
        c.target = -c.e * speed.u;
        approaching += c.active ? 1 : 0;
        fastest = -speed.u > fastest ? -speed.u : fastest;
    }
    if (!(fastest > rest_speed))
        for (int contact_i = 0; contact_i < count; ++contact_i) first[contact_i].target = 0;
    return approaching;
}

/// Makes the contacts that approach the next wave; returns how many there are.
int begin_wave(const ContactView& contacts, const BodyView& bodies, scalar rest_speed) {
    int approaching = 0;
    // bound: max_contacts: end is after first: each pair has a contact
    for (int first = 0, end = 0; first < *contacts.count; first = end) {
        end = manifold_end(contacts, first);
        approaching += begin_wave_of_pair(&contacts.contacts[first], end - first, bodies, rest_speed);
    }
    return approaching;
}

}  // namespace

template <class Left>
void solve_impacts(const ContactView& contacts, const BodyView& bodies, scalar rest_speed, Left& left, StepReport& report) {
    int approaching = begin_wave(contacts, bodies, rest_speed);
    for (int wave_i = 0; approaching > 0 && wave_i < limits::impact_waves_max && left.some(); ++wave_i) {
        const SweepOutcome outcome = solve_active_contacts(contacts, bodies, left);
        count(report.sweeps, outcome.sweeps);
        if (!outcome.finished) count(report.sweeps_unfinished);
        count(report.impact_waves);
        // bound: max_contacts
        for (int contact_i = 0; contact_i < *contacts.count; ++contact_i)
            contacts.contacts[contact_i].j_total += contacts.contacts[contact_i].j;
        // Among close-packed bodies impacts go to and fro: in the second half of the waves they bounce no more.
        const bool bounce = wave_i < limits::impact_waves_max / 2;
        approaching = begin_wave(contacts, bodies, bounce ? rest_speed : scalar_max);
    }
    count(report.impacts_deferred, approaching);
}

// The linker takes the one that the scene calls.
template void solve_impacts(const ContactView&, const BodyView&, scalar, AnyVisits&, StepReport&);
template void solve_impacts(const ContactView&, const BodyView&, scalar, VisitsLeft&, StepReport&);

} }  // namespace ingot
