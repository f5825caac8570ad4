// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a rotation method knows of the steps before this one.
///
/// A method is a struct that a scene names, `using rotation = ...`, with
///     static constexpr const char* name;
///     static constexpr bool as_printed;      // Listing 1: every right-hand side is of step n
///     static constexpr bool compensates;     // keeps A_low, 9 numbers a body
///     static constexpr bool returns_energy;  // keeps E_0, 1 number a body
///     static int integrate_A(const BodyView&, scalar h, const FlightClock&);   // bodies whose turn was clamped
/// integrate_A turns every body as it would turn freely, for h seconds, with the angular momentum L - kick_ahead tau_T. After
/// an integrate_L of the whole step, kick_ahead = h/2 makes that the L of mid-step, and the driven step kick-drift-kick, of
/// second order. It keeps L bitwise. h may be negative: compositions go back and forth. A body whose A would not be finite,
/// or whose spin passes limits::spin_runaway, keeps its A and is marked bad.
struct FlightClock {
    uint32_t steps;          ///< taken so far; the polar step is due every limits::polar_interval of them
    scalar energy_unit = 1;  ///< (h / h_1)^2: energies are kept in units of the first step's h_1, whatever h is now
    scalar kick_ahead = 0;   ///< s
};

/// integrate_A of a method in a step with contacts: some have one for it, which has the same bits.
template <class Rotation>
auto turn_beside_contacts(const BodyView& bodies, scalar h, const FlightClock& clock, int)
    -> decltype(Rotation::integrate_A_beside_contacts(bodies, h, clock)) {
    return Rotation::integrate_A_beside_contacts(bodies, h, clock);
}
template <class Rotation>
int turn_beside_contacts(const BodyView& bodies, scalar h, const FlightClock& clock, long) {
    return Rotation::integrate_A(bodies, h, clock);
}
template <class Rotation>
int turn_beside_contacts(const BodyView& bodies, scalar h, const FlightClock& clock) {
    return turn_beside_contacts<Rotation>(bodies, h, clock, 0);
}

/// The next flight of all bodies begins anew, in units of its own: for compositions of flights of many lengths.
inline void forget_energies(const BodyView& bodies) {
    if (bodies.energy == nullptr) return;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) bodies.energy[tile_i] = {};  // bound: max_bodies / lanes, rounded up
}

} }  // namespace ingot
