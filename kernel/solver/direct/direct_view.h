// SPDX-License-Identifier: MIT
// What the direct solver works on, without its capacities: one island of contacts at a time, copied out of the blocks into
// doubles.
//
// The whole local solve is in double, whatever the scalar: impulses of 4e4 N s have a grain of 4e-3 in float, which is 4 mm/s
// on the 1 kg between them. What goes in and what comes out, motion, may be float.
#pragma once

#include "../../constraint/contact.h"
#include "../../constraint/kinematic_view.h"
#include "../../constraint/response.h"
#include "../../math/wide.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

using DirectVector = Vec3<wide_scalar>;

/// Rows of a manifold, by their numbers of contact.h; and how many of them are active at most, for three normals are enough.
template <bool rolls>
inline constexpr int direct_rows_of = rolls ? 9 : 7;
template <bool rolls>
inline constexpr int active_rows_of = direct_rows_of<rolls> - 1;

/// A row as the sweeps have it: speed = d.(v_A - v_B) + L_A.k_A + L_B.k_B, impulses j add d j inv_M and J j; see
/// contact_block.h.
struct DirectRow {
    DirectVector d;           ///< 0 for a torsion
    DirectVector J[2], k[2];  ///< of A and B; k = inv_I_world J, in double, so that the matrix of the rows is symmetric
    wide_scalar j;                 ///< N s; or the push of the position stage, kg m
    wide_scalar target;            ///< m/s, or m: speed or displacement a normal has at least
    wide_scalar K;                 ///< compliance
};

/// Friction that slides, t = mu N x / |x| with x = t - u / K, near where it is; and likewise a resistance to rolling that gives way.
struct SlideDirection {
    wide_scalar x[2];   ///< unit, along the force
    wide_scalar share;  ///< mu N / |x|, at most 1: how much the force turns with the slip
};

/// What manifolds have beside the rest if they resist being rolled.
template <bool rolls>
struct RollingOfManifold {
    static constexpr int pair_count = 1;  ///< pairs of rows within a circle: friction
    using RowBits = uint8_t;

    static wide_scalar lever_or(wide_scalar mu, int) { return mu; }
};
template <>
struct RollingOfManifold<true> {
    static constexpr int pair_count = 2;  ///< and rolling
    using RowBits = uint16_t;
    wide_scalar lever;  ///< m

    wide_scalar lever_or(wide_scalar mu, int pair_i) const { return pair_i == 0 ? mu : lever; }
};
/// The first row of a pair.
inline constexpr int row_of_pair(int pair_i) { return pair_i == 0 ? friction_row : rolling_row; }

template <bool rolls>
struct DirectManifoldOf : RollingOfManifold<rolls> {
    using RowBits = typename RollingOfManifold<rolls>::RowBits;

    wide_scalar mu, radius;      ///< m; |torsion| <= mu radius N
    SlideDirection slip[RollingOfManifold<rolls>::pair_count];  ///< that sliding rows were factored with
    wide_scalar torsion_sign;    ///< of the torsion; 0: it carries nothing
    Index position;      ///< block and lane: see manifold_at
    Index body[2];       ///< of DirectBody
    Index first;         ///< manifold of the island, the first that shares a body with this one
    Index active_begin;  ///< the first of its active rows
    RowBits rows;           ///< bit per row that exists
    RowBits active;         ///< bit per row that is solved for
    RowBits factored;       ///< the same of the matrix that is factored
    RowBits sliding;        ///< bit per active row of friction, torsion and rolling that slides
    uint8_t pulls;          ///< bit per row that may have any sign
    uint8_t points;         ///< rows that are normals, 1 or 4 in a block

    /// Of the impulses of a pair: how many times the load of the normals its circle is wide.
    wide_scalar bound_of(int pair_i) const { return this->lever_or(mu, pair_i); }
};

/// Motion: v_CM and L, or dp and dth. [0] is what cannot move.
struct DirectBody : FreeBodyOf<wide_scalar> {
    DirectVector linear, angular;
    Index body_i;  ///< of SolverBody
};

/// A row of the matrix of active rows, and of its factor.
struct DirectActive {
    wide_scalar inv_pivot;  ///< 0: the row depends on those before it, and takes nothing
    wide_scalar x;          ///< right-hand side, then solution
    uint32_t offset;   ///< of the first entry
    Index begin;    ///< column of the first entry
    Index row;      ///< of DirectRow
};

/// v_CM and L of a body with forces, before contacts.
struct FreeMotion {
    scalar v_CM[3], L[3];
};

/// How an island is solved, and how that went.
enum class IslandState : uint8_t {
    swept,
    chosen,  ///< to be solved
    solved,
    left_to_sweeps,  ///< chosen, but an impact leaves it to the sweeps for this substep
};

template <bool rolls>
struct DirectViewOf {
    static constexpr int row_count = direct_rows_of<rolls>, pair_count = RollingOfManifold<rolls>::pair_count;
    using Manifold = DirectManifoldOf<rolls>;

    Manifold* manifolds;
    DirectRow* rows;       ///< row_count of each manifold
    DirectActive* active;  ///< room for active_rows_of of each manifold
    DirectBody* bodies;    ///< room for manifold_capacity + 2
    wide_scalar* entries;       ///< of the matrix, row by row from the first that is not zero
    int manifold_capacity, entry_capacity;

    FreeMotion* free_motion;  ///< by solver body
    IslandState* state;       ///< by island
    Index* local;          ///< by solver body: of DirectBody
    uint8_t* unsettled;       ///< by record: steps in a row that ended with sweeps at their bound

    int manifold_count, body_count, active_count, entry_count;  ///< of the island at hand
    int loaded_island;                                          ///< -1: none
    bool some_chosen;  ///< of the batch
    bool factored, some_slide;
    bool paid;      ///< the factor at hand has been taken from work_left in this attempt
    bool uneven;    ///< bodies of limits::direct_mass_ratio touch, or carry as much
    bool steep;     ///< its mass is limits::direct_steepness times that of its lightest body
    int work_left;  ///< multiplications that the attempt at hand may still spend on factors; see limits::direct_work_max
    wide_scalar unit;  ///< m; of lengths and speeds in limits.h
};
using DirectView = DirectViewOf<false>;
using RollingDirectView = DirectViewOf<true>;
template <class Direct>
using ManifoldOf = typename Direct::Manifold;

} }  // namespace ingot

#pragma GCC diagnostic pop
