// SPDX-License-Identifier: MIT
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void take_in(const SolverView& solver, const BodyView& bodies, DirectView& direct, uint16_t body_i) {
    if (body_i == 0) return;
    const int known = direct.local[body_i];
    if (known != 0 && known < direct.body_count && direct.bodies[known].body_i == body_i) return;
    const Place at = place_of(solver.slot_of[body_i]);
    const SymmetricMatrix inv_I = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
    direct.local[body_i] = static_cast<uint16_t>(direct.body_count);
    DirectBody& body = direct.bodies[direct.body_count++];
    body.inv_M = static_cast<wide_scalar>(solver.bodies[body_i].v_CM[3]);
    body.inv_I_world = {static_cast<wide_scalar>(inv_I.xx), static_cast<wide_scalar>(inv_I.yy), static_cast<wide_scalar>(inv_I.zz),
                        static_cast<wide_scalar>(inv_I.xy), static_cast<wide_scalar>(inv_I.xz), static_cast<wide_scalar>(inv_I.yz)};
    body.r_CM = in_double(lane_of(bodies.translation[at.tile].r_CM, at.lane));
    body.body_i = body_i;
}

void load_row(const DirectView& direct, const DirectManifold& manifold, DirectRow& row, const DirectVector& d,
              const DirectVector& J_A, const DirectVector& J_B) {
    const DirectBody &A = direct.bodies[manifold.body[0]], &B = direct.bodies[manifold.body[1]];
    row.d = d;
    row.J[0] = J_A;
    row.J[1] = J_B;
    row.k[0] = A.inv_I_world * J_A;
    row.k[1] = B.inv_I_world * J_B;
    row.K = length_sq(d) * (A.inv_M + B.inv_M) + dot(row.k[0], J_A) + dot(row.k[1], J_B);
}

DirectVector lane_in_double(const scalar (&rows)[3][lanes], int lane_i) { return in_double(lane_of(rows, lane_i)); }

/// Levers of the normals anew, from the points: four points of one plane have three normals that are independent, to the
/// rounding of doubles; the floats of the block would make a fourth of their own rounding.
void load_manifold(const SolverView& solver, DirectView& direct, DirectManifold& manifold, DirectRow* rows) {
    const int lane_i = manifold.position % lanes;
    const ContactBlock& block = solver.blocks[manifold.position / lanes];
    const DirectVector n = lane_in_double(block.n, lane_i), t_1 = lane_in_double(block.t_1, lane_i),
                       t_2 = lane_in_double(block.t_2, lane_i);
    const ManifoldRecord& record = solver.records[solver.pairs[block.manifold[lane_i]].record];
    manifold.mu = static_cast<wide_scalar>(block.mu[lane_i]);
    manifold.radius =
        record.manifold.count > 1 ? static_cast<wide_scalar>(block.torsion.radius[lane_i]) : 0;  // of one point: rounding
    manifold.points = static_cast<uint8_t>(record.manifold.count > 1 ? block_rows : 1);   // whatever it shares its block with
    manifold.rows = 0;
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        if (!(static_cast<scalar>(row) < block.count[lane_i])) continue;
        const DirectVector P = in_double(record.manifold.points[row].P), none = {};
        load_row(direct, manifold, rows[row], n,
                 manifold.body[0] != 0 ? cross(P - direct.bodies[manifold.body[0]].r_CM, n) : none,
                 manifold.body[1] != 0 ? cross(n, P - direct.bodies[manifold.body[1]].r_CM) : none);
        manifold.rows = static_cast<uint8_t>(manifold.rows | 1u << row);
    }
    if (!(manifold.mu > 0)) return;
    const Levers *along_1 = &block.friction.levers[0], *along_2 = &block.friction.levers[1];
    load_row(direct, manifold, rows[friction_row], t_1, lane_in_double(along_1->J_A, lane_i),
             lane_in_double(along_1->J_B, lane_i));
    load_row(direct, manifold, rows[friction_row + 1], t_2, lane_in_double(along_2->J_A, lane_i),
             lane_in_double(along_2->J_B, lane_i));
    manifold.rows = static_cast<uint8_t>(manifold.rows | 3u << friction_row);
    if (!(manifold.radius > 0)) return;
    const DirectVector none = {};
    load_row(direct, manifold, rows[torsion_row], none, manifold.body[0] != 0 ? n : none, manifold.body[1] != 0 ? -n : none);
    if (rows[torsion_row].K > 0) manifold.rows = static_cast<uint8_t>(manifold.rows | 1u << torsion_row);
}

}  // namespace

void load_rows(const SolverView& solver, const BodyView& bodies, DirectView& direct, int island_i) {
    const Island& island = solver.islands[island_i];
    direct.loaded_island = island_i;
    direct.factored = false;
    direct.uneven = false;
    direct.manifold_count = island.member_count;
    direct.body_count = 1;
    direct.bodies[0] = {};
    direct.local[0] = 0;
    for (int manifold_i = 0; manifold_i < direct.manifold_count; ++manifold_i) {  // bound: max_manifolds
        DirectManifold& manifold = direct.manifolds[manifold_i];
        manifold.position = solver.members[island.member_begin + manifold_i];
        const ContactBlock& block = solver.blocks[manifold.position / lanes];
        const uint16_t body_A = block.body_A[manifold.position % lanes], body_B = block.body_B[manifold.position % lanes];
        take_in(solver, bodies, direct, body_A);
        take_in(solver, bodies, direct, body_B);
        manifold.body[0] = direct.local[body_A];
        manifold.body[1] = direct.local[body_B];
        manifold.active = 0;
        direct.uneven = direct.uneven || are_uneven(solver, body_A, body_B);
        load_manifold(solver, direct, manifold, direct.rows + manifold_i * direct_rows);

        manifold.first = static_cast<uint16_t>(manifold_i);
        for (int before = 0; before < manifold_i; ++before) {  // bound: max_island: manifolds of an island before one
            const DirectManifold& other = direct.manifolds[before];
            bool shared = false;
            for (const uint16_t mine : manifold.body)
                for (const uint16_t theirs : other.body) shared = shared || (mine != 0 && mine == theirs);
            if (!shared) continue;
            manifold.first = static_cast<uint16_t>(before);
            break;
        }
    }
}

} }  // namespace ingot
