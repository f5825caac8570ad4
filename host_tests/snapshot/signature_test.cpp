// SPDX-License-Identifier: MIT
// Scenes that differ in one trait refuse each other's snapshots. traits_test.py holds the rows against the traits of scene.h: a trait without a row
// fails.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace ingot;

inline constexpr auto tetrahedron = convex_hull<4>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
inline constexpr auto taller = convex_hull<4>({{1, 1, scalar(1.001)}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});

struct Plain : Scene {
    using shapes = Shapes<Sphere, Box>;
};

/// Two fields of numbers of the same kinds.
struct OfUser : ForceField {
    scalar c, c_turn;
    template <class Each>
    constexpr void numbers(Each& each) {
        each(c);
        each(c_turn);
    }
};
struct TwoInTurn : OneCore {
    static constexpr int workers = 2;
};
struct Constants {
    static constexpr ConvexHull one[] = {tetrahedron.value.view()}, other[] = {taller.value.view()};
    static constexpr LevelTable a_level[1] = {}, two_levels[2] = {};
};

// clang-format off
#define FLIP(trait, count, ...) struct Flip_##trait##_##count : Plain { __VA_ARGS__; };
#define SAME FLIP
#include "trait_flips.h"
#undef SAME
#undef FLIP
// clang-format on

TEST(Signature, is_another_for_each_trait) {
    std::set<uint64_t> signatures{scene_signature<Plain>()};
#define FLIP(trait, count, ...) \
    EXPECT_TRUE(signatures.insert(scene_signature<Flip_##trait##_##count>()).second) << #trait " = " #__VA_ARGS__;
#define SAME(trait, count, ...) EXPECT_EQ(scene_signature<Flip_##trait##_##count>(), scene_signature<Plain>()) << #trait " = " #__VA_ARGS__;
#include "trait_flips.h"
#undef SAME
#undef FLIP
}

TEST(Signature, is_the_same_for_scenes_of_the_same_traits) {
    struct Twin : Plain {};
    EXPECT_EQ(scene_signature<Twin>(), scene_signature<Plain>());
}

}  // namespace
