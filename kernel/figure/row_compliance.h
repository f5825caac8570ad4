// SPDX-License-Identifier: MIT
// How the rate of a joint's direction answers an impulse on it.
#pragma once

#include "measure_joint.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The change of a row's rate by an impulse of 1 on it: up to the parent, which answers with all of its figure, and down over the joint.
template <unsigned width>
scalar compliance_of(const FigureRows<width>& rows, const OneLane<width>& at, const JointRowView& all, int row_i, const Vector& along) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i, at.lane_i);
    const Spatial<scalar> none{};
    Spatial<scalar> of_parent{};
    if (node.parent != no_node) {
        const Vector d = read(at, row.d);
        const Spatial<scalar> sent = impulse_from(impulse_through(at, row, node.kind, none, along), d);
        of_parent = twist_at(read(at, rows.response(all.responses, node.parent)) * sent, d);
    }
    return dot(along, free_rates(at, row, node.kind, twist_through(at, row, node.kind, of_parent, none, along) - of_parent));
}

} }  // namespace ingot

#pragma GCC diagnostic pop
