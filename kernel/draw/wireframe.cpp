// SPDX-License-Identifier: MIT
#include "wireframe.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// sin(k pi / 8).
scalar sine(int k) {
    constexpr scalar quarter[] = {0, scalar(0.38268343236508977), scalar(0.70710678118654752), scalar(0.92387953251128676), 1};
    const int half = k & 7;
    const scalar s = quarter[half <= 4 ? half : 8 - half];
    return (k & 8) == 0 ? s : -s;
}
scalar cosine(int k) { return sine(k + 4); }

/// The number k of the points of a circle of radius R, in the plane of two of the axes; along: how far it is moved along the third.
Vector on_circle(int plane, int k, scalar R, scalar along) {
    const scalar u = R * cosine(k), v = R * sine(k);
    if (plane == 0) return {u, v, along};
    if (plane == 1) return {along, u, v};
    return {v, along, u};
}
Line chord(int plane, int k, scalar R, scalar along) { return {on_circle(plane, k, R, along), on_circle(plane, k + 1, R, along)}; }

Line line_of_sphere(int line_i, scalar R) { return chord(line_i / lines_of_circle, line_i, R, 0); }

/// Two circles about the z axis, and what joins them: of a cylinder, and of the straight part of a capsule.
Line line_of_tube(int line_i, scalar R, scalar half_length) {
    if (line_i < 2 * lines_of_circle) return chord(0, line_i, R, line_i < lines_of_circle ? half_length : -half_length);
    const Vector side = on_circle(0, 4 * line_i, R, 0);  // every quarter of the circle
    return {{side.x, side.y, half_length}, {side.x, side.y, -half_length}};
}
constexpr int lines_of_tube = 2 * lines_of_circle + 4;

/// Beyond the tube, the half circles at both ends of a capsule: circles about y and about x that are cut in the middle.
Line line_of_caps(int line_i, scalar R, scalar half_length) {
    const bool about_y = line_i < lines_of_circle;
    Line line = chord(about_y ? 2 : 1, line_i, R, 0);
    const scalar end = line.a.z + line.b.z > 0 ? half_length : -half_length;
    line.a.z += end;
    line.b.z += end;
    return line;
}

/// Its ends are low for a bit that is 0, high for one that is 1, on two axes; on the third it goes from low to high.
Line edge_of_box(const Vector& low, const Vector& high, int line_i) {
    const int axis = line_i / 4;
    const auto corner = [&](int end) {
        const bool far_u = (line_i & 1) != 0, far_v = (line_i & 2) != 0, far = end != 0;
        const bool x = axis == 0 ? far : far_u, y = axis == 1 ? far : axis == 0 ? far_u : far_v, z = axis == 2 ? far : far_v;
        return Vector{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z};
    };
    return {corner(0), corner(1)};
}

/// Of a net on the face of a half space; the directions are those of Duff et al., "Building an Orthonormal Basis, Revisited", 2017: n need not be
/// told apart from the axes.
Line line_of_face(const Vector& n, scalar offset, int line_i, scalar cell) {
    const scalar sign = n.z < 0 ? scalar(-1) : scalar(1), a = -1 / (sign + n.z), b = n.x * n.y * a;
    const Vector u = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, v = {b, sign + n.y * n.y * a, -n.y};
    constexpr int half = lines_of_half_space / 2;  // in each direction: cells, and one more
    const bool along_u = line_i < half;
    const scalar aside = cell * static_cast<scalar>(line_i % half - half / 2), reach = cell * (half / 2);
    const Vector middle = n * offset + (along_u ? v : u) * aside, way = (along_u ? u : v) * reach;
    return {middle - way, middle + way};
}

Line in_shape(const PlacedShape& of, int line_i, scalar cell) {
    const Vector& size = of.shape.size;
    switch (of.shape.kind) {
        case ShapeKind::sphere: return line_of_sphere(line_i, size.x);
        case ShapeKind::cylinder: return line_of_tube(line_i, size.x, size.y);
        case ShapeKind::capsule:
            if (line_i < lines_of_tube) return line_of_tube(line_i, size.x, size.y);
            return line_of_caps(line_i - lines_of_tube, size.x, size.y);
        case ShapeKind::level:
        case ShapeKind::box: return edge_of_box(-size, size, line_i);
        case ShapeKind::half_space: return line_of_face(size, of.shape.offset, line_i, cell);
        default: return {of.hull->vertices[of.hull->edges[line_i].a], of.hull->vertices[of.hull->edges[line_i].b]};
    }
}

}  // namespace

int line_count(const PlacedShape& shape) {
    switch (shape.shape.kind) {
        case ShapeKind::none: return 0;
        case ShapeKind::sphere: return 3 * lines_of_circle;
        case ShapeKind::cylinder: return lines_of_tube;
        case ShapeKind::capsule: return lines_of_capsule;
        case ShapeKind::level:  // the box that holds it: triangles are for whoever has the tables
        case ShapeKind::box: return lines_of_box;
        case ShapeKind::half_space: return lines_of_half_space;
        case ShapeKind::hull: return shape.hull == nullptr ? 0 : shape.hull->edge_count;
    }
    return 0;
}

Line line_of(const PlacedShape& shape, int line_i, scalar cell) {
    const Line own = in_shape(shape, line_i, cell);
    return {shape.r + shape.A * own.a, shape.r + shape.A * own.b};
}

Line line_of_bounds(const Vector& low, const Vector& high, int line_i) { return edge_of_box(low, high, line_i); }

} }  // namespace ingot
