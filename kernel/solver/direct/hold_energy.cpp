// SPDX-License-Identifier: MIT
#include "hold_energy.h"

#include "../../base/limits.h"
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <class Direct>
bool some_bounce(const SolverView& solver, const Direct& island) {
    // bound: max_island of HybridIslands: larger islands are swept
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        const ContactBlock& block = solver.blocks[manifold.position / lanes];
        // bound: 4: block_rows
        for (int row = 0; row < manifold.points; ++row)
            if (has(manifold.rows, row) && block.row[row].landing[manifold.position % lanes] < limits::unbounded) return true;
    }
    return false;
}

template <class Direct>
DirectVector free_v(const Direct& island, const DirectBody& body) { return in_double(island.free_motion[body.body_i].v_CM); }
template <class Direct>
DirectVector free_L(const Direct& island, const DirectBody& body) { return in_double(island.free_motion[body.body_i].L); }

/// What belts give: the impulses of friction times the speeds that they aim at. It grows with the impulses, as `along` does.
template <class View, class Direct>
wide_scalar work_of_belts(const View& solver, const Direct& island) {
    wide_scalar work = 0;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        const FrictionRows& friction = solver.blocks[manifold.position / lanes].friction;
        for (int axis = 0; axis < 2; ++axis)
            if (has(manifold.rows, friction_row + axis))
                work += static_cast<wide_scalar>(friction.j[axis][manifold.position % lanes]) *
                        island.rows[manifold_i * Direct::row_count + friction_row + axis].target;
    }
    return work;
}

/// What kinematic bodies give: the impulses of rows times how fast these bodies go along them.
template <class View, class Direct>
wide_scalar work_of_kinematic(const View& solver, const Direct& island) {
    wide_scalar work = 0;
    for_kinematic(solver, island, [&](const ManifoldOf<Direct>& manifold, const DirectBody&, const SolverBody& moving) {
        const DirectRow* const rows = island.rows + (&manifold - island.manifolds) * Direct::row_count;
        const DirectVector u = in_double(moving.v_CM), omega = in_double(moving.L);
        for_impulses(solver, manifold, [&](int row, scalar& j, scalar&) {
            work += static_cast<wide_scalar>(j) * (dot(rows[row].d, u) - dot(rows[row].k[1], omega));
        });
    });
    return work;
}

}  // namespace

template <class View, class Direct>
void hold_energy(const View& solver, const Direct& island) {
    // The energy of the free motion and `share` of the change is E + share along + share^2 across.
    wide_scalar along = 0, across = 0;
    // bound: max_island + 2: manifolds join at most one body more than they are; and what cannot move
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        const SolverBody& now = solver.bodies[body.body_i];
        const DirectVector v = free_v(island, body), L = free_L(island, body), d_v = in_double(now.v_CM) - v, d_L = in_double(now.L) - L;
        const DirectVector turn = body.spin_of(d_L);
        along += dot(d_v, v) / body.inv_M + dot(turn, L);
        across += 0.5 * (length_sq(d_v) / body.inv_M + dot(turn, d_L));
    }
    if constexpr (View::has_belts) along -= work_of_belts(solver, island);
    if constexpr (sees_kinematic<View>) along -= work_of_kinematic(solver, island);
    if (!(along + across > 0) || some_bounce(solver, island)) return;

    const wide_scalar share = along < 0 ? -along / (2 * across) : 0;
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        SolverBody& now = solver.bodies[body.body_i];
        const DirectVector v = free_v(island, body), L = free_L(island, body);
        put_scalars(now.v_CM, v + (in_double(now.v_CM) - v) * share);
        put_scalars(now.L, L + (in_double(now.L) - L) * share);
    }
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i)
        for_impulses(solver, island.manifolds[manifold_i], [&](int, scalar& j, scalar& j_sweep) {
            j = j_sweep = static_cast<scalar>(static_cast<wide_scalar>(j) * share);
        });
}

// The linker takes the one that the scene calls.
template void hold_energy(const SolverView&, const DirectView&);
template void hold_energy(const RollingView&, const RollingDirectView&);
template void hold_energy(const BeltView&, const DirectView&);
template void hold_energy(const RollingBeltView&, const RollingDirectView&);
template void hold_energy(const KinematicViewOf<SolverView>&, const DirectView&);
template void hold_energy(const KinematicViewOf<RollingView>&, const RollingDirectView&);
template void hold_energy(const KinematicViewOf<BeltView>&, const DirectView&);
template void hold_energy(const KinematicViewOf<RollingBeltView>&, const RollingDirectView&);

} }  // namespace ingot
