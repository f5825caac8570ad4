// SPDX-License-Identifier: MIT
// Figures: bodies that hang together by joints, as trees.
#pragma once

#include "../body/body_tiles.h"
#include "../joint/joint_lists.h"
#include "figure_row.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr Index no_node = index_max;
inline constexpr Index no_loop = index_max;

/// A body of a figure. Its parent comes before it.
struct FigureNode {
    Index slot;      ///< of the body
    Index joint;     ///< to its parent; no_joint: the root of what is tied to nothing
    Index parent;    ///< node of the same figure, counted from its first; no_node: the root
    Index figure;
    Index towards;   ///< on the way of a cursor: the next node down; no_node: none comes here, see reached_bodies.h
    JointKind kind;  ///< of its joint; none: it has none
    bool is_A;       ///< the body is A of its joint
};
/// What lengths of limits.h are of, where a joint goes along its free direction: m of a slider and of a wheel's travel, rad of others.
INGOT_INLINE scalar unit_of_travel(JointKind kind, int direction_i, scalar unit) {
    return kind == JointKind::slider || (is_wheel(kind) && direction_i == 1) ? unit : scalar(1);
}
INGOT_INLINE bool is_ball(JointKind kind) { return kind == JointKind::ball || kind == JointKind::driven_ball; }

/// A tree: nodes [first_node .. first_node + node_count), depth first.
struct Figure {
    Index first_node, node_count;
    Index group;
    Index cursor;    ///< node that knows of all impulses of the figure; no_node: all do. See cursor.h
    uint8_t lane_i;  ///< of the group
    bool was_beyond; ///< while its joints are pushed back from beyond their ends: some have been
    Index ground;    ///< slot of the body that cannot move, to which the root is tied, or no_body: the world, or nothing
    uint8_t doublings;  ///< of the substeps, that it asks for
    bool resolved;      ///< spins changed little in the last substep: targets of second order are right for it
    uint8_t parted;     ///< 2: a joint is further apart than pushes leave it, as bodies were put there; 1: it was in the substep before
};

/// Figures of one form that are solved side by side: as many as there are lanes, or one.
struct FigureGroup {
    Index figure[lanes];
    Index first_row;  ///< of FigureView::rows
    bool is_wide;
};

/// Without its capacities.
struct FigureView {
    BodyView bodies;
    const uint16_t* awake;  ///< by tile, a bit a lane; null: all are
    uint16_t* jointed;      ///< by tile, a bit a lane: bodies of figures, which nothing else moves in the step
    JointLists lists;
    FigureNode* nodes;
    Figure* figures;
    FigureGroup* groups;
    FigureRow<1>* rows;   ///< room for every node; those of a wide group lie in the room of as many
    Index* node_of;       ///< by slot of a body that has joints: its node
    Index* end_at;        ///< by slot of a body that has joints: how far its list of ends has been gone through
    int joint_slots;      ///< in use
    int figure_count, node_count;
    int group_count;      ///< of the batch at hand: figures that are cut into as many substeps
    int row_count;        ///< of the batch
    scalar elapsed;       ///< s, since the step began
    Vector gravity;       ///< m/s^2
    scalar h;             ///< s, of the step
    scalar unit;          ///< m; of lengths and speeds in limits.h: Scene::length_unit
};

/// A group as its rows are worked on.
template <unsigned width_of_rows, class Kinds = AnyKinds>
struct FigureRows {
    static constexpr unsigned width = width_of_rows;
    using T = typename AllLanes<width>::T;
    static constexpr AllLanes<width, Kinds> all{};
    static constexpr int lane_count = static_cast<int>(width);

    const FigureView& view;
    const FigureGroup& group;

    FigureRow<width>& operator[](int row_i) const { return reinterpret_cast<FigureRow<width>*>(view.rows + group.first_row)[row_i]; }
    Figure& figure(int lane_i = 0) const { return view.figures[group.figure[lane_i]]; }
    FigureNode& node(int row_i, int lane_i = 0) const { return view.nodes[figure(lane_i).first_node + row_i]; }
    /// Of the joint of a row; all lanes have the same.
    JointKind kind(int row_i) const { return Kinds::of(node(row_i).kind); }
    int count() const { return figure().node_count; }

    static OneLane<width> one(int lane_i) { return {lane_i}; }
    static Spatial<T> no_twist() { return {Vec3<T>{}, Vec3<T>{}}; }
    static auto all_lanes() { return splat<T>(1) > T{}; }

    /// Of the row of the same number: see respond_figures.h.
    Spatial6Rows<width>& response(Spatial6Rows<1>* responses, int row_i) const {
        return reinterpret_cast<Spatial6Rows<width>*>(responses + group.first_row)[row_i];
    }
    const Spatial6Rows<width>& response(const Spatial6Rows<1>* responses, int row_i) const {
        return reinterpret_cast<const Spatial6Rows<width>*>(responses + group.first_row)[row_i];
    }

    /// of(node): a vector of each lane's node.
    template <class Of>
    INGOT_INLINE Vec3<T> gathered(int row_i, const Of& of) const {
        scalar rows[3][width];
        for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
            const Vector value = of(node(row_i, lane_i));
            rows[0][lane_i] = value.x;
            rows[1][lane_i] = value.y;
            rows[2][lane_i] = value.z;
        }
        return read(all, rows);
    }
    /// The same of one lane.
    template <class Of>
    INGOT_INLINE Vector gathered(const OneLane<width>& at, int row_i, const Of& of) const {
        return of(node(row_i, at.lane_i));
    }
    template <class Of>
    INGOT_INLINE Vec3<T> gathered(const AllLanes<width, Kinds>&, int row_i, const Of& of) const {
        return gathered(row_i, of);
    }
    INGOT_INLINE Vec3<T> own_anchor(int row_i) const {
        return gathered(row_i, [this](const FigureNode& of) { return own_frame(of).anchor; });
    }
    INGOT_INLINE Vec3<T> anchor_of_parent(int row_i) const {
        return gathered(row_i, [this](const FigureNode& of) { return frame_of_parent(of).anchor; });
    }
    const JointRecord& joint(const FigureNode& of) const { return view.lists.joints[of.joint]; }
    const JointFrame& own_frame(const FigureNode& of) const { return of.is_A ? joint(of).frame_A : joint(of).frame_B; }
    const JointFrame& frame_of_parent(const FigureNode& of) const {
        return of.is_A ? joint(of).frame_B : joint(of).frame_A;
    }
};

/// Calls of_row(rows, at, row_i) for the row and lane of one body.
template <class OfRow>
INGOT_INLINE auto at_node(const FigureView& view, Index node_i, const OfRow& of_row) {
    const Figure& figure = view.figures[view.nodes[node_i].figure];
    const FigureGroup& group = view.groups[figure.group];
    if constexpr (lanes > 1)
        if (group.is_wide) return of_row(FigureRows<lanes>{view, group}, OneLane<lanes>{figure.lane_i}, node_i - figure.first_node);
    return of_row(FigureRows<1>{view, group}, OneLane<1>{0}, node_i - figure.first_node);
}

/// Calls stage(rows) for the groups of the batch, by their width.
template <class Kinds = AnyKinds, class Stage>
INGOT_INLINE void for_groups(const FigureView& view, const Stage& stage) {
    for (int group_i = 0; group_i < view.group_count; ++group_i) {  // bound: max_joints
        const FigureGroup& group = view.groups[group_i];
        if (lanes > 1 && group.is_wide)
            stage(FigureRows<lanes, Kinds>{view, group});
        else
            stage(FigureRows<1, Kinds>{view, group});
    }
}

} }  // namespace ingot
