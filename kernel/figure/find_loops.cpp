// SPDX-License-Identifier: MIT
#include "find_loops.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_node(const FigureView& view, Index slot) {
    return slot != no_body && (static_cast<unsigned>(view.jointed[place_of(slot).tile]) >> place_of(slot).lane & 1u) != 0;
}

uint8_t row_count_of(JointKind kind) {
    switch (kind) {
        case JointKind::ball: return 3;
        case JointKind::universal: return 4;
        case JointKind::fixed: return 6;
        default: return 5;
    }
}

/// The loops of a figure, which may be its first.
LoopFigure& loops_of(LoopView& loops, Index figure_i) {
    Index& loops_i = loops.of_figure[figure_i];
    if (loops_i == no_loop) {
        loops_i = static_cast<Index>(loops.figure_count++);
        loops.figures[loops_i] = {};
        loops.figures[loops_i].figure = figure_i;
        loops.figures[loops_i].first_joint = no_loop;
    }
    return loops.figures[loops_i];
}

/// False where there is no room.
bool add_loop(const FigureView& view, LoopView& loops, Index joint_i, Index node_A, Index node_B) {
    const JointRecord& record = view.lists.joints[joint_i];
    const bool is_A = node_B == no_node;
    const Index child = is_A ? node_A : node_B, figure_i = view.nodes[child].figure;
    const uint8_t row_count = row_count_of(record.kind);
    if (loops.joint_count == loops.joint_capacity) return false;
    LoopFigure& of = loops_of(loops, figure_i);
    if (of.row_count + row_count > loops.rows_max) return false;
    const auto loop_i = static_cast<Index>(loops.joint_count++);
    LoopJoint& loop = loops.joints[loop_i];
    loop = {};
    loop.joint = joint_i;
    loop.child = child;
    loop.other = is_A ? no_node : node_A;
    loop.ground = is_A ? record.body_B : record.body_A;
    loop.kind = record.kind;
    loop.is_A = is_A;
    loop.first_row = static_cast<uint8_t>(of.row_count);
    loop.row_count = row_count;
    of.row_count = static_cast<Index>(of.row_count + row_count);
    Index* last = &of.first_joint;
    while (*last != no_loop) last = &loops.joints[*last].next;  // bound: max_loops
    *last = loop_i;
    loop.next = no_loop;
    return true;
}

/// Calls each(joint_i, node_A, node_B) for the joints that are in no tree, of which a side can move.
template <class Each>
void for_left_out(const FigureView& view, const Each& each) {
    for (int joint_i = 0; joint_i < view.joint_slots; ++joint_i) {  // bound: max_joints
        const JointRecord& record = view.lists.joints[joint_i];
        if (record.kind == JointKind::none) continue;
        const Index node_A = is_node(view, record.body_A) ? view.node_of[record.body_A] : no_node;
        const Index node_B = is_node(view, record.body_B) ? view.node_of[record.body_B] : no_node;
        const auto is_of_tree = [&](Index node_i) { return node_i != no_node && view.nodes[node_i].joint == joint_i; };
        if ((node_A == no_node && node_B == no_node) || is_of_tree(node_A) || is_of_tree(node_B)) continue;
        each(static_cast<Index>(joint_i), node_A, node_B);
    }
}

}  // namespace

int find_loops(const FigureView& view, NoLoops&) {
    int lost = 0;
    for_left_out(view, [&](Index, Index, Index) { ++lost; });
    return lost;
}

int find_loops(const FigureView& view, LoopView& loops) {
    loops.joint_count = loops.figure_count = 0;
    for (int figure_i = 0; figure_i < view.figure_count; ++figure_i) loops.of_figure[figure_i] = no_loop;  // bound: max_joints
    int lost = 0;
    for_left_out(view, [&](Index joint_i, Index node_A, Index node_B) {
        if (!add_loop(view, loops, joint_i, node_A, node_B)) ++lost;
    });
    int32_t row = 0, entry = 0, column = 0;
    for (int loops_i = 0; loops_i < loops.figure_count; ++loops_i) {  // bound: max_loops
        LoopFigure& of = loops.figures[loops_i];
        of.first_row = row;
        of.first_entry = entry;
        of.first_column = column;
        row += of.row_count;
        entry += of.row_count * (of.row_count + 1) / 2;
        column += of.row_count * view.figures[of.figure].node_count;
    }
    return lost;
}

void load_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        const scalar share = 1 / static_cast<scalar>(1 << view.figures[of.figure].doublings);
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            const Vector on_B = view.lists.joints[loop.joint].j * share;
            loop.given = loop.is_A ? -on_B : on_B;
            for (scalar& j : loop.j) j = 0;
        });
    });
}

} }  // namespace ingot
