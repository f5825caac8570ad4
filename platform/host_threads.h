// SPDX-License-Identifier: MIT
// Workers of a scene (kernel/base/workers.h) that are threads of the host.
//
//   struct Village : ingot::Scene {
//       using workers = ingot::platform::HostThreads<4>;
//       ...
//   };
#pragma once

namespace ingot::platform {

/// Calls call(task, 0) .. call(task, count - 1), each once, on `workers` threads of which the caller is one, and returns when all are done.
///
/// The others are made by the first call that needs them and live until the program ends. They look for work for a moment after the last, so that the
/// stages of a step do not wait for them, and then sleep: where a step comes now and then, its first tasks are the caller's. Calls from several
/// threads take turns; a task does not call it again.
void run_on_threads(int workers, int count, void (*call)(void* task, int task_i), void* task);

/// count: 2 .. 16. More threads than there are cores free are slower than one.
template <int count>
struct HostThreads {
    static constexpr int workers = count;  ///< so many tasks at one time
    /// What a step asks of its workers: see base/workers.h.
    template <class Task>
    static void run(int tasks, Task& task) {
        // The task may be const: what is called takes the type back as it was.
        run_on_threads(workers, tasks, [](void* of, int task_i) { (*static_cast<Task*>(of))(task_i); },
                       const_cast<void*>(static_cast<const void*>(&task)));
    }
};

}  // namespace ingot::platform
