// SPDX-License-Identifier: MIT
#include "sliding.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "normal_set.h"

namespace ingot { inline namespace INGOT_ABI {

/// sqrt(x) in double without an instruction for it: the scalar's, and two steps of Newton's, which are the same everywhere.
double square_root(double x) {
    if (!(x > 1e-30)) return 0;
    double y = static_cast<double>(sqrt(static_cast<scalar>(x)));
    for (int step_i = 0; step_i < 2; ++step_i) y = 0.5 * (y + x / y);
    return y;
}

double load_of(const DirectManifold& manifold, const DirectRow* rows) {
    double N = 0;
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.rows, row)) N += larger(rows[row].j, 0);
    return N;
}

FrictionImpulse cut(const FrictionImpulse& t, double limit) {
    const double length_sq = t.at[0] * t.at[0] + t.at[1] * t.at[1];
    if (length_sq <= limit * limit) return t;
    const double length = square_root(length_sq), share = length > 0 ? limit / length : 0;
    return {{t.at[0] * share, t.at[1] * share}};
}

FrictionImpulse projected_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, double limit) {
    const DirectRow* const pair = rows + friction_row;
    const double inv_K = 1 / larger(pair[0].K, pair[1].K);
    return cut({{pair[0].j - inv_K * row_motion<false>(island, manifold, pair[0]), pair[1].j - inv_K * row_motion<false>(island, manifold, pair[1])}}, limit);
}
double projected_twist(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, double limit) {
    const DirectRow& twist = rows[twist_row];
    return within(twist.j - row_motion<false>(island, manifold, twist) / twist.K, limit);
}

namespace {

constexpr int slide_rows = 3;  ///< friction_row and those after it

bool slides(const DirectManifold& manifold, int i) { return has(manifold.rows, friction_row + i) && !has(manifold.active, friction_row + i); }

template <class Visitor>
void for_sliding(const DirectView& island, Visitor visit) {
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i)
        for (int i = 0; i < slide_rows; ++i)
            if (slides(island.manifolds[manifold_i], i)) visit(manifold_i, i, island.rows[manifold_i * direct_rows + friction_row + i]);
}

/// Lets friction follow, manifold by manifold, and notes what was proposed.
double propose(const DirectView& island, int slot) {
    double fastest = 0;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const DirectManifold& manifold = island.manifolds[manifold_i];
        DirectRow* const rows = island.rows + manifold_i * direct_rows;
        const double limit = manifold.mu * load_of(manifold, rows);
        double next[slide_rows] = {};
        if (slides(manifold, 0)) {
            const FrictionImpulse t = projected_friction(island, manifold, rows, limit);
            next[0] = t.at[0];
            next[1] = t.at[1];
        }
        if (slides(manifold, 2)) next[2] = projected_twist(island, manifold, rows, limit * manifold.radius);
        for (int i = 0; i < slide_rows; ++i) {
            if (!slides(manifold, i)) continue;
            DirectRow& row = rows[friction_row + i];
            const double change = next[i] - row.j;
            island.slides[manifold_i].proposed[slot][i] = next[i];
            island.slides[manifold_i].change[slot][i] = change;
            fastest = larger(fastest, size_of(change) * row.K);
            give<false>(island, manifold, row, change);
        }
    }
    return fastest;
}

/// Shares of the passes that are remembered, which make the change least.
struct Shares {
    double at[slide_memory];
};

/// Solves N x = b for a symmetric N that is positive semi-definite; unknowns that depend on those before them are 0.
Shares solve_normal_equations(double (&N)[slide_memory][slide_memory], Shares b, int count) {
    bool used[slide_memory];
    for (int k = 0; k < count; ++k) {
        double known = 0, diagonal = N[k][k];
        for (int c = 0; c < k; ++c)
            if (used[c]) known += N[k][c] * N[k][c] / N[c][c];  // of L D L^T, with L D in the lower half
        used[k] = diagonal - known > 1e-10 * diagonal;
        if (!used[k]) continue;
        N[k][k] = diagonal - known;
        for (int row = k + 1; row < count; ++row)
            for (int c = 0; c < k; ++c)
                if (used[c]) N[row][k] -= N[row][c] * N[k][c] / N[c][c];
        for (int c = 0; c < k; ++c)
            if (used[c]) b.at[k] -= N[k][c] / N[c][c] * b.at[c];
    }
    for (int k = count - 1; k >= 0; --k) {
        b.at[k] = used[k] ? b.at[k] / N[k][k] : 0;
        for (int row = k + 1; row < count; ++row)
            if (used[k] && used[row]) b.at[k] -= N[row][k] / N[k][k] * b.at[row];
    }
    return b;
}

Shares least_change(const DirectView& island, int slot, int count) {
    double N[slide_memory][slide_memory] = {};
    Shares b = {};
    for_sliding(island, [&](int manifold_i, int i, DirectRow& row) {
        const SlideHistory& history = island.slides[manifold_i];
        double difference[slide_memory];
        for (int k = 0; k < count; ++k) difference[k] = history.change[slot][i] - history.change[k][i];
        for (int k = 0; k < count; ++k) {
            b.at[k] += row.K * difference[k] * history.change[slot][i];
            for (int c = 0; c <= k; ++c) N[k][c] += row.K * difference[k] * difference[c];
        }
    });
    return solve_normal_equations(N, b, count);
}

}  // namespace

double follow_sliding(const DirectView& island, int pass_i) {
    const int slot = pass_i % slide_memory, count = pass_i < slide_memory ? pass_i + 1 : slide_memory;
    const double fastest = propose(island, slot);
    if (count == 1 || !(fastest > 0)) return fastest;
    const Shares share = least_change(island, slot, count);
    for_sliding(island, [&](int manifold_i, int i, DirectRow& row) {
        const SlideHistory& history = island.slides[manifold_i];
        double mixed = 0;
        for (int k = 0; k < count; ++k) mixed -= share.at[k] * (history.proposed[slot][i] - history.proposed[k][i]);
        give<false>(island, island.manifolds[manifold_i], row, mixed);
    });
    return fastest;
}

} }  // namespace ingot
