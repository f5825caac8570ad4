// SPDX-License-Identifier: MIT
// Scenes with friction for the smallest targets and the golden hashes: a tower, a pyramid and a mixed pile.
#pragma once

#include "contact/bullets.h"
#include "contact/materials.h"
#include "contact/piles.h"
#include "contact/stacks.h"
#include "well_but_for_impacts.h"

namespace scenes {

/// What they share. Pairs are as many as manifolds and half again: bodies that touch are near others.
template <int bodies, int manifolds>
struct Stacked : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;

    static constexpr scalar h = display_rate_h;  ///< s
};

/// Ten cubes in one column.
struct Tower10 : Stacked<11, 10> {
    static constexpr const char* name = "tower_10";
    static constexpr const char* title = "ten cubes in one column";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return Tower<10>::body(body_i); }
};

/// The budget of a Cortex-M4F, see TenBoxes: ten cubes side by side, and in one column, in what memory they need.
struct TenBoxesBudget : Stacked<11, 10> {
    static constexpr bool bounces = false;
    static constexpr bool recycles_manifolds = false;
    static constexpr bool hides_internal_edges = false, holds_crowds = false;
    using solver = ingot::SequentialImpulses;
    using rotation = ingot::LieMidpoint;
};
struct TenBoxesRow : TenBoxesBudget {
    static constexpr const char* name = "ten_boxes_row";
    static constexpr const char* title = "ten cubes side by side";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return TenBoxes<false>::body(body_i); }
};
struct TenBoxesColumn : TenBoxesBudget {
    static constexpr const char* name = "ten_boxes_column";
    static constexpr const char* title = "ten cubes in one column, as small as can be";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return TenBoxes<true>::body(body_i); }
};

/// The same with a budget of work.
struct TenBoxesOnBudget : TenBoxesBudget {
    static constexpr const char* name = "ten_boxes_on_budget";
    static constexpr const char* title = "ten cubes in one column, each contact visited up to 20 times a step";
    static constexpr int golden_steps = 120;
    static constexpr int work_budget = 20 * max_manifolds;
    static bool went_well(ingot::StepReport report) {
        report.sweeps_unfinished = 0;
        return report.clean();
    }
    static constexpr PlacedBody body(int body_i) { return TenBoxes<true>::body(body_i); }
};

/// Boxes and balls fall into a pit, solved point by point: impacts, what slides and spins, manifolds that come and go, rest.
struct LightPile : Stacked<13, 48> {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using solver = ingot::SequentialImpulses;
    static constexpr bool bounces = false;
    static constexpr const char* name = "light_pile";
    static constexpr const char* title = "boxes and balls fall into a pit, solved point by point";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr scalar side = scalar(1.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i < 5) return pit_wall(body_i, side, scalar(0.5));
        const int piece_i = body_i - 5;
        const Vector r = {(scalar(piece_i % 2) - scalar(0.5)) * scalar(0.7), scalar(0.1) * scattered(piece_i, 0), scalar(0.5) + scalar(piece_i / 2)};
        const scalar size = scalar(0.25) + scalar(0.05) * scattered(piece_i, 1);
        if (piece_i % 3 == 0) return solid_ball(1, size, r, scalar(0.5));
        PlacedBody box = solid_box(scalar(1 + piece_i % 2), {size, size * scalar(0.75), size * scalar(0.5)}, r, scalar(0.5));
        box.turn(scattered_rotation(piece_i));
        box.move({}, {0, 0, 3});
        return box;
    }
};

/// A wall of 55 cubes: ten in the lowest row.
struct Pyramid55 : Stacked<56, 110> {
    static constexpr const char* name = "pyramid_55";
    static constexpr const char* title = "a wall of 55 cubes";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return Pyramid<10>::body(body_i); }
};

/// 1000 t on 1 kg, which no sweeps carry: solved directly.
struct MassRatio1e6 : Stacked<3, 2> {
    using solver = ingot::HybridIslands<2, 6>;
    static constexpr const char* name = "mass_ratio_1e6";
    static constexpr const char* title = "a cube of 1000 t on one of 1 kg";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return MassRatio<1, 1000000>::body(body_i); }
};

/// Twenty cubes in one column, solved directly.
struct Tower20 : Stacked<21, 20> {
    using solver = ingot::HybridIslands<20, 10>;
    static constexpr const char* name = "tower_20";
    static constexpr const char* title = "twenty cubes in one column, solved directly";
    static constexpr int golden_steps = 120;
    static constexpr PlacedBody body(int body_i) { return Tower<20>::body(body_i); }
};

/// Boxes of 1 and 100 kg fall on each other: a solver that picks itself, with solves that settle and solves that do not.
struct ChosenBoxes : Stacked<13, 78> {
    using solver = ingot::HybridIslands<>;
    static constexpr const char* name = "uneven_boxes";
    static constexpr const char* title = "boxes of 1 and 100 kg fall on each other, solved by what suits";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr PlacedBody body(int body_i) { return UnevenBoxes<12, 100>::body(body_i); }
};

/// Boxes and balls fall into a pit, some of them springy: every routine of these shapes, manifolds that come and go, bounces and rest.
struct MixedPile : Stacked<21, 110> {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
    static constexpr const char* name = "mixed_pile";
    static constexpr const char* title = "boxes and balls fall into a pit";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr int wall_count = 5;
    static constexpr scalar side = 3;

    static constexpr PlacedBody body(int body_i) {
        if (body_i < wall_count) return pit_wall(body_i, side, scalar(0.5));
        const int piece_i = body_i - wall_count;
        const Vector r = {scalar(piece_i % 2) - scalar(0.5) + scalar(0.1) * scattered(piece_i, 0),
                          scalar(piece_i / 2 % 2) - scalar(0.5) + scalar(0.1) * scattered(piece_i, 1),
                          1 + scalar(piece_i / 4)};
        const scalar size = scalar(0.3) + scalar(0.1) * scattered(piece_i, 2);
        const scalar e = piece_i % 5 == 0 ? scalar(0.5) : scalar(0);
        if (piece_i % 3 == 0) return solid_ball(1, size, r, scalar(0.5), e);
        PlacedBody box = solid_box(1, {size, size * scalar(0.75), size * scalar(0.5)}, r, scalar(0.5), e);
        box.turn(scattered_rotation(piece_i));
        return box;
    }
};

/// Three towers of four fall asleep, and a ball that rolls into the first wakes it: of islands at the end, some sleep and one moves.
struct SleepingTowers : Stacked<14, 48> {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    static constexpr bool sleeps = true;
    static constexpr const char* name = "sleeping_towers";
    static constexpr const char* title = "towers that sleep, and a ball that wakes one";
    static constexpr int golden_steps = 130;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(scalar(0.6));
        if (body_i < 13)  // slot by slot another tower: a tile holds bodies of all
            return unit_cube({3 * static_cast<scalar>((body_i - 1) % 3), 0, static_cast<scalar>((body_i - 1) / 3) + scalar(0.5)}, scalar(0.6));
        PlacedBody ball = solid_ball(1, scalar(0.5), {-6, scalar(0.2), scalar(0.5)}, scalar(0.6));
        ball.move({3, 0, 0}, {0, 6, 0});
        return ball;
    }
};

/// Boxes, balls and a capsule in a sensor, with filters, events and sleep: many features at once, for the budgets of small targets.
struct Playground : Stacked<9, 12> {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    static constexpr bool filters = true, sleeps = true;
    static constexpr bool hides_internal_edges = false, holds_crowds = false;  // its ground is alone, and there is room for all
    static constexpr int max_overlaps = 8, max_events = 24;
    static constexpr const char* name = "playground";
    static constexpr const char* title = "boxes, balls and a capsule, with filters, a sensor, events and sleep";
    static constexpr int golden_steps = 60;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar mu = scalar(0.5);
        if (body_i == 0) return flat_ground(mu);
        if (body_i < 4) return unit_cube({0, 0, static_cast<scalar>(body_i) - scalar(0.4)}, mu);
        if (body_i == 4) {
            PlacedBody sensor = fixed_box({2, 2, 2}, {0, 0, 2}, mu);
            sensor.def.sensor = true;
            return sensor;
        }
        PlacedBody piece = solid_ball(1, scalar(0.5), {static_cast<scalar>(body_i - 5) * 2 - 5, scalar(0.1), scalar(0.6)}, mu, scalar(0.5));
        if (body_i == 8) piece.def.shape = ingot::Capsule{scalar(0.5), scalar(0.5)};
        if (body_i == 7) piece.def.filter = {2, 1};  // meets nobody but the ground and the boxes
        piece.move({3, 0, 0}, {0, 6, 0});
        return piece;
    }
};

/// Bullets through standing walls, followed within the step.
struct BulletRange : Stacked<BulletWalls::body_count, 40> {
    static constexpr bool continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    static constexpr const char* name = "bullet_walls";
    static constexpr const char* title = "bullets through standing walls";
    static constexpr int golden_steps = 60;
    static constexpr PlacedBody body(int body_i) { return BulletWalls::body(body_i); }
    /// In a crowd some wait for others, and bullets that scrape along a wall spin beyond the limit: that is what reports are for.
    static bool went_well(ingot::StepReport report) {
        report.impacts_deferred = report.spins_clamped = report.sweeps_unfinished = 0;
        return report.clean();
    }
};

/// Parcels on belts, balls that resist being rolled, a crawler.
struct Conveyors : Stacked<ConveyorLine::body_count, 48> {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    static constexpr const char* name = "conveyors";
    static constexpr const char* title = "parcels on belts, balls that resist being rolled";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr PlacedBody body(int body_i) { return ConveyorLine::body(body_i).body; }
};

/// Adds the bodies of a scene one by one: no target keeps them all.
template <class S>
ingot::Status set_up_placed(ingot::World<S>& world) {
    ingot::Status status = world.set_gravity({0, 0, -standard_gravity});
    for (int body_i = 0; body_i < S::max_bodies && status == ingot::Status::ok; ++body_i) {
        PlacedBody placed = S::body(body_i);
        placed.def.friction = placed.mu;
        status = world.add(placed.def).status;
    }
    return status;
}
inline ingot::Status set_up(ingot::World<Tower10>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<TenBoxesRow>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<TenBoxesColumn>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<TenBoxesOnBudget>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<LightPile>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<Pyramid55>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<MassRatio1e6>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<Tower20>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<ChosenBoxes>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<MixedPile>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<SleepingTowers>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<Playground>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<BulletRange>& world) { return set_up_placed(world); }
inline ingot::Status set_up(ingot::World<Conveyors>& world) {
    ingot::Status status = set_up_placed(world);
    for (int body_i = 0; body_i < Conveyors::max_bodies && status == ingot::Status::ok; ++body_i) {
        const MaterialBody material = ConveyorLine::body(body_i);
        status = world.set_rolling_resistance(world.body_at(body_i), material.rolling_lever);
        if (status == ingot::Status::ok) status = world.set_surface_velocity(world.body_at(body_i), material.surface_velocity);
    }
    return status;
}

}  // namespace scenes
