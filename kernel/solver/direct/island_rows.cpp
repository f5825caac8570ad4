// SPDX-License-Identifier: MIT
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Whether impulses of one row are lost in those of another: see limits::direct_steepness.
template <class Direct>
bool is_steep(const Direct& direct) {
    wide_scalar mass = 0, lightest = 0;  // kg, 1/kg
    for (int body_i = 1; body_i < direct.body_count; ++body_i) {  // bound: max_island + 2: manifolds join at most one body more than they are
        mass += 1 / direct.bodies[body_i].inv_M;
        lightest = max(lightest, direct.bodies[body_i].inv_M);
    }
    return mass * lightest > limits::direct_steepness;
}

template <class Direct>
void take_in(const SolverView& solver, const BodyView& bodies, Direct& direct, Index body_i) {
    if (body_i == 0) return;
    const int known = direct.local[body_i];
    if (known != 0 && known < direct.body_count && direct.bodies[known].body_i == body_i) return;
    const Place at = place_of(solver.slot_of[body_i]);
    const SymmetricMatrix inv_I = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
    direct.local[body_i] = static_cast<Index>(direct.body_count);
    DirectBody& body = direct.bodies[direct.body_count++];
    body.inv_M = static_cast<wide_scalar>(solver.bodies[body_i].v_CM[3]);
    body.inv_I_world = {static_cast<wide_scalar>(inv_I.xx), static_cast<wide_scalar>(inv_I.yy), static_cast<wide_scalar>(inv_I.zz),
                        static_cast<wide_scalar>(inv_I.xy), static_cast<wide_scalar>(inv_I.xz), static_cast<wide_scalar>(inv_I.yz)};
    body.r_CM = in_double(lane_of(bodies.translation[at.tile].r_CM, at.lane));
    body.body_i = body_i;
}

template <class Direct>
void load_row(const Direct& direct, const ManifoldOf<Direct>& manifold, DirectRow& row, const DirectVector& d,
              const DirectVector& J_A, const DirectVector& J_B) {
    const DirectBody &A = direct.bodies[manifold.body[0]], &B = direct.bodies[manifold.body[1]];
    row.d = d;
    row.J[0] = J_A;
    row.J[1] = J_B;
    row.k[0] = A.spin_of(J_A);
    row.k[1] = B.spin_of(J_B);
    row.K = length_sq(d) * (A.inv_M + B.inv_M) + dot(row.k[0], J_A) + dot(row.k[1], J_B);
}

DirectVector lane_in_double(const LaneRow (&rows)[3], int lane_i) { return in_double(lane_of(rows, lane_i)); }

/// Puts a row that the block shows among the manifold's. Levers of normals are found anew from the points, in double: four points of one plane have
/// three independent normals, and rounding of the block's floats would make a fourth.
template <class Direct>
void load_seen_row(Direct& direct, ManifoldOf<Direct>& manifold, DirectRow* rows, const SeenRow& seen, const ManifoldRecord* record) {
    const int lane_i = manifold.position % lanes;
    const DirectVector none = {}, d = lane_in_double(seen.d, lane_i);
    const bool moves[2] = {manifold.body[0] != 0, manifold.body[1] != 0};
    DirectRow& row = rows[seen.number];
    if (seen.number < friction_row && record != nullptr) {
        const DirectVector P = in_double(record->manifold.points[seen.number].P);
        load_row(direct, manifold, row, d, moves[0] ? direct.bodies[manifold.body[0]].lever_of(P, d) : none,
                 moves[1] ? direct.bodies[manifold.body[1]].opposite_lever_of(P, d) : none);
    } else if (seen.levers != nullptr) {
        load_row(direct, manifold, row, d, lane_in_double(seen.levers->J_A, lane_i), lane_in_double(seen.levers->J_B, lane_i));
    } else {
        load_row(direct, manifold, row, none, moves[0] ? d : none, moves[1] ? -d : none);
        if (!(row.K > 0)) return;
    }
    row.target = 0;
    manifold.rows = static_cast<typename Direct::Manifold::RowBits>(manifold.rows | 1u << seen.number);
}

/// Which rows of a block a manifold has.
template <class Direct>
bool has_row(const ContactBlock& block, const ManifoldOf<Direct>& manifold, int number) {
    if (number < friction_row) return static_cast<scalar>(number) < block.count[manifold.position % lanes];
    if (number >= rolling_row) return manifold.bound_of(1) > 0;
    return manifold.mu > 0 && (number < torsion_row || manifold.radius > 0);
}

template <class View, class Direct>
void load_manifold(const View& solver, Direct& direct, ManifoldOf<Direct>& manifold, DirectRow* rows) {
    const int lane_i = manifold.position % lanes, block_i = manifold.position / lanes;
    const ContactBlock& block = solver.blocks[block_i];
    const ManifoldRecord& record = solver.records[solver.pairs[block.manifold[lane_i]].record];
    // Rows that are of another moment than the record: of what turns far, and of balls that meet.
    const Vector turned = Vector{block.n[0][lane_i], block.n[1][lane_i], block.n[2][lane_i]} - record.manifold.n;
    const bool is_area = record.manifold.count > 1, moved = (block.moving >> lane_i & 1u) != 0 || length_sq(turned) > 0;
    manifold.mu = static_cast<wide_scalar>(block.mu[lane_i]);
    manifold.radius = is_area ? static_cast<wide_scalar>(block.torsion.radius[lane_i]) : 0;  // of one point: rounding
    manifold.points = static_cast<uint8_t>(is_area ? block_rows : 1);                        // whatever it shares its block with
    manifold.rows = 0;
    if constexpr (View::rolls) manifold.lever = static_cast<wide_scalar>(solver.rolling[block_i].lever[lane_i]);
    ContactConstraint<View>::Given::for_rows(solver, block_i, [&](const SeenRow& seen) {
        if (has_row<Direct>(block, manifold, seen.number)) load_seen_row(direct, manifold, rows, seen, moved ? nullptr : &record);
    });
    for (int axis = 0; axis < 2; ++axis) {
        if (!has(manifold.rows, friction_row + axis)) continue;
        wide_scalar& target = rows[friction_row + axis].target;
        target -= static_cast<wide_scalar>(block.friction.shift[axis][lane_i]);
        if constexpr (View::has_belts) target -= static_cast<wide_scalar>(solver.belts[block_i].speed[axis][lane_i]);
    }
}

/// Puts the body that stands for a kinematic one into a manifold that was loaded as one with what cannot move. It is B from now on: rows are the same
/// with A and B in each other's place and d turned round. J = 0 and k = -J of the partner: see constraint/kinematic_view.h.
template <class Direct>
void load_kinematic(const SolverView& solver, Direct& direct, ManifoldOf<Direct>& manifold, DirectRow* rows, Index body_i, int& end) {
    const bool is_A = manifold.body[0] == 0;
    if (is_A) manifold.body[0] = manifold.body[1];
    manifold.body[1] = static_cast<Index>(--end);
    DirectBody& body = direct.bodies[end];
    body = {};
    body.body_i = body_i;
    body.linear = in_double(solver.bodies[body_i].v_CM);
    body.angular = in_double(solver.bodies[body_i].L);
    // bound: direct_rows_of: nine, with rolling
    for (int row = 0; row < Direct::row_count; ++row) {
        if (!has(manifold.rows, row)) continue;
        DirectRow& at = rows[row];
        if (is_A) {
            at.d = -at.d;
            at.J[0] = at.J[1];
            at.k[0] = at.k[1];
        }
        at.J[1] = {};
        at.k[1] = -at.J[0];
    }
}

}  // namespace

template <class View, class Direct>
void load_rows(const View& solver, const BodyView& bodies, Direct& direct, int island_i) {
    const Island& island = solver.islands[island_i];
    direct.loaded_island = island_i;
    direct.factored = false;
    direct.uneven = island.carries;
    direct.manifold_count = island.member_count;
    direct.body_count = 1;
    direct.bodies[0] = {};
    direct.local[0] = 0;
    [[maybe_unused]] int end = direct.manifold_capacity + 2;  // there is room: each manifold joins a body more, or has a kinematic one
    for (int manifold_i = 0; manifold_i < direct.manifold_count; ++manifold_i) {  // bound: max_manifolds
        ManifoldOf<Direct>& manifold = direct.manifolds[manifold_i];
        manifold.position = solver.members[island.member_begin + manifold_i];
        const ContactBlock& block = solver.blocks[manifold.position / lanes];
        Index body_A = block.body_A[manifold.position % lanes], body_B = block.body_B[manifold.position % lanes];
        [[maybe_unused]] Index kinematic_i = 0;
        if constexpr (sees_kinematic<View>) {
            Index* const of_pair[2] = {&body_A, &body_B};
            for (Index* const body : of_pair) {
                if (*body < solver.kinematic.body_begin) continue;
                kinematic_i = *body;
                *body = 0;
            }
        }
        take_in(solver, bodies, direct, body_A);
        take_in(solver, bodies, direct, body_B);
        manifold.body[0] = direct.local[body_A];
        manifold.body[1] = direct.local[body_B];
        manifold.active = 0;
        direct.uneven = direct.uneven || are_uneven(solver, body_A, body_B);
        load_manifold(solver, direct, manifold, direct.rows + manifold_i * Direct::row_count);
        if constexpr (sees_kinematic<View>)
            if (kinematic_i != 0) load_kinematic(solver, direct, manifold, direct.rows + manifold_i * Direct::row_count, kinematic_i, end);

        manifold.first = static_cast<Index>(manifold_i);
        for (int before = 0; before < manifold_i; ++before) {  // bound: max_island: manifolds of an island before one
            const ManifoldOf<Direct>& other = direct.manifolds[before];
            bool shared = false;
            for (const Index mine : manifold.body)
                for (const Index theirs : other.body) shared = shared || (mine != 0 && mine == theirs);
            if (!shared) continue;
            manifold.first = static_cast<Index>(before);
            break;
        }
    }
    direct.steep = is_steep(direct);
}

// The linker takes the one that the scene calls.
template void load_rows(const SolverView&, const BodyView&, DirectView&, int);
template void load_rows(const RollingView&, const BodyView&, RollingDirectView&, int);
template void load_rows(const BeltView&, const BodyView&, DirectView&, int);
template void load_rows(const RollingBeltView&, const BodyView&, RollingDirectView&, int);
template void load_rows(const KinematicViewOf<SolverView>&, const BodyView&, DirectView&, int);
template void load_rows(const KinematicViewOf<RollingView>&, const BodyView&, RollingDirectView&, int);
template void load_rows(const KinematicViewOf<BeltView>&, const BodyView&, DirectView&, int);
template void load_rows(const KinematicViewOf<RollingBeltView>&, const BodyView&, RollingDirectView&, int);

} }  // namespace ingot
