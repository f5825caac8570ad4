// SPDX-License-Identifier: MIT
// What the solver works on in scenes whose bodies have joints.
//
// A body of a figure does not answer an impulse by itself: the figure does, through its joints. So a contact of such a body is prepared with that
// answer, a 6x6 compliance, and before it is visited the figure's cursor brings the body up to date with all impulses that its figure has got
// meanwhile (figure/cursor.h). Manifolds of which one body has joints have blocks of their own; two of one colour share no figure.
#pragma once

#include "../figure/joint_row.h"
#include "../figure/loop_view.h"
#include "../figure/note_reactions.h"
#include "material_view.h"
#include "without_joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// What one body of each lane answers to a force F and a moment T about its centre of mass: v += vv F + wv^T T, omega += wv F + ww T.
struct SideResponse {
    LaneRow vv[6], wv[9], ww[6];
    LaneRow I[6];    ///< kg m^2, world: what turns a change of omega into one of L
    LaneRow joined;  ///< of a body of a figure, by what share of what it would answer without joints rounding is all that it does; 0: it has none
};

/// Beside a block whose manifolds have a body with joints.
struct JointedBlock {
    SideResponse A, B;
    /// What A answers to impulses on B, where both are of one figure: v += vv F + vw T, omega += wv F + ww T; else 0.
    LaneRow vv[9], vw[9], wv[9], ww[9];
    bool some_across;  ///< of a lane that is not 0
};

/// Bodies with joints among the solver's.
struct JointedBodies {
    static constexpr bool articulates = true;

    FigureView figures;
    Spatial6Rows<1>* responses;  ///< room for every node, as FigureView::rows
    Index* node_of;              ///< by solver body: its node, or no_node
    Index* leader_of;            ///< by solver body: one that stands for all of its figure; of a free body itself
    uint8_t* doublings_of;       ///< by island: 1 and how often its substeps are halved; 0: it has no joints
    JointedBlock* blocks;        ///< by block, from `first_block` on
    int first_block, lane_count;
    Index* parted;               ///< by manifold: room to sort in
    bool is_fresh;               ///< figures and contacts are those of the begin of the batch: no substep has been made
    bool some_stand;             ///< islands of the batch have left it, while others are solved again

    int body_count;              ///< of the solver; from it on, bodies stand for kinematic ones

    bool has_joints(Index body_i) const { return body_i < body_count && node_of[body_i] != no_node; }
};
INGOT_INLINE Index leader_of(const NoJointedBodies&, Index body_i) { return body_i; }
INGOT_INLINE Index leader_of(const JointedBodies& jointed, Index body_i) { return jointed.leader_of[body_i]; }

/// View: any without kinematic bodies.
template <class View>
struct JointedViewOf : View {
    static constexpr bool articulates = true;
    JointedBodies jointed;
    static constexpr NoLoops loops = {};
};
using JointedView = JointedViewOf<SolverView>;
using JointedMaterialView = JointedViewOf<RollingBeltView>;

/// The same, some of whose joints close loops.
template <class View>
struct LoopedViewOf : View {
    static constexpr bool articulates = true;
    JointedBodies jointed;
    LoopView loops;
};
using LoopedView = LoopedViewOf<SolverView>;
using LoopedMaterialView = LoopedViewOf<RollingBeltView>;

/// The same where joints have rows of their own. Rows: JointRowView, of limits; or DrivenRowView, of limits and drives.
template <class View, class Rows>
struct RowedViewOf : JointedViewOf<View> {
    static constexpr bool has_joint_rows = true, has_drives = Rows::has_drives;
    Rows joint_rows;
};
using RowedView = RowedViewOf<SolverView, JointRowView>;
using RowedMaterialView = RowedViewOf<RollingBeltView, JointRowView>;
using DrivenView = RowedViewOf<SolverView, DrivenRowView>;
using DrivenMaterialView = RowedViewOf<RollingBeltView, DrivenRowView>;

/// Both.
template <class View>
struct LoopedRowedViewOf : LoopedViewOf<View> {
    static constexpr bool has_joint_rows = true, has_drives = true;
    LoopedRowView joint_rows;
};
using LoopedRowedView = LoopedRowedViewOf<SolverView>;
using LoopedRowedMaterialView = LoopedRowedViewOf<RollingBeltView>;

/// Any of these, of which it is told what joints bear.
template <class View>
struct ReactingViewOf : View {
    ReactionView reactions;
};
template <class View>
inline constexpr bool tells_reactions = false;
template <class View>
inline constexpr bool tells_reactions<ReactingViewOf<View>> = true;
template <class View>
struct WithoutReactions {
    using Type = View;
};
template <class View>
struct WithoutReactions<ReactingViewOf<View>> {
    using Type = View;
};

template <class View>
struct WithoutRows {
    using Type = View;
};
template <class View, class Rows>
struct WithoutRows<RowedViewOf<View, Rows>> {
    using Type = JointedViewOf<View>;
};
template <class View>
struct WithoutRows<LoopedRowedViewOf<View>> {
    using Type = LoopedViewOf<View>;
};
template <class View>
struct WithoutRows<ReactingViewOf<View>> {
    using Type = typename WithoutRows<View>::Type;
};
/// The view for stages of contacts, to which rows of joints, and what these bear, are nothing.
template <class View>
INGOT_INLINE typename WithoutRows<View>::Type& without_rows(View& solver) {
    return solver;
}

/// Whether the manifolds of a block have a body with joints.
INGOT_INLINE bool is_jointed(const JointedBodies& jointed, int block_i) { return block_i >= jointed.first_block; }
/// Blocks before it are of free bodies alone.
template <class View>
INGOT_INLINE int first_jointed_block(const View& solver) {
    if constexpr (View::articulates)
        return solver.jointed.first_block;
    else
        return solver.block_count;
}

} }  // namespace ingot
