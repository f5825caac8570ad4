// SPDX-License-Identifier: MIT
#include "solve_impacts.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Impacts at one time, of contacts that are not aside.
struct Wave {
    const ImpactStep& step;
    const ContactView& contacts;
    scalar now;

    /// Makes the contacts of one pair that approach part of it; returns how many there are. `slack`: of their tolerances, see solve_active_contacts.
    ///
    /// Whether the pair bounces is asked of its fastest contact: corners that land together bounce together or not at all.
    int begin_pair(Contact* first, int count, bool bounce, scalar slack) const {
        int approaching = 0;
        scalar fastest = 0;
        // bound: max_contacts: those of one pair
        for (int contact_i = 0; contact_i < count; ++contact_i) {
            Contact& c = first[contact_i];
            c.active = false;
            if (c.aside || is_worn(c)) continue;
            const SpeedInStep speed = speed_at(step, c, now);
            c.tolerance = tolerance_of(c, speed);
            const bool approaches = speed.u < -slack * c.tolerance;
            // A light ball between two heavy ones would pass on a little of their speeds in each wave.
            // Without bounces all are solved together: pushed one after another they would push each other for ever.
            c.active = approaches || !bounce || (stays(c) && !(speed.u > c.tolerance));
            c.target = -speed.change;  // at the begin of the step, of what is to be at rest now
            c.change = -c.e * speed.u;  // kept here until the pair is known to bounce
            approaching += approaches ? 1 : 0;
            fastest = -speed.u > fastest ? -speed.u : fastest;
        }
        for (int contact_i = 0; bounce && fastest > step.rest_speed && contact_i < count; ++contact_i)
            first[contact_i].target += first[contact_i].change;
        return approaching;
    }
    int begin(bool bounce, scalar slack) const {
        int approaching = 0;
        // bound: max_contacts: end is after first: each pair has a contact
        for (int first = 0, end = 0; first < *contacts.count; first = end) {
            end = manifold_end(contacts, first);
            approaching += begin_pair(&contacts.contacts[first], end - first, bounce, slack);
        }
        return approaching;
    }
    /// How many of those that approach would bounce.
    int bouncing() const {
        int bouncing = 0;
        // bound: max_contacts
        for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {
            const Contact& c = contacts.contacts[contact_i];
            bouncing += c.active && c.change > c.e * step.rest_speed ? 1 : 0;
        }
        return bouncing;
    }
    /// How many of those that touch have had all their visits in it; others are counted by forget_times.
    int worn() const {
        int worn = 0;
        // bound: max_contacts
        for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {
            const Contact& c = contacts.contacts[contact_i];
            worn += !c.aside && c.touches && is_worn(c) ? 1 : 0;
        }
        return worn;
    }
    void end() const {
        // bound: max_contacts
        for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {
            Contact& c = contacts.contacts[contact_i];
            if (!c.active) continue;
            c.j_total += c.j;
            c.j_impact += c.j;
            take_back(c, c.j, now, step.bodies);
        }
    }
};

}  // namespace

template <class Left>
void solve_impacts(const ImpactStep& step, const ContactView& contacts, scalar now, bool bounce, Left& left, StepReport& report) {
    const Wave wave{step, contacts, now};
    int approaching = wave.begin(bounce, 1);
    for (int wave_i = 0; approaching > 0 && wave_i < limits::impact_waves_max && left.some(); ++wave_i) {
        const SweepOutcome outcome = solve_active_contacts(contacts, step.bodies, left);
        count(report.sweeps, outcome.sweeps);
        if (!outcome.finished) count(report.sweeps_unfinished);
        count(report.impact_waves);
        wave.end();
        // Among close-packed bodies impacts go to and fro: in the second half of the waves they bounce no more. What a solve left to rounding is no
        // impact of the next wave: the corners of a needle whose masses differ by 200 would hand it to each other in every wave there is.
        approaching = wave.begin(bounce && wave_i < limits::impact_waves_max / 2, slack_after(outcome.sweeps - 1));
        if (bounce && wave_i == limits::impact_waves_max / 2) count(report.impacts_deferred, wave.bouncing());
    }
    count(report.impacts_deferred, approaching + wave.worn());
}

// The linker takes the one that the scene calls.
template void solve_impacts(const ImpactStep&, const ContactView&, scalar, bool, AnyVisits&, StepReport&);
template void solve_impacts(const ImpactStep&, const ContactView&, scalar, bool, VisitsLeft&, StepReport&);

} }  // namespace ingot
