// SPDX-License-Identifier: MIT
#include "manifold_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr int candidates_max = 32;  // one bit each

/// Twice the signed area of the triangle a b c.
scalar area(const Candidate& a, const Candidate& b, const Candidate& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The candidate of the largest weight above zero that is not kept yet; -1: none.
template <class Weight>
int heaviest(const Candidate* candidates, int count, uint32_t kept, uint32_t known, scalar preference, Weight weight) {
    int best = -1;
    scalar best_weight = 0;
    for (int i = 0; i < count; ++i) {
        if ((kept >> i & 1u) != 0) continue;
        const scalar own = weight(candidates[i]), w = (known >> i & 1u) != 0 ? own * preference : own;
        if (w > best_weight) {
            best = i;
            best_weight = w;
        }
    }
    return best;
}

uint32_t spanning(const Candidate* candidates, int count, scalar tolerance, const Before& before) {
    uint32_t known = 0;
    for (int i = 0; i < count; ++i) known |= before.has(candidates[i].feature) ? 1u << i : 0u;

    int deepest = 0;
    scalar least = scalar_max;
    for (int i = 0; i < count; ++i) {
        const scalar s = (known >> i & 1u) != 0 ? candidates[i].separation - tolerance : candidates[i].separation;
        if (s < least) {
            deepest = i;
            least = s;
        }
    }
    uint32_t kept = 1u << deepest;
    const Candidate& a = candidates[deepest];
    const int second = heaviest(candidates, count, kept, known, scalar(1.21), [&](const Candidate& p) {
        return (p.x - a.x) * (p.x - a.x) + (p.y - a.y) * (p.y - a.y);
    });
    if (second < 0) return kept;
    kept |= 1u << second;
    const Candidate& b = candidates[second];
    const int third =
        heaviest(candidates, count, kept, known, scalar(1.1), [&](const Candidate& p) { return abs(area(a, b, p)); });
    if (third < 0) return kept;
    kept |= 1u << third;
    const Candidate& c = candidates[third];
    const scalar turn = area(a, b, c) < 0 ? scalar(-1) : scalar(1);
    const int fourth = heaviest(candidates, count, kept, known, scalar(1.1), [&](const Candidate& p) {
        const scalar ab = -turn * area(a, b, p), bc = -turn * area(b, c, p), ca = -turn * area(c, a, p);
        const scalar most = ab > bc ? ab : bc;
        return most > ca ? most : ca;
    });
    return fourth < 0 ? kept : kept | 1u << fourth;
}

}  // namespace

void keep_points(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before,
                 Manifold& manifold) {
    count = count < candidates_max ? count : candidates_max;
    const uint32_t kept = count <= Manifold::points_max ? ~0u : spanning(candidates, count, tolerance, before);
    manifold.n = frame.n;
    manifold.count = 0;
    for (int i = 0; i < count; ++i) {
        if ((kept >> i & 1u) == 0) continue;
        const Candidate& p = candidates[i];
        const Vector P = frame.origin + (frame.e_x * p.x + frame.e_y * p.y + frame.n * p.z);
        manifold.points[manifold.count++] = {P, p.separation, p.feature};
    }
}

} }  // namespace ingot
