// SPDX-License-Identifier: MIT
// How the body of a row moves.
#pragma once

#include "figure_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// kg m^2/s, of a spin w, world axes.
template <class At, class T = typename At::T>
INGOT_INLINE Vec3<T> momentum_of_spin(const At& at, const FigureRow<At::width>& row, const Vec3<T>& w) {
    const Mat3<T> A = read(at, row.A);
    return A * scaled(read(at, row.I_body), transpose_times(A, w));
}

/// rad/s, of every row from its L.
template <unsigned width, class Kinds>
void set_spins(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const Mat3<T> A = read(rows.all, row.A);
        write(rows.all, row.w, A * unscaled(read(rows.all, row.I_body), transpose_times(A, read(rows.all, row.L))));
    }
}

/// The change that a solve gives, at the centre of mass.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> change_of_centre(const At& at, const FigureRow<At::width>& row) {
    return twist_at(read(at, row.change), read(at, row.c));
}

} }  // namespace ingot

#pragma GCC diagnostic pop
