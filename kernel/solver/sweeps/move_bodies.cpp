// SPDX-License-Identifier: MIT
#include "move_bodies.h"

#include "../../base/limits.h"
#include "../../body/axis_locks.h"
#include "../../body/kinematics.h"
#include "../../body/turning_inertia.h"
#include "../../math/sqrt.h"
#include "turning_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void set4(scalar (&to)[4], const Vector& value, scalar fourth = 0) {
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
    to[3] = fourth;
}
Vector vector_of(const scalar (&from)[4]) { return {from[0], from[1], from[2]}; }

/// True where forces or contacts leave the motion of a body within limits::speed_runaway and spin_runaway. False for NaN.
bool stays_in_range(const RotationTile& rotation, const Vector& v_CM, const Vector& L, int lane_i) {
    const scalar most = limits::speed_runaway, scale = rotation.inv_I_scale[lane_i];
    if (!(abs(v_CM.x) <= most && abs(v_CM.y) <= most && abs(v_CM.z) <= most)) return false;
    if ((abs(L.x) + abs(L.y) + abs(L.z)) * scale <= limits::spin_runaway) return true;  // no ratio is beyond 1: omega is not longer than that
    return is_within_runaway(spin_of(lane_of(rotation.A, lane_i), lane_of(rotation.inv_I_ratio, lane_i) * scale, L));
}

/// A body at the begin of a step, and what acts on it.
struct MotionAtBegin {
    Vector v_CM, L, a, tau;
    scalar inv_M;
};
MotionAtBegin motion_of(const BodyView& bodies, const Vector& gravity, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& translation = bodies.translation[at.tile];
    const RotationTile& rotation = bodies.rotation[at.tile];
    const scalar inv_M = translation.inv_M[at.lane];
    return {lane_of(translation.v_CM, at.lane), lane_of(rotation.L, at.lane), lane_of(translation.F_T, at.lane) * inv_M + gravity,
            lane_of(rotation.tau_T, at.lane), inv_M};
}

void begin_body(const SolverView& solver, int body_i, const MotionAtBegin& motion) {
    SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    body = {};
    history = {};
    set4(body.v_CM, motion.v_CM, motion.inv_M);
    set4(body.L, motion.L);
    set4(body.dp, {}, sqrt(length_sq(motion.a)));
    set4(history.a, motion.a);
    set4(history.tau, motion.tau);
}

/// True where neither what it has nor what acts on it leads out of range.
bool begins_well(const BodyView& bodies, const MotionAtBegin& motion, scalar h, const Place& at) {
    return stays_in_range(bodies.rotation[at.tile], motion.v_CM + motion.a * h, motion.L + motion.tau * h, at.lane);
}

Index add_body(SolverView& solver, const MotionAtBegin& motion, int slot) {
    const int local = solver.body_count++;
    solver.slot_of[local] = static_cast<Index>(slot);
    begin_body(solver, local, motion);
    return static_cast<Index>(local);
}

/// The solver's own body of a slot; 0 for one that cannot move, or that has gone bad: its motion must not reach those that touch it.
Index take_in(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, int slot) {
    const Place at = place_of(slot);
    const scalar inv_M = bodies.translation[at.tile].inv_M[at.lane];
    if (!(inv_M > 0)) return 0;
    if (takes_part(solver, slot)) return solver.local_of[slot];
    const MotionAtBegin motion = motion_of(bodies, gravity, slot);
    if (!begins_well(bodies, motion, h, at)) {
        if (!solver.side_by_side) mark_lane_bad(bodies.rotation[at.tile].bad, at.lane);
        return 0;
    }
    return add_body(solver, motion, slot);
}
/// Of a figure: it is solved as one, so all of its bodies take part. One that has gone bad does so without the forces on it.
Index take_in_of_figure(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, int slot) {
    const Index local = take_in(solver, bodies, gravity, h, slot);
    if (local != 0) return local;
    const Place at = place_of(slot);
    set_lane(bodies.translation[at.tile].F_T, at.lane, Vector{});
    set_lane(bodies.rotation[at.tile].tau_T, at.lane, Vector{});
    return add_body(solver, motion_of(bodies, gravity, slot), slot);
}

/// What cannot move is of several parts: 0 is there already.
void name_local(const SolverView& solver, Index slot, Index local) {
    if (solver.local_of[slot] != local) solver.local_of[slot] = local;
}

/// The inertia that it began the step with.
void begin_inertia(const BodyView& bodies, const Place& at) {
    const RotationTile& tile = bodies.rotation[at.tile];
    set_lane(bodies.translation[at.tile].inv_I_world, at.lane,
             inverse_inertia_world(lane_of(tile.A, at.lane), lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane]));
}

}  // namespace

void take_in_bodies(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h) {
    solver.bodies[0] = {};
    solver.histories[0] = {};
    solver.body_count = 1;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const BodyPair& pair = solver.pairs[manifold_i];
        name_local(solver, pair.body_A, take_in(solver, bodies, gravity, h, pair.body_A));
        name_local(solver, pair.body_B, take_in(solver, bodies, gravity, h, pair.body_B));
    }
}

void take_in_figures(SolverView&, NoJointedBodies&, const BodyView&, const Vector&, scalar) {}
void take_in_figures(SolverView& solver, JointedBodies& jointed, const BodyView& bodies, const Vector& gravity, scalar h) {
    const FigureView& figures = jointed.figures;
    for (int node_i = 0; node_i < figures.node_count; ++node_i) {  // bound: max_bodies
        const Index slot = figures.nodes[node_i].slot;
        solver.local_of[slot] = take_in_of_figure(solver, bodies, gravity, h, slot);
    }
    jointed.body_count = solver.body_count;
    for (int body_i = 0; body_i < solver.body_count; ++body_i) {
        jointed.node_of[body_i] = no_node;
        jointed.leader_of[body_i] = static_cast<Index>(body_i);
    }
    for (int node_i = 0; node_i < figures.node_count; ++node_i) {
        const FigureNode& node = figures.nodes[node_i];
        const Index body_i = solver.local_of[node.slot];
        jointed.node_of[body_i] = static_cast<Index>(node_i);
        solver.bodies[body_i].dth[3] = turns_with_figure;
        jointed.leader_of[body_i] = solver.local_of[figures.nodes[figures.figures[node.figure].first_node].slot];
    }
}

void lead_machines(const SolverView& solver, JointedBodies& jointed, const LoopView& loops) {
    if (loops.machine_of == nullptr) return;
    const FigureView& figures = jointed.figures;
    for (int node_i = 0; node_i < figures.node_count; ++node_i) {  // bound: max_bodies
        const FigureNode& node = figures.nodes[node_i];
        const Figure& first = figures.figures[loops.machine_of[node.figure]];
        jointed.leader_of[solver.local_of[node.slot]] = solver.local_of[figures.nodes[first.first_node].slot];
    }
}

void take_in_again(const SolverView& solver, const BodyView& bodies, const Vector& gravity) {
    for_bodies(solver, [&](int body_i) {
        const scalar turns = solver.bodies[body_i].dth[3];
        if (turns != turns_little) begin_inertia(bodies, place_of(solver.slot_of[body_i]));
        begin_body(solver, body_i, motion_of(bodies, gravity, solver.slot_of[body_i]));
        solver.bodies[body_i].dth[3] = min(turns, turns_little);
    });
}

void kick_bodies(const SolverView& solver, scalar h) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        if (solver.islands[island_i].in_batch) solver.islands[island_i].fastest_sq = 0;
    for_bodies(solver, [&](int body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        for (int i = 0; i < 4; ++i) history.v_begin[i] = body.v_CM[i];  // the fourth of a and tau is 0
        for (int i = 0; i < 4; ++i) history.L_begin[i] = body.L[i];
        for (int i = 0; i < 4; ++i) body.v_CM[i] = body.v_CM[i] + history.a[i] * h;
        for (int i = 0; i < 4; ++i) body.L[i] = body.L[i] + history.tau[i] * h;
        scalar& fastest_sq = solver.islands[solver.island_of[body_i]].fastest_sq;
        fastest_sq = max(fastest_sq, length_sq(vector_of(body.v_CM)));
    });
}

namespace {

/// Calls note(body_i, is_steady) for each body, and keeps what it returns beside the sum of L.
template <class View, class Note>
INGOT_INLINE void drift_each(View& solver, const BodyView& bodies, scalar h, const Note& note) {
    solver.some_hit = false;
    for_bodies(solver, [&](int body_i) {
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector v = vector_of(body.v_CM), change = v - vector_of(history.v_begin), L = vector_of(body.L);
        const scalar smooth = 2 * h * body.dp[3];
        const bool hit = length_sq(change) > smooth * smooth;
        const Vector dp = vector_of(body.dp) + (hit ? v : v - change * scalar(0.5)) * h;
        const SymmetricMatrix inv_I_world = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
        const Vector spun = L - vector_of(history.L_begin);
        const bool turns = body.dth[3] > turns_little;
        const Vector turn = turns ? turn_on(solver, bodies, body_i, hit, h) : inv_I_world * L * h;
        solver.some_hit = solver.some_hit || hit;
        const scalar steady_change = limits::steady_acceleration * body.dp[3] * h + limits::settled_speed * solver.unit;
        const bool is_steady = length_sq(change) + dot(spun, inv_I_world * spun) * body.v_CM[3] <= steady_change * steady_change;
        set4(body.dp, dp, body.dp[3]);
        set4(body.dth, vector_of(body.dth) + turn, body.dth[3]);
        if (body.dth[3] == turns_little && turns_so_far(solver, bodies, body_i, turn)) begin_turning(solver, bodies, body_i);
        body.L[3] = hit ? scalar(1) : scalar(0);
        set4(history.L_sum, vector_of(history.L_sum) + L * shares_of_substep(solver), note(body_i, is_steady));
    });
}

}  // namespace

template <class View>
void drift_bodies(View& solver, const BodyView& bodies, scalar h) {
    drift_each(solver, bodies, h, [&](int body_i, bool is_steady) {
        Island& island = solver.islands[solver.island_of[body_i]];
        island.steady = island.steady && is_steady;
        return scalar(0);
    });
}
template <class View>
void drift_some_bodies(View& solver, const BodyView& bodies, scalar h) {
    drift_each(solver, bodies, h, [](int, bool is_steady) { return is_steady ? scalar(0) : scalar(1); });
}
void tell_unsteady_bodies(const SolverView& solver) {
    for_bodies(solver, [&](int body_i) {
        if (solver.histories[body_i].L_sum[3] > 0) solver.islands[solver.island_of[body_i]].steady = false;
    });
}

namespace {

bool moves_in_figure(const NoJointedBodies&, int) { return false; }
bool moves_in_figure(const JointedBodies& jointed, int body_i) { return jointed.has_joints(static_cast<Index>(body_i)); }

/// False, and nothing is written, where it has gone bad.
bool write_body(const SolverView& solver, int body_i, const BodyView& bodies, const Vector& gravity, scalar h) {
    const SolverBody& body = solver.bodies[body_i];
    const SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_of(solver.slot_of[body_i]);
    const Vector v = vector_of(body.v_CM), L = vector_of(body.L), dp = vector_of(body.dp);
    RotationTile& rotation = bodies.rotation[at.tile];
    TranslationTile& translation = bodies.translation[at.tile];
    if (!stays_in_range(rotation, v, L, at.lane) || !is_finite(dp) || !is_finite(vector_of(body.dth))) return false;
    const Vector a = (v - dp * (1 / h)) * (2 / h), L_mean = vector_of(history.L_sum) * (1 / static_cast<scalar>(solver.effort.substeps));
    set_lane(translation.v_CM, at.lane, v);
    set_lane(translation.F_T, at.lane, (a - gravity) * (1 / body.v_CM[3]));
    set_lane(rotation.L, at.lane, L);
    set_lane(rotation.tau_T, at.lane, (L - L_mean) * (2 / h));
    return true;
}

void mark_body(const SolverView& solver, int body_i, const BodyView& bodies, bool good) {
    const Place at = place_of(solver.slot_of[body_i]);
    RotationTile& rotation = bodies.rotation[at.tile];
    mark_lane_bad(good ? rotation.kicked : rotation.bad, at.lane);
}

}  // namespace

template <class Joints>
void write_contact_motion(const SolverView& solver, const Joints& jointed, const BodyView& bodies, const Vector& gravity, scalar h) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i)  // bound: max_bodies + 1
        if (!moves_in_figure(jointed, body_i)) mark_body(solver, body_i, bodies, write_body(solver, body_i, bodies, gravity, h));
}

namespace {

/// Calls each(slot) for bodies that can move and that take_in_bodies has left out.
template <class Each>
void over_left_out(const SolverView& solver, const BodyView& bodies, const Each& each) {
    const auto look_at = [&](int slot) {
        const Place at = place_of(slot);
        if (solver.local_of[slot] == 0 && bodies.translation[at.tile].inv_M[at.lane] > 0) each(slot);
    };
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        look_at(solver.pairs[manifold_i].body_A);
        look_at(solver.pairs[manifold_i].body_B);
    }
}

}  // namespace

void write_motion_of_part(const SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h) {
    // Of each body whether it is good; of [0], which is none, whether some were left out.
    for (int body_i = 1; body_i < solver.body_count; ++body_i)  // bound: max_bodies + 1
        solver.colours_of_body[body_i] = write_body(solver, body_i, bodies, gravity, h) ? 1u : 0u;
    solver.colours_of_body[0] = 0;
    over_left_out(solver, bodies, [&](int) { solver.colours_of_body[0] = 1; });
}
void mark_motion_of_part(const SolverView& solver, const BodyView& bodies) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i)  // bound: max_bodies + 1
        mark_body(solver, body_i, bodies, solver.colours_of_body[body_i] != 0);
    if (solver.colours_of_body[0] == 0) return;
    over_left_out(solver, bodies, [&](int slot) { mark_lane_bad(bodies.rotation[place_of(slot).tile].bad, place_of(slot).lane); });
}

namespace {

template <class View, class Joints>
void turn_by_pushes(const View& solver, const Joints& jointed, const BodyView& bodies, scalar h, const TaskRange& of) {
    for (int body_i = of.begin; body_i < of.end; ++body_i) {  // bound: max_bodies + 1
        if (moves_in_figure(jointed, body_i)) continue;
        const SolverBody& body = solver.bodies[body_i];
        const SolverBodyHistory& history = solver.histories[body_i];
        const Place at = place_of(solver.slot_of[body_i]);
        const SymmetricMatrix inv_I_world = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
        RotationTile& rotation = bodies.rotation[at.tile];
        if ((rotation.bad >> at.lane & 1u) != 0) continue;
        Matrix A;
        if (body.dth[3] > turns_little) {
            A = attitude_at_end(solver, bodies, body_i);
        } else {
            const Vector push = vector_of(body.dth) - inv_I_world * vector_of(history.L_sum) * (h / static_cast<scalar>(solver.effort.substeps));
            if (!(length_sq(push) > limits::settled_turn * limits::settled_turn)) continue;
            A = turned_about(lane_of(rotation.A, at.lane), push);
        }
        if (is_finite(A)) set_lane(rotation.A, at.lane, A);
    }
}

}  // namespace

template <class Joints>
void turn_by_corrections(const SolverView& solver, const Joints& jointed, const BodyView& bodies, scalar h) {
    turn_by_pushes(solver, jointed, bodies, h, {1, solver.body_count});
}
void turn_by_corrections(const LockedView& solver, const NoJointedBodies& jointed, const BodyView& bodies, scalar h) {
    turn_by_pushes(solver, jointed, bodies, h, {1, solver.body_count});
}
void turn_some_by_corrections(const SolverView& solver, const TaskRange& of, const BodyView& bodies, scalar h) {
    turn_by_pushes(solver, NoJointedBodies{}, bodies, h, of);
}
void turn_some_by_corrections(const LockedView& solver, const TaskRange& of, const BodyView& bodies, scalar h) {
    turn_by_pushes(solver, NoJointedBodies{}, bodies, h, of);
}

void hold_bodies(const LockedView& solver, const BodyView& bodies) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        const int slot = solver.slot_of[body_i];
        const unsigned locks = solver.locks[slot];
        if (locks == 0) continue;
        SolverBody& body = solver.bodies[body_i];
        SolverBodyHistory& history = solver.histories[body_i];
        const Vector a = free_part(three_of(history.a), translations_locked(locks));
        set_three(history.a, a);
        body.dp[3] = sqrt(length_sq(a));
        if (rotations_locked(locks) == 0 || body.dth[3] > turns_little) continue;
        const Place at = place_of(slot);
        const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
        set_lane(bodies.translation[at.tile].inv_I_world, at.lane, locked_inertia_of(bodies, slot, locks).inverse_world(A));
    }
}

// The linker takes the one that the scene calls.
template void drift_bodies(SolverView&, const BodyView&, scalar);
template void drift_bodies(LockedView&, const BodyView&, scalar);
template void drift_some_bodies(SolverView&, const BodyView&, scalar);
template void drift_some_bodies(LockedView&, const BodyView&, scalar);
template void write_contact_motion(const SolverView&, const NoJointedBodies&, const BodyView&, const Vector&, scalar);
template void write_contact_motion(const SolverView&, const JointedBodies&, const BodyView&, const Vector&, scalar);
template void turn_by_corrections(const SolverView&, const NoJointedBodies&, const BodyView&, scalar);
template void turn_by_corrections(const SolverView&, const JointedBodies&, const BodyView&, scalar);

} }  // namespace ingot
