// SPDX-License-Identifier: MIT
// Schemes for bodies in a force field. A scene names one: `using flight = BlanesMoan4;`.
//
// A scheme is a struct with
//     static constexpr const char* name;
//     static constexpr int order;
//     static constexpr bool takes_velocities;   // fields may depend on velocity
//     template <class Rotation, class Field>
//     static int fly(const BodyView&, const Forcing<Field>&, scalar h, const FlightClock&);   // bodies whose turn was clamped
// that advances r_CM, v_CM, A and L over one step, with gravity, F_T, tau_T and the field.
#pragma once

#include "forced_tile.h"
#include "integrate_r.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// v_CM and L after h seconds at a place that does not change; explicit midpoint where the field depends on them.
template <class Field>
void kick(const BodyView& bodies, const Forcing<Field>& forcing, scalar h, scalar t) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        const ForcedTile tile(bodies, tile_i);
        const TileState from = tile.state();
        Kick rates = tile.kick_at(from, t, forcing);
        if constexpr (Field::depends_on_velocity) {
            const lane half = splat<lane>(h * scalar(0.5));
            rates = tile.kick_at({from.r_CM, from.v_CM + rates.a * half, from.A, from.L + rates.tau * half}, t, forcing);
        }
        tile.store_velocities(from, rates, h);
    }
}

/// Free flight of h seconds: the scene's rotation method, and r_CM.
template <class Rotation>
int drift(const BodyView& bodies, scalar h, const FlightClock& clock) {
    if (bodies.translation != nullptr) drift_r(bodies, h);
    return Rotation::integrate_A(bodies, h, clock);
}

/// Half a kick, free flight with the scene's rotation method, half a kick.
///
/// Order:   2; time-reversible and, for a field that is a potential, without drift in energy. Exact for free bodies and for
///          uniform gravity.
/// Cost:    the free step and 2 evaluations of the field, 4 where it depends on velocity.
/// Source:  Strang 1968; for rigid bodies Celledoni, Fasso, Safstrom, Zanna 2008.
struct KickDriftKick {
    static constexpr const char* name = "kick_drift_kick";
    static constexpr int order = 2;  ///< of the error in h
    static constexpr bool takes_velocities = true;

    template <class Rotation, class Field>
    static int fly(const BodyView& bodies, const Forcing<Field>& forcing, scalar h, const FlightClock& clock) {
        const scalar half = h * scalar(0.5);
        kick(bodies, forcing, half, scalar(0));
        const int clamped = drift<Rotation>(bodies, h, clock);
        kick(bodies, forcing, half, h);
        return clamped;
    }
};

/// Seven kicks and six free flights, some of them backward, weighted for order 4 and small error.
///
/// Order:   4, as high as the rotation method has it: name one of order 4 or more. Time-reversible and, for a field that is a
///          potential, without drift in energy: the most accurate scheme per cost for smooth fields at rest in time.
/// Needs:   a field that does not depend on velocity.
/// Cost:    6 free steps and 7 evaluations of the field.
/// Source:  Blanes and Moan 2002, table 2, SRKN 6 stages, order 4 (b).
struct BlanesMoan4 {
    static constexpr const char* name = "blanes_moan_4";
    static constexpr int order = 4;  ///< of the error in h
    static constexpr bool takes_velocities = false;

    template <class Rotation, class Field>
    static int fly(const BodyView& bodies, const Forcing<Field>& forcing, scalar h, const FlightClock& clock) {
        constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486, b4 = 1 - 2 * (b1 + b2 + b3);
        constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
        constexpr scalar kicks[4] = {scalar(b1), scalar(b2), scalar(b3), scalar(b4)}, drifts[3] = {scalar(a1), scalar(a2), scalar(a3)};
        constexpr scalar times[7] = {0, scalar(a1), scalar(a1 + a2), scalar(0.5), scalar(0.5 + a3), scalar(1 - a1), 1};  // of the kicks
        constexpr int stages = 6;

        const FlightClock of_stage{clock.steps, 1};
        int clamped = 0;
        for (int stage_i = 0; stage_i <= stages; ++stage_i) {
            kick(bodies, forcing, h * kicks[stage_i <= 3 ? stage_i : stages - stage_i], h * times[stage_i]);
            if (stage_i == stages) break;
            forget_energies(bodies);
            const int clamped_here = drift<Rotation>(bodies, h * drifts[stage_i < 3 ? stage_i : stages - 1 - stage_i], of_stage);
            clamped = clamped_here > clamped ? clamped_here : clamped;
        }
        return clamped;
    }
};

/// The Runge-Kutta scheme of order 4 for rotations: each stage turns A by the exponentials of weighted angular velocities.
/// v_CM, r_CM and L go by the classical scheme. The scene's rotation method is not used.
///
/// Order:   4, for every field. Energy drifts with h^5 a step.
/// Valid:   to limits::forced_substeps_max limits::angle_per_forced_substep, 4 rad a step: a body that spins faster than the second in a step takes
///          2, 4 ... substeps. One that turns further still counts as clamped: A stays a rotation, and what it turns is wrong.
/// Error:   with the fourth power of the turn of a substep. A top that turns by 170 rad is 2e-3 rad off where that is 1/4 rad, and 5e-5 rad
///          where it is 1/8; BlanesMoan4 is 1e-9 off at half a radian a step.
/// Cost:    4 evaluations of the field, about 620 flops and 40 divisions a body and substep; bodies of a tile that take other
///          numbers of substeps add theirs.
/// Source:  Celledoni, Marthinsen, Owren 2003, "Commutator-free Lie group methods".
struct CommutatorFree4 {
    static constexpr const char* name = "commutator_free_4";
    static constexpr int order = 4;  ///< of the error in h
    static constexpr bool takes_velocities = true;

    template <class Rotation, class Field>
    static int fly(const BodyView& bodies, const Forcing<Field>& forcing, scalar h, const FlightClock& clock) {
        const bool polar_step = clock.steps % limits::polar_interval == 0;
        int clamped = 0;
        for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
            const ForcedTile tile(bodies, tile_i);
            CompensationTile* const compensation = bodies.compensation != nullptr ? &bodies.compensation[tile_i] : nullptr;
            clamped += fly_in_substeps(tile, compensation, forcing, h, polar_step);
        }
        return clamped;
    }

private:
    /// Rates of the whole state.
    struct Slope {
        Vec3<lane> v, omega;
        Kick kick;
    };

    template <class Field>
    INGOT_INLINE static Slope slope_at(const ForcedTile& tile, const TileState& at, scalar t, const Forcing<Field>& forcing) {
        return {at.v_CM, spin_of(at.A, tile.inv_I_body, at.L), tile.kick_at(at, t, forcing)};
    }

    INGOT_INLINE static Mat3<lane> turned(const Mat3<lane>& A, const Vec3<lane>& angle) { return A + world_turn(A, rodrigues(angle)); }

    /// The state t seconds from `from` at a constant slope, but for A.
    INGOT_INLINE static TileState moved(const TileState& from, const Slope& slope, scalar t, const Mat3<lane>& A) {
        const lane step = splat<lane>(t);
        return {from.r_CM + slope.v * step, from.v_CM + slope.kick.a * step, A, from.L + slope.kick.tau * step};
    }

    /// Each body takes the substeps of its own spin, whatever the others of its tile take. Returns how many spin faster than the most are for.
    template <class Field>
    static int fly_in_substeps(const ForcedTile& tile, CompensationTile* compensation, const Forcing<Field>& forcing, scalar h, bool polar_step) {
        const lane angle_sq = length_sq(spin_of(load(tile.rotation.A), tile.inv_I_body, load(tile.rotation.L))) * splat<lane>(h * h);
        uint16_t waiting = all_lanes;
        scalar limit = limits::angle_per_forced_substep;
        // bound: log2(limits::forced_substeps_max): most doubles
        for (int most = 1;; most *= 2, limit *= 2) {
            const uint16_t further = static_cast<uint16_t>(waiting & bits(angle_sq > splat<lane>(limit * limit)));
            const bool is_last = further == 0 || most == limits::forced_substeps_max;
            const uint16_t mine = is_last ? waiting : static_cast<uint16_t>(waiting & ~further);
            const scalar part = h / static_cast<scalar>(most);
            // bound: limits::forced_substeps_max
            for (int substep_i = 0; mine != 0 && substep_i < most; ++substep_i)
                fly_tile(tile, compensation, forcing, part, part * static_cast<scalar>(substep_i), polar_step, mask_from_bits(mine));
            if (is_last) return count_bits(further);
            waiting = further;
        }
    }

    /// The bodies that are `mine`, from t seconds after the begin of the step.
    template <class Field>
    INGOT_INLINE static void fly_tile(const ForcedTile& tile, CompensationTile* compensation, const Forcing<Field>& forcing, scalar h, scalar t,
                                      bool polar_step, mask mine) {
        const scalar half = h * scalar(0.5);
        const lane step = splat<lane>(h), half_step = splat<lane>(half), twelfth = splat<lane>(h / 12), sixth = splat<lane>(h / 6);
        const lane two = splat<lane>(2), three = splat<lane>(3);
        const TileState from = tile.state();

        const Slope k1 = slope_at(tile, from, t, forcing);
        const Mat3<lane> A_2 = turned(from.A, k1.omega * half_step);
        const Slope k2 = slope_at(tile, moved(from, k1, half, A_2), t + half, forcing);
        const Slope k3 = slope_at(tile, moved(from, k2, half, turned(from.A, k2.omega * half_step)), t + half, forcing);
        const Slope k4 = slope_at(tile, moved(from, k3, h, turned(A_2, k3.omega * step - k1.omega * half_step)), t + h, forcing);

        const auto mean = [&](const Vec3<lane>& a, const Vec3<lane>& b, const Vec3<lane>& c, const Vec3<lane>& d) {
            return ((a + d) + (b + c) * two) * sixth;
        };
        const Vec3<lane> middle = (k2.omega + k3.omega) * two;
        const Mat3<lane> first = world_turn(from.A, rodrigues((k1.omega * three + middle - k4.omega) * twelfth));
        const Mat3<lane> second = world_turn(from.A + first, rodrigues((k4.omega * three + middle - k1.omega) * twelfth));

        const Kick kick{mean(k1.kick.a, k2.kick.a, k3.kick.a, k4.kick.a), mean(k1.kick.tau, k2.kick.tau, k3.kick.tau, k4.kick.tau)};
        store_L(tile, from.L, kick.tau, mine);  // the means have h in them
        store_A(tile, compensation, from.A, first + second, polar_step, mine);
        if (tile.translation == nullptr) return;
        TranslationTile& to = *tile.translation;
        store_if_within(limits::speed_runaway, to.v_CM, select(mine, from.v_CM + kick.a, from.v_CM), to.bad);
        const Vec3<lane> r = from.r_CM + mean(k1.v, k2.v, k3.v, k4.v);
        store_if_within(limits::position_max, to.r_CM, select(mine, r, from.r_CM), to.bad);
    }

    INGOT_INLINE static void store_L(const ForcedTile& tile, const Vec3<lane>& L, const Vec3<lane>& kick, mask mine) {
        RotationTile& to = tile.rotation;
        const mask kicked = both(mine, abs(kick.x) + abs(kick.y) + abs(kick.z) > lane{});
        store_if_within(scalar_max, to.L, select(mine, L + kick, L), to.bad);
        to.kicked = static_cast<uint16_t>(to.kicked | bits(kicked));
    }

    INGOT_INLINE static void store_A(const ForcedTile& tile, CompensationTile* compensation, const Mat3<lane>& A, const Mat3<lane>& turn,
                                     bool polar_step, mask mine) {
        Mat3<lane> A_next = A, A_low{};
        if (compensation != nullptr) A_low = load(compensation->A_low);
        const Mat3<lane> A_low_before = A_low;
        add_compensated(A_next, A_low, turn);
        const mask good = is_finite(select(mine, A_next, A));
        const Mat3<lane> correction = polar_step ? polar_correction(A_next) : Mat3<lane>{};
        const mask moved = both(good, tile.movable);
        if (compensation != nullptr)
            store(compensation->A_low, select(mine, select(moved, A_low + correction, Mat3<lane>{}), A_low_before));
        else
            A_next = A_next + correction;
        store(tile.rotation.A, select(both(mine, moved), A_next, A));
        mark_bad(tile.rotation.bad, good);
    }
};

/// F_T and tau_T += what the field gives `ahead` seconds from the begin of the step: for steps that take forces as constant. With
/// ahead = h/2 the step is of second order, with 0 it is that of Listing 1.
template <class Field>
INGOT_INLINE void add_field_forces_to(const BodyView& bodies, int tile_i, const Forcing<Field>& forcing, scalar ahead) {
    const ForcedTile tile(bodies, tile_i);
    TileState at = tile.state();
    if (ahead > 0) {
        Kick kick{};
        if constexpr (Field::depends_on_velocity) kick = tile.kick_at(at, scalar(0), forcing);
        at = predicted(at, kick, tile.inv_I_body, ahead);
    }
    const Wrench wrench = tile.wrench_at(at, ahead, forcing);
    store_if_within(scalar_max, tile.rotation.tau_T, tile.tau_T + wrench.tau, tile.rotation.bad);
    if (tile.translation != nullptr) store_if_within(scalar_max, tile.translation->F_T, tile.F_T + wrench.F, tile.translation->bad);
}
template <class Field>
void add_field_forces(const BodyView& bodies, const Forcing<Field>& forcing, scalar ahead) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) add_field_forces_to(bodies, tile_i, forcing, ahead);
}

} }  // namespace ingot

#pragma GCC diagnostic pop
