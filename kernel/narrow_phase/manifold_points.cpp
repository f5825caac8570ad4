// SPDX-License-Identifier: MIT
#include "manifold_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Twice the signed area of the triangle a b c.
scalar area(const Candidate& a, const Candidate& b, const Candidate& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Which candidates were chosen, in the order of the choice.
struct Choice {
    int chosen[Manifold::points_max];
    int count;

    bool has(int i) const {
        bool found = false;
        // bound: 32: candidates of a manifold
        for (int k = 0; k < count; ++k) found |= chosen[k] == i;
        return found;
    }
};

/// How much a candidate adds to those that are chosen, m^2: the square of its distance from one; twice the area of its triangle with two, and twice
/// what it adds to the triangle of three.
scalar weight_of(const Candidate* candidates, const Choice& choice, const Candidate& p) {
    const Candidate& a = candidates[choice.chosen[0]];
    if (choice.count == 1) return (p.x - a.x) * (p.x - a.x) + (p.y - a.y) * (p.y - a.y);
    const Candidate& b = candidates[choice.chosen[1]];
    const scalar of_ab = area(a, b, p);
    if (choice.count == 2) return abs(of_ab);
    const Candidate& c = candidates[choice.chosen[2]];
    const scalar turn = area(a, b, c) < 0 ? scalar(-1) : scalar(1);
    const scalar ab = -turn * of_ab, bc = -turn * area(b, c, p), ca = -turn * area(c, a, p);
    const scalar most = ab > bc ? ab : bc;
    return most > ca ? most : ca;
}

/// All candidates weigh what they span.
struct AllAlike {
    static scalar share_of(const Candidate&, const Candidate&) { return 1; }
};
/// 1 of what is as near as the deepest, and soon less: what touches at the end of the step, if at all, makes room for what touches before.
struct NearOnesFirst {
    scalar margin;

    scalar share_of(const Candidate& p, const Candidate& deepest) const {
        if (!(margin > deepest.separation)) return 1;
        const scalar share = (margin - p.separation) / (margin - deepest.separation), sq = share * share;
        return sq * sq * (sq * sq);
    }
};

/// Adds the candidate of the largest weight above zero; what was chosen at this turn in the step before weighs more.
template <class Order>
bool add_heaviest(const Candidate* candidates, int count, const Before& before, const Order& order, Choice& choice) {
    const scalar preference = choice.count == 1 ? scalar(1.21) : scalar(1.1);
    int best = -1;
    scalar best_weight = 0;
    for (int i = 0; i < count; ++i) {
        if (choice.has(i)) continue;
        scalar w = weight_of(candidates, choice, candidates[i]) * order.share_of(candidates[i], candidates[choice.chosen[0]]);
        if (before.had(choice.count, candidates[i].feature)) w = w * preference;
        if (w > best_weight) {
            best = i;
            best_weight = w;
        }
    }
    if (best < 0) return false;
    choice.chosen[choice.count++] = best;
    return true;
}

template <class Order>
Choice spanning(const Candidate* candidates, int count, scalar tolerance, const Before& before, const Order& order) {
    Choice choice{};
    scalar least = scalar_max;
    for (int i = 0; i < count; ++i) {
        const scalar s = before.had(0, candidates[i].feature) ? candidates[i].separation - tolerance : candidates[i].separation;
        if (s < least) {
            choice.chosen[0] = i;
            least = s;
        }
    }
    choice.count = 1;
    while (choice.count < Manifold::points_max && add_heaviest(candidates, count, before, order, choice)) {}  // bound: 4: Manifold::points_max
    return choice;
}

template <class Order>
void keep_four(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before, const Order& order,
               Manifold& manifold) {
    Choice choice;
    choice.count = count;  // number by number: a table of them would be copied by a call
    for (int i = 0; i < Manifold::points_max; ++i) choice.chosen[i] = i;
    if (count > Manifold::points_max) choice = spanning(candidates, count, tolerance, before, order);
    manifold.n = frame.n;
    manifold.count = static_cast<int8_t>(choice.count);
    // bound: 4: Manifold::points_max
    for (int i = 0; i < choice.count; ++i) {
        const Candidate& p = candidates[choice.chosen[i]];
        const Vector P = frame.origin + (frame.e_x * p.x + frame.e_y * p.y + frame.n * p.z);
        manifold.points[i] = {P, p.separation, p.feature};
    }
}

}  // namespace

void keep_points(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before, Manifold& manifold) {
    keep_four(candidates, count, frame, tolerance, before, AllAlike{}, manifold);
}
void keep_near_points(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before, scalar margin,
                      Manifold& manifold) {
    keep_four(candidates, count, frame, tolerance, before, NearOnesFirst{margin}, manifold);
}

} }  // namespace ingot
