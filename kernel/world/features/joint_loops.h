// SPDX-License-Identifier: MIT
// Joints that close loops.
#pragma once

#include "../../figure/close_loops.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

namespace features {

/// Those of them that close loops, and ties.
struct LoopJoints : Feature {
    template <class S>
    static constexpr bool named = has_loops<S>;
    /// The most rows of one.
    template <class S>
    static constexpr unsigned rows_of_loop() {
        if (Figures::has_trees<S>() || has_targets<S>) return rows_of_joint_max;
        return S::joints::has(JointKind::parallel) ? 2 : 1;
    }

    template <class S, bool present>
    struct Memory {
        static constexpr unsigned loop_capacity = static_cast<unsigned>(S::max_loops);
        static constexpr unsigned row_capacity = rows_of_loop<S>() * loop_capacity;
        static constexpr unsigned rows_of_figure = row_capacity < limits::loop_rows_max ? row_capacity : limits::loop_rows_max;
        static constexpr unsigned node_capacity = Figures::Memory<S, true>::node_capacity;

        LoopJoint loop_joints[loop_capacity] = {};
        LoopFigure loop_figures[loop_capacity] = {};
        Index loops_of_figure[Figures::figure_capacity<S>] = {};
        uint8_t loop_order[row_capacity] = {};
        scalar loop_lacks[row_capacity] = {};
        scalar loop_triangles[(row_capacity * (rows_of_figure + 1) + 1) / 2] = {};  // n (n + 1) / 2 for figures of n rows, row_capacity in all
        Spatial<scalar> loop_answers[node_capacity * rows_of_figure] = {};

        LoopView loops() {
            LoopView view{};
            view.joints = loop_joints;
            view.figures = loop_figures;
            view.of_figure = loops_of_figure;
            view.z = loop_lacks;
            view.L = loop_triangles;
            view.order = loop_order;
            view.X = loop_answers;
            view.joint_capacity = S::max_loops;
            view.rows_max = static_cast<int>(rows_of_figure);
            return view;
        }
    };
    template <class S>
    struct Memory<S, false> {
        static NoLoops loops() { return {}; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (has_loops<S>) each(S::max_loops);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_loops >= 0 && S::max_loops <= S::max_joints,
                      "joints that close loops are among the joints: set max_loops to max_joints at most");
        return true;
    }
};

}  // namespace features

} }  // namespace ingot
