// SPDX-License-Identifier: MIT
// `BodyState s;` is what `BodyState s{};` is: over poisoned memory, both leave the same members. compile.initialised looks at every struct's source.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cstring>
#include <new>

namespace {

using namespace ingot;

/// A T by default initialisation, over bytes that were something else before.
template <class T>
class Poisoned {
public:
    explicit Poisoned(unsigned char poison) {
        std::memset(bytes_, poison, sizeof bytes_);
        asm volatile("" : : "r"(bytes_) : "memory");  // whatever lies there is there
        made_ = new (bytes_) T;
        asm volatile("" : : "r"(bytes_) : "memory");
    }
    const T& made() const { return *made_; }
    const unsigned char* bytes() const { return bytes_; }

private:
    alignas(T) unsigned char bytes_[sizeof(T)];
    T* made_;
};

/// Bytes that keep what was there before: gaps between members, and members that nobody initialises.
template <class T>
size_t bytes_left() {
    const Poisoned<T> ones(0xff), zeros(0);
    size_t left = 0;
    for (size_t byte_i = 0; byte_i < sizeof(T); ++byte_i) left += ones.bytes()[byte_i] != zeros.bytes()[byte_i] ? 1u : 0u;
    return left;
}

TEST(Initialised, are_the_structs_that_users_make) {
    constexpr size_t s = sizeof(scalar);
    EXPECT_EQ(bytes_left<BodyState>(), 0u);
    EXPECT_EQ(bytes_left<MassDistribution>(), 0u);
    EXPECT_EQ(bytes_left<MassProperties>(), 0u);
    EXPECT_EQ(bytes_left<MeshTriangle>(), 0u);
    EXPECT_EQ(bytes_left<UserPose>(), 0u);
    EXPECT_EQ(bytes_left<UserMotion>(), 0u);
    EXPECT_EQ(bytes_left<Quaternion>(), 0u);
    EXPECT_EQ(bytes_left<BodyId>(), 0u);
    EXPECT_EQ(bytes_left<BodyFilter>(), 0u);
    EXPECT_EQ(bytes_left<CollidingBody>(), 0u);
    EXPECT_EQ(bytes_left<Spring>(), 0u);
    EXPECT_EQ(bytes_left<ThrusterTable<2>>(), 0u);
    EXPECT_EQ(bytes_left<Box>(), 0u);
    EXPECT_EQ(bytes_left<HalfSpace>(), 0u);
    // No more is left than the gaps.
    EXPECT_LE(bytes_left<Shape>(), s - 1);
    EXPECT_LE(bytes_left<PlacedShape>(), sizeof(PlacedShape) - (1 + 16 * s + sizeof(void*)));
    EXPECT_LE(bytes_left<Event>(), sizeof(Event) - (3 + 16 + 7 * s));
    EXPECT_LE(bytes_left<QueryNearest>(), sizeof(QueryNearest) - (8 + 7 * s + 4));
    EXPECT_LE(bytes_left<Result<scalar>>(), s - 1);
}

TEST(Initialised, as_what_does_nothing) {
    const Poisoned<BodyDef> def(0xa5);
    EXPECT_EQ(def.made().state.v_CM.x, 0);
    EXPECT_EQ(def.made().mass.M, 0);
    EXPECT_EQ(def.made().shape.kind, ShapeKind::none);
    const Poisoned<PlacedShape> placed(0xa5);
    EXPECT_EQ(placed.made().A.c0.x, 1);
    EXPECT_EQ(placed.made().hull, nullptr);
    EXPECT_EQ(Poisoned<BodyId>(0xa5).made(), BodyId{});
    EXPECT_TRUE(Poisoned<StepReport>(0xa5).made().clean());
}

TEST(Results, have_another_value_where_they_have_none) {
    constexpr Result<int> some{Status::ok, 3}, none{Status::stale_id, 0};
    static_assert(some.value_or(7) == 3 && none.value_or(7) == 7);
    EXPECT_EQ((Result<scalar>{Status::not_finite, 1}.value_or(2)), 2);
}

TEST(Statuses, are_told_in_words) {
    EXPECT_STREQ(name(Status::ok), "ok");
    EXPECT_NE(std::strstr(name(Status::no_room), "max_bodies"), nullptr);
    for (int status = 1; status <= static_cast<int>(Status::other_scene); ++status) {
        EXPECT_NE(std::strchr(name(static_cast<Status>(status)), ':'), nullptr) << status;
        EXPECT_STRNE(name(static_cast<Status>(status)), "no status") << status;
        for (int other = 0; other < status; ++other) EXPECT_STRNE(name(static_cast<Status>(status)), name(static_cast<Status>(other)));
    }
    EXPECT_STREQ(name(static_cast<Status>(255)), "no status");
}

}  // namespace
