// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// One point where two bodies touch, or meet in the step: geometry from find_contacts, the row from contact_rows, its impulse from solve_impacts or
/// solve_contact_forces.
///
/// A and B are body slots, n points from B to A. With k = inv_I_world (r x n) and symmetric inertia, n.(omega x r) = L.k:
/// a row reads v_CM and L, and writes v_CM and L, and needs neither omega nor a gyroscopic term.
struct Contact {
    Index body_A, body_B;
    bool active : 1;     ///< takes part in the solve at hand
    bool aside : 1;      ///< of other bodies than the impact at hand
    bool touches : 1;    ///< since `when`; else its bodies are on their way
    bool is_new : 1;     ///< found, and no row yet
    bool at_hand : 1;    ///< it meets in the impact at hand
    uint8_t corner : 3;  ///< of a box: which; else 0
    uint8_t impacts;     ///< at different times of this step
    uint16_t visits;     ///< of solves, for impacts of this step
    Vector n;            ///< unit normal, from B to A
    Vector lever_A;      ///< r_AP x n, m; exactly zero for a sphere, whose normal passes through its centre
    Vector lever_B;      ///< r_BP x n, m
    scalar separation;   ///< m, as they meet; negative where the shapes overlap
    scalar when;         ///< s, from the begin of the step: of its impact to come, or since when it touches; limits::unbounded: neither
    scalar e;            ///< restitution of the pair
    Vector k_A, k_B;     ///< inv_I_world lever; zero for an immovable body
    scalar inv_K;        ///< kg; inverse of the denominator of Hecker 1997, Fig. 4
    scalar target;       ///< m/s; the solve at hand makes n.(v_AP - v_BP) at least this
    scalar tolerance;    ///< m/s; the rounding of n.(v_AP - v_BP)
    scalar j;            ///< N s; of the solve at hand
    scalar change;       ///< N s; of j in the sweep at hand
    scalar direction;    ///< N s; conjugate direction of the solve at hand
    scalar j_impact;     ///< N s; of the impact at hand
    scalar j_total;      ///< N s; given in this step
};

/// Whether a contact has had all the impacts of a step that it may have.
INGOT_INLINE bool stays(const Contact& c) { return c.impacts >= limits::impacts_in_step_max; }

/// Whether the impacts of a step have visited a contact as often as they may: they go on without it, and what presses as the step ends holds it.
INGOT_INLINE bool is_worn(const Contact& c) { return c.visits >= limits::impact_visits_max; }

INGOT_INLINE bool is_at_its_bound(const Contact& c) { return stays(c) || is_worn(c); }

/// The contacts of a step, without their capacity. Those of a pair stand together.
struct ContactView {
    Contact* contacts;
    Index* count;
    int capacity;
    Vector* places = nullptr;  ///< m, world, of each: see note_new_places; null: nobody asks
};

} }  // namespace ingot
