// SPDX-License-Identifier: MIT
#include "turning_bodies.h"

#include "../../base/limits.h"
#include "../../body/kinematics.h"
#include "../../body/turning_inertia.h"
#include "../../constraint/turning_body.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Place place_in_tiles(const SolverView& solver, int body_i) { return place_of(solver.slot_of[body_i]); }
Vector inverse_moments(const BodyView& bodies, const Place& at) {
    const RotationTile& tile = bodies.rotation[at.tile];
    return lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane];
}

/// A after what pushed the body: they turn it, and leave it its energy.
Matrix pushed(const Matrix& A, const Vector& push, const Vector& inv_I_body, const Vector& L) {
    if (!(length_sq(push) > 0)) return A;
    return return_energy(turned_about(A, push), inv_I_body, L, dot(L, spin_of(A, inv_I_body, L)));
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

void begin_turning(SolverView& solver, const BodyView& bodies, int body_i) {
    SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_in_tiles(solver, body_i);
    const Vector L = three_of(body.L), turned = three_of(body.dth);
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    const scalar twice_energy = dot(L, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L);
    set_attitude(history, length_sq(turned) > 0 ? return_energy(turned_about(A, turned), inverse_moments(bodies, at), L, twice_energy) : A);
    set_three(history.turn, turned);
    body.dth[3] = turns_far;
    solver.some_turn = true;
}

void find_turning_bodies(SolverView& solver, const BodyView& bodies, scalar h) {
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

void turn_half_way(const SolverView& solver, const BodyView& bodies, scalar h) {
    for_bodies(solver, [&](int body_i) {
        SolverBody& body = solver.bodies[body_i];
        if (!(body.dth[3] > turns_little)) return;
        SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_in_tiles(solver, body_i);
        const Vector inv_I_body = inverse_moments(bodies, at), L = three_of(body.L);
        Matrix A = pushed(attitude_of(history), turned_by_pushes(body, history), inv_I_body, L);
        if (body.dth[3] == turns_far) (void)turn_freely(A, inv_I_body, L, h / 2);
        set_attitude(history, A);
        if (takes_contacts_along(solver)) set_three(body.dth, {});
        set_three(history.turn, three_of(body.dth));
        set_lane(bodies.translation[at.tile].inv_I_world, at.lane, inverse_inertia_world(A, inv_I_body));
    });
}

Vector turn_on(const SolverView& solver, const BodyView& bodies, int body_i, bool hit, scalar h) {
    SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_in_tiles(solver, body_i);
    const Vector inv_I_body = inverse_moments(bodies, at), L = three_of(body.L);
    Matrix A = attitude_of(history);
    Vector turn;
    if (body.dth[3] == turns_into_impact) {
        turn = turn_freely(A, inv_I_body, L, h);
    } else {
        const SymmetricMatrix inv_I_world = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
        const Vector first = inv_I_world * three_of(history.L_begin) * (h / 2), rest = inv_I_world * L * (h / 2);
        turn = first + turn_freely(A, inv_I_body, L, h / 2);
        // A hit that nobody foresaw: targets are for a body that goes all of the substep by its new motion.
        if (hit) {
            A = pushed(A, rest - first, inv_I_body, L);
            turn += rest - first;
        }
    }
    body.dth[3] = turns_far;
    set_attitude(history, A);
    set_three(history.turn, three_of(history.turn) + turn);
    return turn;
}

Matrix attitude_at_end(const SolverView& solver, const BodyView& bodies, int body_i) {
    const SolverBodyHistory& history = solver.histories[body_i];
    const SolverBody& body = solver.bodies[body_i];
    return pushed(attitude_of(history), turned_by_pushes(body, history), inverse_moments(bodies, place_in_tiles(solver, body_i)), three_of(body.L));
}

} }  // namespace ingot
