// SPDX-License-Identifier: MIT
// A share of all impulses of an island with joints, found by its energy, in the place of all: for gaining_figures.cpp and pushed_figures.cpp.
#pragma once

#include "../../base/limits.h"
#include "../../constraint/contact.h"
#include "../../figure/joint_drives.h"
#include "../../figure/joint_rows.h"
#include "../../figure/moving_joint.h"
#include "../../figure/three_energies.h"
#include "../../math/sqrt.h"
#include "jointed_visits.h"

/// of(View) for each view of bodies with joints: templates are instantiated for all, and the linker takes the one that the scene calls.
#define INGOT_JOINTED_VIEWS(of)                                                                        \
    of(JointedView); of(JointedMaterialView); of(LoopedView); of(LoopedMaterialView); of(RowedView);   \
    of(RowedMaterialView); of(DrivenView); of(DrivenMaterialView); of(LoopedRowedView); of(LoopedRowedMaterialView)

namespace ingot { inline namespace INGOT_ABI {

/// Marked by beta, the share of their impulses to give next: sweeps to come set it anew. 1: the island keeps what it has.
inline bool is_candidate(const Island& island) { return island.beta != 1; }

/// Whether a surface of a contact moves by itself: contacts of its island may give energy. In scenes that have no belts all speeds are 0.
template <class View>
INGOT_INLINE bool is_on_belt([[maybe_unused]] const View& solver, [[maybe_unused]] int block_i, [[maybe_unused]] int lane_i) {
    if constexpr (View::has_belts)
        return solver.belts[block_i].speed[0][lane_i] != 0 || solver.belts[block_i].speed[1][lane_i] != 0;
    else
        return false;
}

/// Of nothing finite, too.
inline scalar shared_part(scalar j, scalar share) { return share == 0 ? scalar(0) : j * share; }

/// Of what contacts have changed of the motion of a body without joints.
inline void take_share(const SolverView& solver, int body_i, scalar share, scalar h) {
    SolverBody& body = solver.bodies[body_i];
    const SolverBodyHistory& history = solver.histories[body_i];
    for (int i = 0; i < 3; ++i) {
        const scalar v = history.v_begin[i] + history.a[i] * h, L = history.L_begin[i] + history.tau[i] * h;
        body.v_CM[i] = v + shared_part(body.v_CM[i] - v, share);
        body.L[i] = L + shared_part(body.L[i] - L, share);
    }
}

/// Calls each(row, island) for the rows of the joints of candidates.
template <class View, class Rows, class Each>
void for_candidate_rows(const View& solver, const Rows& rows, const Each& each) {
    for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
        Island& island = island_of_node(solver, node_of(rows, rows.list[i]));
        if (is_candidate(island)) each(rows.list[i], island);
    }
}

/// The share, after a half and a half of that, which is all again: drives, too, give what they gave.
inline constexpr scalar all_again = 4;

/// Drives that are rows answer what is left of the other impulses, as those that stand in factors do by themselves. Islands with some are swept.
template <class View, class Rows>
void settle_drives(const View& solver, const Rows& rows) {
    bool some = false;
    for (int sweep_i = 0; sweep_i == 0 || (some && sweep_i < limits::gaining_rounds); ++sweep_i)  // bound: limits::gaining_rounds
        for_candidate_rows(solver, rows, [&](JointRow& row, Island& island) {
            if (!row.is_drive || !(row.K > 0 || row.closes) || island.beta == all_again) return;
            visit_joint_row(solver.jointed.figures, rows, row);
            some = island.sweeps_on = true;
        });
    if (!some) return;
    // From the impulses alone, and of these islands alone: see solve_velocities.
    stand_unless(solver, false, [](const Island& island) { return island.sweeps_on; });
    give_joint_rows(solver.jointed.figures, rows);
    pass_contact_impulses(solver);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sweeps_on = false;  // bound: max_bodies
}

/// Impulses of the candidates become their shares, and all bodies move as these let them.
template <class Whole>
void give_shares(Whole& whole, scalar h) {
    auto& solver = without_rows(whole);
    using View = typename WithoutRows<Whole>::Type;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        if (is_spare(block.manifold[lane_i]) || !is_candidate(solver.islands[block.island[lane_i]])) continue;
        const scalar share = solver.islands[block.island[lane_i]].beta;
        ContactConstraint<View>::Given::for_rows(solver, position / lanes,
                                                 [&](const SeenRow& row) { row.j[lane_i] = shared_part(row.j[lane_i], share); });
    }
    const JointedBodies& jointed = solver.jointed;
    if constexpr (Whole::has_joint_rows) {
        for_candidate_rows(solver, whole.joint_rows, [](JointRow& row, const Island& island) {
            if (!row.is_drive) row.j = shared_part(row.j, island.beta);
            if (row.is_drive && island.beta == all_again && (row.K > 0 || row.closes)) row.j = row.j_sweep;
        });
        give_joint_rows(jointed.figures, whole.joint_rows);
    }
    stand_unless(solver, true, is_candidate);
    pass_contact_impulses(solver);
    if constexpr (Whole::has_drives) settle_drives(solver, whole.joint_rows);
    end_passing(solver);
    end_jointed_sweeps(solver, jointed);
    for_bodies(solver, [&](int body_i) {
        const Island& island = solver.islands[solver.island_of[body_i]];
        if (is_candidate(island) && !jointed.has_joints(static_cast<Index>(body_i))) take_share(solver, body_i, island.beta, h);
    });
}

/// J, of a body with these velocities and this angular momentum.
inline scalar energy_of(const SolverView& solver, const BodyView& bodies, int body_i, const Vector& v, const Vector& L) {
    const Place at = place_of(solver.slot_of[body_i]);
    return (length_sq(v) / solver.bodies[body_i].v_CM[3] + dot(L, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L)) / 2;
}

/// The same if nothing met it in the substep.
inline scalar energy_alone(const SolverView& solver, const BodyView& bodies, int body_i, scalar h) {
    const SolverBodyHistory& history = solver.histories[body_i];
    return energy_of(solver, bodies, body_i, three_of(history.v_begin) + three_of(history.a) * h,
                     three_of(history.L_begin) + three_of(history.tau) * h);
}

/// Where Island::sums has the work of drives, beside energies.
inline constexpr int work_at = 5;
/// From where the work of drives is counted: from what they give with all impulses of contacts, or from nothing, without a solve.
enum class WorkFrom { all, alone };
/// J, of the drives of candidates, by the mean of both rates: what a drive gives is linear in its rate. In sums[work_at] of each.
template <WorkFrom from, class View, class Rows>
void add_work(const View& solver, const Rows& rows, [[maybe_unused]] int i) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sums[work_at] = 0;  // bound: max_bodies
    for_candidate_rows(solver, rows, [&](JointRow& row, Island& island) {
        if (!row.is_drive) return;
        const DriveInSolve drive = drive_in_solve(solver.jointed.figures, rows, row);
        if constexpr (from == WorkFrom::alone) {
            island.sums[work_at] += drive.j * (drive.rate + drive.rate_alone) / 2;
        } else {
            // Conjugate gradients begin anew, if at all.
            scalar &j_of_all = row.j_sweep, &rate_of_all = row.direction;
            if (i == 0) {
                j_of_all = drive.j;
                rate_of_all = drive.rate;
            }
            island.sums[work_at] += (drive.j - j_of_all) * (drive.rate + rate_of_all) / 2;
        }
    });
}

/// J, of the candidates: in sums[i] of each. Without the work of their drives: contacts and ends of joints give none by themselves.
template <WorkFrom from, class Whole>
void add_energies(Whole& whole, const BodyView& bodies, int i) {
    auto& solver = without_rows(whole);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sums[i] = 0;  // bound: max_bodies
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!is_candidate(island)) return;
        const SolverBody& body = solver.bodies[body_i];
        island.sums[i] += energy_of(solver, bodies, body_i, three_of(body.v_CM), three_of(body.L));
    });
    if constexpr (Whole::has_drives) {
        add_work<from>(solver, whole.joint_rows, i);
        for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
            solver.islands[island_i].sums[i] -= solver.islands[island_i].sums[work_at];
    }
}

/// Finds what the candidates have with all of their impulses, a half and a fourth, and gives each the share that share_of(island, energies) says.
template <WorkFrom from, class Whole, class ShareOf>
void give_found_shares(Whole& whole, const BodyView& bodies, scalar h, const ShareOf& share_of) {
    auto& solver = without_rows(whole);
    add_energies<from>(whole, bodies, 0);
    give_shares(whole, h);
    add_energies<from>(whole, bodies, 1);
    give_shares(whole, h);
    add_energies<from>(whole, bodies, 2);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (is_candidate(island)) island.beta = all_again * share_of(island, ThreeEnergies{island.sums[0], island.sums[1], island.sums[2]});
    }
    give_shares(whole, h);
}

} }  // namespace ingot
