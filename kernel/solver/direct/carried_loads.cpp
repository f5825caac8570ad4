// SPDX-License-Identifier: MIT
#include "carried_loads.h"

#include "../../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// What SolverBodyHistory::P_v is for here.
enum : int {
    push_on_others,  ///< m s^-2, of all contacts
    carried,          ///< kg, with its own mass
    carried_found,    ///< kg, by the pass at hand
};

scalar* of(const SolverView& solver, int body_i) { return solver.histories[body_i].P_v; }
scalar mass_of(const SolverView& solver, int body_i) { return 1 / solver.bodies[body_i].v_CM[3]; }

/// Marks islands that are to be looked at by sweeps_on; false: there is none.
bool find_heavy_islands(const SolverView& solver, int manifold_capacity) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        Island& island = solver.islands[solver.island_of[body_i]];
        const scalar inv_M = solver.bodies[body_i].v_CM[3];
        island.size += 1 / inv_M;
        island.size_before = inv_M > island.size_before ? inv_M : island.size_before;
    }
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.sweeps_on = island.size * island.size_before > limits::direct_mass_ratio && island.manifold_count <= manifold_capacity;
        some = some || island.sweeps_on;
    }
    return some;
}

/// Calls each(holder, held, push) for contacts of the islands that are looked at, and both ways round; a holder of 0 cannot move. push: m s^-2.
template <class Each>
void for_pushes(const SolverView& solver, const Each& each) {
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const Index island_i = solver.island_at[manifold_i];
        if (island_i == no_island || !solver.islands[island_i].sweeps_on) continue;
        const BodyPair& pair = solver.pairs[manifold_i];
        const Vector& n = solver.records[pair.record].manifold.n;  // from B to A
        const int A = solver.local_of[pair.body_A], B = solver.local_of[pair.body_B];
        const auto along_n = [&](int body_i) {
            const scalar* const a = solver.histories[body_i].a;
            return a[0] * n.x + a[1] * n.y + a[2] * n.z;
        };
        if (A != 0 && along_n(A) < 0) each(B, A, -along_n(A));
        if (B != 0 && along_n(B) > 0) each(A, B, along_n(B));
    }
}

/// Hands loads on by one contact. After as many passes as the longest way to the ground has contacts, nothing changes any more.
void hand_on(const SolverView& solver) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) of(solver, body_i)[carried_found] = mass_of(solver, body_i);  // bound: max_bodies + 1
    for_pushes(solver, [&](int holder, int held, scalar push) {
        if (holder != 0) of(solver, holder)[carried_found] += of(solver, held)[carried] * (push / of(solver, held)[push_on_others]);
    });
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].at_bound = true;  // bound: max_bodies
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!island.sweeps_on) continue;
        scalar* const body = of(solver, body_i);
        const scalar M = mass_of(solver, body_i);
        if (body[carried_found] - M > limits::direct_mass_ratio * M) island.carries = true;
        if (body[carried_found] != body[carried]) island.at_bound = false;
        body[carried] = body[carried_found];
    }
}

}  // namespace

void mark_carrying(const SolverView& solver, int manifold_capacity) {
    bool some = find_heavy_islands(solver, manifold_capacity);
    if (!some) return;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) of(solver, body_i)[carried] = mass_of(solver, body_i);  // bound: max_bodies + 1
    for_pushes(solver, [&](int, int held, scalar push) { of(solver, held)[push_on_others] += push; });
    for (int pass_i = 1; some; ++pass_i) {  // bound: max_island of HybridIslands: no island goes on after as many passes as it has manifolds
        hand_on(solver);
        some = false;
        for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
            Island& island = solver.islands[island_i];
            island.sweeps_on = island.sweeps_on && !island.carries && !island.at_bound && pass_i < island.manifold_count;
            some = some || island.sweeps_on;
        }
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i)
        for (int i = 0; i < 3; ++i) of(solver, body_i)[i] = 0;
}

} }  // namespace ingot
