// SPDX-License-Identifier: MIT
// Several shapes on one body.
//
//     struct Tools : ingot::Scene { ... static constexpr int max_shapes_of_body = 2; };
//     constexpr ingot::ShapeDef parts[] = {{ingot::Cylinder{0.02f, 0.15f}},                       // in the frame you like
//                                          {ingot::Box{{0.03f, 0.03f, 0.06f}}, {0, 0, 0.2f}, A}};
//     def.mass = ingot::principal(ingot::solid_of_shapes(7850, parts)).value;
//     def.state = ingot::body_state(def.mass, {{0, 0, 2}});
//     const ingot::BodyId hammer = world.add(def, parts).value;
//
// A shape has a slot of its own, shapes_of_body of them for each body: slot k of the bodies is slots k shapes_of_body to
// (k + 1) shapes_of_body - 1 of the shapes. Search for pairs, narrow phase and queries see shapes, as bodies of that many slots; the solver
// sees bodies. With one shape a body the two are the same slots and the same memory.
//
// The road not taken: one pool of shapes for all bodies would waste no slot of a body with fewer shapes, but a shape slot would then pass
// from one body to another between two steps, and what is told of the contacts of the first would name the second. A shape slot costs
// about 350 bytes in float; a body with its share of manifolds costs 6000.
#pragma once

#include "../body/mass_properties.h"
#include "surface.h"
#include "convex_hull.h"

namespace ingot { inline namespace INGOT_ABI {

/// One shape of a body of several, and its material. Place in the user's frame of the body's MassProperties: that of their r_CM and A_principal;
/// an immovable body without them lies in its own frame.
struct ShapeDef {
    Shape shape{};  ///< in its own frame
    Vector r{};                            ///< m, of the origin of the shape's own frame
    Matrix A = identity_matrix<scalar>();  ///< the shape's axes in the user's frame; a rotation
    scalar restitution = 0;                ///< as in BodyDef
    scalar friction = scalar(0.5);  ///< as in BodyDef
    bool sensor = false;                   ///< this shape is a sensor; for scenes with max_overlaps
};

/// Where a shape is in the frame of its body: centre of mass and principal axes.
struct ShapePlace {
    Vector r{};  ///< m
    Matrix A{};  ///< shape to body
};

/// The place of a part in the frame of the body that has this mass.
INGOT_INLINE ShapePlace place_in_body(const ShapeDef& part, const MassProperties& mass) {
    return {transpose_times(mass.A_principal, part.r - mass.r_CM), transposed(mass.A_principal) * part.A};
}

/// The shapes of all bodies, without their capacity.
struct CompoundView {
    const Surface* surfaces;   ///< by shape slot
    const ShapePlace* places;  ///< by shape slot
    BodyView shapes;           ///< as bodies: r_CM is where a shape is, v_CM that of its body, and L is omega, with inv_I_body = 1
    int shapes_of_body;
};

/// Brings the shapes of one body where the body is.
///
/// A shape has the velocity of the centre of mass of its body, and a Surface::bounding_radius about it: so bounds and margins hold every point of
/// the shape however the body turns.
/// Cost: about 120 flops a shape.
void place_shapes(const BodyView& bodies, const CompoundView& compounds, int slot);

/// Pairs of shapes of one body are none.
template <int shapes_of_body, class PairList>
void drop_pairs_of_one_body(const PairList& found) {
    int kept = 0;
    // bound: max_pairs and the pairs of shapes of one body: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i)
        if (found.pairs[pair_i].body_A / shapes_of_body != found.pairs[pair_i].body_B / shapes_of_body) found.pairs[kept++] = found.pairs[pair_i];
    *found.count = static_cast<Index>(kept);
}

/// The solid of a shape in its own frame. Hulls are not known here, half spaces have no mass: both are no solid, see mass_properties.h.
constexpr MassDistribution solid_of_shape(scalar density, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere: return solid_sphere(density, shape.size.x);
        case ShapeKind::capsule: return solid_capsule(density, shape.size.x, shape.size.y);
        case ShapeKind::box: return solid_box(density, shape.size);
        case ShapeKind::cylinder: return solid_cylinder(density, shape.size.x, shape.size.y);
        default: return solids::no_solid();
    }
}

/// All shapes as one solid of this density, kg m^-3, in the user's frame; where two overlap, both count. Sensors have no mass.
/// Bodies with hulls: combine their solid_hull with placed and combined.
template <unsigned N>
constexpr MassDistribution solid_of_shapes(scalar density, const ShapeDef (&parts)[N]) {
    MassDistribution sum{};
    for (const ShapeDef& part : parts) {
        if (part.sensor) continue;
        const MassDistribution solid = placed(solid_of_shape(density, part.shape), part.A, part.r);
        sum = sum.M == 0 ? solid : combined(sum, solid);
    }
    return sum;
}

} }  // namespace ingot
