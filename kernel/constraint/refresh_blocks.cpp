// SPDX-License-Identifier: MIT
#include "refresh_blocks.h"

#include "../body/turning_inertia.h"
#include "block_bodies.h"
#include "collect_blocks.h"
#include "jointed_view.h"
#include "locked_view.h"
#include "moved_manifold.h"
#include "row_flight.h"
#include "turning_body.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A solver body that stands for a kinematic one.
bool is_carrier(const SolverView& solver, Index body_i) { return body_i != 0 && !(solver.bodies[body_i].v_CM[3] > 0); }

uint16_t turning_lanes(const SolverView& solver, const ContactBlock& block) {
    uint16_t turning = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        if (is_turning(solver, block.body_A[lane_i]) || is_turning(solver, block.body_B[lane_i]))
            turning = static_cast<uint16_t>(turning | 1u << lane_i);
    return turning;
}
/// What turns far and is round: it rolls, and lands on other points than it had.
bool rolls(const SolverView& solver, Index body_i, int shape_slot) {
    if (!is_turning(solver, body_i)) return false;
    const ShapeKind kind = solver.shapes.surface({shape_slot}).shape.kind;
    return kind == ShapeKind::capsule || kind == ShapeKind::cylinder;
}
bool turns(const ContactBlock& block, int lane_i) { return (block.turning >> lane_i & 1u) != 0; }

bool some_rolls(const SolverView& solver, const ContactBlock& block, int lane_i) {
    const BodyPair& shapes = solver.shape_pairs[block.manifold[lane_i]];
    return rolls(solver, block.body_A[lane_i], shapes.body_A) || rolls(solver, block.body_B[lane_i], shapes.body_B);
}

/// The motion at the end of the substep if its impulses are those of the substep before.
template <class View>
BodyPairLanes going_on(const View& solver, const ContactBlock& block, const BodyPairLanes& motion, scalar h) {
    const BodyPairLanes forces = gather_histories(solver, block, &SolverBodyHistory::a, &SolverBodyHistory::tau);
    const lane step = splat<lane>(h), inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B);
    auto next = held_pair(solver, block, {motion.linear_A + forces.linear_A * step, motion.angular_A + forces.angular_A * step,
                                          motion.linear_B + forces.linear_B * step, motion.angular_B + forces.angular_B * step, {}});
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        const lane j = load(block.row[row].j);
        add_linear(next, load(block.n) * j, inv_M_A, inv_M_B);
        add_angular(next, block.row[row].levers, j);
    }
    for (int axis = 0; axis < 2; ++axis) {
        const lane j = load(block.friction.j[axis]);
        add_linear(next, load(axis == 0 ? block.t_1 : block.t_2) * j, inv_M_A, inv_M_B);
        add_angular(next, block.friction.levers[axis], j);
    }
    return next;
}

/// Keeps the speeds along the rows, in the place of targets and shifts, and separations, in that of landings. Returns the lanes that meet by more
/// than forces and the impulses of the substep before explain.
template <class View>
mask note_speeds(const View& solver, ContactBlock& block, scalar h) {
    const BodyPairLanes motion = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const BodyPairLanes forces = gather_histories(solver, block, &SolverBodyHistory::a, &SolverBodyHistory::tau);
    const BodyPairLanes next = going_on(solver, block, motion, h);
    const Vec3<lane> n = load(block.n), slip = motion.linear_A - motion.linear_B;
    const lane apart = dot(n, displaced.linear_A - displaced.linear_B), approach = dot(n, slip);
    const lane approach_next = dot(n, next.linear_A - next.linear_B);
    const lane pull = dot(n, forces.linear_A - forces.linear_B), gap = scale_of(solver, block) * splat<lane>(limits::touching_gap);
    const lane fall = max(gather(solver.bodies, block.body_A, &SolverBody::dp).at[3], gather(solver.bodies, block.body_B, &SolverBody::dp).at[3]);
    const lane step = splat<lane>(h), inv_h = splat<lane>(1 / h);
    const mask was_hit = motion.last[1] + motion.last[3] > lane{};  // an impact is not given again
    mask hit = splat<lane>(1) < lane{};
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        const Levers& levers = block.row[row].levers;
        const lane s = separation_now(block, row, apart, displaced), u = row_speed(levers, approach, motion);
        const lane u_free = u + row_speed(levers, pull, forces) * step;
        const lane u_next = select(was_hit, u_free, max(u_free, row_speed(levers, approach_next, next)));
        hit = either(hit, both(is_used(block, row), u_next - resting_target(s, gap, inv_h) < splat<lane>(-2) * fall * step));
        store(block.row[row].target, u);
        store(block.row[row].landing, s);
    }
    for (int axis = 0; axis < 2; ++axis)
        store(block.friction.shift[axis], row_speed(block.friction.levers[axis], dot(load(axis == 0 ? block.t_1 : block.t_2), slip), motion));
    return hit;
}

bool meets_impact(const SolverView& solver, Index body_i) { return solver.bodies[body_i].dth[3] == turns_into_impact; }

/// Where the body of a manifold is `ahead` seconds after the begin of the substep, or its end. flown: s, by which the attitude of a body that turns
/// far is beyond that.
MovedBody body_of(const SolverView& solver, const BodyView& bodies, int slot, int shape_slot, Index body_i, scalar ahead, scalar flown) {
    const Place at = place_of(slot);
    const Vector r = lane_of(bodies.translation[at.tile].r_CM, at.lane);
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    const ShapeSlot of = {shape_slot};
    const PlacedShape shape = place_on_body(solver.shapes.surface(of).shape, solver.shapes.place(of), solver.shapes.hull(of), r, A);
    if (body_i == 0) return {shape, r, {}, identity_matrix<scalar>()};
    const SolverBody& body = solver.bodies[body_i];
    const bool is_far = is_turning(solver, body_i);
    const Vector omega = lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * three_of(body.L);
    const Vector beyond = is_far ? turned_by_pushes(body, solver.histories[body_i]) : three_of(body.dth);
    const Matrix seen = is_far ? attitude_of(solver.histories[body_i]) : A;
    const scalar left = is_far && !meets_impact(solver, body_i) ? ahead - flown : ahead;
    return {shape, r, three_of(body.dp) + three_of(body.v_CM) * ahead, turned_about(seen, beyond + omega * left) * transposed(A)};
}

struct MovedPair {
    MovedBody A, B;
};
MovedPair pair_of(const SolverView& solver, const BodyView& bodies, const ContactBlock& block, int lane_i, scalar ahead, scalar flown) {
    const Index manifold_i = block.manifold[lane_i];
    const BodyPair &pair = solver.pairs[manifold_i], &shapes = solver.shape_pairs[manifold_i];
    return {body_of(solver, bodies, pair.body_A, shapes.body_A, block.body_A[lane_i], ahead, flown),
            body_of(solver, bodies, pair.body_B, shapes.body_B, block.body_B[lane_i], ahead, flown)};
}

/// A lane's manifold as it is where contacts act. Returns by how much that is beyond the begin of the substep, s.
scalar collect_moved(const SolverView& solver, const BodyView& bodies, ContactBlock& block, int lane_i, scalar h, Collected& in) {
    const Index body_A = block.body_A[lane_i], body_B = block.body_B[lane_i];
    const scalar half = h / 2, ahead = meets_impact(solver, body_A) || meets_impact(solver, body_B) ? scalar(0) : half;
    const Manifold& found = solver.records[solver.pairs[block.manifold[lane_i]].record].manifold;
    const MovedPair pair = pair_of(solver, bodies, block, lane_i, ahead, half);
    const Manifold now = moved_manifold(found, pair.A, pair.B);
    if (body_A != 0) set_lane(in.A.r_CM, lane_i, pair.A.r_begin + pair.A.shift);
    if (body_B != 0) set_lane(in.B.r_CM, lane_i, pair.B.r_begin + pair.B.shift);
    set_lane(in.n, lane_i, now.n);
    for (int row = 0; row < now.count; ++row) {  // bound: 4: Manifold::points_max
        in.separation[row][lane_i] = now.points[row].separation;
        set_lane(in.P[row], lane_i, now.points[row].P);
    }
    return ahead;
}

/// Impulses across the normal stay what they are as the normal turns.
Vec3<lane> along_tangents(const ContactBlock& block, const LaneRow (&of)[2]) {
    return load(block.t_1) * load(of[0]) + load(block.t_2) * load(of[1]);
}
void set_along_tangents(const ContactBlock& block, mask turning, const Vec3<lane>& value, LaneRow (&of)[2]) {
    store(of[0], select(turning, dot(value, load(block.t_1)), load(of[0])));
    store(of[1], select(turning, dot(value, load(block.t_2)), load(of[1])));
}

/// What a block keeps while it is prepared again.
struct KeptRows {
    lane cached_inverse[10], separation[block_rows], u[block_rows], s[block_rows];

    explicit KeptRows(const ContactBlock& block) {
        for (int i = 0; i < 10; ++i) cached_inverse[i] = load(block.cached_inverse[i]);
        for (int row = 0; row < block_rows; ++row) {
            separation[row] = load(block.row[row].separation);
            u[row] = load(block.row[row].target);
            s[row] = load(block.row[row].landing);
        }
    }
};

template <class View>
void refresh_block(const View& solver, const BodyView& bodies, int block_i, scalar h) {
    ContactBlock& block = solver.blocks[block_i];
    const mask turning = mask_from_bits(block.turning), moving = mask_from_bits(moves_contacts<View> ? block.moving : uint16_t{0});
    Collected in{};
    scalar ahead_of[lanes] = {};
    collect_free(solver, bodies, block, in);
    if constexpr (View::locks_axes) block.rows = block_rows;
    if constexpr (moves_contacts<View>)
        for (int lane_i = 0; lane_i < lanes; ++lane_i)
            if ((block.moving >> lane_i & 1u) != 0) ahead_of[lane_i] = collect_moved(solver, bodies, block, lane_i, h, in);
    const KeptRows kept(block);
    auto contacts = vectors_of<LaneContactsOfView<View>>(solver, block, in);
    see_locks(solver, block, contacts);
    const Vec3<lane> friction = along_tangents(block, block.friction.j), reference = along_tangents(block, block.friction.reference),
                     slip_before = along_tangents(block, block.friction.shift);
    store(block.n, select(moving, contacts.n, load(block.n)));
    store(block.t_1, select(moving, contacts.t_1, load(block.t_1)));
    store(block.t_2, select(moving, contacts.t_2, load(block.t_2)));
    set_along_tangents(block, moving, friction, block.friction.j);
    set_along_tangents(block, moving, reference, block.friction.reference);
    ContactConstraint<View>::Given::prepare(solver, block_i, contacts);
    for (int i = 0; i < 10; ++i) store(block.cached_inverse[i], select(turning, load(block.cached_inverse[i]), kept.cached_inverse[i]));

    const BodyPairLanes motion = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const Vec3<lane> n = load(block.n), slip = motion.linear_A - motion.linear_B;
    const lane apart = dot(n, displaced.linear_A - displaced.linear_B), approach = dot(n, slip), ahead = load(ahead_of);
    const lane substep = splat<lane>(static_cast<scalar>(solver.substeps - solver.substeps_left)), now = substep + ahead * splat<lane>(1 / h);
    const lane since = now - load(block.refreshed_at), none = lane{};
    // Of the change since the rows were made, what half a substep makes.
    const mask shifts = both(moving, both(ahead > none, since > none));
    const lane share = select(shifts, splat<lane>(scalar(0.5)) / select(shifts, since, splat<lane>(1)), none);
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        NormalRow& of = block.row[row];
        const lane u = row_speed(of.levers, approach, motion), c = (u - kept.u[row]) * share;
        store(of.separation, select(turning, kept.s[row] - row_displacement(of.levers, apart, displaced), kept.separation[row]));
        store(of.landing, select(shifts, c + max(u - c, none), none));
    }
    const Vec3<lane> along[2] = {load(block.t_1), load(block.t_2)};
    for (int axis = 0; axis < 2; ++axis) {
        const lane u = row_speed(block.friction.levers[axis], dot(along[axis], slip), motion);
        store(block.friction.shift[axis], (u - dot(along[axis], slip_before)) * share);
    }
    store(block.refreshed_at, select(moving, now, load(block.refreshed_at)));
}

}  // namespace

template <class View>
void note_turning_speeds(const View& solver, int block_count, scalar h) {
    for (int block_i = 0; block_i < block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        ContactBlock& block = solver.blocks[block_i];
        block.turning = turning_lanes(solver, block);
        block.moving = block.noted = 0;
        if (block.turning == 0) continue;
        block.noted = static_cast<uint16_t>(bits(note_speeds(solver, block, h)) & block.turning);
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const Index A = block.body_A[lane_i], B = block.body_B[lane_i];
            if (turns(block, lane_i) && takes_contacts_along(solver) && !is_carrier(solver, A) && !is_carrier(solver, B) &&
                some_rolls(solver, block, lane_i))
                block.moving = static_cast<uint16_t>(block.moving | 1u << lane_i);
        }
    }
}

void mark_hit_bodies(const SolverView& solver, int block_count) {
    for (int block_i = 0; block_i < block_count; ++block_i) {  // bound: as above
        const ContactBlock& block = solver.blocks[block_i];
        for (unsigned lane_i = 0, left = block.noted; left != 0; ++lane_i, left >>= 1) {  // bound: lanes: noted has a bit a lane
            if ((left & 1u) == 0) continue;
            const Index of[2] = {block.body_A[lane_i], block.body_B[lane_i]};
            for (const Index body_i : of)
                if (is_turning(solver, body_i)) solver.bodies[body_i].dth[3] = turns_into_impact;
        }
    }
}

template <class View>
void refresh_blocks(const View& solver, const BodyView& bodies, scalar h) {
    for (int block_i = 0; block_i < first_jointed_block(solver); ++block_i)  // bound: max_manifolds, rounded up to whole blocks
        if (solver.blocks[block_i].turning != 0) refresh_block(solver, bodies, block_i, h);
}

void shift_targets(const SolverView& solver) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: as above
        ContactBlock& block = solver.blocks[block_i];
        if (block.turning == 0) continue;
        for (int row = 0; row < block.rows; ++row) {
            store(block.row[row].target, load(block.row[row].target) - load(block.row[row].landing));
            store(block.row[row].landing, splat<lane>(limits::unbounded));
        }
    }
}

void separate_turned(const SolverView& solver, const BodyView& bodies) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: as above
        ContactBlock& block = solver.blocks[block_i];
        if (block.moving == 0) continue;
        scalar s[block_rows][lanes] = {};
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if ((block.moving >> lane_i & 1u) == 0) continue;
            const MovedPair pair = pair_of(solver, bodies, block, lane_i, 0, 0);
            const Manifold now = moved_manifold(solver.records[solver.pairs[block.manifold[lane_i]].record].manifold, pair.A, pair.B);
            for (int row = 0; row < now.count; ++row) s[row][lane_i] = now.points[row].separation;
        }
        const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
        const lane apart = dot(load(block.n), displaced.linear_A - displaced.linear_B);
        for (int row = 0; row < block.rows; ++row) {
            NormalRow& of = block.row[row];
            const lane off = load(s[row]) - row_displacement(of.levers, apart, displaced);
            store(of.separation, select(mask_from_bits(block.moving), off, load(of.separation)));
        }
    }
}

// The linker takes the one that the scene calls.
template void note_turning_speeds(const SolverView&, int, scalar);
template void note_turning_speeds(const LockedView&, int, scalar);
template void refresh_blocks(const JointedView&, const BodyView&, scalar);
template void refresh_blocks(const LoopedView&, const BodyView&, scalar);
template void refresh_blocks(const JointedMaterialView&, const BodyView&, scalar);
template void refresh_blocks(const LoopedMaterialView&, const BodyView&, scalar);
template void refresh_blocks(const LockedView&, const BodyView&, scalar);
template void refresh_blocks(const SolverView&, const BodyView&, scalar);
template void refresh_blocks(const BallView&, const BodyView&, scalar);
template void refresh_blocks(const RollingView&, const BodyView&, scalar);
template void refresh_blocks(const BeltView&, const BodyView&, scalar);
template void refresh_blocks(const RollingBeltView&, const BodyView&, scalar);

} }  // namespace ingot

#pragma GCC diagnostic pop
