// SPDX-License-Identifier: MIT
// Both broad phases find every pair whose bounds overlap and of which one can move, and no other: against a double loop.
#include <gtest/gtest.h>

#include <ingot/broad_phase/all_pairs.h>
#include <ingot/broad_phase/sorted_tree.h>

#include "contact/play.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using ingot::BodyPair;
using ingot::Index;
using ingot::lanes;
using ingot_reference::RandomInput;

constexpr int bodies_max = 3000, pairs_max = 65535;

/// Bounds and whether bodies move; all that a broad phase reads.
struct Bodies {
    std::vector<ingot::RotationTile> rotation;
    std::vector<ingot::TranslationTile> translation;
    std::vector<ingot::BoundsTile> bounds;
    int count;

    explicit Bodies(int body_count)
        : rotation(tiles(body_count)), translation(tiles(body_count)), bounds(tiles(body_count)), count(body_count) {
        for (int slot = 0; slot < static_cast<int>(tiles(body_count)) * lanes; ++slot) put(slot, empty_low, -empty_low, false);
    }
    static std::size_t tiles(int body_count) { return static_cast<std::size_t>((body_count + lanes - 1) / lanes); }
    static constexpr double empty_low = 2e30;

    void put(int slot, const Vector3d& low, const Vector3d& high, bool moves) {
        const ingot::Place at = ingot::place_of(slot);
        for (int axis = 0; axis < 3; ++axis) {
            bounds[static_cast<std::size_t>(at.tile)].fat_low[axis][at.lane] = static_cast<scalar>(low(axis));
            bounds[static_cast<std::size_t>(at.tile)].fat_high[axis][at.lane] = static_cast<scalar>(high(axis));
        }
        translation[static_cast<std::size_t>(at.tile)].inv_M[at.lane] = moves ? scalar(1) : scalar(0);
    }
    void put(int slot, double low, double high, bool moves) { put(slot, Vector3d::Constant(low), Vector3d::Constant(high), moves); }

    ingot::BodyView view() { return {rotation.data(), translation.data(), nullptr, nullptr, static_cast<int>(rotation.size())}; }

    bool moves(int slot) const {
        const ingot::Place at = ingot::place_of(slot);
        return translation[static_cast<std::size_t>(at.tile)].inv_M[at.lane] > 0;
    }
    bool overlap(int a, int b) const {
        const ingot::Place A = ingot::place_of(a), B = ingot::place_of(b);
        const ingot::BoundsTile &of_A = bounds[static_cast<std::size_t>(A.tile)], &of_B = bounds[static_cast<std::size_t>(B.tile)];
        for (int axis = 0; axis < 3; ++axis)
            if (!(of_A.fat_low[axis][A.lane] <= of_B.fat_high[axis][B.lane] && of_B.fat_low[axis][B.lane] <= of_A.fat_high[axis][A.lane]))
                return false;
        return true;
    }
    std::vector<ingot::PairKey> expected() const {
        std::vector<ingot::PairKey> keys;
        for (int a = 0; a < count; ++a)
            for (int b = a + 1; b < count; ++b)
                if ((moves(a) || moves(b)) && overlap(a, b)) keys.push_back(ingot::key_of(static_cast<Index>(a), static_cast<Index>(b)));
        return keys;
    }
};

struct Found {
    std::vector<ingot::PairKey> keys;
    int lost;
};
template <class BroadPhase>
Found found_by(Bodies& bodies, int capacity) {
    using Memory = typename BroadPhase::template Memory<bodies_max, pairs_max>;
    static const std::unique_ptr<Memory> memory(new Memory{});  // what an earlier search left in it must not matter
    std::vector<BodyPair> pairs(static_cast<std::size_t>(capacity));
    Index count = 7, lost = 7;
    std::vector<std::uint8_t> flags(bodies.bounds.size() * lanes, ingot::SearchFlag::searched);
    memory->find_pairs({bodies.view(), {}, bodies.bounds.data(), flags.data()}, {pairs.data(), capacity, &count, &lost});
    Found found;
    found.lost = lost;
    for (int i = 0; i < count; ++i) {
        found.keys.push_back(pairs[static_cast<std::size_t>(i)].key());
        EXPECT_EQ(pairs[static_cast<std::size_t>(i)].record, ingot::no_record);
    }
    return found;
}

/// Sizes over three decades, clusters, equal boxes, boxes that only touch, half spaces, slots without a shape, some immovable.
Bodies random_bodies(RandomInput& random, int count) {
    Bodies bodies(count);
    const double world = 2 * std::cbrt(count) * random.real(0.5, 2);
    const double sizes = random.real(0, 1.5);  // decades
    const int half_spaces = random.integer(0, 5);
    const bool on_grid = random.integer(0, 3) == 0;
    for (int slot = 0; slot < count; ++slot) {
        const int kind = random.integer(0, 99);
        if (slot < half_spaces) {
            bodies.put(slot, -1e30, 1e30, false);
        } else if (kind < 5) {
            continue;  // no shape
        } else {
            Vector3d centre = random.vector(world / 2);
            if (kind < 15) centre = Vector3d::Constant(world / 3) + random.vector(0.5);
            Vector3d half = Vector3d::Constant(0.5);
            if (on_grid)
                for (int axis = 0; axis < 3; ++axis) centre(axis) = std::floor(centre(axis));  // equal boxes, which touch
            else
                half = std::pow(10, random.real(-sizes, sizes / 3)) * (Vector3d::Constant(0.6) + random.vector(0.4));
            bodies.put(slot, centre - half, centre + half, random.integer(0, 9) > 0);
        }
    }
    return bodies;
}

constexpr int counts[] = {1, 2, 3, 7, 8, 9, 16, 17, 63, 64, 65, 130, 300, 511, 513, 1000, 3000};

TEST(BroadPhase, both_find_exactly_the_overlaps) {
    RandomInput random(3);
    int pairs = 0, scenes = 0;
    for (const int count : counts) {
        for (int scene_i = 0; scene_i < (count > 500 ? 4 : 30); ++scene_i) {
            Bodies bodies = random_bodies(random, count);
            const std::vector<ingot::PairKey> expected = bodies.expected();
            if (expected.size() > pairs_max) continue;
            const Found all = found_by<ingot::AllPairs>(bodies, pairs_max), tree = found_by<ingot::SortedTree>(bodies, pairs_max);
            ASSERT_EQ(all.keys, expected) << count;
            ASSERT_EQ(tree.keys, expected) << count;
            EXPECT_EQ(all.lost, 0);
            EXPECT_EQ(tree.lost, 0);
            pairs += static_cast<int>(expected.size());
            ++scenes;
        }
    }
    figure("scenes", scenes);
    figure("pairs", pairs);
    EXPECT_GT(pairs, 10000);
}

/// A full array keeps as many as there is room for, sorted, each one true, and counts the rest.
template <class BroadPhase>
void expect_full_array_is_told() {
    RandomInput random(4);
    for (const int count : {9, 64, 300, 1000}) {
        Bodies bodies = random_bodies(random, count);
        const std::vector<ingot::PairKey> expected = bodies.expected();
        if (expected.size() < 2 || expected.size() > pairs_max) continue;
        for (const std::size_t capacity : {expected.size() - 1, expected.size() / 2, std::size_t{1}}) {
            const Found found = found_by<BroadPhase>(bodies, static_cast<int>(capacity));
            EXPECT_EQ(found.keys.size(), capacity);
            EXPECT_EQ(static_cast<std::size_t>(found.lost), expected.size() - capacity);
            EXPECT_TRUE(std::is_sorted(found.keys.begin(), found.keys.end()));
            EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.keys.begin(), found.keys.end()));
            EXPECT_EQ(std::adjacent_find(found.keys.begin(), found.keys.end()), found.keys.end());
        }
    }
}
TEST(BroadPhase, all_pairs_tells_what_has_no_room) { expect_full_array_is_told<ingot::AllPairs>(); }
TEST(BroadPhase, sorted_tree_tells_what_has_no_room) { expect_full_array_is_told<ingot::SortedTree>(); }

/// More than can be counted are as many as can.
template <class BroadPhase>
void expect_lost_pairs_are_counted_to_the_end() {
    if (INGOT_INDEX_BITS != 16) GTEST_SKIP() << "no test comes to the end of 32 bits";
    constexpr int count = 400;
    Bodies bodies(count);
    for (int slot = 0; slot < count; ++slot) bodies.put(slot, Vector3d(0, 0, 0), Vector3d(1, 1, 1), true);
    ASSERT_GT(bodies.expected().size(), 65535u + 1);
    const Found found = found_by<BroadPhase>(bodies, 1);
    EXPECT_EQ(found.keys.size(), 1u);
    EXPECT_EQ(found.lost, 65535);
}
TEST(BroadPhase, all_pairs_counts_what_is_lost_to_the_end) { expect_lost_pairs_are_counted_to_the_end<ingot::AllPairs>(); }
TEST(BroadPhase, sorted_tree_counts_what_is_lost_to_the_end) { expect_lost_pairs_are_counted_to_the_end<ingot::SortedTree>(); }

/// All bodies at one place; all in a line; bounds that are a point.
TEST(BroadPhase, degenerate_places_are_places) {
    for (const int count : {2, 9, 40, 200}) {
        for (int kind = 0; kind < 3; ++kind) {
            Bodies bodies(count);
            for (int slot = 0; slot < count; ++slot) {
                const Vector3d centre = kind == 0 ? Vector3d(1, 2, 3) : Vector3d(slot * 0.75, 0, 0);
                const Vector3d half = Vector3d::Constant(kind == 2 ? 0 : 0.5);
                bodies.put(slot, centre - half, centre + half, true);
            }
            EXPECT_EQ(found_by<ingot::SortedTree>(bodies, pairs_max).keys, bodies.expected());
            EXPECT_EQ(found_by<ingot::AllPairs>(bodies, pairs_max).keys, bodies.expected());
        }
    }
}

/// A tree that is kept finds, for the shapes that are due alone, what a double loop finds: after some bodies moved, a little or far away, came,
/// went, froze, or all of them; where all are searched for, and where some rest.
TEST(BroadPhase, a_kept_tree_finds_the_pairs_of_those_that_are_due) {
    using Memory = ingot::SortedTree::AwakeMemory<bodies_max, pairs_max>;
    RandomInput random(11);
    int searches = 0, pairs_seen = 0;
    for (const int count : {1, 8, 65, 300, 1000}) {
        for (int scene_i = 0; scene_i < 4; ++scene_i) {
            const std::unique_ptr<Memory> memory(new Memory{});
            Bodies bodies = random_bodies(random, count);
            std::vector<std::uint8_t> flags(bodies.bounds.size() * lanes, 0);
            for (int slot = 0; slot < count; ++slot) flags[static_cast<std::size_t>(slot)] = scene_i % 2 == 0 || random.integer(0, 2) > 0;
            std::vector<BodyPair> pairs(pairs_max);
            Index found = 0, lost = 0;
            const ingot::SearchView search = {bodies.view(), {}, bodies.bounds.data(), flags.data()};
            const ingot::PairList list = {pairs.data(), pairs_max, &found, &lost};
            memory->find_pairs(search, list);
            for (int round_i = 0; round_i < 60; ++round_i) {
                const int moved = random.integer(0, 9) == 0 ? count : random.integer(1, 1 + count / 20);
                int due = 0;
                for (int i = 0; i < moved; ++i) {
                    const int slot = moved == count ? i : random.integer(0, count - 1);
                    if (search.has(slot, ingot::SearchFlag::due)) continue;
                    search.set(slot, ingot::SearchFlag::due | ingot::SearchFlag::searched);
                    memory->due_shapes()[due++] = static_cast<std::uint32_t>(slot);
                    const double far = random.integer(0, 3) == 0 ? 20 : 0.5;
                    const Vector3d centre = random.vector(far), half = Vector3d::Constant(0.6) + random.vector(0.4);
                    if (random.integer(0, 15) == 0)
                        bodies.put(slot, Bodies::empty_low, -Bodies::empty_low, false);
                    else
                        bodies.put(slot, centre - half, centre + half, random.integer(0, 7) > 0);
                }
                memory->find_due_pairs(search, due, list);
                std::vector<ingot::PairKey> expected, keys;
                for (const ingot::PairKey key : bodies.expected()) {
                    const ingot::PairKey high = key >> INGOT_INDEX_BITS;
                    const int A = static_cast<int>(high), B = static_cast<int>(key - (high << INGOT_INDEX_BITS));
                    if (search.has(A, ingot::SearchFlag::searched) || search.has(B, ingot::SearchFlag::searched)) expected.push_back(key);
                }
                if (expected.size() > pairs_max) break;
                for (int i = 0; i < found; ++i) keys.push_back(pairs[static_cast<std::size_t>(i)].key());
                ASSERT_EQ(keys, expected) << count << " " << round_i;
                ASSERT_EQ(lost, 0);
                ++searches;
                pairs_seen += found;
            }
        }
    }
    figure("searches", searches);
    figure("pairs", pairs_seen);
    EXPECT_GT(searches, 600);
}

/// Pairs are searched for again before they can touch: in every step of a pile that falls, each two balls nearer than
/// limits::contact_margin have a manifold, and none do that are further apart than the margin, what they travel and what they spin.
template <class BroadPhase>
void expect_manifolds_of_all_near_pairs() {
    using Pile = scenes::SpherePile<4>;
    auto scene = play<Pile, BroadPhase>();
    const double h = 1.0 / 60, margin = static_cast<double>(ingot::limits::contact_margin), rounding = 1e-5;
    for (int step_i = 0; step_i < 200; ++step_i) {
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < Pile::body_count; ++i) bodies.push_back(scene.placed_now(i));
        int near = 0, within = 0;
        for (int i = Pile::wall_count; i < Pile::body_count; ++i) {
            for (int k = 0; k < i; ++k) {
                const double apart = -overlap_by_faces(bodies[static_cast<std::size_t>(i)], bodies[static_cast<std::size_t>(k)]);
                const double spin = scene.omega(i).norm() + (scene.moves(k) ? scene.omega(k).norm() : 0);
                near += apart <= margin - rounding;
                within += apart <= margin + h * ((scene.v(i) - scene.v(k)).norm() + 0.5 * spin) + rounding;
            }
        }
        const StepReport report = scene.step(Pile::h);
        ASSERT_GE(report.contacts, near) << step_i;
        ASSERT_LE(report.contacts, within) << step_i;
    }
    EXPECT_GT(scene.reports().most_contacts, 100);
}
TEST(BroadPhase, all_pairs_is_asked_again_in_time) { expect_manifolds_of_all_near_pairs<ingot::AllPairs>(); }
TEST(BroadPhase, sorted_tree_is_asked_again_in_time) { expect_manifolds_of_all_near_pairs<ingot::SortedTree>(); }

/// A fat AABB is the box around a body and a share of its extent on each side, of what moves, and nothing of what does not: whatever its size, so no
/// body is looked at for what is far from it in its own measure.
void expect_fat_by_a_share(bool one_by_one) {
    RandomInput random(2719);
    for (int trial_i = 0; trial_i < 200; ++trial_i) {
        const int count = random.integer(1, 24);
        Bodies bodies(count);
        std::vector<ingot::Surface> surfaces;
        for (int slot = 0; slot < count; ++slot) {
            const ingot::Place at = ingot::place_of(slot);
            const double size = std::exp(random.real(-5, 3));
            const Vector3d r = random.vector(20);
            surfaces.push_back({ingot::Box{{scalar(size), scalar(size * random.real(0.1, 1)), scalar(size * random.real(0.1, 1))}}, 0, 0, 0});
            ingot::set_lane(bodies.rotation[static_cast<std::size_t>(at.tile)].A, at.lane, ingot_reference::to_matrix(random.rotation()));
            ingot::set_lane(bodies.translation[static_cast<std::size_t>(at.tile)].r_CM, at.lane, ingot_reference::to_vector(r));
            bodies.translation[static_cast<std::size_t>(at.tile)].inv_M[at.lane] = random.integer(0, 2) == 0 ? scalar(0) : scalar(1);
            ingot::invalidate_bounds(bodies.bounds.data(), slot);
        }
        const ingot::SurfaceView view = {surfaces.data(), count};
        std::vector<std::uint8_t> flags(Bodies::tiles(count) * lanes);
        std::vector<std::uint32_t> due(Bodies::tiles(count) * lanes);
        if (one_by_one)
            (void)ingot::refresh_bounds_and_due({bodies.view(), view, bodies.bounds.data(), flags.data()}, scalar(0.01), due.data(), false);
        else
            ASSERT_TRUE(ingot::refresh_bounds(bodies.view(), view, scalar(0.01), bodies.bounds.data()));
        for (int slot = 0; slot < count; ++slot) {
            const ingot::Place at = ingot::place_of(slot);
            const ingot::BoundsTile& tile = bodies.bounds[static_cast<std::size_t>(at.tile)];
            for (int axis = 0; axis < 3; ++axis) {
                const double low = static_cast<double>(tile.low[axis][at.lane]), high = static_cast<double>(tile.high[axis][at.lane]);
                const double skin = bodies.moves(slot) ? static_cast<double>(ingot::bounding::skin_share) * (high - low) : 0;
                const double rounding = 4 * static_cast<double>(ingot::epsilon) * (std::abs(low) + std::abs(high));
                EXPECT_NEAR(static_cast<double>(tile.fat_low[axis][at.lane]), low - skin, bodies.moves(slot) ? rounding : 0) << trial_i;
                EXPECT_NEAR(static_cast<double>(tile.fat_high[axis][at.lane]), high + skin, bodies.moves(slot) ? rounding : 0) << trial_i;
            }
        }
    }
}
TEST(Bounds, are_fat_by_a_share) { expect_fat_by_a_share(false); }
TEST(Bounds, of_those_that_are_due_are_fat_by_a_share) { expect_fat_by_a_share(true); }

/// The bounds of a half space hold all of it, half of limits::contact_margin above its face too, and are no larger where the face lies along two of
/// the axes; any other is everywhere.
TEST(Bounds, of_a_half_space_end_at_its_face) {
    constexpr double margin = static_cast<double>(ingot::limits::contact_margin) / 2, everywhere = static_cast<double>(ingot::limits::unbounded);
    const Vector3d r(3, -700, 0.25);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double along : {-1.0, 1.0, 0.6}) {
            Bodies bodies(1);
            const Vector3d n = along * Vector3d::Unit(axis) + std::sqrt(1 - along * along) * Vector3d::Unit((axis + 1) % 3);
            constexpr double offset = -2.5;
            const ingot::Surface surface = {ingot::HalfSpace{{scalar(n.x()), scalar(n.y()), scalar(n.z())}, scalar(offset)}, 0, 0, 0};
            ingot::set_lane(bodies.rotation[0].A, 0, ingot::identity_matrix<scalar>());
            ingot::set_lane(bodies.translation[0].r_CM, 0, ingot::Vector{scalar(r.x()), scalar(r.y()), scalar(r.z())});
            ASSERT_TRUE(ingot::refresh_bounds(bodies.view(), {&surface, 1}, scalar(0.01), bodies.bounds.data()));
            const ingot::BoundsTile& bounds = bodies.bounds[0];
            for (int k = 0; k < 3; ++k) {
                const double low = static_cast<double>(bounds.low[k][0]), high = static_cast<double>(bounds.high[k][0]);
                const bool ends_above = k == axis && along == 1, ends_below = k == axis && along == -1;
                const double rounding = 12 * static_cast<double>(ingot::epsilon) * (std::abs(r(k)) + std::abs(offset));
                const double face = r(k) + (ends_below ? -offset : offset);
                EXPECT_EQ(low <= -everywhere, !ends_below) << axis << k << along;
                EXPECT_EQ(high >= everywhere, !ends_above) << axis << k << along;
                if (ends_above) {
                    EXPECT_TRUE(high >= face + margin && high <= face + margin + rounding) << high;
                }
                if (ends_below) {
                    EXPECT_TRUE(low <= face - margin && low >= face - margin - rounding) << low;
                }
            }
        }
    }
}

}  // namespace
