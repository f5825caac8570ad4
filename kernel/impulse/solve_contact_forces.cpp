// SPDX-License-Identifier: MIT
#include "solve_contact_forces.h"

#include "../base/limits.h"
#include "contact_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void add_force(const BodyView& bodies, int slot, const Vector& F, const Vector& tau) {
    const Place at = place_of(slot);
    TranslationTile& translation = bodies.translation[at.tile];
    RotationTile& rotation = bodies.rotation[at.tile];
    set_lane(translation.F_T, at.lane, lane_of(translation.F_T, at.lane) + F);
    set_lane(rotation.tau_T, at.lane, lane_of(rotation.tau_T, at.lane) + tau);
}

}  // namespace

template <class Left>
void solve_contact_forces(const ContactView& contacts, const BodyView& bodies, scalar h, Left& left, StepReport& report) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {  // bound: max_contacts
        Contact& c = contacts.contacts[contact_i];
        c.tolerance = tolerance_of(c, normal_speed(c, bodies));
        c.active = c.touches;
        c.target = 0;
    }
    const SweepOutcome outcome = solve_active_contacts(contacts, bodies, left);
    count(report.sweeps, outcome.sweeps);
    if (!outcome.finished) count(report.sweeps_unfinished);

    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {
        Contact& c = contacts.contacts[contact_i];
        if (!c.active || !(c.j > 0)) continue;
        const scalar force = c.j / h;
        add_force(bodies, c.body_A, c.n * force, c.lever_A * force);
        add_force(bodies, c.body_B, c.n * -force, c.lever_B * -force);
        take_back(c, c.j, c.when / 2, bodies);
        c.j_total += c.j;
    }
}

// The linker takes the one that the scene calls.
template void solve_contact_forces(const ContactView&, const BodyView&, scalar, AnyVisits&, StepReport&);
template void solve_contact_forces(const ContactView&, const BodyView&, scalar, VisitsLeft&, StepReport&);

} }  // namespace ingot
