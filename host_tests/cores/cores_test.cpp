// SPDX-License-Identifier: MIT
// The bits of a world are those of one core, whoever does the work and in whatever order: states, events, reports and snapshots.
#include "reference/brief_types.h"
#include "reference/draws.h"
#include "same_bits.h"
#include "shuffled_workers.h"

namespace {

using namespace cores_test;
using ingot_reference::draws;

template <class S, int count>
void expect_same_when_shuffled(uint64_t seed, scalar h) {
    Shuffled<count>::seed = seed;
    Shuffled<count>::most_tasks = 0;
    expect_same_bits<S, Shuffled<count>>(seed, 100, h);
    EXPECT_GT(Shuffled<count>::most_tasks, 1) << "nothing was shared";
}

/// One heap. True where it was one island that all cores worked on together for most of its steps: of heaps of chance not all are.
template <class S, int count>
bool is_same_in_one_heap(uint64_t seed, scalar h) {
    Shuffled<count>::seed = seed;
    Shuffled<count>::rows = 0;
    constexpr int steps = S::continuous ? 12 : 40;  // where many are fast, flights take longer than all else
    expect_same_bits<S, Shuffled<count>>(seed, steps, h, Lie::in_one_heap);
    return Shuffled<count>::rows > 30 * steps;
}
/// Whether the contacts of a heap can be shared, and it has room to be large.
template <class S>
constexpr bool may_be_shared = ingot::solves_in_parts<On<S, Shuffled<2>>> && S::shapes::has(ingot::ShapeKind::box) && S::max_manifolds > 400;

template <class S>
class Cores : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<3, Sleepers, Materials, Full, Plain, Locked, Balls, Fast, OnLevels, Joined, Hybrid, Pointwise, Scarce>;
TYPED_TEST_SUITE(Cores, Scenes);

TYPED_TEST(Cores, give_the_bits_of_one) {
    const scalar rates[] = {60, 30, 120, 240, 1000};
    for (uint64_t seed = 1; seed <= static_cast<uint64_t>(draws(16)); ++seed) {
        const scalar h = 1 / rates[seed % 5];
        expect_same_when_shuffled<TypeParam, 3>(seed, h);
#if !INGOT_TEST_BRIEF
        expect_same_when_shuffled<TypeParam, 2>(seed + 100, h);
        expect_same_when_shuffled<TypeParam, 8>(seed + 200, h);
#endif
    }
}
TYPED_TEST(Cores, give_the_bits_of_one_to_one_large_heap) {
    const scalar rates[] = {60, 30, 120};
    int shared = 0;
    for (uint64_t seed = 1; seed <= static_cast<uint64_t>(draws(4)); ++seed) {
        const scalar h = 1 / rates[seed % 3];
        shared += is_same_in_one_heap<TypeParam, 3>(seed + 300, h) ? 1 : 0;
#if !INGOT_TEST_BRIEF
        shared += is_same_in_one_heap<TypeParam, 2>(seed + 400, h) ? 1 : 0;
        shared += is_same_in_one_heap<TypeParam, 8>(seed + 500, h) ? 1 : 0;
#endif
    }
    if (may_be_shared<TypeParam>) {
        EXPECT_GT(shared, 0);
    }
}

}  // namespace
