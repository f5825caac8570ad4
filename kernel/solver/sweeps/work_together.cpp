// SPDX-License-Identifier: MIT
#include "work_together.h"

#include "order_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Index first_manifold(const SolverView& view, const Visit& visit) {
    int lane_i = 0;
    while ((visit.lane_bits >> lane_i & 1u) == 0) ++lane_i;  // bound: lanes: a visit has one lane or more
    return view.blocks[visit.block].manifold[lane_i];
}

/// Of one level and colour; beyond the last colour each is by itself.
bool are_of_one_group(const SolverView& view, const Visit& a, const Visit& b) {
    const Index of_a = first_manifold(view, a), of_b = first_manifold(view, b);
    return view.level[of_a] == view.level[of_b] && view.colour[of_a] == view.colour[of_b] && view.colour[of_a] < contact_colours;
}

}  // namespace

WorkTogether::Groups WorkTogether::list_groups(const SolverView& view, const Visit* visits, int count, Index* ends) {
    int group_count = 0;
    for (int visit_i = 1; visit_i <= count; ++visit_i)  // bound: max_manifolds
        if (visit_i == count || !are_of_one_group(view, visits[visit_i - 1], visits[visit_i])) ends[group_count++] = static_cast<Index>(visit_i);
    return {visits, ends, group_count};
}

bool WorkTogether::has_large_groups(const Groups& groups) const {
    int in_large = 0;
    for (int group = 0; group < groups.count; ++group) {  // bound: max_manifolds
        const TaskRange range = groups.range(group);
        if (range.end - range.begin >= 2 * run_.least_visits) in_large += range.end - range.begin;
    }
    return 4 * in_large >= 3 * groups.visit_count();
}

void WorkTogether::begin_batch(const SolverView& view) {
    visit_groups_ = list_groups(view, view.visits, view.visit_count, ends_of_visits_).count;
    shares_ = view.visit_count >= 2 * limits::tasks_worth_share * run_.least_visits && has_large_groups(groups_of_all(view));
}

} }  // namespace ingot
