// SPDX-License-Identifier: MIT
#pragma once

#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// One point where two bodies touch: geometry from find_contacts, the row from contact_rows, its impulse from solve_impacts or
/// solve_contact_forces.
///
/// A and B are body slots, n points from B to A. With k = inv_I_world (r x n) and symmetric inertia, n.(omega x r) = L.k:
/// a row reads v_CM and L, and writes v_CM and L, and needs neither omega nor a gyroscopic term.
struct Contact {
    Index body_A, body_B;
    bool active;         ///< takes part in the solve at hand
    Vector n;            ///< unit normal, from B to A
    Vector lever_A;      ///< r_AP x n, m; exactly zero for a sphere, whose normal passes through its centre
    Vector lever_B;      ///< r_BP x n, m
    scalar separation;   ///< m; negative where the shapes overlap
    scalar e;            ///< restitution of the pair
    Vector k_A, k_B;     ///< inv_I_world lever; zero for an immovable body
    scalar inv_K;        ///< kg; inverse of the denominator of Hecker 1997, Fig. 4
    scalar target;       ///< m/s; the solve at hand makes n.(v_AP - v_BP) at least this
    scalar tolerance;    ///< m/s; the rounding of n.(v_AP - v_BP)
    scalar j;            ///< N s; of the solve at hand
    scalar change;       ///< N s; of j in the sweep at hand
    scalar direction;    ///< N s; conjugate direction of the solve at hand
    scalar j_total;      ///< N s; given in this step
};

/// The contacts of a step, without their capacity.
struct ContactView {
    Contact* contacts;
    Index* count;
    int capacity;
};

} }  // namespace ingot
