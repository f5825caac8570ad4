// SPDX-License-Identifier: MIT
#include "prepare_blocks.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr ManifoldRecord no_contact = {{{0, 0, 1}, 0, {}}, 0, 0, {}, {}, {}, {}, 0, 0, 0};

const ManifoldRecord& record_of(const SolverView& solver, uint16_t manifold_i) {
    return manifold_i == no_manifold ? no_contact : solver.records[solver.pairs[manifold_i].record];
}

/// The two bodies of each lane, as rows need them, and the points of their manifolds.
struct LaneBodies {
    Vec3<lane> r_CM;
    Sym3<lane> inv_I_world;
    lane inv_M;
    mask moves;
};
struct LaneContacts {
    LaneBodies A, B;
    Vec3<lane> n, t_1, t_2;
    Vec3<lane> P[block_rows];
    lane used[block_rows];  ///< 1 where a manifold has that point, else 0
    lane separation[block_rows];
    lane inv_M;             ///< of both bodies
};

/// What is collected lane by lane, for the vectors to take over.
struct Collected {
    struct Body {
        scalar r_CM[3][lanes], inv_I_world[6][lanes], inv_M[lanes];

        void put(int lane_i, const BodyView& bodies, int slot) {
            const Place at = place_of(slot);
            set_lane(r_CM, lane_i, lane_of(bodies.translation[at.tile].r_CM, at.lane));
            set_lane(inv_I_world, lane_i, lane_of(bodies.translation[at.tile].inv_I_world, at.lane));
            inv_M[lane_i] = bodies.translation[at.tile].inv_M[at.lane];
        }
        LaneBodies loaded() const {
            const lane inverse_mass = load(inv_M);
            return {
                load(r_CM),
                {load(inv_I_world[0]), load(inv_I_world[1]), load(inv_I_world[2]), load(inv_I_world[3]), load(inv_I_world[4]), load(inv_I_world[5])},
                inverse_mass,
                inverse_mass > lane{}};
        }
    };
    Body A, B;
    scalar n[3][lanes], P[block_rows][3][lanes], used[block_rows][lanes], separation[block_rows][lanes];
};

/// Names the bodies of a block, and collects them. A body that is 0 to the solver is all zero here too; between two of them there
/// is nothing to solve: the lane is as if it had no points.
void collect(const SolverView& solver, const BodyView& bodies, ContactBlock& block, Collected& in) {
    block.rows = 1;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const uint16_t manifold_i = block.manifold[lane_i];
        const ManifoldRecord& record = record_of(solver, manifold_i);
        block.body_A[lane_i] = block.body_B[lane_i] = 0;
        block.mu[lane_i] = record.mu;
        block.e[lane_i] = record.e;
        set_lane(in.n, lane_i, record.manifold.n);
        if (manifold_i == no_manifold) continue;
        const BodyPair& pair = solver.pairs[manifold_i];
        block.body_A[lane_i] = solver.local_of[pair.body_A];
        block.body_B[lane_i] = solver.local_of[pair.body_B];
        if (block.body_A[lane_i] != 0) in.A.put(lane_i, bodies, pair.body_A);
        if (block.body_B[lane_i] != 0) in.B.put(lane_i, bodies, pair.body_B);
        if (record.manifold.count > 1) block.rows = block_rows;
        if (block.body_A[lane_i] == 0 && block.body_B[lane_i] == 0) continue;  // one has gone bad
        for (int row = 0; row < record.manifold.count; ++row) {  // bound: 4: Manifold::points_max
            in.used[row][lane_i] = 1;
            in.separation[row][lane_i] = record.manifold.points[row].separation;
            set_lane(in.P[row], lane_i, record.manifold.points[row].P);
        }
    }
}

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

LaneContacts vectors_of(const Collected& in, int rows) {
    LaneContacts contacts;
    contacts.A = in.A.loaded();
    contacts.B = in.B.loaded();
    contacts.inv_M = contacts.A.inv_M + contacts.B.inv_M;
    contacts.n = load(in.n);
    tangents(contacts.n, contacts.t_1, contacts.t_2);
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        contacts.P[row] = load(in.P[row]);
        contacts.used[row] = load(in.used[row]);
        contacts.separation[row] = load(in.separation[row]);
    }
    return contacts;
}

INGOT_INLINE void store_lever(scalar (&to_J)[3][lanes], scalar (&to_k)[3][lanes], const LaneBodies& body, const Vec3<lane>& lever, mask there) {
    const Vec3<lane> J = select(both(there, body.moves), lever, Vec3<lane>{});
    store(to_J, J);
    store(to_k, body.inv_I_world * J);
}

/// A row along `direction` at P; no lever on what cannot move, or where there is no point.
INGOT_SHARED void store_levers(Levers& levers, const LaneContacts& contacts, const Vec3<lane>& P, const Vec3<lane>& direction, mask there) {
    store_lever(levers.J_A, levers.k_A, contacts.A, cross(P - contacts.A.r_CM, direction), there);
    store_lever(levers.J_B, levers.k_B, contacts.B, cross(direction, P - contacts.B.r_CM), there);
}

/// Compliance between two rows: the speed along the one that a unit impulse along the other gives. inv_M: times the cosine between them.
INGOT_INLINE lane compliance(const Levers& row, const Levers& other, lane inv_M) {
    return inv_M + dot(load(row.k_A), load(other.J_A)) + dot(load(row.k_B), load(other.J_B));
}

/// True where the normal of one point goes through the centres of both bodies that move, but for the rounding of P: there it has no lever.
INGOT_INLINE mask is_central(const LaneContacts& contacts) {
    const Vec3<lane> P = contacts.P[0], n = contacts.n;
    const lane rounding = splat<lane>(8 * epsilon) * (abs(P.x) + abs(P.y) + abs(P.z));
    const auto passes = [&](const LaneBodies& body) {
        const Vec3<lane> J = cross(P - body.r_CM, n);
        return either(opposite(body.moves), both(both(abs(J.x) <= rounding, abs(J.y) <= rounding), abs(J.z) <= rounding));
    };
    return both(passes(contacts.A), passes(contacts.B));
}

/// Levers of the normals, their compliance and its inverse. Returns which manifolds are central.
template <int rows>
INGOT_INLINE mask prepare_normals(ContactBlock& block, const LaneContacts& contacts) {
    const lane one = splat<lane>(1);
    const mask alone = rows > 1 ? contacts.used[1] == lane{} : one > lane{};
    const mask central = both(alone, is_central(contacts));
    block.central = rows == 1 && !any(opposite(central));
    mask there[block_rows];
    for (int row = 0; row < rows; ++row) {
        there[row] = contacts.used[row] > lane{};
        ContactRow& to = block.row[row];
        store_levers(to.levers, contacts, contacts.P[row], contacts.n, both(there[row], opposite(central)));
        store(to.separation, contacts.separation[row]);
        store(to.target, lane{});
        store(to.landing, splat<lane>(limits::unbounded));
        store(to.direction, lane{});
    }
    Sym4 K;
    for (int row = 0; row < rows; ++row)
        for (int c = row; c < rows; ++c)
            K(row, c) =
                select(both(there[row], there[c]), compliance(block.row[row].levers, block.row[c].levers, contacts.inv_M), row == c ? one : lane{});
    lane count{};
    for (int row = 0; row < rows; ++row) count = count + contacts.used[row];
    const Sym4 all = inverse_of_used<rows>(K, count);
    store(block.count, count);
    for (int row = 0; row < rows; ++row) {
        for (int c = row; c < rows; ++c) {
            store(block.K[Sym4::index(row, c)], K(row, c));
            store(block.cached_inverse[Sym4::index(row, c)], all(row, c));
        }
    }
    return both(central, there[0]);
}

/// Where friction takes hold: the mean of the points, of which those beyond the margin count less and less, and how far they are from it.
struct Middle {
    Vec3<lane> P;
    lane radius;
};
INGOT_INLINE Middle middle_of(const LaneContacts& contacts, int rows) {
    const lane one = splat<lane>(1), margin = splat<lane>(limits::contact_margin), least_weight = splat<lane>(scalar(1e-6));
    Middle middle{};
    lane weight[block_rows], weights{};
    for (int row = 0; row < rows; ++row) {
        const lane near = max(lane{}, min(one, splat<lane>(2) - contacts.separation[row] / margin));
        weight[row] = contacts.used[row] * near + contacts.used[row] * least_weight;
        middle.P += contacts.P[row] * weight[row];
        weights = weights + weight[row];
    }
    const lane inv_weights = one / select(weights > lane{}, weights, one);
    middle.P = middle.P * inv_weights;
    for (int row = 0; row < rows; ++row) middle.radius = middle.radius + weight[row] * sqrt(length_sq(contacts.P[row] - middle.P));
    const mask has_area = rows > 1 ? contacts.used[1] > lane{} : one < lane{};
    middle.radius = select(has_area, middle.radius * inv_weights, lane{});  // one point is its own middle but for rounding
    return middle;
}

INGOT_INLINE void prepare_friction(FrictionPair& friction, const LaneContacts& contacts, const Vec3<lane>& P) {
    const mask there = contacts.used[0] > lane{};
    store_levers(friction.levers[0], contacts, P, contacts.t_1, there);
    store_levers(friction.levers[1], contacts, P, contacts.t_2, there);
    const lane K_11 = compliance(friction.levers[0], friction.levers[0], contacts.inv_M);
    const lane K_22 = compliance(friction.levers[1], friction.levers[1], contacts.inv_M);
    const lane K_12 = compliance(friction.levers[0], friction.levers[1], lane{});
    prepare_pair(friction, K_11, K_12, K_22, there);
}

INGOT_INLINE void prepare_torsion(TorsionRow& torsion, const LaneContacts& contacts, lane radius) {
    const lane one = splat<lane>(1);
    const Vec3<lane> k_A = select(contacts.A.moves, contacts.A.inv_I_world * contacts.n, Vec3<lane>{});
    const Vec3<lane> k_B = select(contacts.B.moves, contacts.B.inv_I_world * -contacts.n, Vec3<lane>{});
    const lane K = dot(k_A, contacts.n) - dot(k_B, contacts.n);
    const mask turns = both(contacts.used[0] > lane{}, K > lane{});
    store(torsion.k_A, k_A);
    store(torsion.k_B, k_B);
    store(torsion.K, K);
    store(torsion.inv_K, select(turns, one / select(turns, K, one), lane{}));
    store(torsion.radius, radius);
    store(torsion.direction, lane{});
}

/// The impulses of the step before; friction's as components of what they were in the world.
void recall(const SolverView& solver, ContactBlock& block, int lane_i, const ManifoldRecord& record) {
    const scalar share = shares_of_substep(solver);
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        block.row[row].j[lane_i] = record.j[row] * share;
        block.row[row].j_before[lane_i] = record.j_before[row] * share;
    }
    const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
    block.friction.j[0][lane_i] = dot(record.j_friction, t_1) * share;
    block.friction.j[1][lane_i] = dot(record.j_friction, t_2) * share;
    block.friction.reference[0][lane_i] = dot(record.j_reference, t_1) * share;
    block.friction.reference[1][lane_i] = dot(record.j_reference, t_2) * share;
    block.torsion.j[lane_i] = record.manifold.count > 1 ? record.j_torsion * share : 0;
    block.substeps[lane_i] = static_cast<scalar>(age_of(record));
}

void count_central(const SolverView& solver, const ContactBlock& block, mask central) {
    for (unsigned lane_i = 0, left = bits(central); left != 0; ++lane_i, left >>= 1)  // bound: lanes: central has a bit a lane
        if ((left & 1u) != 0) ++solver.islands[block.island[lane_i]].central_count;
}

void prepare_block(const SolverView& solver, const BodyView& bodies, int block_i) {
    ContactBlock& block = solver.blocks[block_i];
    Collected in{};
    collect(solver, bodies, block, in);
    const LaneContacts contacts = vectors_of(in, block.rows);
    store(block.inv_M_A, contacts.A.inv_M);
    store(block.inv_M_B, contacts.B.inv_M);
    store(block.n, contacts.n);
    store(block.t_1, contacts.t_1);
    store(block.t_2, contacts.t_2);

    const mask central = block.rows == 1 ? prepare_normals<1>(block, contacts) : prepare_normals<block_rows>(block, contacts);
    const Middle middle = middle_of(contacts, block.rows);
    prepare_friction(block.friction, contacts, middle.P);
    prepare_torsion(block.torsion, contacts, middle.radius);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) recall(solver, block, lane_i, record_of(solver, block.manifold[lane_i]));
    count_central(solver, block, central);
}

}  // namespace

void prepare_blocks(const SolverView& solver, const BodyView& bodies) {
    // bound: max_manifolds, rounded up to whole blocks
    for (int block_i = 0; block_i < solver.block_count; ++block_i) prepare_block(solver, bodies, block_i);
}

void remember_impulses(const SolverView& solver) {
    constexpr scalar substeps_max = limits::substeps_kept;
    const scalar part = 1 / shares_of_substep(solver);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        const ContactBlock& block = solver.blocks[block_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const uint16_t manifold_i = block.manifold[lane_i];
            if (manifold_i == no_manifold || solver.islands[block.island[lane_i]].begins_again) continue;
            ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
            const scalar substeps = block.substeps[lane_i];
            const auto age = static_cast<uint16_t>(substeps < substeps_max ? substeps : substeps_max);
            record.substeps = solver.islands[block.island[lane_i]].steady ? static_cast<uint16_t>(age | steady_bit) : age;
            for (int row = 0; row < record.manifold.count; ++row) {
                record.j[row] = block.row[row].j[lane_i] * part;
                record.j_before[row] = block.row[row].j_before[lane_i] * part;
            }
            const Vector t_1 = lane_of(block.t_1, lane_i), t_2 = lane_of(block.t_2, lane_i);
            record.j_friction = (t_1 * block.friction.j[0][lane_i] + t_2 * block.friction.j[1][lane_i]) * part;
            record.j_reference = (t_1 * block.friction.reference[0][lane_i] + t_2 * block.friction.reference[1][lane_i]) * part;
            record.j_torsion = block.torsion.j[lane_i] * part;
        }
    }
}

} }  // namespace ingot
