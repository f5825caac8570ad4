// SPDX-License-Identifier: MIT
// A cursor's way over one joint: see cursor.h.
#pragma once

#include "tree_passes.h"

namespace ingot { inline namespace INGOT_ABI {

/// Hands what is new to the parent.
template <unsigned width>
void climb(const FigureRows<width>& rows, const OneLane<width>& at, const Spatial6Rows<1>* responses, int row_i) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i, at.lane_i);
    FigureRow<width>& parent = rows[node.parent];
    const Spatial<scalar> sent = impulse_to_send(at, row, node.kind);
    const Spatial<scalar> due = impulse_from(sent - read(at, row.sent), read(at, row.d));
    write(at, row.sent, sent);
    write(at, parent.impulse, read(at, parent.impulse) + due);
    write(at, parent.change, read(at, parent.change) + read(at, rows.response(responses, node.parent)) * due);
}

template <unsigned width>
void descend(const FigureRows<width>& rows, const OneLane<width>& at, int row_i) {
    FigureRow<width>& row = rows[row_i];
    write(at, row.change, change_of_child(at, row, rows.node(row_i, at.lane_i).kind, change_of_parent(rows, at, row_i)));
}

} }  // namespace ingot
