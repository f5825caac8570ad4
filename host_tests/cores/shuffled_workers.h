// SPDX-License-Identifier: MIT
// Workers on one thread that take tasks in an order of chance: what depends on who comes first is found without waiting for it to happen.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace cores_test {

template <int count>
struct Shuffled {
    static constexpr int workers = count;
    static constexpr int least_visits = 1;  ///< heaps of a test are small
    static inline uint64_t seed = 1;
    static inline int rows = 0;             ///< of tasks: of an island that is shared there are hundreds in a step
    static inline int most_tasks = 0;  ///< that were handed out at one time: a test sees that work was shared at all

    template <class Task>
    static void run(int tasks, Task& task) {
        std::vector<int> order;
        for (int i = 0; i < tasks; ++i) order.push_back(i);
        for (int i = tasks - 1; i > 0; --i) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>((seed >> 33) % static_cast<uint64_t>(i + 1))]);
        }
        for (const int task_i : order) task(task_i);
        ++rows;
        most_tasks = tasks > most_tasks ? tasks : most_tasks;
    }
};

}  // namespace cores_test
