// SPDX-License-Identifier: MIT
// The four normals of a manifold as one complementarity problem, in lanes.
#pragma once

#include "../math/vec3.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int block_rows = 4;

/// A symmetric 4x4 matrix, row by row of its upper half.
struct Sym4 {
    lane at[10];

    static constexpr int index(int row, int column) {
        const int r = row < column ? row : column, c = row < column ? column : row;
        return r * block_rows - r * (r - 1) / 2 + (c - r);
    }
    INGOT_INLINE lane operator()(int row, int column) const { return at[index(row, column)]; }
    INGOT_INLINE lane& operator()(int row, int column) { return at[index(row, column)]; }
};

INGOT_INLINE lane least(lane a, lane b) { return select(a < b, a, b); }
INGOT_INLINE lane greatest(lane a, lane b) { return select(a > b, a, b); }

/// The inverse of a positive definite matrix, by the symmetric sweep operator. Cost: 4 divisions, about 120 flops.
INGOT_INLINE Sym4 inverse(Sym4 m) {
    for (int pivot = 0; pivot < block_rows; ++pivot) {
        const lane inv = splat<lane>(1) / m(pivot, pivot);
        lane column[block_rows];
        for (int row = 0; row < block_rows; ++row) column[row] = m(row, pivot);
        for (int row = 0; row < block_rows; ++row) {
            if (row == pivot) continue;
            for (int c = row; c < block_rows; ++c)
                if (c != pivot) m(row, c) = m(row, c) - column[row] * column[c] * inv;
        }
        for (int row = 0; row < block_rows; ++row) m(row, pivot) = column[row] * inv;
        m(pivot, pivot) = -inv;
    }
    for (lane& entry : m.at) entry = -entry;
    return m;
}

/// Impulses of the four rows.
struct Row4 {
    lane at[block_rows];
};

/// Starting over, row by row: for the rare case in which dropping the most negative leads astray. It never gains energy.
INGOT_INLINE Row4 solve_row_by_row(const Sym4& K, const Row4& w, const Row4& before, const mask (&pulls)[block_rows]) {
    Row4 l = before;
    for (int round_i = 0; round_i < 6; ++round_i) {
        for (int row = 0; row < block_rows; ++row) {
            lane u = w.at[row];
            for (int c = 0; c < block_rows; ++c) u = u + K(row, c) * (l.at[c] - before.at[c]);
            const lane next = l.at[row] - u / K(row, row);
            l.at[row] = select(pulls[row], next, greatest(next, lane{}));
        }
    }
    return l;
}

/// l >= 0 with w + K (l - before) >= 0 and one of the two zero in each row; K is the compliance, B the inverse of K with 1.01 of its
/// diagonal. A row that `pulls` takes any sign.
///
/// The unconstrained solution first; while an impulse is negative, the most negative row is dropped from B by a rank-one change. Rows
/// that are not used have a zero row in B, and K = 1 on the diagonal. Bound: 4 drops, 6 rounds.
/// Source: active set by symmetric sweeps; the start over is ours.
INGOT_INLINE Row4 solve_block(const Sym4& K, const Sym4& B, const Row4& w, const Row4& before, const mask (&pulls)[block_rows]) {
    Row4 l;
    lane lowest{};
    for (int row = 0; row < block_rows; ++row) {
        lane d{};
        for (int c = 0; c < block_rows; ++c) d = d + B(row, c) * w.at[c];
        l.at[row] = before.at[row] - d;
        lowest = least(lowest, select(pulls[row], lane{}, l.at[row]));
    }
    mask negative = lowest < lane{};
    if (!any(negative)) return l;

    const lane one = splat<lane>(1);
    const mask was_negative = negative;
    Sym4 left = B;
    mask dropped[block_rows] = {};
    for (int drop_i = 0; drop_i < block_rows && any(negative); ++drop_i) {
        mask is[block_rows], found = one < lane{};
        lane column[block_rows] = {}, diagonal = one, l_row{};
        for (int row = 0; row < block_rows; ++row) {
            const mask free = both(negative, select(pulls[row], lane{}, l.at[row]) <= lowest);
            is[row] = both(free, opposite(found));
            found = either(found, is[row]);
            l_row = select(is[row], l.at[row], l_row);
            diagonal = select(is[row], left(row, row), diagonal);
            for (int c = 0; c < block_rows; ++c) column[c] = select(is[row], left(row, c), column[c]);
        }
        const lane inv = one / diagonal;
        lowest = lane{};
        for (int row = 0; row < block_rows; ++row) {
            l.at[row] = select(is[row], lane{}, select(negative, l.at[row] - column[row] * (l_row * inv), l.at[row]));
            dropped[row] = either(dropped[row], is[row]);
            lowest = least(lowest, select(pulls[row], lane{}, l.at[row]));
            for (int c = row; c < block_rows; ++c) {
                const lane changed = left(row, c) - column[row] * column[c] * inv;
                const mask gone = either(is[row], is[c]);
                left(row, c) = select(negative, select(gone, lane{}, changed), left(row, c));
            }
        }
        negative = both(negative, lowest < lane{});
    }

    // A dropped row that approaches after all: not the solution.
    lane scale{}, worst{};
    for (int row = 0; row < block_rows; ++row) {
        lane u = w.at[row];
        for (int c = 0; c < block_rows; ++c) u = u + K(row, c) * (l.at[c] - before.at[c]);
        worst = least(worst, select(dropped[row], u, lane{}));
        scale = greatest(scale, abs(w.at[row]));
    }
    const mask astray = both(was_negative, worst < scale * splat<lane>(scalar(-1e-3)));
    if (any(astray)) {
        const Row4 again = solve_row_by_row(K, w, before, pulls);
        for (int row = 0; row < block_rows; ++row) l.at[row] = select(astray, again.at[row], l.at[row]);
    }
    return l;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
