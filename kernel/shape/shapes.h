// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../base/status.h"
#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

/// In this order the routines of the narrow phase take their two shapes.
enum class ShapeKind : uint8_t { none, sphere, capsule, box, cylinder, hull, half_space, level };

/// These are shapes of what cannot move.
constexpr bool is_ground(ShapeKind kind) { return kind == ShapeKind::half_space || kind == ShapeKind::level; }

/// The surface of a body in its own frame (origin at the centre of mass, principal axes). Made from Sphere, Box, HalfSpace,
/// Capsule, Cylinder or Hull.
struct Shape {
    ShapeKind kind{};  ///< which
    /// sphere: radius, 0, 0; box: half extents; half space: outward unit normal; capsule, cylinder: radius, half length, 0;
    /// hull: radius of the ball about the origin that holds it, its number in Scene::hulls, 0; level: half extents of the box that holds it
    Vector size{};
    scalar offset{};  ///< half space: distance of its face from the origin along the normal; level: which, see Level; else 0
};

/// A ball about the centre of mass. radius in m, limits::size_min .. size_max.
struct Sphere {
    static constexpr ShapeKind kind = ShapeKind::sphere;
    scalar radius{};  ///< m
    constexpr operator Shape() const { return {kind, {radius, 0, 0}, 0}; }
};

/// A box about the centre of mass, along the principal axes. half_extents in m, each limits::size_min .. size_max.
struct Box {
    static constexpr ShapeKind kind = ShapeKind::box;
    Vector half_extents{};  ///< m, of each edge the half
    constexpr operator Shape() const { return {kind, half_extents, 0}; }
};

/// All points with normal . r <= offset: solid ground; a wall. For immovable bodies only.
struct HalfSpace {
    static constexpr ShapeKind kind = ShapeKind::half_space;
    Vector normal{};  ///< unit, out of the solid
    scalar offset{};    ///< m, of the face from the origin along the normal
    constexpr operator Shape() const { return {kind, normal, offset}; }
};

/// All points no further than the radius from a stretch of the z axis. radius and half_length (of the straight part) in m, each
/// limits::size_min .. size_max.
struct Capsule {
    static constexpr ShapeKind kind = ShapeKind::capsule;
    scalar radius{}, half_length{};  ///< m
    constexpr operator Shape() const { return {kind, {radius, half_length, 0}, 0}; }
};

/// A cylinder about the origin, its axis along z. radius and half_length in m, each limits::size_min .. size_max.
struct Cylinder {
    static constexpr ShapeKind kind = ShapeKind::cylinder;
    scalar radius{}, half_length{};  ///< m
    constexpr operator Shape() const { return {kind, {radius, half_length, 0}, 0}; }
};

/// A convex polyhedron: its form is a ConvexHull, of a body Scene::hulls[form], of a query whatever PlacedShape::hull points to. The
/// radius of the ball about the origin that holds it is ConvexHull::radius, limits::size_min .. size_max. See hull_of.
struct Hull {
    static constexpr ShapeKind kind = ShapeKind::hull;
    scalar radius{};  ///< m
    int form = 0;  ///< of Scene::hulls
    constexpr operator Shape() const { return {kind, {radius, static_cast<scalar>(form), 0}, 0}; }
};

/// How many contacts of planes of their own a body may have with one level: floor and walls.
inline constexpr int level_patches = 4;

/// A mesh or a field of heights, from a table: Scene::levels[number]. Made by World::add_level. Its origin is the middle of the box that holds it.
///
/// As each pair of shapes has one contact, a level is as many shapes, in slots one behind the other, as it may have contacts with a body.
struct Level {
    static constexpr ShapeKind kind = ShapeKind::level;
    Vector half_extents{};  ///< m, of the box along its axes that holds it
    int number = 0;         ///< of Scene::levels
    int patch = 0;          ///< which of its shapes, 0 .. level_patches - 1
    constexpr operator Shape() const { return {kind, half_extents, static_cast<scalar>(number * level_patches + patch)}; }
};
constexpr int level_number(const Shape& level) { return static_cast<int>(level.offset) / level_patches; }
constexpr int patch_number(const Shape& level) { return static_cast<int>(level.offset) % level_patches; }

/// The shapes a scene names: `using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;`. Only their tests are linked.
template <class... Named>
struct Shapes {
    static constexpr bool has([[maybe_unused]] ShapeKind kind) { return ((Named::kind == kind) || ... || false); }  ///< the scene names this kind
};

/// Radius of the sphere about the centre of mass that holds the shape; 0 for a half space, which has none. Units: m.
scalar bounding_radius(const Shape& shape);

struct ConvexHull;
/// The least half extent of a shape; of a hull, the radius of the ball about its centre that it holds. What has no size is infinitely thick.
/// Units: m. hull: the form of a hull; else null.
///
/// Never inlined: where gcc sees it beside BodyShapes::hull, in one unit at -O3, it takes the null of other kinds for one that a hull may have.
INGOT_NOINLINE scalar least_half_extent(const Shape& shape, const ConvexHull* hull);

/// Errors: not_finite, bad_shape (a size outside limits::size_min .. size_max), bad_direction (a normal not of unit length),
///         out_of_range (an offset beyond limits::position_max).
Status check_shape(const Shape& shape);

} }  // namespace ingot
