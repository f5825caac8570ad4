// SPDX-License-Identifier: MIT
// One conductor for all solvers of contacts with friction.
#pragma once

#include "../base/report.h"
#include "../body/body_tiles.h"
#include "../constraint/impact_note.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a solver gets of a step. It reads v_CM, L, F_T and tau_T of the begin of the step, before integrate_v and integrate_L. To bodies it writes
/// only marks of those that have gone bad; their motion is written by write_contact_motion.
struct ContactStep {
    BodyView bodies;
    Vector gravity;     ///< m s^-2
    scalar h;           ///< s
    StepNotes notes;
};

/// m/s; what gravity gives in a substep.
inline scalar fall_speed_of(const ContactStep& step, int substeps) {
    return sqrt(length_sq(step.gravity)) * (step.h / static_cast<scalar>(substeps));
}

/// Solves all contacts of a step, island by island: many islands of one plan are a batch, which is cut into substeps alike.
///
/// In each substep forces act, the impulses of the substep before are given again, and the solver corrects them; then bodies are displaced,
/// and overlaps taken back by displacements that no velocity ever sees. No softness, no slop, no leak: loads do not sink, and corrections
/// give no energy. Restitution finds the time of impact within the substep. An island in which nothing accelerates needs fewer substeps;
/// one that turns out to accelerate begins again, with all of them.
///
/// Solver: begin, next_batch (false after the last), substeps, and the verbs of a substep as they stand here.
template <class Solver>
void conduct_substeps(Solver& solver, const ContactStep& step, StepReport& report) {
    solver.begin(step, report);
    while (solver.next_batch(step)) {  // bound: max_bodies: every batch has an island that was in none before, or one that begins again, once
        const int substeps = solver.substeps();
        const scalar h = step.h / static_cast<scalar>(substeps);
        for (int substep_i = 0; substep_i < substeps; ++substep_i) {  // bound: Effort::substeps_max, times eight
            solver.refresh(step.bodies, h);
            solver.predict(h, step.notes, report);
            solver.kick(h);
            solver.warm_start(h);
            solver.solve_velocities(step, h, report);
            solver.note_impulses(step.notes);
            solver.drift(step.bodies, h);
            solver.solve_positions(step, h);
        }
        solver.end_batch(step, report);
    }
}

} }  // namespace ingot
