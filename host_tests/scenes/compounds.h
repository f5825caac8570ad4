// SPDX-License-Identifier: MIT
// Bodies of several shapes: hammers, tables, jacks and dumbbells.
#pragma once

#include "hulls.h"

namespace scenes {

/// What scenes of such bodies share.
template <int bodies, int manifolds, int shapes_of_body = 5>
struct Compounded : Hulled<bodies, manifolds> {
    static constexpr int max_shapes_of_body = shapes_of_body;
};

/// Parts in the frame of their maker, of 1 kg m^-3 but for what a test says.
template <unsigned N>
struct Parts {
    ingot::ShapeDef parts[N];

    constexpr ingot::MassProperties mass(scalar M) const { return ingot::principal(ingot::with_mass(ingot::solid_of_shapes(1, parts), M)).value; }
};

constexpr ingot::ShapeDef part(const ingot::Shape& shape, const Vector& r, scalar mu, const ingot::Matrix& A = ingot::identity_matrix<scalar>(),
                               scalar e = 0) {
    ingot::ShapeDef def;
    def.shape = shape;
    def.r = r;
    def.A = A;
    def.friction = mu;
    def.restitution = e;
    return def;
}

constexpr ingot::Matrix along_x = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};  ///< turns what lies along z to lie along x
constexpr ingot::Matrix along_y = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

/// A handle along x from the origin, and a head across its end.
constexpr Parts<2> hammer(scalar mu) {
    return {{part(ingot::Cylinder{scalar(0.0625), scalar(0.5)}, {scalar(0.5), 0, 0}, mu, along_x),
             part(ingot::Box{{scalar(0.125), scalar(0.125), scalar(0.25)}}, {1, 0, 0}, mu)}};
}
/// A plate of 1 m x 1 m x 0.125 m on four legs of 0.75 m; the feet are at height 0.
constexpr Parts<5> table(scalar mu) {
    constexpr ingot::Shape leg = ingot::Box{{scalar(0.0625), scalar(0.0625), scalar(0.375)}};
    constexpr scalar a = scalar(0.4375), z = scalar(0.375);
    return {{part(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.0625)}}, {0, 0, scalar(0.8125)}, mu), part(leg, {a, a, z}, mu),
             part(leg, {-a, a, z}, mu), part(leg, {a, -a, z}, mu), part(leg, {-a, -a, z}, mu)}};
}
/// Three capsules across each other.
constexpr Parts<3> jack(scalar mu) {
    constexpr ingot::Shape arm = ingot::Capsule{scalar(0.125), scalar(0.375)};
    return {{part(arm, {}, mu), part(arm, {}, mu, along_x), part(arm, {}, mu, along_y)}};
}
/// Two balls of this radius with this way between their centres, along y.
constexpr Parts<2> dumbbell(scalar radius, scalar way, scalar mu) {
    return {{part(ingot::Sphere{radius}, {0, -way / 2, 0}, mu), part(ingot::Sphere{radius}, {0, way / 2, 0}, mu)}};
}

/// A body of such parts of mass M, its maker's frame at r and turned by A, at rest.
template <class S, unsigned N>
ingot::Result<ingot::BodyId> add_parts(ingot::World<S>& world, const Parts<N>& parts, scalar M, const Vector& r,
                                       const ingot::Matrix& A = ingot::identity_matrix<scalar>()) {
    ingot::BodyDef def;
    def.mass = parts.mass(M);
    def.state = ingot::body_state(def.mass, {r, A});
    return world.add(def, parts.parts);
}

/// Hammers, tables, jacks, dumbbells and plain bodies fall into a pit.
struct CompoundPile : Compounded<19, 160> {
    using broad_phase = ingot::SortedTree;
    static constexpr const char* name = "compound_pile";
    static constexpr const char* title = "hammers, tables, jacks and dumbbells fall into a pit";
    static constexpr int golden_steps = 180;
    static bool went_well(ingot::StepReport report) { return well_but_for_impacts(report); }
    static constexpr int wall_count = 5;
    static constexpr scalar side = 3, mu = scalar(0.5);
};
template <class S>
ingot::Status set_up_compounds(ingot::World<S>& world) {
    ingot::Status status = world.set_gravity({0, 0, -standard_gravity});
    for (int wall_i = 0; wall_i < S::wall_count && status == ingot::Status::ok; ++wall_i) {
        PlacedBody wall = pit_wall(wall_i, S::side, S::mu);
        wall.def.friction = wall.mu;
        status = world.add(wall.def).status;
    }
    for (int i = 0; i < S::max_bodies - S::wall_count && status == ingot::Status::ok; ++i) {
        const Vector r = {scalar(i % 2) - scalar(0.5) + scalar(0.1) * scattered(i, 0),
                          scalar(i / 2 % 2) - scalar(0.5) + scalar(0.1) * scattered(i, 1), 1 + scalar(i / 4) * scalar(1.25)};
        const ingot::Matrix A = scattered_rotation(i);
        PlacedBody cube = hull_body<S>(cube_form, r, S::mu);
        cube.def.friction = S::mu;
        cube.turn(A);
        status = i % 5 == 0   ? add_parts(world, hammer(S::mu), 1, r, A).status
                 : i % 5 == 1 ? add_parts(world, jack(S::mu), 1, r, A).status
                 : i % 5 == 2 ? add_parts(world, table(S::mu), 1, r, A).status
                 : i % 5 == 3 ? add_parts(world, dumbbell(scalar(0.25), scalar(0.75), S::mu), 1, r, A).status
                              : world.add(cube.def).status;
    }
    return status;
}
inline ingot::Status set_up(ingot::World<CompoundPile>& world) { return set_up_compounds(world); }

}  // namespace scenes
