// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/manifold.h"

namespace ingot { inline namespace INGOT_ABI {

/// What is noted of a manifold during a step.
struct ImpactNote {
    scalar speed;   ///< m/s, of the fastest point when it meets the other body, if it does; 0: none approaches
    uint8_t point;  ///< of the manifold
    bool carried;   ///< a point gave an impulse in some substep
};

/// By members, as write_pair: a note has a gap.
INGOT_INLINE void write_note(ImpactNote& to, const ImpactNote& note) {
    to.speed = note.speed;
    to.point = note.point;
    to.carried = note.carried;
}

/// What a manifold gave in all substeps of a step: A gets it, B the opposite.
struct ImpulseSum {
    scalar j[Manifold::points_max];  ///< N s, along n at the points
    Vector friction;                 ///< N s, world
};

/// Where a step notes what contacts do.
struct StepNotes {
    ImpactNote* impacts = nullptr;  ///< by manifold: who pushed whom; null in scenes without events
    ImpulseSum* sums = nullptr;     ///< by record; null in scenes that do not name reads_contacts
};

} }  // namespace ingot
