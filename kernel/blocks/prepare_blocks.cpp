// SPDX-License-Identifier: MIT
#include "prepare_blocks.h"

#include "../base/limits.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr ManifoldRecord no_contact = {{{0, 0, 1}, 0, {}}, 0, 0, {}, {}, {}, {}, 0, 0, 0};

const ManifoldRecord& record_of(const SolverView& solver, uint16_t manifold_i) {
    return manifold_i == no_manifold ? no_contact : solver.records[solver.pairs[manifold_i].record];
}

void recall(ContactBlock& block, int lane_i, const ManifoldRecord& record) {
    for (int row = 0; row < block.rows; ++row) {
        block.row[row].j[lane_i] = record.j[row];
        block.row[row].j_before[lane_i] = record.j_before[row];
    }
    const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
    block.friction.j[0][lane_i] = dot(record.j_friction, t_1);
    block.friction.j[1][lane_i] = dot(record.j_friction, t_2);
    block.friction.reference[0][lane_i] = dot(record.j_reference, t_1);
    block.friction.reference[1][lane_i] = dot(record.j_reference, t_2);
    block.twist.j[lane_i] = record.manifold.count > 1 ? record.j_twist : 0;  // one point resists none, and must not remember one
    block.substeps[lane_i] = static_cast<scalar>(record.substeps);
}

/// A body as the rows need it, of each lane.
struct RowBody {
    Vec3<lane> r_CM;
    Sym3<lane> inv_I_world;
    lane inv_M;
};

/// What is collected lane by lane before the vectors take over.
struct BlockInput {
    struct Body {
        scalar r_CM[3][lanes], inv_I_world[6][lanes], inv_M[lanes];

        void put(int lane_i, const BodyView& bodies, int slot) {
            const Place at = place_of(slot);
            set_lane(r_CM, lane_i, lane_of(bodies.translation[at.tile].r_CM, at.lane));
            set_lane(inv_I_world, lane_i, lane_of(bodies.translation[at.tile].inv_I_world, at.lane));
            inv_M[lane_i] = bodies.translation[at.tile].inv_M[at.lane];
        }
        RowBody loaded() const {
            return {load(r_CM), {load(inv_I_world[0]), load(inv_I_world[1]), load(inv_I_world[2]), load(inv_I_world[3]), load(inv_I_world[4]),
                                 load(inv_I_world[5])}, load(inv_M)};
        }
    };
    Body A, B;
    scalar n[3][lanes], P[block_rows][3][lanes], used[block_rows][lanes], separation[block_rows][lanes];
};

/// Two directions across n, the same for the same n: from the axis that n is furthest from.
INGOT_INLINE void tangents(const Vec3<lane>& n, Vec3<lane>& t_1, Vec3<lane>& t_2) {
    const lane one = splat<lane>(1);
    const mask across_x = both(abs(n.x) <= abs(n.y), abs(n.x) <= abs(n.z)), across_y = both(opposite(across_x), abs(n.y) <= abs(n.z));
    const mask across_z = both(opposite(across_x), opposite(across_y));
    const Vec3<lane> axis = {select(across_x, one, lane{}), select(across_y, one, lane{}), select(across_z, one, lane{})};
    const Vec3<lane> t = cross(n, axis);
    t_1 = t * (one / sqrt(length_sq(t)));
    t_2 = cross(n, t_1);
}

/// Rows along `direction` at levers r_A, r_B; no lever on what cannot move.
INGOT_INLINE void store_levers(Levers& levers, const RowBody& A, const RowBody& B, const Vec3<lane>& J_A, const Vec3<lane>& J_B) {
    store(levers.J_A, J_A);
    store(levers.J_B, J_B);
    store(levers.k_A, A.inv_I_world * J_A);
    store(levers.k_B, B.inv_I_world * J_B);
}

/// Compliance between two rows: the speed along the one that a unit impulse along the other gives; `share` is the cosine between them.
INGOT_INLINE lane compliance(const Levers& row, const Levers& other, lane inv_M) {
    return inv_M + dot(load(row.k_A), load(other.J_A)) + dot(load(row.k_B), load(other.J_B));
}

/// Compliance of the normals and its inverse.
template <int rows>
void prepare_normals(ContactBlock& block, const lane (&used)[block_rows], lane inv_M) {
    const lane one = splat<lane>(1);
    Sym4 K, stiffened;
    for (int row = 0; row < rows; ++row)
        for (int c = row; c < rows; ++c)
            K(row, c) = select(both(used[row] > lane{}, used[c] > lane{}), compliance(block.row[row].levers, block.row[c].levers, inv_M), row == c ? one : lane{});
    const mask singular = rows == block_rows ? used[rows - 1] > lane{} : one < lane{};  // fewer points have full rank
    const lane factor = select(singular, splat<lane>(limits::block_diagonal), one);
    stiffened = K;
    for (int row = 0; row < rows; ++row) stiffened(row, row) = K(row, row) * factor;
    const Sym4 B = inverse<rows>(stiffened);
    for (int row = 0; row < rows; ++row) {
        for (int c = row; c < rows; ++c) {
            const int entry = Sym4::index(row, c);
            const lane inverse_entry = select(both(used[row] > lane{}, used[c] > lane{}), B(row, c), lane{});
            store(block.K[entry], K(row, c));
            store(block.B[entry], inverse_entry);
            store(block.held[entry], inverse_entry);
        }
    }
}

void prepare_block(const SolverView& solver, const BodyView& bodies, int block_i) {
    ContactBlock& block = solver.blocks[block_i];
    BlockInput in{};
    block.rows = 1;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const int position = block_i * lanes + lane_i;
        block.manifold[lane_i] = solver.order[position];
        const bool spare = block.manifold[lane_i] == no_manifold;
        const ManifoldRecord& contact = record_of(solver, block.manifold[lane_i]);
        const BodyPair pair = spare ? BodyPair{} : solver.pairs[block.manifold[lane_i]];
        block.body_A[lane_i] = spare ? 0 : solver.local_of[pair.body_A];
        block.body_B[lane_i] = spare ? 0 : solver.local_of[pair.body_B];
        block.mu[lane_i] = contact.mu;
        block.e[lane_i] = contact.e;
        if (!spare) {
            in.A.put(lane_i, bodies, pair.body_A);
            in.B.put(lane_i, bodies, pair.body_B);
        }
        if (contact.manifold.count > 1) block.rows = block_rows;
        set_lane(in.n, lane_i, contact.manifold.n);
        for (int row = 0; row < contact.manifold.count; ++row) {
            in.used[row][lane_i] = 1;
            in.separation[row][lane_i] = contact.manifold.points[row].separation;
            set_lane(in.P[row], lane_i, contact.manifold.points[row].P);
        }
    }
    const RowBody A = in.A.loaded(), B = in.B.loaded();
    const Vec3<lane> n = load(in.n);
    Vec3<lane> P[block_rows];
    lane used[block_rows], separation[block_rows];
    for (int row = 0; row < block.rows; ++row) {
        P[row] = load(in.P[row]);
        used[row] = load(in.used[row]);
        separation[row] = load(in.separation[row]);
    }

    const lane one = splat<lane>(1), inv_M = A.inv_M + B.inv_M;
    store(block.inv_M_A, A.inv_M);
    store(block.inv_M_B, B.inv_M);
    store(block.n, n);
    Vec3<lane> t_1, t_2;
    tangents(n, t_1, t_2);
    store(block.t_1, t_1);
    store(block.t_2, t_2);
    const mask movable_A = A.inv_M > lane{}, movable_B = B.inv_M > lane{};
    const auto lever_A = [&](const Vec3<lane>& at, const Vec3<lane>& direction) { return select(movable_A, cross(at - A.r_CM, direction), Vec3<lane>{}); };
    const auto lever_B = [&](const Vec3<lane>& at, const Vec3<lane>& direction) { return select(movable_B, cross(direction, at - B.r_CM), Vec3<lane>{}); };

    // Normals, and the middle of the points that friction acts at: those beyond the margin count less and less.
    Vec3<lane> middle{};
    lane weights{};
    const lane margin = splat<lane>(limits::contact_margin);
    lane weight[block_rows];
    for (int row = 0; row < block.rows; ++row) {
        const mask there = used[row] > lane{};
        store_levers(block.row[row].levers, A, B, select(there, lever_A(P[row], n), Vec3<lane>{}), select(there, lever_B(P[row], n), Vec3<lane>{}));
        store(block.row[row].separation, separation[row]);
        store(block.row[row].target, lane{});
        store(block.row[row].landing, splat<lane>(limits::unbounded));
        weight[row] = used[row] * greatest(lane{}, least(one, splat<lane>(2) - separation[row] / margin)) + used[row] * splat<lane>(scalar(1e-6));
        middle += P[row] * weight[row];
        weights = weights + weight[row];
    }
    const lane inv_weights = one / select(weights > lane{}, weights, one);
    middle = middle * inv_weights;
    lane radius{};
    for (int row = 0; row < block.rows; ++row) radius = radius + weight[row] * sqrt(length_sq(P[row] - middle));
    // Of one point it is rounding, which blocks of one row do not have: lanes must not see what a manifold shares its block with.
    store(block.twist.radius, block.rows > 1 ? select(used[1] > lane{}, radius * inv_weights, lane{}) : lane{});

    if (block.rows == 1)
        prepare_normals<1>(block, used, inv_M);
    else
        prepare_normals<block_rows>(block, used, inv_M);

    store_levers(block.friction.levers[0], A, B, lever_A(middle, t_1), lever_B(middle, t_1));
    store_levers(block.friction.levers[1], A, B, lever_A(middle, t_2), lever_B(middle, t_2));
    const mask any_point = used[0] > lane{};
    const lane k11 = compliance(block.friction.levers[0], block.friction.levers[0], inv_M), k22 = compliance(block.friction.levers[1], block.friction.levers[1], inv_M);
    const lane k12 = compliance(block.friction.levers[0], block.friction.levers[1], lane{});
    const lane inv_det = one / select(any_point, k11 * k22 - k12 * k12, one);
    store(block.friction.K[0], k11);
    store(block.friction.K[1], k22);
    store(block.friction.inv_K[0], select(any_point, k22 * inv_det, lane{}));
    store(block.friction.inv_K[1], select(any_point, -k12 * inv_det, lane{}));
    store(block.friction.inv_K[2], select(any_point, k11 * inv_det, lane{}));

    const Vec3<lane> k_A = select(movable_A, A.inv_I_world * n, Vec3<lane>{}), k_B = select(movable_B, B.inv_I_world * -n, Vec3<lane>{});
    const lane k_twist = dot(k_A, n) - dot(k_B, n);
    store(block.twist.K, k_twist);
    store(block.twist.k_A, k_A);
    store(block.twist.k_B, k_B);
    const mask turns = both(any_point, k_twist > lane{});
    store(block.twist.inv_K, select(turns, one / select(turns, k_twist, one), lane{}));
    for (int row = 0; row < block.rows; ++row) store(block.row[row].direction, lane{});
    for (int axis = 0; axis < 2; ++axis) store(block.friction.direction[axis], lane{});
    store(block.twist.direction, lane{});
    for (int lane_i = 0; lane_i < lanes; ++lane_i) recall(block, lane_i, record_of(solver, block.manifold[lane_i]));
}

}  // namespace

void prepare_blocks(const SolverView& solver, const BodyView& bodies) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) prepare_block(solver, bodies, block_i);
}

void remember_impulses(const SolverView& solver) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t manifold_i = block.manifold[lane_i];
            if (manifold_i == no_manifold) continue;
            ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
            const scalar substeps = block.substeps[lane_i];
            record.substeps = static_cast<uint16_t>(substeps < 1000 ? substeps : scalar(1000));
            for (int row = 0; row < block_rows; ++row) {
                const bool there = row < record.manifold.count;
                record.j[row] = there ? block.row[row].j[lane_i] : 0;
                record.j_before[row] = there ? block.row[row].j_before[lane_i] : 0;
            }
            const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
            record.j_friction = t_1 * block.friction.j[0][lane_i] + t_2 * block.friction.j[1][lane_i];
            record.j_reference = t_1 * block.friction.reference[0][lane_i] + t_2 * block.friction.reference[1][lane_i];
            record.j_twist = block.twist.j[lane_i];
        }
    }
}

} }  // namespace ingot
