// SPDX-License-Identifier: MIT
#include "prepare_block.h"

#include "kinematic_levers.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Prepares a block again. It keeps its separations, from which drift_kinematic_bodies has taken what a kinematic body has turned by, and what the
/// substep asks for: its targets, and where it lands. Bodies that stand for kinematic ones are seen as before. for_pushes: its normals alone.
template <class View>
void refresh_block(const View& solver, const BodyView& bodies, int block_i, bool for_pushes = false) {
    ContactBlock& block = solver.blocks[block_i];
    lane separation[block_rows], target[block_rows], landing[block_rows];
    for (int row = 0; row < block_rows; ++row) {
        separation[row] = load(block.row[row].separation);
        target[row] = load(block.row[row].target);
        landing[row] = load(block.row[row].landing);
    }
    with_contacts(solver, bodies, block_i, [&](auto& contacts) {
        Normals::prepare(solver, block_i, contacts);
        if (!for_pushes) ContactConstraint<View>::BesideNormals::prepare(solver, block_i, contacts);
    });
    for (int row = 0; row < block_rows; ++row) {
        store(block.row[row].separation, separation[row]);
        store(block.row[row].target, target[row]);
        store(block.row[row].landing, landing[row]);
    }
    if constexpr (View::articulates)
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (is_spare(block.manifold[lane_i])) continue;
            if (block.body_A[lane_i] >= solver.jointed.body_count) see_kinematic_rows(solver, block_i, lane_i, true);
            if (block.body_B[lane_i] >= solver.jointed.body_count) see_kinematic_rows(solver, block_i, lane_i, false);
        }
}

/// The same in the middle of a solve: it keeps how friction turns round, too, and of islands that stand the inverse as it is.
template <class View>
void refresh_block_in_solve(const View& solver, const BodyView& bodies, int block_i) {
    constexpr int entries = sizeof(ContactBlock::cached_inverse) / sizeof(LaneRow);
    ContactBlock& block = solver.blocks[block_i];
    uint16_t standing = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const Index island_i = block.island[lane_i];
        if (island_i != no_island && !solver.islands[island_i].in_batch) standing = static_cast<uint16_t>(standing | 1u << lane_i);
    }
    lane inverse[entries];
    for (int i = 0; i < entries; ++i) inverse[i] = load(block.cached_inverse[i]);
    const lane mu = load(block.mu);
    const FrictionRows& friction = block.friction;
    const uint16_t sliding = friction.sliding;
    const bool turns_round = friction.turns_round;
    refresh_block(solver, bodies, block_i);
    for (int i = 0; i < entries; ++i)
        store(block.cached_inverse[i], select(mask_from_bits(standing), inverse[i], load(block.cached_inverse[i])));
    store(block.mu, mu);
    block.friction.sliding = sliding;
    block.friction.turns_round = turns_round;
}

bool is_ball(const SolverView& solver, int shape_slot) {
    const ShapeSlot of = {shape_slot};
    return solver.shapes.surface(of).shape.kind == ShapeKind::sphere && solver.shapes.place(of) == nullptr;
}

/// When two balls meet, or come as near as they get, s; no later than `latest`. x, v: m, m/s, from B to A, which closes in.
scalar time_of_nearest(const Vector& x, const Vector& v, scalar separation, scalar reach, scalar latest) {
    const scalar per_v_sq = 1 / length_sq(v), nearest = -dot(x, v) * per_v_sq;
    const scalar apart = separation * (separation + 2 * reach) * per_v_sq, before_sq = nearest * nearest - apart;
    return min(before_sq > 0 ? apart / (nearest + sqrt(before_sq)) : nearest, latest);
}

/// Of balls that fly towards each other the normal and the levers become those of when they are nearest in the step: not where they come nearer by so
/// little in it that they touch all through it, as far as contacts can tell.
INGOT_RARE void see_balls_meet(const SolverView& solver, const BodyView& bodies, const BodyPair& pair, const BodyPair& shapes, int lane_i, scalar gap,
                               Collected& in) {
    if (!is_ball(solver, shapes.body_A) || !is_ball(solver, shapes.body_B)) return;
    const Place A = place_of(pair.body_A), B = place_of(pair.body_B);
    const Vector r_A = lane_of(bodies.translation[A.tile].r_CM, A.lane), r_B = lane_of(bodies.translation[B.tile].r_CM, B.lane);
    const Vector v_A = lane_of(bodies.translation[A.tile].v_CM, A.lane), v_B = lane_of(bodies.translation[B.tile].v_CM, B.lane);
    const Vector x = r_A - r_B, v = v_A - v_B;
    const scalar radius_A = solver.shapes.surface({shapes.body_A}).shape.size.x, radius_B = solver.shapes.surface({shapes.body_B}).shape.size.x;
    const scalar reach = radius_A + radius_B;
    if (!(-dot(x, v) * solver.step_h > gap * reach)) return;
    const scalar t = time_of_nearest(x, v, in.separation[0][lane_i], reach, solver.step_h);
    const Vector at_A = r_A + v_A * t, at_B = r_B + v_B * t, away = at_A - at_B, n = away * (1 / sqrt(length_sq(away)));
    set_lane(in.n, lane_i, n);
    in.separation[0][lane_i] = dot(n, x) - reach;
    set_lane(in.A.r_CM, lane_i, at_A);
    set_lane(in.B.r_CM, lane_i, at_B);
    set_lane(in.P[0], lane_i, (at_A - n * radius_A + (at_B + n * radius_B)) * scalar(0.5));
}

}  // namespace

void collect(const SolverView& solver, const BodyView& bodies, ContactBlock& block, Collected& in) {
    block.rows = 1;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const Index manifold_i = block.manifold[lane_i];
        const ManifoldRecord& record = kept_of(solver, manifold_i).record;
        block.mu[lane_i] = record.mu;
        block.e[lane_i] = record.e;
        block.halvings[lane_i] = static_cast<uint8_t>(record.manifold.halvings);
        set_lane(in.n, lane_i, record.manifold.n);
        if (is_spare(manifold_i)) continue;
        const BodyPair& pair = solver.pairs[manifold_i];
        const bool A_moves = solver.local_of[pair.body_A] != 0, B_moves = solver.local_of[pair.body_B] != 0;
        if (A_moves) in.A.put(lane_i, bodies, pair.body_A);
        if (B_moves) in.B.put(lane_i, bodies, pair.body_B);
        // Impacts are of those that come from apart: else each collision in a heap makes all of it rattle.
        if (presses(load_of(record), in.A.inv_M[lane_i] + in.B.inv_M[lane_i], solver.unit)) block.e[lane_i] = 0;
        if (record.manifold.count > 1) block.rows = block_rows;
        if (!A_moves && !B_moves) continue;  // one has gone bad
        for (int row = 0; row < record.manifold.count; ++row) {  // bound: 4: Manifold::points_max
            in.used[row][lane_i] = 1;
            in.separation[row][lane_i] = record.manifold.points[row].separation;
            set_lane(in.P[row], lane_i, record.manifold.points[row].P);
        }
    }
}

void collect_free(const SolverView& solver, const BodyView& bodies, ContactBlock& block, Collected& in) {
    collect(solver, bodies, block, in);
    if (solver.shape_pairs == nullptr) return;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const Index manifold_i = block.manifold[lane_i];
        const bool is_apart = in.used[0][lane_i] > 0 && !(in.used[1][lane_i] > 0) && in.separation[0][lane_i] > 0;
        if (is_apart && in.A.inv_M[lane_i] > 0 && in.B.inv_M[lane_i] > 0)
            see_balls_meet(solver, bodies, solver.pairs[manifold_i], solver.shape_pairs[manifold_i], lane_i,
                           limits::touching_gap * scale_of(solver.unit, block.halvings[lane_i]), in);
    }
}

void count_central_manifolds(const SolverView& solver) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: as above
        const ContactBlock& block = solver.blocks[block_i];
        for (unsigned lane_i = 0, left = block.noted; left != 0; ++lane_i, left >>= 1)  // bound: lanes: noted has a bit a lane
            if ((left & 1u) != 0) ++solver.islands[block.island[lane_i]].central_count;
    }
}

template <class View>
void refresh_jointed_blocks(const View& solver, const BodyView& bodies, bool for_pushes) {
    for (int block_i = solver.jointed.first_block; block_i < solver.block_count; ++block_i) refresh_block(solver, bodies, block_i, for_pushes);
}

template <class View>
void refresh_in_solve(const View& solver, const BodyView& bodies) {
    for (int block_i = solver.jointed.first_block; block_i < solver.block_count; ++block_i) refresh_block_in_solve(solver, bodies, block_i);
}

template void ResponseOf<FreeBody>::prepare_levers(Levers&, const Vec3<lane>&, const Vec3<lane>&, mask) const;

// The linker takes the one that the scene calls; that of balls is in a file of its own. Belts have no impulses of their own.
template void prepare_blocks(const JointedView&, const BodyView&);
template void prepare_blocks(const LoopedView&, const BodyView&);
template void prepare_blocks(const JointedMaterialView&, const BodyView&);
template void prepare_blocks(const LoopedMaterialView&, const BodyView&);
template void refresh_jointed_blocks(const JointedView&, const BodyView&, bool);
template void refresh_in_solve(const JointedView&, const BodyView&);
template void refresh_jointed_blocks(const LoopedView&, const BodyView&, bool);
template void refresh_in_solve(const LoopedView&, const BodyView&);
template void refresh_jointed_blocks(const JointedMaterialView&, const BodyView&, bool);
template void refresh_in_solve(const JointedMaterialView&, const BodyView&);
template void refresh_jointed_blocks(const LoopedMaterialView&, const BodyView&, bool);
template void refresh_in_solve(const LoopedMaterialView&, const BodyView&);
template void remember_impulses(const JointedView&);
template void remember_impulses(const LoopedView&);
template void remember_impulses(const JointedMaterialView&);
template void remember_impulses(const LoopedMaterialView&);
template void prepare_blocks(const LockedView&, const BodyView&);
template void prepare_blocks(const SolverView&, const BodyView&);
template void prepare_blocks(const RollingView&, const BodyView&);
template void prepare_blocks(const BeltView&, const BodyView&);
template void prepare_blocks(const RollingBeltView&, const BodyView&);
template void remember_impulses(const SolverView&);
template void remember_impulses(const RollingView&);
template void remember_impulses(const RollingBeltView&);

} }  // namespace ingot
