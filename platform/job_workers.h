// SPDX-License-Identifier: MIT
// Workers of a scene (kernel/base/workers.h) that are jobs of somebody else's system: a console's, an engine's.
//
//   void for_each_job(int tasks, void (*call)(void*, int), void* task) { ... }     // of yours: returns when all are done
//
//   struct Village : ingot::Scene {
//       using workers = ingot::platform::JobWorkers<6>;
//       ...
//   };
//   ingot::platform::JobWorkers<6>::for_each = for_each_job;                        // before the first step
#pragma once

namespace ingot::platform {

/// Where nobody has set for_each, tasks are done one after the other. One function for all worlds with so many workers. count: 2 .. 16.
template <int count>
struct JobWorkers {
    static constexpr int workers = count;  ///< so many tasks at one time

    /// Calls call(task, 0) .. call(task, tasks - 1), each once, at most `count` of them at one time, and returns when all are done. What they have
    /// written is seen by whoever goes on from there.
    using ForEach = void (*)(int tasks, void (*call)(void* task, int task_i), void* task);
    static inline ForEach for_each = nullptr;  ///< yours

    /// What a step asks of its workers: see base/workers.h.
    template <class Task>
    static void run(int tasks, Task& task) {
        if (for_each == nullptr) {
            for (int task_i = 0; task_i < tasks; ++task_i) task(task_i);
            return;
        }
        // The task may be const: what is called takes the type back as it was.
        for_each(tasks, [](void* of, int task_i) { (*static_cast<Task*>(of))(task_i); }, const_cast<void*>(static_cast<const void*>(&task)));
    }
};

}  // namespace ingot::platform
