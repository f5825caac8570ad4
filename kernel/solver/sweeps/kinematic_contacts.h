// SPDX-License-Identifier: MIT
// Contacts with kinematic bodies, through a batch and its substeps: see constraint/kinematic_view.h.
#pragma once

#include "../conduct_substeps.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/kinematic_view.h"
#include "../../constraint/locked_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// For a step of h seconds, after prepare_blocks: finds the contacts that are with kinematic bodies, and gives them their solver bodies.
/// Needs: tiles that show the motion of kinematic bodies, see body/kinematic_motion.h.
template <class View>
void see_kinematic_bodies(const View& solver, KinematicContacts& kinematic, const BodyView& bodies, scalar h);

/// The same levers again, after refresh_blocks.
template <class View>
void see_kinematic_levers(const View& solver, const KinematicContacts& kinematic);

/// The begin of a substep of h seconds: velocities as they are then, with the acceleration of what is carried along.
void begin_kinematic_substep(const SolverView& solver, const KinematicContacts& kinematic, scalar h);
/// Velocities as they are at its end, which contacts aim at.
void kick_kinematic_bodies(const SolverView& solver, const KinematicContacts& kinematic, scalar h);
/// Halves the impulses of islands that are asked for what cannot be: see limits::kinematic_yield_share.
template <class View>
void yield_islands(const View& solver, const KinematicContacts& kinematic);
/// Displaces them by a substep, along their arcs. What they turn by is taken from the separations.
void drift_kinematic_bodies(const SolverView& solver, KinematicContacts& kinematic, scalar h);

/// A solver as conduct_substeps asks for it, which sees kinematic bodies. Contacts: SweptContacts, or HybridContacts.
template <class Contacts, class View>
struct SeesKinematic : Contacts {
    template <class... More>
    explicit SeesKinematic(View& of, const More&... more) : Contacts(of, more...), all(of) {}

    bool next_batch(const ContactStep& step) {
        if (!Contacts::next_batch(step)) return false;
        see_kinematic_bodies(contacts(), all.kinematic, step.bodies, step.h);
        return true;
    }
    void refresh(const BodyView& bodies, scalar h) {
        Contacts::refresh(bodies, h);
        see_kinematic_levers(contacts(), all.kinematic);
    }
    void predict(scalar h, const StepNotes& notes, StepReport& report) {
        begin_kinematic_substep(all, all.kinematic, h);
        Contacts::predict(h, notes, report);
    }
    void kick(scalar h) {
        Contacts::kick(h);
        kick_kinematic_bodies(all, all.kinematic, h);
    }
    void drift(const BodyView& bodies, scalar h) {
        yield_islands(contacts(), all.kinematic);
        Contacts::drift(bodies, h);
        drift_kinematic_bodies(all, all.kinematic, h);
    }

private:
    auto& contacts() { return without_locks(without_rows(static_cast<PlainViewOf<View>&>(all))); }

    View& all;
};

} }  // namespace ingot
