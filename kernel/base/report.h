// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"
#include "status.h"

namespace ingot { inline namespace INGOT_ABI {

/// Counts n more; a counter that is full stays full, and never begins anew.
constexpr void count(Index& counter, int n = 1) {
    constexpr int full = index_max;
    counter = static_cast<Index>(n > full - counter ? full : counter + n);
}

/// What the direct solver did in a step: bits of StepReport::direct, which take no room of their own there.
struct DirectBits {
    static constexpr uint8_t solved = 1;      ///< an island
    /// what it found for an island did not settle, or would have taken too much room or work: the sweeps stand
    static constexpr uint8_t unfinished = 2;
    /// an island has more contacts than there is room for: raise max_island of HybridIslands. Sweeps solve it
    static constexpr uint8_t refused = 4;
};

/// What the energy-momentum step did: bits of StepReport::figures.
struct FigureBits {
    static constexpr uint8_t halved = 1;  ///< the step of a figure was cut: it turned far, or passes found no end
    /// passes found no end for the finest parts of the step of a figure: the substeps took it. It counts in sweeps_unfinished
    static constexpr uint8_t unsolved = 2;
    static constexpr uint8_t left_to_substeps = 4;  ///< one closes loops, has joints that the scheme has no rows for, or was put apart
};

/// What a step has to say. Nothing is lost silently: a full array, a body taken out of the motion, an iteration that
/// stopped at its bound each have a count here, which stops at 65535.
struct [[nodiscard]] StepReport {
    Status status{};             ///< bad_step: the step was refused and nothing has changed
    uint8_t direct{};            ///< DirectBits
    uint8_t figure_passes{};     ///< of the energy-momentum step: the most that a figure took in one try, 255: or more
    uint8_t figures{};           ///< FigureBits

    Index bodies_frozen{};    ///< driven out of range in this step: they stand still, see World::is_frozen
    /// turned by the largest angle a step allows instead of omega h, or, by CommutatorFree4, further than its substeps are right for: lower h
    Index spins_clamped{};
    Index contacts{};         ///< contacts found
    /// no room: raise Scene::max_manifolds, or max_contacts in a scene of impacts without friction, to what World::room_needed says; pairs_lost are
    /// among them. Who meets what cannot move is kept first, then who is deepest. The others do not fall: they are stopped, one by one and without
    /// the others in view, see impulse/hold_apart.h. In such a step nothing ends deeper in a fixed shape than limits::touching_gap, and bodies sink
    /// into each other by what gravity moves them in a few steps, or slide off; they do not sleep. Without friction nothing takes overlap back: there
    /// they end a few times deeper than they come in one step. With holds_crowds = false they fall
    Index contacts_lost{};
    Index pairs_lost{};       ///< of contacts_lost, pairs whose bounds overlap: raise Scene::max_pairs
    Index pairs_untested{};   ///< pairs of shapes that overlap by their bounds, and for which the kernel has no test yet
    Index impact_waves{};     ///< rounds of simultaneous impacts that were resolved
    /// contacts still approaching after limits::impact_waves_max or impacts_of_contact, or that bounce no more, as they have had half of that many or
    /// of limits::impacts_in_step_max; contacts that have had limits::impact_visits_max visits; fast bodies that wait for the next step where they
    /// met something
    Index impacts_deferred{};
    Index sweeps{};           ///< sweeps over contacts in all substeps: the most that an island took
    Index overlaps_lost{};    ///< bodies in a sensor, and no room: raise Scene::max_overlaps
    /// that close loops, which hold nothing in this step: a body that was frozen may make more of them than World::add_joint saw
    Index joints_lost{};
    /// m/s; the largest speed that the last sweep over manifolds still corrected; of a direct solve what the grain of its
    /// impulses is worth, where that is more than limits::unsettled_speed
    scalar residual{};
    /// islands that were not settled when their sweeps were over: of up to limits::small_island manifolds, where the last sweep corrected more than
    /// limits::unsettled_speed and a thousandth of what gravity gives in a substep; of more, which settle over many steps, where it corrected more
    /// than all of that. They carry what sweeps do not, or are being hit: see HybridIslands. Of impacts without friction: solves that stopped at
    /// limits::contact_sweeps_max
    Index sweeps_unfinished{};
    Index events_lost{};      ///< no room: raise Scene::max_events

    /// True when the step did all it was asked for, in full.
    constexpr bool clean() const {
        return status == Status::ok && bodies_frozen == 0 && spins_clamped == 0 && contacts_lost == 0 &&
               pairs_untested == 0 && impacts_deferred == 0 && sweeps_unfinished == 0 &&
               overlaps_lost == 0 && joints_lost == 0 && events_lost == 0 && (direct & DirectBits::refused) == 0;
    }
};

inline void note_figures(StepReport& report, uint8_t bits) { report.figures = static_cast<uint8_t>(report.figures | bits); }

/// How much room a world needed: each number is of the trait of its name, which is large enough with it. At least as many: up to 65535 that are lost
/// in a step are counted.
///
///     ingot::RoomNeeded most;
///     ...
///     const ingot::StepReport report = ingot::step(world, h);
///     most.raise(world.room_needed(report));   // in the end: what to set the traits to, if anything was lost
struct RoomNeeded {
    int32_t max_pairs{}, max_manifolds{}, max_contacts{}, max_overlaps{}, max_events{};  ///< of the trait of that name

    /// Each number is raised to that of the other, where that is greater: the high-water mark of both.
    constexpr void raise(const RoomNeeded& other) {
        if (other.max_pairs > max_pairs) max_pairs = other.max_pairs;
        if (other.max_manifolds > max_manifolds) max_manifolds = other.max_manifolds;
        if (other.max_contacts > max_contacts) max_contacts = other.max_contacts;
        if (other.max_overlaps > max_overlaps) max_overlaps = other.max_overlaps;
        if (other.max_events > max_events) max_events = other.max_events;
    }
};

/// An island tells how many sweeps it took, and what the last of them still corrected: the most count. `settled`, m/s: with more it is unfinished.
inline void note_sweeps(StepReport& report, int sweeps, scalar residual, scalar settled) {
    if (!(residual <= settled)) count(report.sweeps_unfinished);
    if (sweeps > report.sweeps) report.sweeps = static_cast<Index>(sweeps < index_max ? sweeps : index_max);
    if (residual > report.residual) report.residual = residual;
}

} }  // namespace ingot
