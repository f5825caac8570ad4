// SPDX-License-Identifier: MIT
#include <ingot/platform/host_threads.h>
#include <ingot/platform/job_workers.h>
#include <ingot/platform/second_core.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace {

using namespace ingot::platform;

/// Each task once, and what it wrote is there when run returns.
template <class Workers>
void expect_each_once(int tasks) {
    std::vector<int> times(static_cast<std::size_t>(tasks));
    const auto task = [&times](int task_i) { ++times[static_cast<std::size_t>(task_i)]; };
    Workers::run(tasks, task);
    for (int task_i = 0; task_i < tasks; ++task_i) ASSERT_EQ(times[static_cast<std::size_t>(task_i)], 1) << task_i << " of " << tasks;
}

TEST(HostThreads, do_each_task_once) {
    for (int round = 0; round < 500; ++round) {
        expect_each_once<HostThreads<2>>(1 + round % 8);
        expect_each_once<HostThreads<3>>(1 + round % 12);
        expect_each_once<HostThreads<8>>(round % 33);
    }
}
TEST(HostThreads, wake_up) {
    for (int round = 0; round < 20; ++round) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));  // longer than they look for work
        expect_each_once<HostThreads<3>>(6);
    }
}
TEST(HostThreads, of_several_callers_take_turns) {
    std::vector<std::thread> callers;
    for (int i = 0; i < 3; ++i)
        callers.emplace_back([] {
            for (int round = 0; round < 200; ++round) expect_each_once<HostThreads<2>>(5);
        });
    for (std::thread& caller : callers) caller.join();
}
/// A task that waits for another one ends only if somebody else does that.
TEST(HostThreads, work_at_the_same_time) {
    std::atomic<int> arrived{0};
    const auto task = [&arrived](int) {
        arrived.fetch_add(1);
        while (arrived.load() < 2) std::this_thread::yield();
    };
    HostThreads<2>::run(2, task);
    EXPECT_EQ(arrived.load(), 2);
}

TEST(JobWorkers, are_one_after_the_other_until_they_are_given) { expect_each_once<JobWorkers<4>>(9); }
TEST(JobWorkers, are_those_of_the_system) {
    static int asked = 0;
    JobWorkers<6>::for_each = [](int tasks, void (*call)(void*, int), void* task) {
        ++asked;
        for (int task_i = tasks - 1; task_i >= 0; --task_i) call(task, task_i);
    };
    expect_each_once<JobWorkers<6>>(9);
    EXPECT_EQ(asked, 1);
    JobWorkers<6>::for_each = nullptr;
}

TEST(SecondCore, does_half) {
    using Second = SecondCore<7>;
    EXPECT_FALSE(Second::serve_once());
    std::atomic<bool> over{false};
    std::thread core_1([&over] {
        while (!over.load())
            if (!Second::serve_once()) std::this_thread::yield();
    });
    for (int round = 0; round < 300; ++round) expect_each_once<Second>(round % 9);
    over.store(true);
    core_1.join();
}

}  // namespace
