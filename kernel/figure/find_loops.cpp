// SPDX-License-Identifier: MIT
#include "find_loops.h"

#include "../base/limits.h"
#include "gear_rows.h"
#include "target_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_node(const FigureView& view, Index slot) {
    return slot != no_body && (static_cast<unsigned>(view.jointed[place_of(slot).tile]) >> place_of(slot).lane & 1u) != 0;
}

uint8_t row_count_of(JointKind kind) {
    switch (kind) {
        case JointKind::ball:
        case JointKind::wheel: return 3;
        case JointKind::universal: return 4;
        case JointKind::target:
        case JointKind::fixed: return 6;
        case JointKind::gear:
        case JointKind::rod:
        case JointKind::rope: return 1;
        case JointKind::parallel: return 2;
        case JointKind::servo:
        case JointKind::ball_servo: return 0;
        default: return 5;
    }
}

/// A servo is driven as a hinge is, or as a ball joint; that it locks nothing is known by its rows: see locks_nothing.
JointKind kind_in_rows(JointKind kind) {
    if (!is_servo(kind)) return kind;
    return kind == JointKind::servo ? JointKind::hinge : JointKind::driven_ball;
}

/// The loops of a figure and its machine, which may be the first.
LoopFigure& loops_of(const FigureView& view, LoopView& loops, Index figure_i) {
    const auto first_of = [&](Index figure) { return loops.machine_of == nullptr ? figure : loops.machine_of[figure]; };
    if (loops.of_figure[figure_i] != no_loop) return loops.figures[loops.of_figure[figure_i]];
    const auto loops_i = static_cast<Index>(loops.figure_count++);
    LoopFigure& of = loops.figures[loops_i];
    of = {};
    of.figure = first_of(figure_i);
    of.first_node = view.figures[of.figure].first_node;
    of.first_joint = no_loop;
    for (Index i = of.figure; i < view.figure_count && first_of(i) == of.figure; ++i) {  // bound: max_bodies
        loops.of_figure[i] = loops_i;
        of.node_count = static_cast<Index>(of.node_count + view.figures[i].node_count);
        ++of.figure_count;
    }
    return of;
}

/// False where there is no room.
bool add_loop(const FigureView& view, LoopView& loops, Index joint_i, Index node_A, Index node_B) {
    const JointRecord& record = view.lists.joints[joint_i];
    const bool is_A = node_B == no_node;
    const Index child = is_A ? node_A : node_B, figure_i = view.nodes[child].figure;
    const uint8_t row_count = row_count_of(record.kind);
    if (loops.joint_count == loops.joint_capacity) return false;
    LoopFigure& of = loops_of(view, loops, figure_i);
    if (of.row_count + row_count > loops.rows_max) return false;
    const auto loop_i = static_cast<Index>(loops.joint_count++);
    LoopJoint& loop = loops.joints[loop_i];
    loop = {};
    loop.joint = joint_i;
    loop.child = child;
    loop.other = is_A ? no_node : node_A;
    loop.ground = is_A ? record.body_B : record.body_A;
    loop.kind = record.kind == JointKind::wheel && is_A ? JointKind::carriage : kind_in_rows(record.kind);
    loop.is_A = is_A;
    loop.first_row = static_cast<uint8_t>(of.row_count);
    loop.row_count = loop.row_end = row_count;
    of.row_count = static_cast<Index>(of.row_count + row_count);
    Index* last = &of.first_joint;
    while (*last != no_loop) last = &loops.joints[*last].next;  // bound: max_loops
    *last = loop_i;
    loop.next = no_loop;
    return true;
}

bool is_slack(const LoopView& loops, int joint_i) { return loops.ties != nullptr && loops.ties[joint_i].slack != 0; }
bool is_slack(const NoLoops&, int) { return false; }

/// Calls each(joint_i, node_A, node_B) for the joints that are in no tree, of which a side can move.
template <class Loops, class Each>
void for_left_out(const FigureView& view, const Loops& loops, const Each& each) {
    for (int joint_i = 0; joint_i < view.joint_slots; ++joint_i) {  // bound: max_joints
        const JointRecord& record = view.lists.joints[joint_i];
        if (record.kind == JointKind::none || is_slack(loops, joint_i)) continue;
        const Index node_A = is_node(view, record.body_A) ? view.node_of[record.body_A] : no_node;
        const Index node_B = is_node(view, record.body_B) ? view.node_of[record.body_B] : no_node;
        const auto is_of_tree = [&](Index node_i) { return node_i != no_node && view.nodes[node_i].joint == joint_i; };
        if ((node_A == no_node && node_B == no_node) || is_of_tree(node_A) || is_of_tree(node_B)) continue;
        if (is_servo(record.kind) && node_B == no_node) continue;  // nothing to turn
        each(static_cast<Index>(joint_i), node_A, node_B);
    }
}

}  // namespace

int find_loops(const FigureView& view, NoLoops& loops) {
    int lost = 0;
    for_left_out(view, loops, [&](Index, Index, Index) { ++lost; });
    return lost;
}

int find_loops(const FigureView& view, LoopView& loops) {
    loops.joint_count = loops.figure_count = 0;
    for (int figure_i = 0; figure_i < view.figure_count; ++figure_i) loops.of_figure[figure_i] = no_loop;  // bound: max_joints
    int lost = 0;
    for_left_out(view, loops, [&](Index joint_i, Index node_A, Index node_B) {
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
        column += of.row_count * of.node_count;
    }
    return lost;
}

void load_loops(const FigureView& view, const LoopView& loops, scalar h) {
    for_looped_figures(view, loops, [&](LoopFigure& of) {
        of.was_apart = false;
        const scalar share = 1 / static_cast<scalar>(1 << view.figures[of.figure].doublings);
        bool resolved = true;
        for_loop_joints(loops, of, [&](LoopJoint& loop) {
            const Vector on_B = view.lists.joints[loop.joint].j * share;
            loop.given = loop.is_A ? -on_B : on_B;
            for (scalar& j : loop.j) j = 0;
            loop.is_slack = loop.kind == JointKind::rope && length_sq(on_B) == 0;
            if (loop.kind == JointKind::gear) begin_gear(loops, loop);
            resolved = resolved && view.lists.joints[loop.joint].resolved != 0;
        });
        if (loops.targets != nullptr) begin_targets(loops, of, h);
        if (loops.ties == nullptr) return;  // else joints of the trees know it
        for (int i = of.figure; i < of.figure + of.figure_count; ++i)  // bound: max_bodies
            view.figures[i].resolved = view.figures[i].resolved && resolved;
    });
}

} }  // namespace ingot
