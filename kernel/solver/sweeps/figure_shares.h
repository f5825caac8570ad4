// SPDX-License-Identifier: MIT
// A share of all impulses of an island with joints, found by its energy, in the place of all: for gaining_figures.cpp and pushed_figures.cpp.
#pragma once

#include "../../base/limits.h"
#include "../../constraint/contact.h"
#include "../../figure/joint_rows.h"
#include "../../figure/moving_joint.h"
#include "../../math/sqrt.h"
#include "jointed_visits.h"

namespace ingot { inline namespace INGOT_ABI {

/// Marked by beta, the share of their impulses to give next: sweeps to come set it anew. 1: the island keeps what it has.
inline bool is_candidate(const Island& island) { return island.beta != 1; }

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

/// Impulses of the candidates become their shares, and all bodies move as these let them.
template <class Whole>
void give_shares(Whole& whole, scalar h) {
    auto& solver = without_rows(whole);
    using View = typename WithoutRows<Whole>::Type;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        if (block.manifold[lane_i] == no_manifold || !is_candidate(solver.islands[block.island[lane_i]])) continue;
        const scalar share = solver.islands[block.island[lane_i]].beta;
        ContactConstraint<View>::Given::for_rows(solver, position / lanes,
                                                 [&](const SeenRow& row) { row.j[lane_i] = shared_part(row.j[lane_i], share); });
    }
    const JointedBodies& jointed = solver.jointed;
    if constexpr (Whole::has_joint_rows) {
        const auto& rows = whole.joint_rows;
        for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
            const Index body_i = solver.local_of[jointed.figures.nodes[node_of(rows, rows.list[i])].slot];
            if (body_i != 0 && is_candidate(solver.islands[solver.island_of[body_i]])) {
                JointRow& row = rows.list[i];
                row.j = shared_part(row.j, solver.islands[solver.island_of[body_i]].beta);
            }
        }
        give_joint_rows(jointed.figures, rows);
    }
    stand_unless(solver, true, is_candidate);
    pass_contact_impulses(solver);
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

/// J, of the candidates: in sums[i] of each.
inline void add_energies(const SolverView& solver, const BodyView& bodies, int i) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sums[i] = 0;  // bound: max_bodies
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!is_candidate(island)) return;
        const SolverBody& body = solver.bodies[body_i];
        island.sums[i] += energy_of(solver, bodies, body_i, three_of(body.v_CM), three_of(body.L));
    });
}

/// What an island has with all of its impulses, a half and a fourth of them.
struct ThreeEnergies {
    scalar all, half, fourth;

    scalar Q() const { return ((all - half) - 2 * (half - fourth)) * (scalar(8) / 3); }
    scalar D() const { return 2 * (all - half) - Q() * scalar(1.5); }
    /// The share to take. 1: as it is.
    scalar share() const {
        if (!is_finite(all)) return 0;
        const scalar d = D(), q = Q(), without = all - d - q;
        if (!(all > without * (1 + limits::figure_gain_allowed)) || !(q > 0)) return 1;
        return d < 0 ? min(-d / (2 * q), scalar(1)) : scalar(0);
    }
    /// The largest with which it has no more than that, J, or than it has without.
    scalar share_up_to(scalar most) const {
        if (!is_finite(all)) return 0;
        const scalar d = D(), q = Q(), gain = max(most - (all - d - q), 0);
        if (!(d + q > gain) || !(q > 0)) return 1;
        return min((sqrt(max(d * d + 4 * q * gain, 0)) - d) / (2 * q), scalar(1));
    }
};

/// Finds what the candidates have with all of their impulses, a half and a fourth, and gives each the share that share_of(island, energies) says.
template <class Whole, class ShareOf>
void give_found_shares(Whole& whole, const BodyView& bodies, scalar h, const ShareOf& share_of) {
    auto& solver = without_rows(whole);
    add_energies(solver, bodies, 0);
    give_shares(whole, h);
    add_energies(solver, bodies, 1);
    give_shares(whole, h);
    add_energies(solver, bodies, 2);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (is_candidate(island)) island.beta = 4 * share_of(island, ThreeEnergies{island.sums[0], island.sums[1], island.sums[2]});
    }
    give_shares(whole, h);
}

} }  // namespace ingot
