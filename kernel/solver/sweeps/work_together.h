// SPDX-License-Identifier: MIT
// Who does the work of a solve: one core, or several that share a large island.
//
// Contacts of one level and colour have no body in common that can move, so it is no matter who visits which of them, and when. A sweep is a row of
// such groups, one after the other; large ones are shared. The order of visits to a body, and so the bits, are those of one core.
//
// The road not taken: to cut an island in space, and to visit what lies across the cuts last. That needs two joins a sweep in the place of one a
// group, but the order, and with it the bits and how fast sweeps settle, would be those of the cuts, on one core too.
#pragma once

#include "../../base/limits.h"
#include "../../base/workers.h"
#include "../../constraint/locked_view.h"
#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// The core at hand does all of it: each function is its stage.
struct WorkAlone {
    static constexpr bool is_shared = false;

    static void begin_batch(const SolverView&) {}
    template <class View, class Each>
    static INGOT_INLINE void over_blocks(View& view, const Each& each) {
        each(view);
    }
    template <class View, class Each>
    static INGOT_INLINE void over_bodies(View& view, const Each& each) {
        each(view);
    }
    template <class Each>
    static INGOT_INLINE void over_visits(const SolverView& view, const Each& each) {
        each(view.visits, view.visit_count);
    }
    template <class Each>
    static INGOT_INLINE void over_live(const SolverView& view, bool, const Each& each) {
        each(view.live, view.live_count);
    }
    template <class View, class Each>
    static INGOT_INLINE void over_batch(const View& view, const Each& each) {
        each(view);
    }
};

/// Becomes a part of its blocks.
INGOT_INLINE void take_blocks(SolverView& view, const TaskRange& blocks) {
    view.blocks += blocks.begin;
    view.block_count = blocks.end - blocks.begin;
}
template <bool rolls, bool has_belts>
INGOT_INLINE void take_blocks(MaterialView<rolls, has_belts>& view, const TaskRange& blocks) {
    take_blocks(static_cast<SolverView&>(view), blocks);
    if (view.rolling != nullptr) view.rolling += blocks.begin;
    if (view.belts != nullptr) view.belts += blocks.begin;
}

/// Several cores share a solve. Each function calls each(part) for parts of a view, of its blocks or its bodies, or each(visits, count).
///
/// Whoever has the k-th part of the visits of a group has the blocks of it in all that is done with blocks: they stay with one core.
class WorkTogether {
public:
    static constexpr bool is_shared = true;

    /// ends_of_visits, ends_of_live: room for a group of each contact.
    WorkTogether(const TaskRunner& runner, Index* ends_of_visits, Index* ends_of_live)
        : run_(runner), ends_of_visits_(ends_of_visits), ends_of_live_(ends_of_live) {}

    /// Before its blocks are prepared.
    void begin_batch(const SolverView& view);

    template <class View, class Each>
    void over_blocks(View& view, const Each& each) const {
        const Groups groups = groups_of_all(view);
        const int tasks = tasks_of(groups.visit_count(), limits::tasks_worth_share * run_.least_visits, 1);
        if (tasks == 1) return each(view);
        do_tasks(tasks, [&](int task_i) {
            over_shares_of(task_i, tasks, groups, [&](const TaskRange& visits) {
                auto part = view;
                take_blocks(part, {first_block(view, visits.begin), first_block(view, visits.end)});
                each(part);
            });
        });
    }
    template <class View, class Each>
    void over_bodies(View& view, const Each& each) const {
        bool turn[tasks_most] = {}, hit[tasks_most] = {};
        const int tasks = tasks_of(view.batch_body_count, limits::bodies_of_task, tasks_of_worker);
        const auto task = [&](int task_i) {
            View part = view;
            take_bodies(part, range_of(task_i, tasks, view.batch_body_count));
            each(part);
            turn[task_i] = part.some_turn;
            hit[task_i] = part.some_hit;
        };
        do_tasks(tasks, task);
        view.some_hit = false;
        for (int task_i = 0; task_i < tasks; ++task_i) {  // bound: tasks_of_worker workers_max
            view.some_turn = view.some_turn || turn[task_i];
            view.some_hit = view.some_hit || hit[task_i];
        }
    }
    /// All visits of the batch, group after group.
    template <class Each>
    void over_visits(const SolverView& view, const Each& each) const {
        over_groups(groups_of_all(view), true, each);
    }
    /// The live ones, from the first group to the last, or from the last to the first.
    template <class Each>
    void over_live(const SolverView& view, bool up, const Each& each) const {
        over_groups(groups_of_live(view), up, each);
    }
    /// Live visits and bodies of the batch, in any order.
    template <class View, class Each>
    void over_batch(const View& view, const Each& each) const {
        const int tasks = tasks_of(view.live_count, limits::tasks_worth_extrapolation * run_.least_visits, 1);
        if (tasks == 1) return each(view);
        const Groups groups = groups_of_live(view);
        do_tasks(tasks, [&](int task_i) {
            View part = view;
            take_bodies(part, range_of(task_i, tasks, view.batch_body_count));
            over_shares_of(task_i, tasks, groups, [&](const TaskRange& visits) {
                const int begin = block_border(view, visits.begin);
                part.live = view.live + begin;
                part.live_count = block_border(view, visits.end) - begin;
                each(part);
                part.batch_body_count = 0;
            });
            part.live_count = 0;
            if (part.batch_body_count > 0) each(part);  // it has no visits
        });
    }

private:
    static constexpr int tasks_most = tasks_of_worker * workers_max;

    /// A list of visits, and where each of its groups ends.
    struct Groups {
        const Visit* visits;
        const Index* ends;
        int count;

        TaskRange range(int group) const { return {group == 0 ? 0 : ends[group - 1], ends[group]}; }
        int visit_count() const { return count == 0 ? 0 : ends[count - 1]; }
    };
    static Groups list_groups(const SolverView& view, const Visit* visits, int count, Index* ends);
    /// Whether three of four visits are in groups that are shared. Else a core would fetch what others have worked on, and back, for little.
    bool has_large_groups(const Groups& groups) const;
    Groups groups_of_all(const SolverView& view) const { return {view.visits, ends_of_visits_, visit_groups_}; }
    Groups groups_of_live(const SolverView& view) const {
        return view.live == view.visits ? groups_of_all(view) : list_groups(view, view.live, view.live_count, ends_of_live_);
    }

    static INGOT_INLINE void take_bodies(SolverView& view, const TaskRange& bodies) {
        view.batch_bodies += bodies.begin;
        view.batch_body_count = bodies.end - bodies.begin;
    }
    /// That of a visit, or the next one where a visit before has it too: then it goes with that.
    static int first_block(const SolverView& view, int visit_i) {
        if (visit_i == view.visit_count) return view.block_count;
        const Index block = view.visits[visit_i].block;
        return visit_i > 0 && view.visits[visit_i - 1].block == block ? block + 1 : block;
    }

    /// The live visit from which a part may begin: those of one block stay together.
    static int block_border(const SolverView& view, int visit_i) {
        // bound: lanes
        while (visit_i > 0 && visit_i < view.live_count && view.live[visit_i].block == view.live[visit_i - 1].block) ++visit_i;
        return visit_i;
    }

    /// of_each: tasks for each worker, at most.
    int tasks_of(int count, int least, int of_each) const {
        const int worth = shares_ ? count / least : 1, most = of_each * run_.workers;
        return worth < 2 ? 1 : worth < most ? worth : most;
    }
    template <class Task>
    void do_tasks(int tasks, const Task& task) const {
        if (tasks == 1) return task(0);
        run_(tasks, [&task](int task_i) { task(task_i); });
    }

    /// Calls each(visits) for the parts of the groups that one of the workers has in a sweep; small groups go by turns.
    template <class Each>
    void over_shares_of(int task_i, int tasks, const Groups& groups, const Each& each) const {
        for (int group = 0; group < groups.count; ++group) {  // bound: max_manifolds
            const TaskRange range = groups.range(group);
            const int count = range.end - range.begin, of_sweep = tasks_of(count, run_.least_visits, 1);
            const int parts = of_sweep < tasks ? of_sweep : tasks;
            if (parts == 1 && group % tasks == task_i) each(range);
            if (parts == 1 || task_i >= parts) continue;
            const TaskRange part = range_of(task_i, parts, count);
            each(TaskRange{range.begin + part.begin, range.begin + part.end});
        }
    }

    /// Small groups that follow each other are visited by the core at hand, all at once.
    template <class Each>
    void over_groups(const Groups& groups, bool up, const Each& each) const {
        const auto visit = [&](const TaskRange& range) {
            if (range.begin != range.end) each(groups.visits + range.begin, range.end - range.begin);
        };
        TaskRange small = {0, 0};
        for (int k = 0; k < groups.count; ++k) {  // bound: max_manifolds
            const TaskRange range = groups.range(up ? k : groups.count - 1 - k);
            const int count = range.end - range.begin, tasks = tasks_of(count, run_.least_visits, 1);
            if (tasks == 1) {
                if (small.begin == small.end) small = range;
                (up ? small.end : small.begin) = up ? range.end : range.begin;
                continue;
            }
            visit(small);
            small = {0, 0};
            run_(tasks, [each, tasks, count, of_group = groups.visits + range.begin](int task_i) {
                const TaskRange part = range_of(task_i, tasks, count);
                each(of_group + part.begin, part.end - part.begin);
            });
        }
        visit(small);
    }

    TaskRunner run_;
    Index *ends_of_visits_, *ends_of_live_;
    int visit_groups_ = 0;
    bool shares_ = false;  ///< the batch at hand is worth it
};

} }  // namespace ingot
