// SPDX-License-Identifier: MIT
// Runs of a contact scene: one that is followed, and several that are timed side by side.
#pragma once

#include "contact_metrics.h"
#include "rows.h"

namespace report {

using BeginRun = std::function<std::unique_ptr<ContactRun>()>;

/// What the run of a scene shows when every step is looked at.
std::vector<Metric> followed(const ContactCase& scene, const BeginRun& begin, int rate, double seconds);

/// us per step of each run, in the later half of the time.
///
/// The runs take turns, a burst of steps each, so that whatever else the machine does meets all of them. CPU time of this
/// thread; NaN for a run whose bodies froze. Of each burst the least over the repetitions, of the bursts the median: as in the anchors.
std::vector<double> raced(const ContactCase& scene, const std::vector<BeginRun>& begins, int rate, double seconds,
                          int repetitions);

/// How far the velocities are from rest after some steps from a cold start, and what it took.
struct Approach {
    int steps;
    double us;        ///< CPU time of all of them
    double distance;  ///< m/s: sqrt(2 T / M), T the kinetic energy, M the mass of all bodies that move
};

/// At 1, 2, 4, ... 256 steps of 1/rate s.
std::vector<Approach> approach_to_rest(const ContactCase& scene, const BeginRun& begin, int rate);

/// Scenes that stand still from the first step on: whatever moves in them is the solver's error.
bool stands_still(const std::string& scene);

/// Rows of an approach: case "<scene>_steps_<n>", metrics distance_to_exact and us_since_start.
void add_approach(const std::vector<Approach>& approach, const Row& row, Rows& rows);

}  // namespace report
