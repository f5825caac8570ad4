// SPDX-License-Identifier: MIT
#include "half_spaces.h"

#include "../math/wide.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_before(const HalfSpaces& s, int i, const Vector& n, scalar least) {
    const Vector& m = s.n[i];
    if (m.x != n.x) return m.x < n.x;
    if (m.y != n.y) return m.y < n.y;
    if (m.z != n.z) return m.z < n.z;
    return s.least[i] < least;
}

/// In an order of their own, so that sums round alike whatever order they came in.
void sort(HalfSpaces& s) {
    for (int end = 1; end < s.count; ++end) {  // bound: movers::planes_max
        const Vector n = s.n[end];
        const scalar least = s.least[end];
        int place = end;
        for (; place > 0 && !is_before(s, place - 1, n, least); --place) {  // bound: movers::planes_max
            s.n[place] = s.n[place - 1];
            s.least[place] = s.least[place - 1];
        }
        s.n[place] = n;
        s.least[place] = least;
    }
}

using Wide = Vec3<wide_scalar>;
Wide wide_of(const Vector& v) { return {static_cast<wide_scalar>(v.x), static_cast<wide_scalar>(v.y), static_cast<wide_scalar>(v.z)}; }
wide_scalar sum_of(const Wide& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// The search for the shortest y with n . y >= b for all planes: seen from the point w that is wanted. In double, as three planes that are all but
/// parallel have a determinant of 10^-8.
class Shortest {
public:
    Wide n[movers::planes_max];
    wide_scalar b[movers::planes_max];
    int count;
    wide_scalar size;  ///< m, of what b was computed from: its roundings are some epsilon of that
    wide_scalar far;   ///< m, how long y may be

    /// Each plane gives way by so much.
    bool find(wide_scalar by, Wide& y) {
        by_ = by;
        found_ = false;
        best_sq_ = far * far;
        consider({0, 0, 0});
        if (found_) return y = best_, true;
        for (int i = 0; i < count; ++i) {  // bound: movers::planes_max
            if (b[i] > by_) consider(n[i] * (b[i] - by_));
            for (int k = i + 1; k < count; ++k) {  // bound: movers::planes_max
                meet(i, k);
                for (int m = k + 1; m < count; ++m) meet(i, k, m);  // bound: movers::planes_max
            }
        }
        y = best_;
        return found_;
    }

private:
    static constexpr double epsilon_of_double = 1.0 / (1LL << 52);

    /// Keeps y where it is shorter than what there is and no plane forbids it, to its own roundings. That all planes of a set press is not asked:
    /// what is all but parallel has no sign for it, and who does not press gives a longer y than the set without it.
    void consider(const Wide& y) {
        const wide_scalar length_sq_y = length_sq(y);
        if (!(length_sq_y < best_sq_)) return;
        const wide_scalar slack = 64 * epsilon_of_double * (sum_of(y) + size) + by_;
        for (int i = 0; i < count; ++i)  // bound: movers::planes_max
            if (!(dot(n[i], y) >= b[i] - slack)) return;
        found_ = true;
        best_ = y;
        best_sq_ = length_sq_y;
    }

    /// Shortest y on two planes; twice, as what is all but parallel loses digits that its residual has.
    void meet(int i, int k) {
        const Wide &p = n[i], &q = n[k], across = cross(p, q), aside = cross(across, p);
        const wide_scalar sine_sq = length_sq(across), c = dot(p, q);
        if (!(sine_sq > 1024 * epsilon_of_double * epsilon_of_double)) return;
        const auto on = [&](wide_scalar at_p, wide_scalar at_q) { return p * at_p + aside * ((at_q - c * at_p) / sine_sq); };
        const wide_scalar b_p = b[i] - by_, b_q = b[k] - by_;
        Wide y = on(b_p, b_q);
        y += on(b_p - dot(p, y), b_q - dot(q, y));
        consider(y);
    }
    /// The point of three planes.
    void meet(int i, int k, int m) {
        const Wide &p = n[i], &q = n[k], &u = n[m], q_u = cross(q, u), u_p = cross(u, p), p_q = cross(p, q);
        const wide_scalar det = dot(p, q_u);
        if (!(abs(det) > 1024 * epsilon_of_double)) return;
        const auto on = [&](wide_scalar at_p, wide_scalar at_q, wide_scalar at_u) { return (q_u * at_p + u_p * at_q + p_q * at_u) * (1 / det); };
        const wide_scalar b_p = b[i] - by_, b_q = b[k] - by_, b_u = b[m] - by_;
        Wide y = on(b_p, b_q, b_u);
        y += on(b_p - dot(p, y), b_q - dot(q, y), b_u - dot(u, y));
        consider(y);
    }

    wide_scalar by_, best_sq_;
    Wide best_;
    bool found_;
};

/// Every plane gives way by as much, and no more than has to be: y of the least such. most: m, with which w itself will do.
Wide least_wrong(Shortest& search, wide_scalar most) {
    const wide_scalar fine = static_cast<wide_scalar>(epsilon) * search.size;
    Wide y = {0, 0, 0}, tried;
    wide_scalar low = 0, high = fine;
    // bound: 8 (double: 18): eight times as much each turn
    for (; high < most && !search.find(high, y); high *= 8) low = high;
    if (!(high < most)) high = most, y = {0, 0, 0};
    // bound: 26 (double: 54): it is halved until it is as fine as a scalar tells
    while (high - low > fine) {
        const wide_scalar middle = low + (high - low) / 2;
        if (search.find(middle, tried)) {
            high = middle;
            y = tried;
        } else {
            low = middle;
        }
    }
    return y;
}

}  // namespace

Vector nearest_in(HalfSpaces& s, const Vector& w, scalar far) {
    sort(s);
    Shortest search;
    const Wide from = wide_of(w);
    search.count = s.count;
    search.size = sum_of(from);
    wide_scalar most = 0;
    for (int i = 0; i < s.count; ++i) {  // bound: movers::planes_max
        search.n[i] = wide_of(s.n[i]);
        wide_scalar least = static_cast<wide_scalar>(s.least[i]);
        // As a scalar it is of unit length to a rounding; by Newton's method, twice, in double.
        for (int turn = 0; turn < 2; ++turn) {
            const wide_scalar shorter = 1.5 - 0.5 * length_sq(search.n[i]);
            search.n[i] = search.n[i] * shorter;
            least = least * shorter;
        }
        search.b[i] = least - dot(search.n[i], from);
        most = max(most, search.b[i]);
        search.size = max(search.size, abs(least));
    }
    if (!(most > 0)) return w;
    search.far = static_cast<wide_scalar>(far) * search.size;
    Wide y;
    if (!search.find(0, y)) y = least_wrong(search, most);
    const Wide x = from + y;
    return {static_cast<scalar>(x.x), static_cast<scalar>(x.y), static_cast<scalar>(x.z)};
}

} }  // namespace ingot
