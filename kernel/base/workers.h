// SPDX-License-Identifier: MIT
// Who does the work of a step: the kernel has no threads, it hands out tasks.
#pragma once

#include "limits.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using workers = ingot::OneCore;`, the default: the core that calls step() does all of it. Costs nothing.
///
/// A type of your own has the same two members, and brings other cores along (platform/host_threads.h has one of std::thread, guide/cores.md says how
/// to write one for a job system or a second core):
///
///     static constexpr int workers;                                   1 .. 16: so many tasks may run at one time
///     template <class Task> static void run(int count, Task& task);   calls task(0) .. task(count - 1), each once, in any order, on any core, and
///                                                                     returns when all are done; what one has written, whoever goes on sees
///
/// And it may have a third, for the sweeps of one large island, which hand out tasks of a microsecond:
///
///     static constexpr int least_visits;                              so many visits to contacts are worth a task: 8, if it is not named
///
/// Tasks write to places of their own, so they need no locks, and what they compute depends on their number alone: the bits of a world are the same
/// for any workers. Up to 4 * workers tasks are handed out at one time, some ten times a step, and some hundred times where one
/// large island is shared; stages with little to do are not. A task takes as much stack as step() does.
struct OneCore {
    static constexpr int workers = 1;  ///< so many tasks at one time
    /// Calls task(0) .. task(count - 1).
    template <class Task>
    static void run(int count, Task& task) {
        for (int task_i = 0; task_i < count; ++task_i) task(task_i);  // bound: 4 workers
    }
};

inline constexpr int workers_max = 16;  ///< of a scene
/// Tasks into which a stage may be cut, for each worker: more than one, so that who is done early takes another.
inline constexpr int tasks_of_worker = 4;
template <class Workers>
inline constexpr int tasks_max = Workers::workers == 1 ? 1 : tasks_of_worker * Workers::workers;

/// The workers of a scene, for code that is compiled apart from it.
struct TaskRunner {
    /// A task of whatever type.
    struct AnyTask {
        void (*call)(const AnyTask& task, int task_i);              ///< does part task_i of it
        void operator()(int task_i) const { call(*this, task_i); }  ///< the same
    };
    int workers;                                  ///< as of the scene's workers
    int least_visits;                             ///< so many visits to contacts are worth a task
    void (*run)(int count, const AnyTask& task);  ///< Workers::run

    /// As Workers::run. The task is copied: one that holds what it works with by value is in one cache line, which other cores read at once.
    template <class Task>
    void operator()(int count, const Task& task) const {
        struct alignas(64) Copied : AnyTask {
            Task task;
            explicit Copied(const Task& of)
                : AnyTask{[](const AnyTask& any, int task_i) { static_cast<const Copied&>(any).task(task_i); }}, task(of) {}
        };
        run(count, Copied(task));
    }
};
/// Workers::least_visits, where it is named.
template <class Workers>
constexpr auto least_visits_of(int) -> decltype(Workers::least_visits + 0) {
    return Workers::least_visits;
}
/// Where it is not.
template <class Workers>
constexpr int least_visits_of(long) {
    return limits::visits_of_task;
}
/// Of the workers of a scene.
template <class Workers>
constexpr TaskRunner runner_of() {
    return {Workers::workers, least_visits_of<Workers>(0), [](int count, const TaskRunner::AnyTask& task) { Workers::run(count, task); }};
}

/// A part of a row of things.
struct TaskRange {
    int begin, end;
};
/// Part task_i of `tasks` equal parts of [0 .. count).
constexpr TaskRange range_of(int task_i, int tasks, int count) {
    const long long all = count;
    return {static_cast<int>(all * task_i / tasks), static_cast<int>(all * (task_i + 1) / tasks)};
}
/// Into how many parts `count` things are cut, of which `least` are worth a task.
template <class Workers>
constexpr int tasks_for(int count, int least) {
    const int worth = count / least;
    return worth < 2 ? 1 : worth < tasks_max<Workers> ? worth : tasks_max<Workers>;
}

/// Calls each(task_i, range) for equal parts of [0 .. count): side by side, or, where there is little, all at once on the core at hand.
template <class Workers, class Each>
INGOT_INLINE void over_ranges(int count, int least, const Each& each) {
    if constexpr (Workers::workers == 1) {
        each(0, TaskRange{0, count});
    } else {
        const int tasks = tasks_for<Workers>(count, least);
        if (tasks == 1) return each(0, TaskRange{0, count});
        const auto task = [&](int task_i) { each(task_i, range_of(task_i, tasks, count)); };
        Workers::run(tasks, task);
    }
}

} }  // namespace ingot
