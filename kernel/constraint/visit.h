// SPDX-License-Identifier: MIT
// What the parts of a contact are handed: the manifolds of a block as they are prepared, and a visit to their rows.
#pragma once

#include "contact_block.h"
#include "response.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The manifolds of a block, and what their bodies answer.
template <class ResponseOfBodies>
struct LaneContactsOf {
    ResponseOfBodies response;
    Vec3<lane> n, t_1, t_2;
    Vec3<lane> P[block_rows];
    lane used[block_rows];  ///< 1 where a manifold has that point, else 0
    lane separation[block_rows];
    Vec3<lane> middle;      ///< where friction takes hold
    lane radius;            ///< m, how far the points are from it
    mask central;           ///< one point, whose normal goes through the centres of both bodies that move
};

using LaneContacts = LaneContactsOf<Response>;

/// A visit to the rows of a block. row_count: of its normals, 1 or block_rows; all_lanes: every lane is active.
template <int row_count, bool all_lanes, class View>
struct RowVisit {
    static constexpr int rows = row_count;
    static constexpr bool whole = all_lanes;
    static constexpr bool articulates = View::articulates;

    const View& solver;
    int block_i;
    ContactBlock& block;
    mask active;
    Vec3<lane> n;
    lane inv_M_A, inv_M_B;
    lane load_of_normals;  ///< N s, once they are solved: what the others are bounded by

    RowVisit(const View& view, int of_block, mask lanes_active)
        : solver(view), block_i(of_block), block(view.blocks[of_block]), active(lanes_active), n(load(block.n)), inv_M_A(load(block.inv_M_A)),
          inv_M_B(load(block.inv_M_B)), load_of_normals{} {}
};

} }  // namespace ingot

#pragma GCC diagnostic pop
