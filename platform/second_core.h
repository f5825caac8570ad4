// SPDX-License-Identifier: MIT
// Workers of a scene (kernel/base/workers.h) for chips with two cores that share memory: RP2040, RP2350, ESP32.
//
//   struct Village : ingot::Scene {
//       using workers = ingot::platform::SecondCore<>;
//       ...
//   };
//   void main_of_core_1() { ingot::platform::SecondCore<>::serve(); }               // core 0 steps the world
#pragma once

#include <stdint.h>

#include <atomic>

namespace ingot::platform {

/// Core 0 calls step(), and takes the tasks of even numbers; core 1 serves, and takes the others. It needs no more of a chip than that both cores see
/// what is stored, in order: the Armv6-M of the RP2040 has no exclusive loads, so no task is taken by who comes first. The kernel hands out the
/// largest tasks first, so halves are alike.
/// number: where two worlds are stepped at one time, they need two. Cost: a few loads and stores a call, and the wait for the slower core.
/// Stack: a task takes as much as step() does, on core 1 too.
template <int number = 0>
class SecondCore {
public:
    static constexpr int workers = 2;  ///< so many tasks at one time

    /// What a step asks of its workers: see base/workers.h.
    template <class Task>
    static void run(int tasks, Task& task) {
        call_ = [](void* of, int task_i) { (*static_cast<Task*>(of))(task_i); };
        task_ = const_cast<void*>(static_cast<const void*>(&task));
        count_ = tasks;
        const uint32_t row = row_.load(std::memory_order_relaxed) + 1;
        row_.store(row, std::memory_order_release);
        for (int task_i = 0; task_i < tasks; task_i += 2) task(task_i);
        while (done_.load(std::memory_order_acquire) != row) {}
    }

    /// Core 1: does its tasks, if there are some; false: there were none, and it may wait for an event or an interrupt.
    static bool serve_once() {
        const uint32_t row = row_.load(std::memory_order_acquire);
        if (row == done_.load(std::memory_order_relaxed)) return false;
        for (int task_i = 1; task_i < count_; task_i += 2) call_(task_, task_i);
        done_.store(row, std::memory_order_release);
        return true;
    }
    /// Core 1, for good.
    [[noreturn]] static void serve() {
        for (;;) (void)serve_once();
    }

private:
    static inline std::atomic<uint32_t> row_{0}, done_{0};  ///< loads and stores alone, which every core has
    static inline void (*call_)(void*, int) = nullptr;
    static inline void* task_ = nullptr;
    static inline int count_ = 0;
};

}  // namespace ingot::platform
