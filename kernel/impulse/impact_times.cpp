// SPDX-License-Identifier: MIT
#include "impact_times.h"

#include "../base/limits.h"
#include "contact_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <class Each>
void for_contacts(const ContactView& contacts, const Each& each) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) each(contacts.contacts[contact_i]);  // bound: max_contacts
}

bool is_awaited(const Contact& c) { return !c.touches && c.when < limits::unbounded; }

bool share_a_body(const BodyView& bodies, const Contact& a, const Contact& b) {
    const auto is_in_both = [&](int slot) { return is_dynamic(bodies, slot) && (slot == b.body_A || slot == b.body_B); };
    return is_in_both(a.body_A) || is_in_both(a.body_B);
}

/// What was to meet at this time and took no impulse, because its body is held elsewhere, is as near as it was: it is held as well.
bool misses(const Contact& c) { return c.at_hand && !(c.j_impact > 0); }

void await_impact(const ImpactStep& step, Contact& c, scalar now) {
    const SpeedInStep speed = speed_at(step, c, c.when);
    const scalar tolerance = max(step.still(), tolerance_of(c, speed));
    const bool comes = (c.when > now && !misses(c)) || speed.u < -tolerance;
    scalar still = tolerance;
    if (step.surfaces.surfaces[c.body_A].shape.kind == ShapeKind::box) {
        const scalar acceleration = dot(c.n, acceleration_in(step, c.body_A) - acceleration_in(step, c.body_B));
        still = max(still, corners_still(acceleration, step.h * limits::corners_together));
    }
    c.touches = !comes && (speed.u <= still || misses(c));
    if (!comes && !c.touches) c.when = limits::unbounded;
}

}  // namespace

template <bool sees_kinematic>
void take_in_new(const ImpactStep& step, const ContactView& contacts, scalar now) {
    for_contacts(contacts, [&](Contact& c) {
        if (!c.is_new) return;
        c.is_new = false;
        const scalar tolerance = c.tolerance;
        prepare_contact_row<sees_kinematic>(c, step.bodies);
        c.tolerance = tolerance;  // the largest in the step
        await_impact(step, c, now);
    });
}

int first_impact(const ContactView& contacts) {
    int first = -1;
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {  // bound: max_contacts
        const Contact& c = contacts.contacts[contact_i];
        if (is_awaited(c) && (first < 0 || c.when < contacts.contacts[first].when)) first = contact_i;
    }
    return first;
}

bool gather_impact(const ImpactStep& step, const ContactView& contacts, int first, StepReport& report) {
    const scalar now = contacts.contacts[first].when, last = now + limits::together * step.h;
    for_contacts(contacts, [](Contact& c) {
        c.aside = true;
        c.at_hand = false;
        c.j_impact = 0;
    });
    contacts.contacts[first].aside = false;
    bool grows = true;
    while (grows) {  // bound: max_contacts: each turn but the last takes one in
        grows = false;
        for_contacts(contacts, [&](Contact& c) {
            if (!c.aside || is_worn(c) || !(c.touches || c.when <= last)) return;
            bool joins = false;
            for_contacts(contacts, [&](const Contact& other) { joins = joins || (!other.aside && share_a_body(step.bodies, c, other)); });
            if (joins) c.aside = false;
            grows = grows || joins;
        });
    }
    bool bounce = true;
    for_contacts(contacts, [&](Contact& c) {
        if (c.aside || c.touches) return;
        c.at_hand = true;
        ++c.impacts;
        constexpr int bounces = limits::impacts_in_step_max / 2;
        if (c.impacts == bounces + 1 && c.e > 0 && speed_at(step, c, c.when).u < -step.rest_speed) count(report.impacts_deferred);
        bounce = bounce && c.impacts <= bounces;
    });
    return bounce;
}

template <class Left>
void hold_until(const ImpactStep& step, const ContactView& contacts, scalar now, Left& left, StepReport& report) {
    bool some = false;
    for_contacts(contacts, [&](Contact& c) {
        c.active = !c.aside && c.touches && c.when < now;
        if (!c.active) return;
        const SpeedInStep then = speed_at(step, c, now);
        c.tolerance = tolerance_of(c, then);
        c.target = -then.change;
        some = some || then.u < -c.tolerance;
    });
    if (!some) return;
    const SweepOutcome outcome = solve_active_contacts(contacts, step.bodies, left);
    count(report.sweeps, outcome.sweeps);
    if (!outcome.finished) count(report.sweeps_unfinished);
    for_contacts(contacts, [&](Contact& c) {
        if (!c.active) return;
        c.j_total += c.j;
        take_back(c, c.j, (c.when + now) / 2, step.bodies);
        c.when = now;
    });
}

int body_of_impact(const ImpactStep& step, const ContactView& contacts, int contact_i, int side) {
    const Contact& c = contacts.contacts[contact_i];
    const int slot = side == 0 ? c.body_A : c.body_B;
    if (c.aside || !is_dynamic(step.bodies, slot)) return -1;
    for (int before = 0; before < contact_i; ++before) {  // bound: max_contacts
        const Contact& other = contacts.contacts[before];
        if (!other.aside && (other.body_A == slot || other.body_B == slot)) return -1;
    }
    return slot;
}

void forget_times(const ContactView& contacts, int slot, scalar now, StepReport& report) {
    for_contacts(contacts, [&](Contact& c) {
        if (c.body_A != slot && c.body_B != slot) return;
        if (is_at_its_bound(c)) {
            if (c.touches) return;
            c.touches = true;
            c.when = now;
            return count(report.impacts_deferred);
        }
        c.touches = false;
        c.when = limits::unbounded;
    });
}

void defer_impacts(const ContactView& contacts, StepReport& report) {
    for_contacts(contacts, [&](Contact& c) {
        if (!is_awaited(c)) return;
        c.touches = true;
        count(report.impacts_deferred);
    });
}

// The linker takes the one that the scene calls.
template void take_in_new<false>(const ImpactStep&, const ContactView&, scalar);
template void take_in_new<true>(const ImpactStep&, const ContactView&, scalar);
template void hold_until(const ImpactStep&, const ContactView&, scalar, AnyVisits&, StepReport&);
template void hold_until(const ImpactStep&, const ContactView&, scalar, VisitsLeft&, StepReport&);

} }  // namespace ingot
