// SPDX-License-Identifier: MIT
#include "build_figures.h"

#include "../body/kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr Index no_end = index_max;

/// A body that can move, and is awake. A figure sleeps and wakes as one.
bool moves(const FigureView& view, Index slot) {
    if (slot == no_body || !is_dynamic(view.bodies, slot)) return false;
    const Place at = place_of(slot);
    return view.awake == nullptr || (view.awake[at.tile] >> at.lane & 1u) != 0;
}
scalar inv_M_of(const FigureView& view, Index slot) {
    const Place at = place_of(slot);
    return view.bodies.translation[at.tile].inv_M[at.lane];
}

// Which ends count: those of all joints; or, in scenes with ties, those of the trees.
struct AllEnds {
    static bool count(const FigureView&, int) { return true; }
};
struct EndsOfTrees {
    static bool count(const FigureView& view, int end) { return !is_tie(view.lists.joints[end / 2].kind); }
};

/// The bodies that hang together with one, as a list in the nodes from `begin` on; returns its end.
template <class Ends>
int list_component(const FigureView& view, Index slot, int begin) {
    int end = begin;
    const auto add = [&](Index body) {
        view.node_of[body] = static_cast<Index>(end);
        view.nodes[end++].slot = body;
    };
    add(slot);
    for (int node_i = begin; node_i < end; ++node_i)  // bound: max_bodies: no body is added twice
        view.lists.for_ends(view.nodes[node_i].slot, [&](int joint_end) {
            const Index other = view.lists.partner_of(joint_end);
            if (Ends::count(view, joint_end) && moves(view, other) && view.node_of[other] == no_node) add(other);
        });
    return end;
}

/// Where the tree begins: the end, at its root, of the joint that ties it; or, where no joint does, none, and the heaviest body.
struct Root {
    Index slot, end;
};
template <class Ends>
Root root_of(const FigureView& view, int begin, int end) {
    Root root = {view.nodes[begin].slot, no_end};
    for (int node_i = begin; node_i < end; ++node_i) {  // bound: max_bodies
        const Index slot = view.nodes[node_i].slot;
        view.lists.for_ends(slot, [&](int joint_end) {
            if (!Ends::count(view, joint_end)) return;
            if (!moves(view, view.lists.partner_of(joint_end)) && (root.end == no_end || joint_end / 2 < root.end / 2))
                root = {slot, static_cast<Index>(joint_end)};
        });
        if (root.end != no_end) continue;
        const scalar inv_M = inv_M_of(view, slot), least = inv_M_of(view, root.slot);
        if (inv_M < least || (inv_M == least && slot < root.slot)) root.slot = slot;
    }
    return root;
}

/// Numbers the bodies of a figure depth first. The way back is by parents, and each body's list of ends goes on where it was left.
template <class Ends>
void number_nodes(FigureView& view, Figure& figure, const Root& root) {
    int count = 0;
    const auto add = [&](Index slot, Index end, Index parent) {
        FigureNode& node = view.nodes[figure.first_node + count];
        node = {};
        node.slot = slot;
        node.joint = static_cast<Index>(end == no_end ? no_joint : end / 2);
        node.parent = parent;
        node.figure = static_cast<Index>(&figure - view.figures);
        if (end != no_end) {
            node.kind = view.lists.joints[end / 2].kind;
            node.is_A = end % 2 == 0;
        }
        view.node_of[slot] = static_cast<Index>(figure.first_node + count);
        uint16_t& jointed = view.jointed[place_of(slot).tile];
        jointed = static_cast<uint16_t>(jointed | 1u << place_of(slot).lane);
        return static_cast<Index>(count++);
    };
    Index node_i = add(root.slot, root.end, no_node);
    while (node_i != no_node) {  // bound: max_bodies + max_joints: each turn takes an end off a list, or a body off the way
        const FigureNode& node = view.nodes[figure.first_node + node_i];
        if (view.end_at[node.slot] == 0) {
            node_i = node.parent;
            continue;
        }
        const int end = view.end_at[node.slot] - 1;
        view.end_at[node.slot] = view.lists.next_end[end];
        const Index other = view.lists.partner_of(end);
        if (Ends::count(view, end) && moves(view, other) && view.node_of[other] == no_node)
            node_i = add(other, static_cast<Index>(end ^ 1), node_i);
    }
}

/// What the joints of a figure remember of the last step.
void recall(const FigureView& view, Figure& figure) {
    figure.resolved = true;
    figure.doublings = 0;
    for (int node_i = figure.first_node; node_i < figure.first_node + figure.node_count; ++node_i) {  // bound: max_bodies
        const Index joint_i = view.nodes[node_i].joint;
        if (joint_i == no_joint) continue;
        figure.resolved = figure.resolved && view.lists.joints[joint_i].resolved != 0;
        if (view.lists.joints[joint_i].doublings > figure.doublings) figure.doublings = view.lists.joints[joint_i].doublings;
    }
}

template <class Ends>
void add_figure(FigureView& view, Index slot) {
    const int begin = view.node_count, end = list_component<Ends>(view, slot, begin);
    const Root root = root_of<Ends>(view, begin, end);
    Figure& figure = view.figures[view.figure_count++];
    figure = {};
    figure.first_node = static_cast<Index>(begin);
    figure.node_count = static_cast<Index>(end - begin);
    figure.ground = root.end == no_end ? no_body : view.lists.partner_of(root.end);
    for (int node_i = begin; node_i < end; ++node_i) view.node_of[view.nodes[node_i].slot] = no_node;
    number_nodes<Ends>(view, figure, root);
    recall(view, figure);
    view.node_count = end;
}

/// Whether the joint of an end takes part in the step.
bool holds(const FigureView& view, const LoopView& loops, int end) {
    return view.lists.joints[end / 2].kind != JointKind::none && loops.ties[end / 2].slack == 0;
}

/// A body's tree, and those that ties hold together with it, one after the other.
void add_machine(FigureView& view, const LoopView& loops, Index slot) {
    const int first_figure = view.figure_count, first_node = view.node_count;
    uint8_t doublings = 0;
    add_figure<EndsOfTrees>(view, slot);
    for (int node_i = first_node; node_i < view.node_count; ++node_i)  // bound: max_bodies: no body is added twice
        view.lists.for_ends(view.nodes[node_i].slot, [&](int end) {
            const JointRecord& joint = view.lists.joints[end / 2];
            const Index other = view.lists.partner_of(end);
            if (!is_tie(joint.kind) || !holds(view, loops, end)) return;
            if (joint.doublings > doublings) doublings = joint.doublings;
            if (moves(view, other) && view.node_of[other] == no_node) add_figure<EndsOfTrees>(view, other);
        });
    for (int i = first_figure; i < view.figure_count; ++i)  // bound: max_bodies
        if (view.figures[i].doublings > doublings) doublings = view.figures[i].doublings;
    for (int i = first_figure; i < view.figure_count; ++i) {
        loops.machine_of[i] = static_cast<Index>(first_figure);
        view.figures[i].doublings = doublings;
    }
}

bool are_alike(const FigureView& view, const Figure& a, const Figure& b) {
    if (a.node_count != b.node_count) return false;
    for (int node_i = 0; node_i < a.node_count; ++node_i) {  // bound: max_bodies
        const FigureNode& of_a = view.nodes[a.first_node + node_i];
        const FigureNode& of_b = view.nodes[b.first_node + node_i];
        if (of_a.parent != of_b.parent || of_a.kind != of_b.kind) return false;
    }
    return true;
}

template <unsigned width>
void load_body(const FigureRows<width>& rows, int row_i, int lane_i) {
    const OneLane<width> at{lane_i};
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i, lane_i);
    const Place place = place_of(node.slot);
    const RotationTile& rotation = rows.view.bodies.rotation[place.tile];
    const TranslationTile& translation = rows.view.bodies.translation[place.tile];
    const Vector inv_I = lane_of(rotation.inv_I_ratio, place.lane) * rotation.inv_I_scale[place.lane];
    write(at, row.r, lane_of(translation.r_CM, place.lane));
    write(at, row.A, lane_of(rotation.A, place.lane));
    write(at, row.v, lane_of(translation.v_CM, place.lane));
    write(at, row.L, lane_of(rotation.L, place.lane));
    write(at, row.I_body, Vector{1 / inv_I.x, 1 / inv_I.y, 1 / inv_I.z});
    write(at, row.turned, Vector{});
    at.put(row.M, 1 / translation.inv_M[place.lane]);
    const auto share = static_cast<scalar>(node.is_A ? -1 : 1) / static_cast<scalar>(1 << rows.figure(lane_i).doublings);
    write(at, row.j, node.kind == JointKind::none ? Vector{} : rows.view.lists.joints[node.joint].j * share);
}

void add_group(FigureView& view, const Index (&figures)[lanes], int count) {
    FigureGroup& group = view.groups[view.group_count];
    for (int lane_i = 0; lane_i < count; ++lane_i) {  // bound: lanes
        group.figure[lane_i] = figures[lane_i];
        view.figures[figures[lane_i]].group = static_cast<Index>(view.group_count);
        view.figures[figures[lane_i]].lane_i = static_cast<uint8_t>(lane_i);
    }
    ++view.group_count;
    group.first_row = static_cast<Index>(view.row_count);
    group.is_wide = lanes > 1 && count == lanes;
    view.row_count += count * view.figures[figures[0]].node_count;
}

}  // namespace

namespace {

/// The body of an end; no_body: there is no joint.
Index slot_of(const FigureView& view, int end) {
    return view.lists.joints[end / 2].kind == JointKind::none ? no_body : view.lists.body_of(end);
}

/// No body has a node.
void begin_building(FigureView& view) {
    for (int end = 0; end < 2 * view.joint_slots; ++end) {  // bound: 2 max_joints
        const Index slot = slot_of(view, end);
        if (slot == no_body) continue;
        view.node_of[slot] = no_node;
        view.end_at[slot] = view.lists.first_end[slot];
    }
    view.figure_count = view.node_count = view.group_count = 0;
    for (int tile_i = 0; tile_i < view.bodies.tile_count; ++tile_i) view.jointed[tile_i] = 0;  // bound: max_bodies / lanes, rounded up
}

}  // namespace

void build_figures(FigureView& view) {
    begin_building(view);
    for (int end = 0; end < 2 * view.joint_slots; ++end) {  // bound: 2 max_joints
        const Index slot = slot_of(view, end);
        if (moves(view, slot) && view.node_of[slot] == no_node) add_figure<AllEnds>(view, slot);
    }
}

void build_figures(FigureView& view, const LoopView& loops) {
    if (loops.ties == nullptr) return build_figures(view);
    begin_building(view);
    for (int end = 0; end < 2 * view.joint_slots; ++end) {  // bound: 2 max_joints
        const Index slot = slot_of(view, end);
        if (moves(view, slot) && view.node_of[slot] == no_node && holds(view, loops, end)) add_machine(view, loops, slot);
    }
}

void group_figures(FigureView& view, int doublings) {
    view.group_count = view.row_count = 0;
    Index alike[lanes];
    int count = 0;
    const auto add_alike = [&](int figure_count) {
        if (figure_count == lanes) return add_group(view, alike, lanes);
        for (int i = 0; i < figure_count; ++i) {  // bound: lanes
            const Index alone[lanes] = {alike[i]};
            add_group(view, alone, 1);
        }
    };
    for (int figure_i = 0; figure_i < view.figure_count; ++figure_i) {  // bound: max_joints
        if (view.figures[figure_i].doublings != doublings) continue;
        recall(view, view.figures[figure_i]);
        view.figures[figure_i].doublings = static_cast<uint8_t>(doublings);
        if (count == lanes || (count > 0 && !are_alike(view, view.figures[alike[0]], view.figures[figure_i]))) {
            add_alike(count);
            count = 0;
        }
        alike[count++] = static_cast<Index>(figure_i);
    }
    add_alike(count);
    for_groups(view, [](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i)  // bound: max_bodies
            for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) load_body(rows, row_i, lane_i);  // bound: lanes
    });
}

} }  // namespace ingot
