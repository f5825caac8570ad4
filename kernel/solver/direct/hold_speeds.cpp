// SPDX-License-Identifier: MIT
#include "hold_speeds.h"

#include "../../base/limits.h"
#include "sliding.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// m/s; of the centre of mass, and of a spin with as much energy.
wide_scalar speed_of(const DirectBody& body, const DirectVector& v, const DirectVector& L) {
    return square_root(length_sq(v)) + square_root(max(body.turning_compliance(L) * body.inv_M, 0));
}

template <class Direct>
wide_scalar speed_without_contacts(const Direct& island, const DirectBody& body) {
    const FreeMotion& free = island.free_motion[body.body_i];
    return speed_of(body, in_double(free.v_CM), in_double(free.L));
}

/// The fastest of heavy bodies, kinematic ones among them.
template <class View, class Direct>
wide_scalar fastest_without_contacts(const View& solver, const Direct& island) {
    wide_scalar fastest = 0, heaviest = 0;  // m/s, kg
    // bound: max_island + 2: manifolds join at most one body more than they are
    for (int body_i = 1; body_i < island.body_count; ++body_i) heaviest = max(heaviest, 1 / island.bodies[body_i].inv_M);
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        if (heaviest * body.inv_M <= static_cast<wide_scalar>(limits::heavy_ratio)) fastest = max(fastest, speed_without_contacts(island, body));
    }
    if constexpr (sees_kinematic<View>)
        for_kinematic(solver, island, [&](const auto&, const DirectBody&, const SolverBody& moving) {
            fastest = max(fastest, square_root(length_sq(in_double(moving.v_CM))));
        });
    return fastest;
}

}  // namespace

template <class View, class Direct>
void hold_speeds(const View& solver, const Direct& island) {
    if (!island.steep) return;
    const wide_scalar fastest = fastest_without_contacts(solver, island);
    bool some = false;
    for (int body_i = 1; body_i < island.body_count; ++body_i) {
        const DirectBody& body = island.bodies[body_i];
        SolverBody& now = solver.bodies[body.body_i];
        const DirectVector v = in_double(now.v_CM), L = in_double(now.L);
        const wide_scalar speed = speed_of(body, v, L), most = max(fastest, speed_without_contacts(island, body));
        if (speed <= most) continue;
        some = true;
        put_scalars(now.v_CM, v * (most / speed));
        put_scalars(now.L, L * (most / speed));
    }
    if (!some) return;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i)  // bound: max_island of HybridIslands: larger islands are swept
        for_impulses(solver, island.manifolds[manifold_i], [](int, scalar& j, scalar& j_sweep) { j = j_sweep = 0; });
}

// The linker takes the one that the scene calls. Belts give speed.
template void hold_speeds(const SolverView&, const DirectView&);
template void hold_speeds(const RollingView&, const RollingDirectView&);
template void hold_speeds(const KinematicViewOf<SolverView>&, const DirectView&);
template void hold_speeds(const KinematicViewOf<RollingView>&, const RollingDirectView&);

} }  // namespace ingot
