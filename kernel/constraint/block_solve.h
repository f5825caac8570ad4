// SPDX-License-Identifier: MIT
// The four normals of a manifold as one complementarity problem, in lanes.
#pragma once

#include "rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {



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

INGOT_INLINE Sym4 load_sym4(const LaneRow (&rows)[10]) {
    Sym4 m;
    for (int entry = 0; entry < 10; ++entry) m.at[entry] = load(rows[entry]);
    return m;
}

/// The inverse of a positive definite matrix, by the symmetric sweep operator. Cost: 4 divisions, about 120 flops.
template <int rows>
INGOT_INLINE Sym4 inverse(Sym4 m) {
    for (int pivot = 0; pivot < rows; ++pivot) {  // bound: 4: block_rows
        const lane inv = splat<lane>(1) / m(pivot, pivot);
        lane column[block_rows];
        for (int row = 0; row < rows; ++row) column[row] = m(row, pivot);
        for (int row = 0; row < rows; ++row) {
            if (row == pivot) continue;
            for (int c = row; c < rows; ++c)
                if (c != pivot) m(row, c) = m(row, c) - column[row] * column[c] * inv;
        }
        for (int row = 0; row < rows; ++row) m(row, pivot) = column[row] * inv;
        m(pivot, pivot) = -inv;
    }
    for (int row = 0; row < rows; ++row)
        for (int c = row; c < rows; ++c) m(row, c) = -m(row, c);
    return m;
}

/// A number for each row: speeds, impulses. Functions take how many rows there are as `rows`: 1, or block_rows.
struct Row4 {
    lane at[block_rows];
};

/// Starts over, row by row, in the rare case that dropping the most negative row leads to no solution. It never gains energy.
template <int rows>
INGOT_RARE Row4 solve_row_by_row(const Sym4& K, const Row4& w, const Row4& before, const mask (&pulls)[block_rows]) {
    Row4 l = before;
    for (int round_i = 0; round_i < 6; ++round_i) {
        for (int row = 0; row < rows; ++row) {
            lane u = w.at[row];
            for (int c = 0; c < rows; ++c) u = u + K(row, c) * (l.at[c] - before.at[c]);
            const lane next = l.at[row] - u / K(row, row);
            l.at[row] = select(pulls[row], next, max(next, lane{}));
        }
    }
    return l;
}

template <int rows>
INGOT_INLINE mask any_of(const mask (&masks)[block_rows]) {
    mask some = masks[0];
    for (int row = 1; row < rows; ++row) some = either(some, masks[row]);
    return some;
}

/// Rows that are out carry nothing: base, which is what rows carry, is without them then, and w is what that makes of the speeds.
template <int rows>
INGOT_INLINE void take_out(const Sym4& K, const mask (&out)[block_rows], Row4& w, Row4& base) {
    const Row4 before = base;
    for (int row = 0; row < rows; ++row) base.at[row] = select(out[row], lane{}, before.at[row]);
    for (int row = 0; row < rows; ++row)
        for (int c = 0; c < rows; ++c) w.at[row] = w.at[row] + K(row, c) * (base.at[c] - before.at[c]);
}

/// What stops all rows but those that are out: zero rows of the inverse.
template <int rows>
INGOT_INLINE Row4 solution_of(const Sym4& inverse, const Row4& w, const Row4& base) {
    Row4 l{};
    for (int row = 0; row < rows; ++row) {
        lane d{};
        for (int c = 0; c < rows; ++c) d = d + inverse(row, c) * w.at[c];
        l.at[row] = base.at[row] - d;
    }
    return l;
}

/// A solution with some rows out, as `inverse` says: it has zero rows for them, and the inverse of the rest elsewhere.
struct Attempt {
    Row4 l;
    mask fails;  ///< a row pulls although it may not, or a row that is out approaches
};
template <int rows>
INGOT_INLINE Attempt solve_with(const LaneRow (&K_rows)[10], const LaneRow (&inverse_rows)[10], Row4 w, const Row4& before,
                                const mask (&pulls)[block_rows], scalar slack) {
    const Sym4 inverse = load_sym4(inverse_rows);
    mask out[block_rows];
    Row4 base = before;
    for (int row = 0; row < rows; ++row) out[row] = opposite(inverse(row, row) > lane{});
    const bool some_out = any(any_of<rows>(out));
    if (some_out) take_out<rows>(load_sym4(K_rows), out, w, base);
    Attempt attempt;
    attempt.l = solution_of<rows>(inverse, w, base);
    attempt.fails = splat<lane>(1) < lane{};
    for (int row = 0; row < rows; ++row) attempt.fails = either(attempt.fails, both(attempt.l.at[row] < lane{}, opposite(pulls[row])));
    if (!some_out) return attempt;
    const Sym4 K = load_sym4(K_rows);
    for (int row = 0; row < rows; ++row) {
        lane u = w.at[row];
        for (int c = 0; c < rows; ++c) u = u + K(row, c) * (attempt.l.at[c] - base.at[c]);
        attempt.fails = either(attempt.fails, both(out[row], either(pulls[row], u < splat<lane>(-slack))));
    }
    return attempt;
}

/// The inverse of the compliance of the rows in use, which are the first ones; zero for the others. Where there are more than one, with
/// limits::block_diagonal times the diagonal: four points have rank 3, and two that all but coincide have rank 1.
template <int rows>
INGOT_INLINE Sym4 inverse_of_used(const Sym4& K, lane count) {
    const lane one = splat<lane>(1);
    if constexpr (rows == 1) return {{select(count > lane{}, one / K(0, 0), lane{})}};
    const lane factor = select(count > one, splat<lane>(limits::block_diagonal), one);
    Sym4 stiffened = K;
    for (int row = 0; row < rows; ++row) stiffened(row, row) = K(row, row) * factor;
    Sym4 all = inverse<rows>(stiffened);
    for (int row = 0; row < rows; ++row)
        for (int c = row; c < rows; ++c) all(row, c) = select(count > splat<lane>(static_cast<scalar>(c)), all(row, c), lane{});
    return all;
}

/// The search for the rows that are out. It begins with none; while a row is negative, the most negative is dropped from the inverse by a rank-one
/// change, and what the others carry follows from the inverse that is left. To change it by what the row carried would leave the roundings of that:
/// of a point that is 3 mm off in a substep of 0.5 us, those of 5 km/s, which push bodies at rest apart at millimetres a second.
template <int rows>
INGOT_RARE Row4 drop_rows(const Sym4& K, lane count, Sym4& left, const Row4& w, const Row4& before, const mask (&pulls)[block_rows]) {
    const lane one = splat<lane>(1);
    left = inverse_of_used<rows>(K, count);
    Row4 l = solution_of<rows>(left, w, before);
    lane lowest{};
    for (int row = 0; row < rows; ++row) lowest = min(lowest, select(pulls[row], lane{}, l.at[row]));
    mask negative = lowest < lane{}, dropped[block_rows] = {};
    const mask was_negative = negative;
    for (int drop_i = 0; drop_i < rows && any(negative); ++drop_i) {
        mask is[block_rows], found = one < lane{};
        lane column[block_rows] = {}, diagonal = one;
        for (int row = 0; row < rows; ++row) {
            const mask free = both(negative, select(pulls[row], lane{}, l.at[row]) <= lowest);
            is[row] = both(free, opposite(found));
            found = either(found, is[row]);
            diagonal = select(is[row], left(row, row), diagonal);
            for (int c = 0; c < rows; ++c) column[c] = select(is[row], left(row, c), column[c]);
        }
        const lane inv = one / diagonal;
        for (int row = 0; row < rows; ++row) {
            dropped[row] = either(dropped[row], is[row]);
            for (int c = row; c < rows; ++c) {
                const lane changed = left(row, c) - column[row] * column[c] * inv;
                const mask gone = either(is[row], is[c]);
                left(row, c) = select(negative, select(gone, lane{}, changed), left(row, c));
            }
        }
        Row4 speeds = w, base = before;
        take_out<rows>(K, dropped, speeds, base);
        const Row4 next = solution_of<rows>(left, speeds, base);
        lowest = lane{};
        for (int row = 0; row < rows; ++row) {
            l.at[row] = select(negative, next.at[row], l.at[row]);
            lowest = min(lowest, select(pulls[row], lane{}, l.at[row]));
        }
        negative = both(negative, lowest < lane{});
    }

    // A dropped row that approaches after all: not the solution.
    lane scale{}, worst{};
    for (int row = 0; row < rows; ++row) {
        lane u = w.at[row];
        for (int c = 0; c < rows; ++c) u = u + K(row, c) * (l.at[c] - before.at[c]);
        worst = min(worst, select(dropped[row], u, lane{}));
        scale = max(scale, abs(w.at[row]));
    }
    const mask astray = both(was_negative, worst < scale * splat<lane>(scalar(-1e-3)));
    if (any(astray)) {
        const Row4 again = solve_row_by_row<rows>(K, w, before, pulls);
        for (int row = 0; row < rows; ++row) l.at[row] = select(astray, again.at[row], l.at[row]);
    }
    return l;
}

/// The search for the rows that are out; of one row it is short: a row that would pull is out, and carries nothing.
template <int rows>
INGOT_INLINE Row4 search(const Sym4& K, lane count, Sym4& left, const Row4& w, const Row4& before, const mask (&pulls)[block_rows]) {
    if constexpr (rows > 1) return drop_rows<rows>(K, count, left, w, before, pulls);
    left = inverse_of_used<rows>(K, count);
    Row4 l = solution_of<rows>(left, w, before);
    const mask is_out = both(l.at[0] < lane{}, opposite(pulls[0]));
    l.at[0] = select(is_out, lane{}, l.at[0]);
    left(0, 0) = select(is_out, lane{}, left(0, 0));
    return l;
}

/// l >= 0 with w + K (l - before) >= 0 and one of the two zero in each row. A row that `pulls` takes any sign.
///
/// K is the compliance of the rows. cached_inverse is inverse_of_used without the rows that were out at the last visit. If the same rows are out now,
/// its product with w is the answer. Else the search begins anew; with `hold`, cached_inverse keeps what it finds. A row that is not used has a zero
/// row in cached_inverse, 1 on the diagonal of K, and w = 0: the others come out the same to the bit as without it.
/// slack: speed, or length, at which a row that is out may approach. Bound: 4 drops, 6 rounds.
/// Source: active set by symmetric sweeps; the cached inverse, and the start over, are ours.
template <int rows, bool hold>
INGOT_INLINE Row4 solve_block(const LaneRow (&K_rows)[10], const LaneRow& count, LaneRow (&cached_inverse)[10], const Row4& w, const Row4& before,
                              const mask (&pulls)[block_rows], scalar slack, mask active) {
    Attempt attempt = solve_with<rows>(K_rows, cached_inverse, w, before, pulls, slack);
    attempt.fails = both(attempt.fails, active);
    if (!any(attempt.fails)) return attempt.l;
    Sym4 left;
    const Row4 found = search<rows>(load_sym4(K_rows), load(count), left, w, before, pulls);
    for (int row = 0; row < rows; ++row) attempt.l.at[row] = select(attempt.fails, found.at[row], attempt.l.at[row]);
    if constexpr (hold)
        for (int row = 0; row < rows; ++row)
            for (int c = row; c < rows; ++c)
                store(cached_inverse[Sym4::index(row, c)], select(attempt.fails, left(row, c), load(cached_inverse[Sym4::index(row, c)])));
    return attempt.l;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
