// SPDX-License-Identifier: MIT
// Bodies with joints among those that a step follows. A figure goes the way that the step has found for it, and if one of its bodies meets what no
// contact of the step has seen to, all of it is taken back to that time and waits there for the next step, whose contacts find it touching.
#pragma once

#include "../figure/loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of scenes without joints.
struct NoFiguresOnPaths {
    static constexpr bool some_figures = false;
    static constexpr bool is_of_figure(int) { return false; }
};

/// The figures of what is awake, as their joints are after the step. Loops: LoopView, or NoLoops.
template <class Loops>
struct FiguresOnPaths {
    static constexpr bool some_figures = true;
    FigureView* figures;
    const Loops* loops;

    bool is_of_figure(int slot) const { return (figures->jointed[place_of(slot).tile] >> place_of(slot).lane & 1) != 0; }
    /// Of all figures that ties hold together the first.
    int machine_of(int figure_i) const {
        if constexpr (Loops::closes)
            if (loops->ties != nullptr) return loops->machine_of[figure_i];
        return figure_i;
    }
    int end_of_machine(int first) const {
        int end = first + 1;
        while (end < figures->figure_count && machine_of(end) == first) ++end;  // bound: max_bodies
        return end;
    }
    int machine_of_body(int slot) const { return machine_of(figures->nodes[figures->node_of[slot]].figure); }
    bool is_tied(int first) const { return figures->nodes[figures->figures[first].first_node].joint != no_joint; }

    /// Calls each(slot) for the bodies of a machine.
    template <class Each>
    void for_bodies_of(int first, const Each& each) const {
        const Figure& last = figures->figures[end_of_machine(first) - 1];
        // bound: max_bodies: the figures of a machine follow each other
        for (int node_i = figures->figures[first].first_node; node_i < last.first_node + last.node_count; ++node_i)
            each(static_cast<int>(figures->nodes[node_i].slot));
    }
    /// The same of the one that a body is of.
    template <class Each>
    void for_bodies_with(int slot, const Each& each) const {
        for_bodies_of(machine_of_body(slot), each);
    }
    /// Calls each(first figure) for all machines.
    template <class Each>
    void for_machines(const Each& each) const {
        // bound: max_bodies
        for (int first = 0; first < figures->figure_count; first = end_of_machine(first)) each(first);
    }
};

} }  // namespace ingot
