// SPDX-License-Identifier: MIT
// The adaptors of stages that several cores share, where a scene names `workers`: base/workers.h. With one core each is the stage itself.
#pragma once

#include "../island/awake_tiles.h"
#include "../solver/sweeps/move_bodies.h"
#include "step_context.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls stage(view, report) for the bodies that move: all, or those that are awake.
template <class S, class Stage>
INGOT_INLINE void over_moving(Step<S>& now, const Stage& stage) {
    if constexpr (shares_work<S>) {
        StepReport of_task[tasks_max<typename S::workers>];
        constexpr int least = (limits::bodies_of_task + lanes - 1) / lanes;
        over_ranges<typename S::workers>(now.bodies.tile_count, least, [&](int task_i, const TaskRange& tiles) {
            if constexpr (S::sleeps)
                over_awake_bodies_of(
                    now.bodies, now.storage.rest_view(), [&tiles](int tile_i) { return tile_i >= tiles.begin && tile_i < tiles.end; },
                    [&](const BodyView& some) { stage(some, of_task[task_i]); });
            else
                stage(tiles_of(now.bodies, tiles.begin, tiles.end - tiles.begin), of_task[task_i]);
        });
        for (const StepReport& report : of_task) count(now.report.spins_clamped, report.spins_clamped);
    } else if constexpr (S::sleeps) {
        over_awake_bodies(now.bodies, now.storage.rest_view(), [&](const BodyView& some) { stage(some, now.report); });
    } else {
        stage(now.bodies, now.report);
    }
}

/// Calls each(part_i, solver) for the parts of the step, side by side.
template <class S, class Each>
INGOT_INLINE void over_parts(Step<S>& now, const Each& each) {
    const auto task = [&](int part_i) { each(part_i, now.parts.solvers[part_i]); };
    S::workers::run(now.parts.count, task);
}

/// Whether most of the contacts are those of one island, so that parts would leave cores idle.
template <class S>
bool is_one_large_island(const Step<S>& now) {
    const int contacts = now.solver.manifold_count, largest = now.parts.count > 1 ? now.parts.parts[0].pair_count : contacts;
    return contacts >= limits::manifolds_together &&
           static_cast<scalar>(largest * S::workers::workers) > limits::uneven_share * static_cast<scalar>(contacts);
}

/// Solves contacts in parts, or one large island together; false, and nothing is done, where there is too little to share.
template <class S>
bool solve_side_by_side([[maybe_unused]] Step<S>& now, [[maybe_unused]] const ContactStep& step) {
    if constexpr (solves_in_parts<S>) {
        auto& storage = now.storage;
        const PartRoom room = storage.part_room();
        const int most = tasks_for<typename S::workers>(now.solver.manifold_count, limits::manifolds_of_task);
        now.parts.count = cut_into_parts(now.solver, now.bodies, most, room, step.notes.impacts, S::kinematic_bodies, now.parts.parts);
        const bool together = is_one_large_island(now);
        if (together || now.parts.count == 1) now.parts.count = 0;
        if (together)
            storage.template solve_together<has_events<S> || S::reads_contacts, S::bounces>(now.solver, step, now.report, storage.work_together());
        if (now.parts.count == 0) return together;
        // bound: tasks_max
        for (int part_i = 0; part_i < now.parts.count; ++part_i) {
            now.parts.solvers[part_i] = now.solver;
            become_part(now.parts.solvers[part_i], now.parts.parts[part_i], room);
        }
        StepReport of_part[tasks_max<typename S::workers>];
        over_parts(now, [&](int part_i, auto& solver) {
            ContactStep own = step;
            if (step.notes.impacts != nullptr) own.notes.impacts = room.notes + now.parts.parts[part_i].pair_begin;
            storage.template solve_contacts<has_events<S> || S::reads_contacts, S::bounces>(solver, own, of_part[part_i]);
        });
        for (int part_i = 0; part_i < now.parts.count; ++part_i) {
            add_report(now.report, of_part[part_i]);
            if (step.notes.impacts != nullptr) give_back_notes(now.parts.parts[part_i], room, step.notes.impacts);
        }
        return true;
    } else {
        return false;
    }
}

/// The bodies that touch get the motion that was found.
template <class S>
INGOT_INLINE void write_contact_motion(Step<S>& now) {
    if constexpr (solves_in_parts<S>) {
        if (now.parts.count > 0) {
            over_parts(now, [&now](int, const auto& solver) { write_motion_of_part(solver, now.bodies, now.storage.gravity, now.h); });
            // bound: tasks_max
            for (int part_i = 0; part_i < now.parts.count; ++part_i) mark_motion_of_part(now.parts.solvers[part_i], now.bodies);
            return;
        }
    }
    write_contact_motion(now.solver, jointed_of(now.solver), now.bodies, now.storage.gravity, now.h);
}

/// And the small turns by which overlaps were taken back.
template <class S>
INGOT_INLINE void turn_by_corrections(Step<S>& now) {
    if constexpr (solves_in_parts<S>) {
        if (now.parts.count > 0) {
            over_parts(now, [&now](int, auto& solver) { turn_by_corrections(solver, jointed_of(solver), now.bodies, now.h); });
            if constexpr (S::continuous) {
                now.solver.body_count = 0;
                // bound: tasks_max
                for (int part_i = 0; part_i < now.parts.count; ++part_i)
                    find_bodies_of_part(now.solver, now.parts.solvers[part_i], now.parts.parts[part_i]);
            }
            return;
        }
        return over_ranges<typename S::workers>(now.solver.body_count - 1, limits::bodies_of_task, [&now](int, const TaskRange& range) {
            turn_some_by_corrections(now.solver, {range.begin + 1, range.end + 1}, now.bodies, now.h);
        });
    }
    turn_by_corrections(now.solver, jointed_of(now.solver), now.bodies, now.h);
}

} }  // namespace ingot
