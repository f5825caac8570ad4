// SPDX-License-Identifier: MIT
#include "turning_bodies.h"

#include "../../base/limits.h"
#include "../../body/axis_locks.h"
#include "../../body/turning_laws.h"
#include "../../constraint/locked_view.h"
#include "../../constraint/turning_body.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Place place_in_tiles(const SolverView& solver, int body_i) { return place_of(solver.slot_of[body_i]); }
Vector inverse_moments(const BodyView& bodies, const Place& at) {
    const RotationTile& tile = bodies.rotation[at.tile];
    return lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane];
}

/// What turns a solver body.
FreeInertia inertia_of(const SolverView& solver, const BodyView& bodies, int body_i) {
    return {inverse_moments(bodies, place_in_tiles(solver, body_i))};
}
LockedInertia inertia_of(const LockedView& solver, const BodyView& bodies, int body_i) {
    return locked_inertia_of(bodies, solver.slot_of[body_i], solver.locks[solver.slot_of[body_i]]);
}

/// A after what pushed the body: they turn it, and leave it its energy.
template <class Inertia>
Matrix pushed(const Matrix& A, const Vector& push, const Inertia& inertia, const Vector& L) {
    if (!(length_sq(push) > 0)) return A;
    return turning::return_energy(inertia, turned_about(A, push), L, dot(L, inertia.spin(A, L)));
}

}  // namespace

bool turns_so_far(const SolverView& solver, const BodyView& bodies, int body_i, const Vector& turn) {
    const SolverBody& body = solver.bodies[body_i];
    const Place at = place_in_tiles(solver, body_i);
    const Vector L = three_of(body.L);
    // Of bodies about to rest the energy does not matter, and where they are does.
    const scalar least = limits::turning_speed * solver.unit;
    return turns_inertia(lane_of(bodies.rotation[at.tile].inv_I_ratio, at.lane), turn) &&
           dot(L, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L) * body.v_CM[3] > least * least;
}

template <class View>
void begin_turning(View& solver, const BodyView& bodies, int body_i) {
    SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_in_tiles(solver, body_i);
    const Vector L = three_of(body.L), turned = three_of(body.dth);
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    const scalar twice_energy = dot(L, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L);
    const auto turned_on = [&] { return turning::return_energy(inertia_of(solver, bodies, body_i), turned_about(A, turned), L, twice_energy); };
    set_attitude(history, length_sq(turned) > 0 ? turned_on() : A);
    set_three(history.turn, turned);
    body.dth[3] = turns_far;
    solver.some_turn = true;
}

template <class View>
void find_turning_bodies(View& solver, const BodyView& bodies, scalar h) {
    const scalar least = limits::turning_speed * solver.unit;
    for_bodies(solver, [&](int body_i) {
        const SolverBody& body = solver.bodies[body_i];
        if (body.dth[3] != turns_little) return;
        const Place at = place_in_tiles(solver, body_i);
        const Vector L = three_of(body.L);
        // No ratio is beyond 1: its energy is no more than this.
        if (length_sq(L) * bodies.rotation[at.tile].inv_I_scale[at.lane] * body.v_CM[3] <= least * least) return;
        if (turns_so_far(solver, bodies, body_i, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L * h))
            begin_turning(solver, bodies, body_i);
    });
}

template <class View>
void turn_half_way(const View& solver, const BodyView& bodies, scalar h) {
    for_bodies(solver, [&](int body_i) {
        SolverBody& body = solver.bodies[body_i];
        if (!(body.dth[3] > turns_little)) return;
        SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_in_tiles(solver, body_i);
        const auto inertia = inertia_of(solver, bodies, body_i);
        const Vector L = three_of(body.L);
        Matrix A = pushed(attitude_of(history), turned_by_pushes(body, history), inertia, L);
        if (body.dth[3] == turns_far) (void)turning::turn_freely(inertia, A, L, h / 2);
        set_attitude(history, A);
        if (takes_contacts_along(solver)) set_three(body.dth, {});
        set_three(history.turn, three_of(body.dth));
        set_lane(bodies.translation[at.tile].inv_I_world, at.lane, inertia.inverse_world(A));
    });
}

template <class View>
Vector turn_on(const View& solver, const BodyView& bodies, int body_i, bool hit, scalar h) {
    SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_in_tiles(solver, body_i);
    const auto inertia = inertia_of(solver, bodies, body_i);
    const Vector L = three_of(body.L);
    Matrix A = attitude_of(history);
    Vector turn;
    if (body.dth[3] == turns_into_impact) {
        turn = turning::turn_freely(inertia, A, L, h);
    } else {
        const SymmetricMatrix inv_I_world = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
        const Vector first = inv_I_world * three_of(history.L_begin) * (h / 2), rest = inv_I_world * L * (h / 2);
        turn = first + turning::turn_freely(inertia, A, L, h / 2);
        // A hit that nobody foresaw: targets are for a body that goes all of the substep by its new motion.
        if (hit) {
            A = pushed(A, rest - first, inertia, L);
            turn += rest - first;
        }
    }
    body.dth[3] = turns_far;
    set_attitude(history, A);
    set_three(history.turn, three_of(history.turn) + turn);
    return turn;
}

template <class View>
Matrix attitude_at_end(const View& solver, const BodyView& bodies, int body_i) {
    const SolverBodyHistory& history = solver.histories[body_i];
    const SolverBody& body = solver.bodies[body_i];
    return pushed(attitude_of(history), turned_by_pushes(body, history), inertia_of(solver, bodies, body_i), three_of(body.L));
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                     \
    template void begin_turning(View&, const BodyView&, int);                                \
    template void find_turning_bodies(View&, const BodyView&, scalar);                       \
    template void turn_half_way(const View&, const BodyView&, scalar);                       \
    template Vector turn_on(const View&, const BodyView&, int, bool, scalar);                \
    template Matrix attitude_at_end(const View&, const BodyView&, int)
INGOT_VIEW(SolverView);
INGOT_VIEW(LockedView);
#undef INGOT_VIEW

} }  // namespace ingot
