// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"
#include "status.h"

namespace ingot { inline namespace INGOT_ABI {

/// Counts n more; a counter that is full stays full, and never begins anew.
constexpr void count(uint16_t& counter, int n = 1) {
    constexpr int full = 65535;
    counter = static_cast<uint16_t>(n > full - counter ? full : counter + n);
}

/// What the direct solver did in a step: bits of StepReport::direct, which take no room of their own there.
struct DirectBits {
    static constexpr uint8_t solved = 1;      ///< an island
    /// what it found for an island did not settle, or would have taken too much room or work: the sweeps stand
    static constexpr uint8_t unfinished = 2;
    /// an island has more contacts than there is room for: raise max_island of HybridIslands. Sweeps solve it
    static constexpr uint8_t refused = 4;
};

/// What a step has to say. Nothing is lost silently: a full array, a body taken out of the motion, an iteration that
/// stopped at its bound each have a count here, which stops at 65535.
struct [[nodiscard]] StepReport {
    Status status{};             ///< bad_step: the step was refused and nothing has changed
    uint8_t direct{};            ///< DirectBits

    uint16_t bodies_frozen{};    ///< driven out of range in this step: they stand still, see World::is_frozen
    /// turned by the largest angle a step allows instead of omega h, or, by CommutatorFree4, further than its substeps are right for: lower h
    uint16_t spins_clamped{};
    uint16_t contacts{};         ///< contacts found
    /// no room: raise Scene::max_manifolds, or max_contacts in a scene of impacts without friction; pairs_lost are among them
    uint16_t contacts_lost{};
    uint16_t pairs_lost{};       ///< of contacts_lost, pairs whose bounds overlap: raise Scene::max_pairs
    uint16_t pairs_untested{};   ///< pairs of shapes that overlap by their bounds, and for which the kernel has no test yet
    uint16_t impact_waves{};     ///< rounds of simultaneous impacts that were resolved
    /// contacts still approaching after limits::impact_waves_max or impacts_of_contact, fast bodies that wait for the next step where they met
    /// something
    uint16_t impacts_deferred{};
    uint16_t sweeps{};           ///< sweeps over contacts in all substeps: the most that an island took
    uint16_t overlaps_lost{};    ///< bodies in a sensor, and no room: raise Scene::max_overlaps
    scalar residual{};           ///< m/s; the largest speed that the last sweep over manifolds still corrected
    uint16_t sweeps_unfinished{};  ///< solves that stopped at limits::contact_sweeps_max
    uint16_t events_lost{};      ///< no room: raise Scene::max_events

    /// True when the step did all it was asked for, in full.
    constexpr bool clean() const {
        return status == Status::ok && bodies_frozen == 0 && spins_clamped == 0 && contacts_lost == 0 &&
               pairs_untested == 0 && impacts_deferred == 0 && sweeps_unfinished == 0 &&
               overlaps_lost == 0 && events_lost == 0 && (direct & DirectBits::refused) == 0;
    }
};

/// An island tells how many sweeps it took, and what the last of them still corrected: the most count.
inline void note_sweeps(StepReport& report, int sweeps, scalar residual) {
    if (sweeps > report.sweeps) report.sweeps = static_cast<uint16_t>(sweeps < 65535 ? sweeps : 65535);
    if (residual > report.residual) report.residual = residual;
}

} }  // namespace ingot
