// SPDX-License-Identifier: MIT
// The adaptors of stages.h for bodies that are too fast for the step: see continuous/.
#pragma once

#include "../continuous/figure_pairs.h"
#include "../continuous/follow_fast_bodies.h"
#include "../figure/build_figures.h"
#include "../figure/find_loops.h"
#include "kinematic_stages.h"

namespace ingot { inline namespace INGOT_ABI {

/// Whether a body has joints. Its figure cannot be taken apart within a step.
template <class S>
INGOT_INLINE bool has_joints_of([[maybe_unused]] const Storage<S>& storage, [[maybe_unused]] int slot) {
    if constexpr (has_joints<S>)
        return storage.first_end[slot] != 0;
    else
        return false;
}

template <class S>
INGOT_INLINE auto fast_pairs_of(Step<S>& now, const BodyShapes& shapes) {
    if constexpr (has_joints<S>)
        return FastPairsOfFigures{{now.bodies, shapes, now.storage.paths, now.h}, now.storage.joint_lists(), now.storage.gravity};
    else
        return FastPairs{now.bodies, shapes, now.storage.paths, now.h};
}

/// The solver as it serves two bodies that meet within the step: without joints.
template <class S>
auto view_of_pairs() {
    if constexpr (!has_joints<S>) {
        return decltype(solver_of_scene<S>()){};
    } else {
        using Plain = decltype(any_of<Storage<S>>().plain_contact_solver());
        return If<S::kinematic_bodies, KinematicViewOf<Plain>, Plain>{};
    }
}
template <class S>
INGOT_INLINE decltype(auto) solver_of_pairs([[maybe_unused]] const Step<S>& now) {
    if constexpr (solves_pointwise<S>) {
        auto view = now.solver;
        view.members = now.storage.members;  // a solve goes along this list, and leaves the view at its end
        return view;
    } else if constexpr (!has_joints<S>) {
        return (now.solver);
    } else {
        auto view = view_of_pairs<S>();
        static_cast<decltype(any_of<Storage<S>>().plain_contact_solver())&>(view) = now.solver;
        if constexpr (S::kinematic_bodies) view.kinematic = now.solver.kinematic;
        return view;
    }
}

/// Figures as their joints are once bodies have been moved: what the step had may have broken, or was moved by itself.
template <class S, bool present = has_joints<S>>
class FiguresOfStep {
    using Loops = decltype(any_of<Storage<S>>().loop_view());

public:
    using OnPaths = FiguresOnPaths<Loops>;

    OnPaths after(Step<S>& now) {
        view_ = now.storage.all_figures();
        if constexpr (S::sleeps) view_.awake = now.storage.awake;
        view_.gravity = now.storage.gravity;
        view_.h = now.h;
        loops_ = now.storage.loop_view();
        build_figures(view_, loops_);
        if constexpr (has_loops<S>) (void)find_loops(view_, loops_);
        return {&view_, &loops_};
    }

private:
    FigureView view_{};
    Loops loops_{};
};
template <class S>
class FiguresOfStep<S, false> {
public:
    using OnPaths = NoFiguresOnPaths;
    static constexpr OnPaths after(Step<S>&) { return {}; }
};

/// What fast bodies are followed by, of a scene: see ContinuousCollision.
template <class S>
struct FastSceneOf {
    using Shapes = ShapesOf<S>;
    using Rotation = typename S::rotation;
    using Solver = typename S::solver;
    using View = decltype(view_of_pairs<S>());
    using Figures = typename FiguresOfStep<S>::OnPaths;
    static constexpr bool notes_impulses = has_events<S>, bounces = S::bounces, sees_kinematic = S::kinematic_bodies;
    static constexpr bool hides_internal_edges = ingot::hides_internal_edges<S>;
    static constexpr int shapes_of_body = S::max_shapes_of_body;
    static constexpr int pair_manifolds = limits::pair_manifolds_max < S::max_manifolds ? limits::pair_manifolds_max : S::max_manifolds;
};

/// The bodies that a step may move.
template <class S>
auto moving_bodies(Step<S>& now) {
    if constexpr (S::sleeps)
        return AwakeBodies{now.storage.rest_view()};
    else
        return EveryBody{now.storage.slots_used};
}

/// Where the bodies begin that may turn out to be fast: all that are awake by now.
template <class S>
void begin_paths([[maybe_unused]] Step<S>& now) {
    if constexpr (S::continuous) moving_bodies(now).for_each([&now](int slot) { begin_path(now.bodies, now.h, slot, now.storage.paths[slot]); });
}

template <class S>
FloorView floor_view(Storage<S>& storage) {
    Index* last_of_shape = nullptr;
    if constexpr (hides_internal_edges<S>) last_of_shape = storage.last_of_shape;
    return {storage.shapes(), storage.bounds, last_of_shape};
}

/// Where impacts in flight are noted, for events: an empty list, or nowhere.
template <class S>
FlightImpactList begin_flights([[maybe_unused]] Step<S>& now) {
    if constexpr (has_events<S>) {
        now.storage.flight_impact_count = 0;
        now.flights = now.storage.flights(now.report);
    }
    return now.flights;
}

/// Who passes sensors in flight.
template <class S>
auto passed_sensors([[maybe_unused]] Step<S>& now) {
    if constexpr (has_sensors<S>) {
        auto& storage = now.storage;
        const SensorView so_far = storage.sensor_view_so_far(storage.generation_of_shapes(storage.generation), now.report);
        return PassedSensors<decltype(storage.meeting_view())>{storage.meeting_view(), so_far};
    } else {
        return NoPassedSensors{};
    }
}

/// Fast bodies meet others within the step, impact by impact.
template <class S>
void follow_fast_bodies([[maybe_unused]] Step<S>& now) {
    if constexpr (S::continuous) {
        auto& storage = now.storage;
        const auto meets = [&storage](int shape_A, int shape_B) { return storage.can_meet(shape_A, shape_B); };
        const auto moving = moving_bodies(now);
        const ManifoldView solved = storage.manifold_view();
        const auto sensors = passed_sensors(now);
        auto tree = storage.tree_of_bounds();
        FollowedBodies lists = {storage.paths, storage.followed, 0, 0};
        FiguresOfStep<S> figures;
        const ContinuousCollision<FastSceneOf<S>, decltype(moving), decltype(meets), decltype(sensors), decltype(tree)> collision = {
            figures.after(now),
            now.bodies,
            storage.body_shapes(),
            storage.shape_materials(),
            floor_view(storage),
            solver_of_pairs(now),
            {solved.pairs, *solved.count},
            storage.paths,
            {storage.gravity, now.h},
            moving,
            meets,
            sensors,
            begin_flights(now),
            tree,
            &lists,
            &now.report};
        follow_fast_bodies(collision);
    }
}

} }  // namespace ingot
