// SPDX-License-Identifier: MIT
#include "solve_manifolds.h"

#include "../base/limits.h"
#include "../math/rotation.h"
#include "conjugate_gradients.h"
#include "order_manifolds.h"
#include "predict_contacts.h"
#include "prepare_blocks.h"
#include "sweep_positions.h"
#include "sweep_velocities.h"
#include "warm_start.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void set4(scalar (&to)[4], const Vector& value, scalar fourth = 0) {
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
    to[3] = fourth;
}
Vector vector_of(const scalar (&from)[4]) { return {from[0], from[1], from[2]}; }

/// The solver's own body of a slot; 0 for one that cannot move.
uint16_t take_in(SolverView& solver, const BodyView& bodies, const Vector& gravity, int slot) {
    const Place at = place_of(slot);
    const scalar inv_M = bodies.translation[at.tile].inv_M[at.lane];
    if (!(inv_M > 0)) return 0;
    if (solver.local_of[slot] != 0) return solver.local_of[slot];
    const int local = solver.body_count++;
    solver.local_of[slot] = static_cast<uint16_t>(local);
    solver.slot_of[local] = static_cast<uint16_t>(slot);

    SolverBody& body = solver.bodies[local];
    SolverBodyHistory& history = solver.histories[local];
    body = {};
    history = {};
    set4(body.v_CM, lane_of(bodies.translation[at.tile].v_CM, at.lane), inv_M);
    set4(body.L, lane_of(bodies.rotation[at.tile].L, at.lane));
    const Vector a = lane_of(bodies.translation[at.tile].F_T, at.lane) * inv_M + gravity;
    set4(body.dp, {}, sqrt(length_sq(a)));
    set4(history.a, a);
    set4(history.tau, lane_of(bodies.rotation[at.tile].tau_T, at.lane));
    return solver.local_of[slot];
}

}  // namespace

void take_in_bodies(SolverView& solver, const BodyView& bodies, const Vector& gravity) {
    solver.bodies[0] = {};
    solver.histories[0] = {};
    solver.body_count = 1;
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) solver.local_of[slot] = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        (void)take_in(solver, bodies, gravity, solver.pairs[manifold_i].body_A);
        (void)take_in(solver, bodies, gravity, solver.pairs[manifold_i].body_B);
    }
}

void kick_bodies(const SolverView& solver, scalar h) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        for (int i = 0; i < 4; ++i) history.v_begin[i] = body.v_CM[i];  // the fourth of a and tau is 0
        for (int i = 0; i < 4; ++i) body.v_CM[i] = body.v_CM[i] + history.a[i] * h;
        for (int i = 0; i < 4; ++i) body.L[i] = body.L[i] + history.tau[i] * h;
    }
}

void drift_bodies(SolverView& solver, const BodyView& bodies, scalar h) {
    solver.some_hit = false;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector v = vector_of(body.v_CM), change = v - vector_of(history.v_begin), L = vector_of(body.L);
        const scalar smooth = 2 * h * body.dp[3];
        const bool hit = length_sq(change) > smooth * smooth;
        const Vector dp = vector_of(body.dp) + (hit ? v : v - change * scalar(0.5)) * h;
        const Vector turn = lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L * h;
        solver.some_hit = solver.some_hit || hit;
        set4(body.dp, dp, body.dp[3]);
        set4(body.dth, vector_of(body.dth) + turn);
        body.L[3] = hit ? scalar(1) : scalar(0);
        set4(history.L_sum, vector_of(history.L_sum) + L);
    }
}

int sweeps_allowed(const SolverView& solver) {
    if (solver.manifold_count <= limits::few_manifolds) return limits::sweeps_of_few;
    int young = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        if (solver.records[solver.pairs[manifold_i].record].substeps < 4 * limits::substeps) ++young;
    return 4 * young > solver.manifold_count ? limits::sweeps_of_young : limits::sweeps;
}

int solve_velocities(const SolverView& solver, int sweeps_max, scalar& residual) {
    scalar size_before = 0;
    for (int sweep_i = 1;; ++sweep_i) {
        if (sweep_i < sweeps_max) begin_sweep(solver);
        const SweepResult result = sweep_velocities(solver, sweep_i % 2 != 0);
        residual = result.residual;
        if (sweep_i == sweeps_max || residual <= limits::settled_speed) return sweep_i;
        const scalar beta = sweep_i > 1 && result.size <= size_before && size_before > 0 ? result.size / size_before : 0;
        size_before = result.size;
        extrapolate(solver, beta);
    }
}

void solve_manifolds(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, StepReport& report) {
    take_in_bodies(solver, bodies, gravity);
    order_manifolds(solver);
    prepare_blocks(solver, bodies);

    const int sweeps_max = sweeps_allowed(solver);
    const scalar h_substep = h / limits::substeps;
    for (int substep_i = 0; substep_i < limits::substeps; ++substep_i) {
        predict_contacts(solver, h_substep);
        kick_bodies(solver, h_substep);
        warm_start(solver, h_substep);
        count(report.sweeps, solve_velocities(solver, sweeps_max, report.residual));
        drift_bodies(solver, bodies, h_substep);
        sweep_positions(solver, h_substep);
    }
    remember_impulses(solver);
}

void write_contact_motion(const SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        const SolverBody& body = solver.bodies[body_i];
        const SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector v = vector_of(body.v_CM), L = vector_of(body.L), dp = vector_of(body.dp);
        RotationTile& rotation = bodies.rotation[at.tile];
        TranslationTile& translation = bodies.translation[at.tile];
        const uint16_t bit = static_cast<uint16_t>(1u << at.lane);
        if (!is_finite(v) || !is_finite(L) || !is_finite(dp) || !is_finite(vector_of(body.dth))) {
            rotation.bad = static_cast<uint16_t>(rotation.bad | bit);
            continue;
        }
        const Vector a = (v - dp * (1 / h)) * (2 / h), L_mean = vector_of(history.L_sum) * (scalar(1) / limits::substeps);
        set_lane(translation.v_CM, at.lane, v);
        set_lane(translation.F_T, at.lane, (a - gravity) * (1 / body.v_CM[3]));
        set_lane(rotation.L, at.lane, L);
        set_lane(rotation.tau_T, at.lane, (L - L_mean) * (2 / h));
        rotation.kicked = static_cast<uint16_t>(rotation.kicked | bit);
    }
}

void turn_by_corrections(const SolverView& solver, const BodyView& bodies, scalar h) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector L_sum = vector_of(solver.histories[body_i].L_sum);
        const Vector drift = lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L_sum * (h / limits::substeps);
        const Vector push = vector_of(solver.bodies[body_i].dth) - drift;
        if (!(length_sq(push) > limits::settled_turn * limits::settled_turn)) continue;
        RotationTile& rotation = bodies.rotation[at.tile];
        if ((rotation.bad >> at.lane & 1u) != 0) continue;
        const Matrix A = lane_of(rotation.A, at.lane);
        const Matrix turned = {A.c0 + cross(push, A.c0), A.c1 + cross(push, A.c1), A.c2 + cross(push, A.c2)};
        const Matrix A_next = turned + polar_correction(turned);
        if (is_finite(A_next)) set_lane(rotation.A, at.lane, A_next);
    }
}

} }  // namespace ingot
