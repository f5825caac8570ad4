// SPDX-License-Identifier: MIT
// The shapes of bodies as they lie on them: for whoever asks where a shape is when its body is somewhere.
#pragma once

#include "compound.h"
#include "placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A slot of a shape: see compound.h. Where each body has one shape, it has the number of the body's slot, and still is no slot of a body.
struct ShapeSlot {
    int number;
};

/// The shapes of all bodies, without their capacity, and the forms of the scene's hulls.
struct BodyShapes {
    SurfaceView surfaces;      ///< by shape slot
    const ShapePlace* places;  ///< by shape slot; null where each body has one shape, in its own frame
    HullTable hulls;
    int shapes_of_body;

    int body_count() const { return body_of({surfaces.slot_count}); }
    INGOT_INLINE int body_of(ShapeSlot shape) const { return shapes_of_body == 1 ? shape.number : shape.number / shapes_of_body; }
    const Surface& surface(ShapeSlot shape) const { return surfaces.surfaces[shape.number]; }
    const ShapePlace* place(ShapeSlot shape) const { return places == nullptr ? nullptr : places + shape.number; }
    /// The form of a hull; null for all other kinds.
    const ConvexHull* hull(ShapeSlot shape) const {
        const Shape& of = surface(shape).shape;
        return of.kind == ShapeKind::hull ? hulls.hulls + static_cast<int>(of.size.y) : nullptr;
    }

    /// Calls each(ShapeSlot) for the shapes that a body has.
    template <class Each>
    INGOT_INLINE void for_shapes(int body, const Each& each) const {
        // bound: max_shapes_of_body
        for (int number = body * shapes_of_body; number < (body + 1) * shapes_of_body; ++number)
            if (surfaces.surfaces[number].shape.kind != ShapeKind::none) each(ShapeSlot{number});
    }
};

/// A shape whose body has its centre of mass at r_CM and its axes at A. place: null for a body's only shape.
INGOT_INLINE PlacedShape place_on_body(const Shape& shape, const ShapePlace* place, const ConvexHull* hull, const Vector& r_CM, const Matrix& A) {
    if (place == nullptr) return {shape, r_CM, A, hull};
    return {shape, r_CM + A * place->r, A * place->A, hull};
}

} }  // namespace ingot
