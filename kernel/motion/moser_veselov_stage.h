// SPDX-License-Identifier: MIT
// The preprocessed discrete Moser-Veselov step in lanes, compiled once for each order (moser_veselov_<order>.cpp).
//
//   y = h scale A^T L             body-frame angular momentum, made free of units
//   c = tan(angle/2) axis         Rodrigues vector of the turn within the step, body frame
//   c = (1 + c.c) q + k (c2 c3, c3 c1, c1 c2)         a fixed point, q and k from the modified inertia
//   A += A (R(c) - 1),  R(c) - 1 = 2/(1 + c.c) (tilde(c) + tilde(c) tilde(c))
//
// A += A (R - 1) with the increment formed directly is 10 to 100 times better in float than A = A R, whose R rounds
// beside 1.
#pragma once

#include "../base/checks.h"
#include "moser_veselov.h"
#include "moser_veselov_series.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

/// modified_inertia, with fewer terms for bodies whose terms drown in rounding.
///
/// The series is one of |omega| h, written in the energy H: where a body spins about an axis of large moment beside a small
/// one (a needle end over end), H is far above (|omega| h)^2 and what counts is the small difference of large terms, of which
/// rounding leaves epsilon H^(order/2 - 1). From where that passes 0.01, what the terms are worth at |omega| h = 0.5, they
/// are left out, two orders at a time.
template <int order>
INGOT_INLINE ModifiedInertia<lane> trusted_modified_inertia(const Vec3<lane>& j, lane H, lane C) {
    ModifiedInertia<lane> modified = modified_inertia<order>(j, H, C);
    if constexpr (order > 2) {
        constexpr scalar H_max = scalar(order == 4 ? (INGOT_DOUBLE ? 4.5e13 : 8.4e4) : order == 6 ? (INGOT_DOUBLE ? 6.7e6 : 290)
                                      : order == 8 ? (INGOT_DOUBLE ? 3.5e4 : 43) : (INGOT_DOUBLE ? 2.6e3 : 17));
        const mask drowned = H > splat<lane>(H_max);
        if (any(drowned)) {
            const ModifiedInertia<lane> shorter = trusted_modified_inertia<order - 2>(j, H, C);
            modified = {select(drowned, shorter.S_minus_1, modified.S_minus_1), select(drowned, shorter.D, modified.D)};
        }
    }
    return modified;
}

/// The Rodrigues vector of the turn of a free body with body-frame momentum y (see the top of this file).
///
/// A lane leaves the loop when its c has settled, and keeps its bits while others go on.
template <int order>
INGOT_INLINE Vec3<lane> solve_turn(const Vec3<lane>& j, const Vec3<lane>& y, lane H, lane C) {
    const ModifiedInertia<lane> modified = trusted_modified_inertia<order>(j, H, C);
    const Vec3<lane> a = j + (j * modified.S_minus_1 + Vec3<lane>{modified.D, modified.D, modified.D});
    // (I2 - I3)/I1 of the modified moments, written without a difference of inverses: near-symmetric bodies lose nothing.
    const lane w = (modified.S_minus_1 + splat<lane>(1)) / (a.x * a.y * a.z);
    const Vec3<lane> k = scaled(scaled(a, a), Vec3<lane>{j.z - j.y, j.x - j.z, j.y - j.x} * w);
    const Vec3<lane> q = scaled(a, y) * splat<lane>(scalar(0.5));

    const lane tolerance = splat<lane>(epsilon / 4);
    Vec3<lane> c = q;
    mask unsettled = splat<lane>(1) > lane{};
    int sweeps_left = limits::sweeps_max;
    // bound: limits::sweeps_max: sweeps_left falls each turn
    do {
        const lane al = splat<lane>(1) + dot(c, c);
        const Vec3<lane> next = q * al + scaled(k, Vec3<lane>{c.y * c.z, c.z * c.x, c.x * c.y}), step = next - c;
        const lane change = abs(step.x) + abs(step.y) + abs(step.z);
        c = select(unsettled, next, c);
        unsettled = both(unsettled, change > tolerance * al);
    } while (any(unsettled) && --sweeps_left > 0);
    return c;
}

/// A tiny turn about y x (j y), which changes the energy and not L, that takes back a sixteenth of the energy's drift.
/// The damping makes it vanish for steady spin, where no turn changes the energy.
INGOT_INLINE Vec3<lane> turn_of_energy_return(const Vec3<lane>& y, const Vec3<lane>& w, lane e, lane e_0) {
    const Vec3<lane> x = cross(y, w);
    const lane damping = e * e * splat<lane>(scalar(1e-3)) + splat<lane>(scalar(1e-30));
    return x * ((e - e_0) * splat<lane>(scalar(1) / 16) / (length_sq(x) + damping));
}

/// The bodies of a tile in flight, in units of a substep.
///
/// A, A_low and L stay in memory while the turn is found: few cores have registers for all.
struct TileFlight {
    Vec3<lane> j;      ///< ratios of the inverse moments
    lane step;         ///< h scale of a substep: takes A^T L to y
    Vec3<lane> y, w;   ///< y and j y
    lane n;            ///< substeps of each body, a power of two
    int substeps;      ///< the most of them
    mask good;         ///< false where the spin has run away, or is NaN
    uint16_t clamped;  ///< bits of bodies that turn further than the most substeps reach
    bool driven;       ///< a torque acts: integrate_L has marked it

    /// Finds y, at the A that the tile has now. L is never -0, so that L less no torque is L to the bit.
    INGOT_INLINE void look_at(const RotationTile& tile, scalar kick_ahead) {
        Vec3<lane> L = load(tile.L);
        if (driven) L -= load(tile.tau_T) * splat<lane>(kick_ahead);
        y = transpose_times(load(tile.A), L) * step;
        w = scaled(j, y);
    }
};

/// Bodies that turn far within a step take substeps, 1, 2, 4 ... substeps_max, so that the square of no turn is more than angle_sq_max. A body that
/// turns further than the most of them reach is clamped: the rest of its turn is left out.
INGOT_PART void cut_into_substeps(TileFlight& flight, lane angle_sq, scalar h, int substeps_max, scalar angle_sq_max) {
    const lane one = splat<lane>(1);
    const scalar angle_max = limits::spin_runaway * h;
    flight.good = angle_sq <= splat<lane>(angle_max * angle_max);
    scalar limit_sq = angle_sq_max, doubled = 2;  // a power of four, and of two: what is made of them is exact
    // bound: log2(substeps_max): most doubles
    for (int most = 2; most <= substeps_max; most *= 2, doubled *= 2, limit_sq *= 4) {
        const mask beyond = angle_sq > splat<lane>(limit_sq);
        flight.n = select(beyond, splat<lane>(doubled), flight.n);
        if (any(beyond)) flight.substeps = most;
    }
    const mask clamped = both(flight.good, angle_sq > splat<lane>(limit_sq));
    lane fraction = one;  // of the step, in a substep
    if (any(clamped)) fraction = select(clamped, splat<lane>(sqrt(limit_sq)) / sqrt(select(clamped, angle_sq, one)), one);
    fraction = fraction / flight.n;
    flight.clamped = bits(clamped);
    flight.step = flight.step * fraction;
    flight.y = flight.y * fraction;
    flight.w = scaled(flight.j, flight.y);
}

INGOT_PART TileFlight begin_flight(const RotationTile& tile, scalar h, scalar kick_ahead, int substeps_max, scalar angle_sq_max) {
    TileFlight flight;
    flight.j = load(tile.inv_I_ratio);
    flight.driven = tile.kicked != 0;
    flight.step = load(tile.inv_I_scale) * splat<lane>(h);
    flight.look_at(tile, kick_ahead);
    flight.n = splat<lane>(1);
    flight.good = flight.n > lane{};
    flight.substeps = 1;
    flight.clamped = 0;
    const lane angle_sq = length_sq(flight.w);
    if (any(angle_sq > splat<lane>(angle_sq_max))) cut_into_substeps(flight, angle_sq, h, substeps_max, angle_sq_max);
    return flight;
}

/// The energy at the begin of this flight, in the units of a substep: n is a power of two, so the change is exact. 0 where it is not known.
INGOT_PART lane begin_energy(const EnergyTile& energy, const TileFlight& flight, scalar unit, uint16_t restarts) {
    lane e_0 = load(energy.E_0) * splat<lane>(unit);
    if (flight.substeps > 1) e_0 = e_0 / (flight.n * flight.n);
    if (restarts != 0) e_0 = select(mask_from_bits(restarts), lane{}, e_0);
    return e_0;
}

/// e_0, or where it was not known the energy H of now: it is kept, and stays to the bit. Converted back in every step it would walk by roundings.
INGOT_PART lane known_energy(EnergyTile& energy, const TileFlight& flight, scalar unit, lane e_0, lane H) {
    const mask known = e_0 > lane{};
    if (!any(opposite(known))) return e_0;
    store(energy.E_0, select(known, load(energy.E_0), H * (flight.n * flight.n) / splat<lane>(unit)));
    return select(known, e_0, H);
}

/// Turns the tile through its substeps. A body that does not come out of one is no longer good.
template <int order, bool compensate, bool energy_return>
INGOT_PART void turn_tile(const BodyView& bodies, int tile_i, const FlightClock& clock, TileFlight& flight, lane e_0) {
    RotationTile& tile = bodies.rotation[tile_i];
    mask good = flight.good, turning = good;
    scalar taken = 0;
    // bound: substeps_max: left at substep_i == substeps, a power of two up to that
    for (int substep_i = 1;; ++substep_i) {
        const lane H = dot(flight.y, flight.w) * splat<lane>(scalar(0.5)), C = length_sq(flight.y) * splat<lane>(scalar(0.5));
        Vec3<lane> c = solve_turn<order>(flight.j, flight.y, H, C);
        if constexpr (energy_return) {
            e_0 = known_energy(bodies.energy[tile_i], flight, clock.energy_unit, e_0, H);
            c += turn_of_energy_return(flight.y, flight.w, H, e_0);
        }
        c = select(turning, c, Vec3<lane>{});
        good = both(good, length_sq(c) <= splat<lane>(1));  // false for NaN too; a good turn has |c| near 1/4 or less
        if (!any(good)) break;
        c = select(good, c, Vec3<lane>{});
        // A body that left the range keeps its last good pose in every digit: none that waited in A_low enters.
        if constexpr (compensate)
            turn_body<true>(tile.A, bodies.compensation[tile_i].A_low, c, good);
        else
            turn_body<false>(tile.A, nullptr, c, good);

        if (substep_i == flight.substeps) break;
        taken += 1;
        turning = flight.n > splat<lane>(taken);
        flight.look_at(tile, clock.kick_ahead);
    }
    flight.good = good;
}

/// A polar step, of all bodies or of those that take substeps. An immovable body keeps its A to the bit.
template <bool compensate>
INGOT_PART void return_to_rotations(const BodyView& bodies, int tile_i, const TileFlight& flight, bool all) {
    RotationTile& tile = bodies.rotation[tile_i];
    const lane one = splat<lane>(1);
    const mask polar_due = both(both(flight.good, load(tile.inv_I_scale) > lane{}), all ? one > lane{} : flight.n > one);
    const Mat3<lane> A = load(tile.A), correction = select(polar_due, polar_correction(A), Mat3<lane>{});
    // With compensation the correction enters at the next step, with the digits it has.
    if constexpr (compensate)
        store(bodies.compensation[tile_i].A_low, load(bodies.compensation[tile_i].A_low) + correction);
    else
        store(tile.A, A + correction);
}

template <int order, bool compensate, bool energy_return, bool for_size>
int integrate_A_moser_veselov(const BodyView& bodies, scalar h, const FlightClock& clock, int substeps_max, scalar angle_sq_max) {
    INGOT_ASSERT(!compensate || bodies.compensation != nullptr);
    INGOT_ASSERT(!energy_return || bodies.energy != nullptr);
    const bool polar_step = clock.steps % limits::polar_interval == 0;
    int clamped_count = 0;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        TileFlight flight = begin_flight(tile, h, clock.kick_ahead, substeps_max, angle_sq_max);
        const uint16_t clamped = flight.clamped;
        if (clamped != 0) clamped_count += count_bits(clamped);

        // Bodies whose energy is to be taken anew.
        const uint16_t restarts = static_cast<uint16_t>(tile.kicked | clamped);
        lane e_0{};
        if constexpr (energy_return) e_0 = begin_energy(bodies.energy[tile_i], flight, clock.energy_unit, restarts);
        // A torque leaves L half a kick beyond the L of this drift: the energy of the flight after it is not known yet.
        if (restarts != 0) {
            const Vec3<lane> tau_T = load(tile.tau_T);
            tile.kicked = static_cast<uint16_t>(clamped | bits(abs(tau_T.x) + abs(tau_T.y) + abs(tau_T.z) > lane{}));
        }

        turn_tile<order, compensate, energy_return>(bodies, tile_i, clock, flight, e_0);
        mark_bad(tile.bad, flight.good);
        // Every polar_interval steps; every step where it has substeps.
        if (polar_step || flight.substeps > 1) return_to_rotations<compensate>(bodies, tile_i, flight, polar_step);
    }
    return clamped_count;
}

/// The four stages of one order that a library holds; the linker takes the one a scene names.
#define INGOT_MOSER_VESELOV_STAGES(order, for_size)                                                                                  \
    template int integrate_A_moser_veselov<order, false, false, for_size>(const BodyView&, scalar, const FlightClock&, int, scalar); \
    template int integrate_A_moser_veselov<order, false, true, for_size>(const BodyView&, scalar, const FlightClock&, int, scalar);  \
    template int integrate_A_moser_veselov<order, true, false, for_size>(const BodyView&, scalar, const FlightClock&, int, scalar);  \
    template int integrate_A_moser_veselov<order, true, true, for_size>(const BodyView&, scalar, const FlightClock&, int, scalar)

} }  // namespace ingot
