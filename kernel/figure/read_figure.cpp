// SPDX-License-Identifier: MIT
#include "read_figure.h"

#include "../body/energy_momentum.h"

namespace ingot { inline namespace INGOT_ABI {

void mark_figure(const BodyView& bodies, const JointLists& lists, Index slot, const FigureMarks& marks) {
    int count = 0;
    const auto add = [&](Index other) {
        if (other == no_body || !is_dynamic(bodies, other) || marks.has(other)) return;
        marks.set(other);
        marks.room[count++] = other;
    };
    add(slot);
    for (int i = 0; i < count; ++i)  // bound: max_bodies: each is added once
        lists.for_ends(marks.room[i], [&](int end) { add(lists.partner_of(end)); });
}

FigureInfo figure_of(const BodyView& bodies, const FigureMarks& marks, int slots) {
    FigureInfo figure{};
    const auto for_marked = [&](const auto& each) {
        for (int slot = 0; slot < slots; ++slot)  // bound: max_bodies
            if (marks.has(slot)) each(slot);
    };
    const auto mass_of = [&](int slot) { return 1 / bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane]; };
    Vector first{}, sum{};  // from the first body: far from the origin no digits are lost
    for_marked([&](int slot) {
        if (figure.body_count++ == 0) first = r_CM_of(bodies, slot);
        const scalar M = mass_of(slot);
        figure.mass += M;
        sum = sum + (r_CM_of(bodies, slot) - first) * M;
        figure.p = figure.p + linear_momentum_of(bodies, slot);
        figure.kinetic_energy += kinetic_energy_of(bodies, slot);
    });
    if (figure.body_count == 0) return figure;
    const Vector centre = sum * (1 / figure.mass);
    figure.r_CM = first + centre;
    figure.v_CM = figure.p * (1 / figure.mass);
    for_marked([&](int slot) {
        const Place at = place_of(slot);
        const Vector v = lane_of(bodies.translation[at.tile].v_CM, at.lane) - figure.v_CM;
        const Vector arm = (r_CM_of(bodies, slot) - first) - centre;
        figure.L = figure.L + lane_of(bodies.rotation[at.tile].L, at.lane) + cross(arm, v * mass_of(slot));
    });
    return figure;
}

} }  // namespace ingot
