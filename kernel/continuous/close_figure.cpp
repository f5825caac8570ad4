// SPDX-License-Identifier: MIT
#include "close_figure.h"

#include "../base/figure_limits.h"
#include "../figure/build_figures.h"
#include "../figure/displace_rows.h"
#include "../figure/factor_figures.h"
#include "../figure/factor_loops.h"
#include "../figure/find_loops.h"
#include "../figure/joint_drives.h"
#include "../figure/move_figures.h"
#include "pair_sub_world.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

void begin_closing(const FigureView&, const NoLoops&) {}
/// A rope has a row where it is longer than it may be, and no other.
void begin_closing(const FigureView& view, const LoopView& loops) {
    load_loops(view, loops, view.h);
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [](LoopJoint& loop) { loop.is_slack = loop.kind == JointKind::rope; });
    });
}
void factor_closing(const FigureView& view, const NoLoops& loops) { factor_figures(view, loops, view.h); }
void factor_closing(const FigureView& view, const LoopView& loops) {
    place_loops(view, loops);
    factor_figures(view, loops, view.h);
    factor_loops(view, loops);
}

/// Joints of trees are off by no more than pushes let them.
template <unsigned width>
bool is_closed(const FigureRows<width>& rows) {
    return !any(set_pushes(rows) > splat<typename AllLanes<width>::T>(limits::joint_gap * limits::joint_gap));
}

/// Velocities stay as they are in the tiles.
void keep_closed_place(const FigureView& view, Index node_i) {
    const FigureNode& node = view.nodes[node_i];
    const Place place = place_of(node.slot);
    if (((view.bodies.rotation[place.tile].bad | view.bodies.translation[place.tile].bad) >> place.lane & 1u) != 0) return;
    FlightState motion = flight_state(view.bodies, node.slot);
    at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        motion.r_CM = read(at, rows[row_i].r);
        motion.A = read(at, rows[row_i].A);
    });
    put_state(view.bodies, node.slot, motion);
    // What it goes on with fits its joints to first order only.
    if (node.joint != no_joint) view.lists.joints[node.joint].resolved = 0;
}

}  // namespace

template <class Loops>
bool close_figure(FigureView& view, const Loops& loops, int first, int end) {
    constexpr int alone = limits::doublings_max + 1;                                            // no figure that a step moves asks for so many
    for (int i = first; i < end; ++i) view.figures[i].doublings = static_cast<uint8_t>(alone);  // bound: max_bodies
    group_figures(view, alone);
    begin_closing(view, loops);
    // bound: limits::closings
    for (int round = 0; round < limits::closings; ++round) {
        place_joints(view);
        (void)place_carriages(view);
        factor_closing(view, loops);
        push_figures(view, loops, round > 0);
    }
    bool holds = true;
    for_groups(view, [&holds](const auto& rows) { holds = is_closed(rows) && holds; });
    for (int i = first; i < end; ++i) {  // bound: max_bodies
        Figure& figure = view.figures[i];
        for (int node_i = figure.first_node; node_i < figure.first_node + figure.node_count; ++node_i)  // bound: max_bodies
            keep_closed_place(view, static_cast<Index>(node_i));
        figure.doublings = 0;
    }
    return holds;
}

// The linker takes the one that the scene calls.
template bool close_figure(FigureView&, const NoLoops&, int, int);
template bool close_figure(FigureView&, const LoopView&, int, int);

} }  // namespace ingot

#pragma GCC diagnostic pop
