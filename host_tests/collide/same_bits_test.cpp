// SPDX-License-Identifier: MIT
// The narrow phase gives the same bits with every compiler and lane count: one hash over the manifolds of all pairs.
#include <gtest/gtest.h>
#include <ingot/narrow_phase/manifold_anchors.h>

#include <cstdio>
#include <cstring>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using ingot::Vector;

/// Numbers that are exact in both scalars, from integers: no library takes part.
struct Numbers {
    std::uint64_t state = 1;
    scalar next() {  // -1 .. 1 in steps of 2^-15
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<scalar>(static_cast<int>(state >> 48) - 32768) / 32768;
    }
    scalar size() { return scalar(0.75) + next() / 2; }
    Vector vector() {
        const scalar x = next(), y = next(), z = next();
        return {x, y, z};
    }
    ingot::Matrix rotation() {
        const Vector u = vector(), v = vector(), first = u * (1 / ingot::sqrt(length_sq(u))), across = cross(first, v);
        const Vector third = across * (1 / ingot::sqrt(length_sq(across)));
        return {first, cross(third, first), third};
    }
};

struct Hash {
    std::uint64_t value = 14695981039346656037u;
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) value = (value ^ bytes[i]) * 1099511628211u;
    }
    void add(const Manifold& m) {
        add(&m.n, sizeof m.n);
        const std::int32_t count = m.count;
        add(&count, sizeof count);
        for (int i = 0; i < m.count; ++i) {
            add(&m.points[i].P, sizeof(Vector));
            add(&m.points[i].separation, sizeof(scalar));
            add(&m.points[i].feature, sizeof(std::uint32_t));
        }
    }
};

constexpr auto rock = ingot::convex_hull({{scalar(0.75), 0, scalar(0.125)},
                                          {scalar(-0.5), scalar(0.25), 0},
                                          {scalar(0.25), scalar(0.875), scalar(-0.25)},
                                          {0, scalar(-0.75), scalar(0.375)},
                                          {scalar(0.125), scalar(0.25), scalar(0.625)},
                                          {scalar(-0.25), scalar(-0.375), scalar(-0.75)},
                                          {scalar(0.5), scalar(0.5), scalar(0.5)}});
static_assert(rock.ok());
constexpr ingot::ConvexHull rock_view = rock.value.view();

TEST(NarrowPhase, has_the_same_bits_everywhere) {
    Numbers numbers;
    Hash hash;
    int touching = 0;
    const auto shape = [&](int kind) {
        PlacedShape s{};
        const scalar x = numbers.size(), y = numbers.size(), z = numbers.size();
        if (kind == 0) s.shape = ingot::Sphere{x};
        if (kind == 1) s.shape = ingot::Capsule{x, y};
        if (kind == 2) s.shape = ingot::Box{{x, y, z}};
        if (kind == 3) s.shape = ingot::Cylinder{x, y};
        if (kind == 4) s.shape = ingot::Hull{rock_view.radius}, s.hull = &rock_view;
        if (kind == 5) s.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        s.A = numbers.rotation();
        s.r = numbers.vector();
        return s;
    };
    for (int i = 0; i < 400; ++i)
        for (int a = 0; a < 5; ++a)
            for (int b = a; b < 6; ++b) {
                PlacedShape A = shape(a), B = shape(b);
                if (i % 3 == 0) A.A = B.A;
                Manifold m{}, again{};
                ASSERT_TRUE(collide(A, B, scalar(0.05), m));
                hash.add(m);
                ingot::ManifoldAnchors anchors{};
                anchor({A.r, A.A}, {B.r, B.A}, m, scalar(0.05), anchors);
                A.r += numbers.vector() * (scalar(1) / 1024);
                Manifold carried = m;
                const ingot::RenewLimits within = {scalar(0.125), scalar(0.05), ingot::limits::contact_margin / 2};
                if (renew_from_anchors({A.r, A.A}, {B.r, B.A}, within, anchors, carried)) hash.add(carried);
                collide(A, B, scalar(0.05), again, &m);
                hash.add(again);
                touching += m.count > 0;
            }
    std::printf("%d touch; hash %016llx\n", touching, static_cast<unsigned long long>(hash.value));
    EXPECT_GT(touching, 3000);
    EXPECT_EQ(hash.value, INGOT_DOUBLE ? 0xfa96bf688f889258u : 0x045029804f85e2b0u);
}

}  // namespace
