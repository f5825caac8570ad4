// SPDX-License-Identifier: MIT
// Contacts with kinematic bodies in the sequential solver, for sequential_kinematic.cpp: see constraint/kinematic_view.h.
#pragma once

#include "../../body/kinematic_motion.h"
#include "../../constraint/kinematic_motion_at.h"
#include "sequential_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// For a step of h seconds: the kinematic body of a manifold, or none.
inline void see_kinematic_body(const PointView& solver, const KinematicPoints& kinematic, const BodyView& bodies, scalar h, int manifold_i) {
    KinematicPoint& point = kinematic.points[manifold_i];
    point = {};
    const BodyPair& pair = solver.pairs[manifold_i];
    const bool is_A = shows_kinematic_motion(bodies, pair.body_A);
    const int slot = is_A ? pair.body_A : pair.body_B, partner = is_A ? pair.body_B : pair.body_A;
    if (!shows_kinematic_motion(bodies, slot) || !takes_part(solver, partner)) return;
    point.sign = is_A ? scalar(-1) : scalar(1);
    point.r_partner = solver.bodies[partner].r_CM;
    point.body = kinematic_contact_of(bodies, kinematic.of_slots, h, slot, point.r_partner);
    point.body.partner = static_cast<Index>(partner);
}

/// Calls each(point) for the manifolds of the island at hand that have a kinematic body.
template <class View, class Each>
void for_kinematic(const View& solver, const Each& each) {
    for (int i = 0; i < solver.member_count; ++i) {  // bound: max_manifolds
        KinematicPoint& point = solver.kinematic.points[solver.members[i]];
        if (point.sign != 0) each(point);
    }
}

/// The solver as conduct_substeps asks for it, which sees kinematic bodies.
template <class View, bool notes_impulses>
struct SeesKinematicPoints : SequentialContacts<View, notes_impulses> {
    using Contacts = SequentialContacts<View, notes_impulses>;
    explicit SeesKinematicPoints(View& of) : Contacts(of), all(of) {}

    bool next_batch(const ContactStep& step) {
        if (!Contacts::next_batch(step)) return false;
        // bound: max_manifolds
        for (int i = 0; i < all.member_count; ++i) see_kinematic_body(all, all.kinematic, step.bodies, step.h, all.members[i]);
        return true;
    }
    void predict(scalar h, const StepNotes& notes, StepReport& report) {
        for_kinematic(all, [&](KinematicPoint& point) {
            const Vector moved = all.bodies[point.body.partner].displacement.linear;
            begin_substep(point.body, moved);
            point.velocity = {velocity_at_begin(point.body, h), point.body.omega, {}};
            point.begin = point.velocity;
            point.forces = {acceleration_at_begin(point.body), point.body.alpha, {}};
        });
        Contacts::predict(h, notes, report);
    }
    void kick(scalar h) {
        Contacts::kick(h);
        for_kinematic(all, [&](KinematicPoint& point) {
            point.velocity = {velocity_at_end(point.body, h), point.body.omega + point.body.alpha * h, {}};
        });
    }
    void drift(const BodyView& bodies, scalar h) {
        bool too_much = false;
        for_kinematic(all, [&](KinematicPoint& point) { too_much = too_much || asks_too_much(this->residual(), point.velocity.linear, all.unit); });
        Contacts::drift(bodies, h);
        if (too_much) this->halve_impulses();
        for_kinematic(all, [&](KinematicPoint& point) {
            point.displacement.angular += mean_spin(point.body, h) * h;
            point.displacement.linear += end_substep(point.body, h);
        });
    }

private:
    View& all;
};

}  // namespace

} }  // namespace ingot
