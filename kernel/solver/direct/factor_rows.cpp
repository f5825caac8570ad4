// SPDX-License-Identifier: MIT
#include "factor_rows.h"

#include "../../base/limits.h"
#include "normal_set.h"
#include "sliding.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The speed along row i of manifold m that a unit impulse along row c of manifold p gives.
template <class Direct>
wide_scalar coupling(const Direct& island, const ManifoldOf<Direct>& m, const ManifoldOf<Direct>& p, const DirectRow& i,
                const DirectRow& c) {
    wide_scalar sum = 0;
    for (int side = 0; side < 2; ++side) {
        if (m.body[side] == 0) continue;
        for (int other = 0; other < 2; ++other) {
            if (m.body[side] != p.body[other]) continue;
            const wide_scalar linear = dot(i.d, c.d) * island.bodies[m.body[side]].inv_M;
            sum += (side == other ? linear : -linear) + dot(i.k[side], c.J[other]);
        }
    }
    return sum;
}

/// Lists active rows and where their entries begin; false: no room.
template <class Direct>
bool list_rows(Direct& island) {
    int count = 0;
    uint32_t entry_count = 0;
    // bound: max_island of HybridIslands: larger islands are swept
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        manifold.factored = manifold.active;
        manifold.active_begin = static_cast<Index>(count);
        const int begin = island.manifolds[manifold.first].active_begin;
        // bound: Direct::row_count: only a member named row is written, of an active row
        for (int row = 0; row < Direct::row_count; ++row) {
            if ((manifold.active >> row & 1u) == 0) continue;
            DirectActive& active = island.active[count];
            active.row = static_cast<Index>(manifold_i * Direct::row_count + row);
            active.begin = static_cast<Index>(begin);
            active.offset = entry_count;
            entry_count += static_cast<uint32_t>(count - begin);
            if (entry_count > static_cast<uint32_t>(island.entry_capacity)) return false;
            ++count;
        }
    }
    island.active_count = count;
    island.entry_count = static_cast<int>(entry_count);
    return true;
}

/// sum over k of a_k b_k, in four sums: a chain of additions would wait for each.
wide_scalar sum_of_products(const wide_scalar* a, const wide_scalar* b, int count) {
    wide_scalar sums[4] = {};
    int i = 0;
    // bound: 6 max_island / 4: count is at most the active rows of an island
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
    // bound: 3: what fours leave
    for (; i < count; ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// The matrix of the same rows, within the step, is the same.
template <class Direct>
bool is_factored(const Direct& island) {
    bool same = island.factored && !island.some_slide;
    for (int manifold_i = 0; manifold_i < island.manifold_count && same; ++manifold_i)
        same = island.manifolds[manifold_i].active == island.manifolds[manifold_i].factored &&
               island.manifolds[manifold_i].sliding == 0;
    return same;
}

template <class Direct>
void factor_symmetric(const Direct& island) {
    // bound: 6 max_island: three normals, two of friction and a twist of each manifold
    for (int i = 0; i < island.active_count; ++i) {
        DirectActive& active = island.active[i];
        const DirectRow& row = island.rows[active.row];
        const ManifoldOf<Direct>& manifold = island.manifolds[active.row / Direct::row_count];
        wide_scalar* const u = island.entries + active.offset;  // u[c - begin]
        // bound: 6 max_island: active rows of an island
        for (int c = active.begin; c < i; ++c) {
            const DirectActive& before = island.active[c];
            const ManifoldOf<Direct>& other = island.manifolds[before.row / Direct::row_count];
            const int first = active.begin > before.begin ? active.begin : before.begin;
            const wide_scalar known =
                sum_of_products(u + (first - active.begin), island.entries + before.offset + (first - before.begin), c - first);
            u[c - active.begin] = coupling(island, manifold, other, row, island.rows[before.row]) - known;
        }
        wide_scalar pivot = row.K * (1 + limits::direct_diagonal);
        for (int c = active.begin; c < i; ++c) {
            const wide_scalar scaled = u[c - active.begin] * island.active[c].inv_pivot;
            pivot -= scaled * u[c - active.begin];
            u[c - active.begin] = scaled;
        }
        if (island.steep && pivot > row.K * limits::direct_independence) pivot -= row.K * limits::direct_diagonal;
        active.inv_pivot = pivot > row.K * limits::direct_diagonal / 2 ? 1 / pivot : 0;
    }
}

/// Row i of Newton's matrix at column c. Sliding friction: K (t - mu N x / |x|) = 0 with x = t - u / K, derived; K makes it a
/// speed like the others.
template <class Direct>
wide_scalar newton_entry(const Direct& island, int i, int c) {
    const int row_i = island.active[i].row, row_c = island.active[c].row, own = row_i % Direct::row_count,
              theirs = row_c % Direct::row_count;
    const ManifoldOf<Direct> &manifold = island.manifolds[row_i / Direct::row_count], &other = island.manifolds[row_c / Direct::row_count];
    const DirectRow &row = island.rows[row_i], &column = island.rows[row_c];
    const wide_scalar damping = i == c ? row.K * limits::direct_diagonal : 0;
    if (!has(manifold.sliding, own)) return coupling(island, manifold, other, row, column) + damping;
    const bool same = &manifold == &other;
    if (own == torsion_row) {
        if (!same || (theirs >= friction_row && theirs != torsion_row)) return 0;
        return theirs == torsion_row ? row.K : -row.K * manifold.torsion_sign * manifold.mu * manifold.radius;
    }
    const int pair_i = own < torsion_row ? 0 : 1, first = row_of_pair(pair_i), axis = own - first;
    const DirectRow* const pair = island.rows + (row_i - axis);
    const SlideDirection& slip = manifold.slip[pair_i];
    const wide_scalar across[2] = {(axis == 0 ? 1 : 0) - slip.x[axis] * slip.x[0], (axis == 1 ? 1 : 0) - slip.x[axis] * slip.x[1]},
                 K = pair_compliance(pair);
    wide_scalar entry = slip.share * (across[0] * coupling(island, manifold, other, pair[0], column) +
                                      across[1] * coupling(island, manifold, other, pair[1], column));
    if (same && theirs < friction_row) entry -= K * manifold.bound_of(pair_i) * slip.x[axis];
    if (same && (theirs == first || theirs == first + 1)) entry += K * ((own == theirs ? 1 : 0) - slip.share * across[theirs - first]);
    return entry + damping;
}

/// L U of Newton's matrix, without exchange: L row by row, and U, column by column, behind it.
template <class Direct>
void factor_general(const Direct& island) {
    wide_scalar *const lower = island.entries, *const upper = island.entries + island.entry_count;
    for (int i = 0; i < island.active_count; ++i) {
        DirectActive& active = island.active[i];
        wide_scalar *const l = lower + active.offset, *const u = upper + active.offset;
        for (int c = active.begin; c < i; ++c) {
            const DirectActive& before = island.active[c];
            const int first = active.begin > before.begin ? active.begin : before.begin, count = c - first,
                      at = c - active.begin;
            l[at] = (newton_entry(island, i, c) -
                     sum_of_products(l + (first - active.begin), upper + before.offset + (first - before.begin), count)) *
                    before.inv_pivot;
            u[at] = newton_entry(island, c, i) -
                    sum_of_products(lower + before.offset + (first - before.begin), u + (first - active.begin), count);
        }
        const wide_scalar pivot = newton_entry(island, i, i) - sum_of_products(l, u, i - active.begin),
                     K = island.rows[active.row].K;
        active.inv_pivot = abs(pivot) > K * limits::direct_diagonal / 2 ? 1 / pivot : 0;
    }
}

/// About how many multiplications a factor takes: of its entries with each other, and for each entry itself.
template <class Direct>
int work_of_factor(const Direct& island) {
    constexpr int of_entry = 16, enough = 1 << 24;
    int work = 0;
    for (int i = 0; i < island.active_count && work < enough; ++i) {
        const int width = i - island.active[i].begin;
        work += width * (width / 2 + of_entry);
    }
    return island.some_slide ? 4 * work : work;  // two factors, with entries of several couplings each
}

/// Takes the work of the factor at hand from the work that is left, once in an attempt, and even if the attempt before has left the factor: whether
/// it has depends on which other islands are solved directly, and what an attempt may do must not. False: there is not so much left.
template <class Direct>
bool pay(Direct& island) {
    if (!island.paid) island.work_left -= work_of_factor(island);
    island.paid = true;
    if (island.work_left < 0) island.factored = false;
    return island.factored;
}

}  // namespace

template <class Direct>
bool factor_rows(Direct& island) {
    if (is_factored(island)) return pay(island);
    island.factored = list_rows(island);
    island.some_slide = false;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        if (island.manifolds[manifold_i].sliding == 0) continue;
        island.some_slide = true;
        find_slide(island, island.manifolds[manifold_i], island.rows + manifold_i * Direct::row_count);
    }
    if (island.some_slide) island.factored = island.factored && 2 * island.entry_count <= island.entry_capacity;
    if (!island.factored) return false;
    island.paid = false;
    if (!pay(island)) return false;
    island.some_slide ? factor_general(island) : factor_symmetric(island);
    return true;
}

template <class Direct>
void solve_factored(const Direct& island) {
    for (int i = 0; i < island.active_count; ++i) {
        DirectActive& active = island.active[i];
        const wide_scalar* const l = island.entries + active.offset;
        for (int c = active.begin; c < i; ++c) active.x -= l[c - active.begin] * island.active[c].x;
    }
    // Back by columns: of L^T where the matrix is symmetric, and D then stands between the two; of U else.
    const wide_scalar* const columns = island.entries + (island.some_slide ? island.entry_count : 0);
    if (!island.some_slide)
        for (int i = 0; i < island.active_count; ++i) island.active[i].x *= island.active[i].inv_pivot;
    // bound: 6 max_island: three normals, two of friction and a twist of each manifold
    for (int i = island.active_count - 1; i >= 0; --i) {
        DirectActive& active = island.active[i];
        if (island.some_slide) active.x *= active.inv_pivot;
        const wide_scalar* const column = columns + active.offset;
        for (int c = active.begin; c < i; ++c) island.active[c].x -= column[c - active.begin] * active.x;
    }
}

// The linker takes those of the scene.
template bool factor_rows(DirectView&);
template bool factor_rows(RollingDirectView&);
template void solve_factored(const DirectView&);
template void solve_factored(const RollingDirectView&);

} }  // namespace ingot
