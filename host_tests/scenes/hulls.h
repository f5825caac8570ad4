// SPDX-License-Identifier: MIT
// Convex hulls in flash, and a pile of every shape there is.
#pragma once

#include "stacked.h"

namespace scenes {

/// Points of hulls in the frame their maker likes; what a world has is seen from their centre of mass.
constexpr Vector cube_points[8] = {{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {0.5, 0.5, -0.5},
                                   {-0.5, -0.5, 0.5},  {0.5, -0.5, 0.5},  {-0.5, 0.5, 0.5},  {0.5, 0.5, 0.5}};
constexpr Vector tetrahedron_points[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // a corner of a cube: all axes and the centre are elsewhere
constexpr Vector octahedron_points[6] = {{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}, {0, 0, 0.5}, {0, 0, -0.5}};
constexpr Vector rock_points[10] = {{2, 1, 0.25},       {2.75, 1.125, 0.25}, {2.5, 1.75, 0.3125}, {2.125, 1.625, 0.25}, {2, 1.25, 0.75},
                                    {2.5, 1, 0.875},   {2.875, 1.5, 0.625}, {2.375, 1.875, 0.75}, {2.25, 1.5, 1},       {2.625, 1.375, 0.9375}};

/// A solid hull as a body has it: its mass, and the hull in the body's frame.
template <unsigned N>
struct SolidHull {
    ingot::MassProperties mass;
    ingot::Result<ingot::HullOf<N>> hull;
};
template <unsigned N>
constexpr SolidHull<N> solid_hull_of(const Vector (&points)[N], scalar M) {
    const auto as_given = ingot::convex_hull(points);
    const auto solid = ingot::solid_hull(1, as_given.value.view());
    const ingot::MassProperties mass = ingot::principal(ingot::with_mass(solid.value, M)).value;
    return {mass, ingot::convex_hull_of_body(points, mass)};
}
inline constexpr auto cube_hull = solid_hull_of(cube_points, 1);
inline constexpr auto tetrahedron_hull = solid_hull_of(tetrahedron_points, 1);
inline constexpr auto octahedron_hull = solid_hull_of(octahedron_points, 1);
inline constexpr auto rock_hull = solid_hull_of(rock_points, 1);
static_assert(cube_hull.hull.ok() && tetrahedron_hull.hull.ok() && octahedron_hull.hull.ok() && rock_hull.hull.ok());

enum HullForm { cube_form, tetrahedron_form, octahedron_form, rock_form };

/// What scenes with these hulls share; every shape and every pair of shapes.
template <int bodies, int manifolds>
struct Hulled : Stacked<bodies, manifolds> {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {cube_hull.hull.value.view(), tetrahedron_hull.hull.value.view(), octahedron_hull.hull.value.view(),
                                                  rock_hull.hull.value.view()};
};

/// A body that is one of these hulls, at rest.
template <class S>
constexpr PlacedBody hull_body(HullForm form, const Vector& r_CM, scalar mu) {
    PlacedBody body;
    body.def.mass = form == cube_form          ? cube_hull.mass
                    : form == tetrahedron_form ? tetrahedron_hull.mass
                    : form == octahedron_form  ? octahedron_hull.mass
                                               : rock_hull.mass;
    body.def.shape = ingot::hull_of<S>(form);
    body.def.state.r_CM = r_CM;
    body.mu = mu;
    return body;
}

/// Hulls of all forms, balls, capsules, boxes and cylinders fall into a pit.
struct HullPile : Hulled<23, 100> {
    static constexpr const char* name = "hull_pile";
    static constexpr const char* title = "hulls and all other shapes fall into a pit";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr int wall_count = 5;
    static constexpr scalar side = 3;

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar mu = scalar(0.5);
        if (body_i < wall_count) return pit_wall(body_i, side, mu);
        const int piece_i = body_i - wall_count;
        const Vector r = {scalar(piece_i % 2) - scalar(0.5) + scalar(0.1) * scattered(piece_i, 0),
                          scalar(piece_i / 2 % 2) - scalar(0.5) + scalar(0.1) * scattered(piece_i, 1), 1 + scalar(piece_i / 4)};
        PlacedBody body = hull_body<HullPile>(static_cast<HullForm>(piece_i % 4), r, mu);
        if (piece_i % 6 == 4) body = solid_ball(1, scalar(0.375), r, mu);
        if (piece_i % 6 == 5) {
            body.def.mass = mass_of(ingot::with_mass(ingot::solid_cylinder(1, scalar(0.375), scalar(0.375)), 1));
            body.def.shape = piece_i % 4 == 1 ? ingot::Shape(ingot::Cylinder{scalar(0.375), scalar(0.375)})
                                              : ingot::Shape(ingot::Capsule{scalar(0.25), scalar(0.25)});
        }
        if (piece_i % 9 == 8) body = solid_box(1, {scalar(0.5), scalar(0.375), scalar(0.25)}, r, mu);
        body.turn(scattered_rotation(piece_i));
        return body;
    }
};
inline ingot::Status set_up(ingot::World<HullPile>& world) { return set_up_placed(world); }

}  // namespace scenes
