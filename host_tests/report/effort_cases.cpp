// SPDX-License-Identifier: MIT
// Compiled once, for float and 4 lanes.
#include "effort_cases.h"

#include <ingot/ingot.h>
#define scenes INGOT_JOIN(scenes_of_effort_, INGOT_ABI, )

#include "kernel_run.h"
#include "random_piles.h"
#include "scenes/contact/all_contact_scenes.h"

namespace report {

namespace {

/// One world for all scenes, so that a level of effort is compiled once.
template <int substeps, int sweeps>
struct AtEffort : ingot::Scene {
    static constexpr int max_bodies = 520;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4000, max_pairs = 16000;
    static constexpr ingot::Effort effort = {substeps, sweeps};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

constexpr bool is(const EffortLevel& level, const ingot::Effort& effort) {
    return level.substeps == effort.substeps && level.sweeps == effort.sweeps;
}
static_assert(is(effort_levels[0], ingot::low_effort) && is(effort_levels[1], {}) && is(effort_levels[3], ingot::high_effort));

template <class Placed, int level_i>
std::unique_ptr<ContactRun> begin_at() {
    constexpr EffortLevel level = effort_levels[level_i];
    return std::make_unique<KernelRun<Placed, AtEffort<level.substeps, level.sweeps>>>();
}

template <class Placed>
EffortCase effort_case(const char* name, bool in_quick_runs) {
    return {contact_case_of<Placed>(name), in_quick_runs,
            {begin_at<Placed, 0>, begin_at<Placed, 1>, begin_at<Placed, 2>, begin_at<Placed, 3>}};
}

}  // namespace

std::vector<EffortCase> effort_cases() {
    using namespace scenes;
    return {effort_case<Pyramid<10>>("pyramid_55", true),           effort_case<Pyramid<20>>("pyramid_210", true),
            effort_case<Pyramid<30>>("pyramid_465", false),         effort_case<SpherePile<8>>("pile_512", false),
            effort_case<RandomPile<8, 8, false>>("pile_boxes_512", true), effort_case<RandomPile<8, 8, true>>("pile_mixed_512", false),
            effort_case<Tower<20>>("tower_20", true)};
}

}  // namespace report
