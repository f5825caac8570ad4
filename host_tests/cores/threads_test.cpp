// SPDX-License-Identifier: MIT
// The same with threads of the host, two cores, and jobs: what a thread sanitizer watches (preset tsan).
#include <ingot/platform/host_threads.h>
#include <ingot/platform/job_workers.h>
#include <ingot/platform/second_core.h>

#include <atomic>
#include <thread>

#include "reference/brief_types.h"
#include "reference/draws.h"
#include "same_bits.h"

namespace {

using namespace cores_test;
using ingot_reference::draws;

template <class S>
class Threads : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<1, Sleepers, Materials, Full, Locked, Balls, Fast, OnLevels, Joined, Hybrid>;
TYPED_TEST_SUITE(Threads, Scenes);

TYPED_TEST(Threads, give_the_bits_of_one) {
    for (uint64_t seed = 1; seed <= static_cast<uint64_t>(draws(8)); ++seed) {
        expect_same_bits<TypeParam, ingot::platform::HostThreads<2>>(seed, 100, scalar(1) / 60);
#if !INGOT_TEST_BRIEF
        expect_same_bits<TypeParam, ingot::platform::HostThreads<5>>(seed, 100, scalar(1) / 60);
#endif
    }
}

/// Threads to which a visit to a contact is worth a task.
template <int count>
struct EagerThreads : ingot::platform::HostThreads<count> {
    static constexpr int least_visits = 1;
};
TYPED_TEST(Threads, give_the_bits_of_one_to_one_large_heap) {
    for (uint64_t seed = 1; seed <= static_cast<uint64_t>(draws(4)); ++seed) {
        expect_same_bits<TypeParam, EagerThreads<2>>(seed + 300, INGOT_TEST_BRIEF ? 20 : 40, scalar(1) / 60, Lie::in_one_heap);
#if !INGOT_TEST_BRIEF
        expect_same_bits<TypeParam, EagerThreads<5>>(seed + 300, 40, scalar(1) / 60, Lie::in_one_heap);
#endif
    }
}

#if !INGOT_TEST_BRIEF
TYPED_TEST(Threads, on_a_second_core) {
    using Second = ingot::platform::SecondCore<>;
    std::atomic<bool> over{false};
    std::thread core_1([&over] {
        while (!over.load())
            if (!Second::serve_once()) std::this_thread::yield();
    });
    for (uint64_t seed = 1; seed <= static_cast<uint64_t>(draws(4)); ++seed) expect_same_bits<TypeParam, Second>(seed, 60, scalar(1) / 60);
    over.store(true);
    core_1.join();
}
#endif

}  // namespace
