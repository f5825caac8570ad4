// SPDX-License-Identifier: MIT
// The adaptors of stages.h that are of kinematic bodies: empty in scenes without.
#pragma once

#include "../continuous/fast_pairs.h"
#include "step_context.h"

namespace ingot { inline namespace INGOT_ABI {

/// Kinematic bodies show how they move, and are awake while they do.
template <class S>
void begin_kinematic_motion([[maybe_unused]] Step<S>& now) {
    if constexpr (S::kinematic_bodies) {
        features::KinematicBodies::for_standing(now.storage, [](KinematicBody& body) { body.v_CM_before = body.omega_before = {}; });
        const scalar smooth = sqrt(length_sq(now.storage.gravity)) * now.h;
        features::KinematicBodies::for_moving(now.storage, [&now, smooth](int slot, KinematicBody& body) {
            aim_at_goal(now.bodies, now.h, smooth, slot, body);
            show_kinematic_motion(now.bodies, slot, body.v_CM, body.omega);
            if constexpr (S::sleeps) now.storage.rest_view().wake(slot);
        });
    }
}

/// They go where their motion leads. From then on the step sees them as immovable bodies.
template <class S>
INGOT_INLINE void move_kinematic_bodies([[maybe_unused]] Step<S>& now) {
    if constexpr (S::kinematic_bodies)
        features::KinematicBodies::for_moving(now.storage, [&now](int slot, KinematicBody& body) {
            hide_kinematic_motion(now.bodies, slot);
            move_kinematic_body(now.bodies, now.h, slot, body);
        });
}

/// Runs a stage, after bodies have been moved, that sees how kinematic bodies moved in the step.
template <class S, class Stage>
INGOT_INLINE void as_kinematic_bodies_moved([[maybe_unused]] Step<S>& now, const Stage& stage) {
    if constexpr (S::kinematic_bodies)
        features::KinematicBodies::for_moving(
            now.storage, [&now](int slot, KinematicBody& body) { show_kinematic_motion(now.bodies, slot, body.v_CM, body.omega); });
    stage();
    if constexpr (S::kinematic_bodies)
        features::KinematicBodies::for_moving(now.storage, [&now](int slot, KinematicBody&) { hide_kinematic_motion(now.bodies, slot); });
}

/// Runs a stage that looks for one floor among what cannot move. Kinematic bodies that move are no part of it: their neighbours move otherwise.
template <class S, class Stage>
INGOT_INLINE void beside_moving_floors([[maybe_unused]] Step<S>& now, const Stage& stage) {
    if constexpr (S::kinematic_bodies) {
        const auto set_inv_M = [&now](scalar inv_M) {
            const BodyView shapes = now.storage.shapes();
            features::KinematicBodies::for_moving(now.storage, [&](int slot, const KinematicBody&) {
                // bound: max_shapes_of_body
                for (int shape_slot = slot * S::max_shapes_of_body; shape_slot < (slot + 1) * S::max_shapes_of_body; ++shape_slot)
                    shapes.translation[place_of(shape_slot).tile].inv_M[place_of(shape_slot).lane] = inv_M;
            });
        };
        set_inv_M(1);
        stage();
        set_inv_M(0);
    } else {
        stage();
    }
}

/// Which kinematic bodies are fast: see find_fast_pairs.
template <class S>
void find_fast_kinematic([[maybe_unused]] Step<S>& now, [[maybe_unused]] const BodyShapes& shapes) {
    if constexpr (S::kinematic_bodies)
        features::KinematicBodies::for_moving(now.storage, [&](int slot, const KinematicBody&) {
            now.storage.paths[slot].fast = kinematic_begins_fast(now.bodies, shapes, now.h, slot);
        });
}

/// What sleeps where a fast kinematic body comes by wakes: it may be met within the step, and nobody waits.
template <class S>
void wake_in_the_way([[maybe_unused]] Step<S>& now) {
    if constexpr (S::kinematic_bodies && S::continuous) {
        auto& storage = now.storage;
        const RestView rest = storage.rest_view();
        const PairList found = storage.pair_list();
        for (int pair_i = 0; pair_i < *found.count; ++pair_i) {  // bound: pairs_with_own of scene.h
            const BodyPair& pair = found.pairs[pair_i];
            const int A = rest.body_of(pair.body_A), B = rest.body_of(pair.body_B), comes = shows_kinematic_motion(now.bodies, A) ? A : B;
            if (!shows_kinematic_motion(now.bodies, comes) || !storage.paths[comes].fast) continue;
            if (!bounds_overlap(storage.bounds, pair.body_A, pair.body_B)) continue;
            const int met = comes == A ? B : A;
            if (is_dynamic(now.bodies, met) && !rest.is_awake(met)) wake_island(now.bodies, rest, storage.manifold_view(), met);
        }
    }
}

/// What touches a body that moves by itself, or hangs on it, does not come to rest.
template <class S>
void keep_carried_awake([[maybe_unused]] Step<S>& now) {
    if constexpr (S::kinematic_bodies && S::sleeps) {
        const ManifoldView moving = now.storage.moving_manifolds();
        for (int manifold_i = 0; manifold_i < *moving.count; ++manifold_i) {  // bound: max_manifolds
            const BodyPair& pair = moving.pairs[manifold_i];
            // The time at rest is -h, and 0 after the step has been added.
            if (shows_kinematic_motion(now.bodies, pair.body_A)) now.storage.rest_time[pair.body_B] = -now.h;
            if (shows_kinematic_motion(now.bodies, pair.body_B)) now.storage.rest_time[pair.body_A] = -now.h;
        }
        if constexpr (has_joints<S>) features::Figures::keep_hanging_awake(now.storage, now.h);
    }
}

} }  // namespace ingot
