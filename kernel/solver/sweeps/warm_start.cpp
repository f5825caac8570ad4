// SPDX-License-Identifier: MIT
#include "warm_start.h"

#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_response.h"
#include "../../constraint/locked_view.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <int rows, bool whole, class View>
INGOT_INLINE void warm_start_visit(const View& solver, const Visit& visit, scalar h) {
    RowVisit<rows, whole, View> at(solver, visit.block, lanes_of(visit.lane_bits));
    auto pair = held_pair(solver, at.block, gather_bodies(solver, at.block, &SolverBody::v_CM, &SolverBody::L));
    if constexpr (View::articulates)
        if (is_jointed(solver.jointed, visit.block)) {  // figures get theirs all at once: see pass_contact_impulses
            JointedPairLanes jointed(pair, solver.jointed.blocks[visit.block - solver.jointed.first_block]);
            ContactConstraint<View>::Given::warm_start(at, jointed, h);
            settle_free(jointed, at.inv_M_A, at.inv_M_B);
            return scatter_bodies(solver, at.block, visit.lane_bits, jointed, &SolverBody::v_CM, &SolverBody::L);
        }
    ContactConstraint<View>::Given::warm_start(at, pair, h);
    scatter_bodies(solver, at.block, visit.lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

}  // namespace

template <class View>
void warm_start(const View& solver, const Visit* visits, int visit_count, scalar h) {
    for (int visit_i = 0; visit_i < visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit visit = visits[visit_i];
        const bool whole = is_all(visit.lane_bits);
        constexpr int fewest = fewest_rows<View>, most = View::points_max;
        constexpr bool knows_whole = !View::locks_axes;
        if (has_one_row(solver, solver.blocks[visit.block]))
            whole ? warm_start_visit<fewest, knows_whole>(solver, visit, h) : warm_start_visit<fewest, false>(solver, visit, h);
        else
            whole ? warm_start_visit<most, knows_whole>(solver, visit, h) : warm_start_visit<most, false>(solver, visit, h);
    }
}

// The linker takes the one that the scene calls. Belts have no impulses of their own.
template void warm_start(const JointedView&, const Visit*, int, scalar);
template void warm_start(const LoopedView&, const Visit*, int, scalar);
template void warm_start(const JointedMaterialView&, const Visit*, int, scalar);
template void warm_start(const LoopedMaterialView&, const Visit*, int, scalar);
template void warm_start(const LockedView&, const Visit*, int, scalar);
template void warm_start(const SolverView&, const Visit*, int, scalar);
template void warm_start(const BallView&, const Visit*, int, scalar);
template void warm_start(const RollingView&, const Visit*, int, scalar);
template void warm_start(const RollingBeltView&, const Visit*, int, scalar);

} }  // namespace ingot
