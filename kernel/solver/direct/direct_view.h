// SPDX-License-Identifier: MIT
// What the direct solver works on, without its capacities: one island of contacts at a time, copied out of the blocks into
// doubles.
//
// The whole local solve is in double, whatever the scalar: impulses of 4e4 N s have a grain of 4e-3 in float, which is 4 mm/s
// on the 1 kg between them. What goes in and what comes out, motion, may be float.
#pragma once

#include "../../constraint/solver_view.h"
#include "../../math/wide.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

using DirectVector = Vec3<wide_scalar>;

inline constexpr int direct_rows = 7;  ///< of a manifold: normals 0 .. 3, friction 4 and 5, torsion 6
inline constexpr int friction_row = 4, torsion_row = 6;

/// A row as the sweeps have it: speed = d.(v_A - v_B) + L_A.k_A + L_B.k_B, impulses j add d j inv_M and J j; see
/// contact_block.h.
struct DirectRow {
    DirectVector d;           ///< 0 for a torsion
    DirectVector J[2], k[2];  ///< of A and B; k = inv_I_world J, in double, so that the matrix of the rows is symmetric
    wide_scalar j;                 ///< N s; or the push of the position stage, kg m
    wide_scalar target;            ///< m/s, or m: speed or displacement a normal has at least
    wide_scalar K;                 ///< compliance
};

/// Friction that slides, t = mu N x / |x| with x = t - u / K, near where it is.
struct SlideDirection {
    wide_scalar x[2];   ///< unit, along the force
    wide_scalar share;  ///< mu N / |x|, at most 1: how much the force turns with the slip
    wide_scalar torsion;  ///< sign of the torsion; 0: it carries nothing
};

struct DirectManifold {
    wide_scalar mu, radius;      ///< m; |torsion| <= mu radius N
    SlideDirection slip;    ///< that sliding rows were factored with
    uint16_t position;      ///< block and lane: see manifold_at
    uint16_t body[2];       ///< of DirectBody
    uint16_t first;         ///< manifold of the island, the first that shares a body with this one
    uint16_t active_begin;  ///< the first of its active rows
    uint8_t rows;           ///< bit per row that exists
    uint8_t active;         ///< bit per row that is solved for
    uint8_t factored;       ///< the same of the matrix that is factored
    uint8_t sliding;        ///< bit per active row of friction and torsion that slides
    uint8_t pulls;          ///< bit per row that may have any sign
    uint8_t points;         ///< rows that are normals, 1 or 4 in a block
};

/// Motion: v_CM and L, or dp and dth. [0] is what cannot move.
struct DirectBody {
    DirectVector linear, angular;
    Sym3<wide_scalar> inv_I_world;
    DirectVector r_CM;
    wide_scalar inv_M;
    uint16_t body_i;  ///< of SolverBody
};

/// A row of the matrix of active rows, and of its factor.
struct DirectActive {
    wide_scalar inv_pivot;  ///< 0: the row depends on those before it, and takes nothing
    wide_scalar x;          ///< right-hand side, then solution
    uint32_t offset;   ///< of the first entry
    uint16_t begin;    ///< column of the first entry
    uint16_t row;      ///< of DirectRow
};

/// v_CM and L of a body with forces, before contacts.
struct FreeMotion {
    scalar v_CM[3], L[3];
};

/// Which contacts are solved together, and what became of it.
enum class IslandState : uint8_t {
    swept,
    chosen,  ///< to be solved
    solved,
    left_to_sweeps,  ///< chosen, but an impact leaves it to the sweeps for this substep
};

struct DirectView {
    DirectManifold* manifolds;
    DirectRow* rows;       ///< direct_rows of each manifold
    DirectActive* active;  ///< room for 6 of each manifold: at most three normals are active
    DirectBody* bodies;    ///< room for manifold_capacity + 2
    wide_scalar* entries;       ///< of the matrix, row by row from the first that is not zero
    int manifold_capacity, entry_capacity;

    FreeMotion* free_motion;  ///< by solver body
    IslandState* state;       ///< by island
    uint16_t* local;          ///< by solver body: of DirectBody
    uint8_t* unsettled;       ///< by record: steps in a row that ended with sweeps at their bound

    int manifold_count, body_count, active_count, entry_count;  ///< of the island at hand
    int loaded_island;                                          ///< -1: none
    bool some_chosen;  ///< of the batch
    bool factored, some_slide;
    bool paid;      ///< the factor at hand has been taken from work_left in this attempt
    bool uneven;    ///< bodies of limits::direct_mass_ratio touch
    int work_left;  ///< multiplications that the attempt at hand may still spend on factors; see limits::direct_work_max
};

} }  // namespace ingot

#pragma GCC diagnostic pop
