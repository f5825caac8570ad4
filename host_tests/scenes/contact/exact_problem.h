// SPDX-License-Identifier: MIT
// A contact scene as a problem for host_tests/reference/contact_reference.h: where its bodies touch, found in double without
// the kernel's collision code. For scenes as they are defined, where bodies touch or are apart; all pairs, so for hundreds of
// bodies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "placed_body.h"
#include "reference/contact_reference.h"
#include "reference/kernel_types.h"

namespace scenes {

using ingot_reference::ContactPoint;
using ingot_reference::ContactProblem;
using ingot_reference::Matrix3d;
using ingot_reference::Vector3d;

/// A face: normal . r = offset, outward, its corners counter-clockwise from outside.
struct Face {
    Vector3d n;
    double offset;
    std::array<Vector3d, 4> corners;
};

/// A body's surface in the world, in double.
struct Surface {
    ingot::ShapeKind kind;  ///< box: a hexahedron
    double radius = 0;      ///< sphere; else of the circumscribed one
    Vector3d centre = Vector3d::Zero();
    Vector3d n = Vector3d::Zero();  ///< half space: normal and offset
    double offset = 0;
    std::vector<Vector3d> corners;
    std::vector<Face> faces;

    explicit Surface(const PlacedBody& body) : kind(body.is_hull ? ingot::ShapeKind::box : body.def.shape.kind) {
        const Matrix3d A = ingot_reference::to_eigen(body.def.state.A);
        const Vector3d size = ingot_reference::to_eigen(body.def.shape.size);
        centre = ingot_reference::to_eigen(body.def.state.r_CM);
        if (kind == ingot::ShapeKind::half_space) {
            n = (A * size).normalized();
            offset = static_cast<double>(body.def.shape.offset) + n.dot(centre);
        } else if (kind == ingot::ShapeKind::sphere) {
            radius = size.x();
        } else {
            for (int i = 0; i < 8; ++i) {
                const Vector3d signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
                const Vector3d local =
                    body.is_hull ? ingot_reference::to_eigen(body.corner[i]) : Vector3d(signs.cwiseProduct(size));
                corners.push_back(centre + A * local);
                radius = std::max(radius, local.norm());
            }
            for (const int(&face_i)[4] : hexahedron_face) add_face(face_i);
        }
    }

private:
    void add_face(const int (&face_i)[4]) {
        Face face;
        for (std::size_t i = 0; i < 4; ++i) face.corners[i] = corners[static_cast<std::size_t>(face_i[i])];
        face.n = (face.corners[2] - face.corners[0]).cross(face.corners[3] - face.corners[1]).normalized();
        face.offset = face.n.dot(face.corners[0] + face.corners[1] + face.corners[2] + face.corners[3]) / 4;
        faces.push_back(face);
    }
};

/// Where two surfaces touch: n from B to A.
struct Touch {
    Vector3d r_P, n;
};

/// What is left of a polygon (or an edge, or a point) over a face.
inline std::vector<Vector3d> clipped(std::vector<Vector3d> polygon, const Face& face, double tolerance) {
    for (std::size_t side_i = 0; side_i < 4; ++side_i) {
        const Vector3d from = face.corners[side_i], to = face.corners[(side_i + 1) % 4],
                       out = (to - from).cross(face.n).normalized();
        std::vector<Vector3d> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector3d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double d_a = out.dot(a - from), d_b = out.dot(b - from);
            if (d_a <= tolerance) kept.push_back(a);
            if ((d_a < -tolerance && d_b > tolerance) || (d_a > tolerance && d_b < -tolerance))
                kept.push_back(a + (b - a) * (d_a / (d_a - d_b)));
        }
        polygon = kept;
    }
    return polygon;
}

/// Adds what of `other` touches a face of `owner`; n points out of the face, times `sign`.
inline void add_touches_on_faces(const Surface& owner, const Surface& other, double sign, double tolerance,
                                 std::vector<Touch>& touches) {
    for (const Face& face : owner.faces) {
        std::vector<Vector3d> touching;
        bool outside = true;
        for (const Vector3d& corner : other.corners) {
            const double d = face.n.dot(corner) - face.offset;
            outside = outside && d >= -tolerance;
            if (d <= tolerance) touching.push_back(corner);
        }
        if (!outside || touching.empty()) continue;
        for (const Face& opposite : other.faces)  // all four corners: in their order
            if (touching.size() == 4 && opposite.n.dot(face.n) < -0.99)
                std::copy(opposite.corners.begin(), opposite.corners.end(), touching.begin());
        for (const Vector3d& r_P : clipped(touching, face, tolerance)) {
            bool is_new = true;
            for (const Touch& touch : touches)
                if ((touch.r_P - r_P).norm() <= 4 * tolerance && touch.n.dot(sign * face.n) > 0.9999) is_new = false;
            if (is_new) touches.push_back({r_P, sign * face.n});
        }
    }
}

/// Where A and B touch within the tolerance, m. Two corners that meet have no normal of their own: they get that of every face
/// that keeps them apart.
inline std::vector<Touch> touches_of(const Surface& A, const Surface& B, double tolerance) {
    using ingot::ShapeKind;
    std::vector<Touch> touches;
    if (A.kind == ShapeKind::half_space || (A.kind == ShapeKind::box && B.kind == ShapeKind::sphere)) {
        touches = touches_of(B, A, tolerance);
        for (Touch& touch : touches) touch.n = -touch.n;
    } else if (B.kind == ShapeKind::half_space) {
        const std::vector<Vector3d> lowest =
            A.kind == ShapeKind::sphere ? std::vector<Vector3d>{A.centre - A.radius * B.n} : A.corners;
        for (const Vector3d& r_P : lowest)
            if (std::abs(B.n.dot(r_P) - B.offset) <= tolerance) touches.push_back({r_P, B.n});
    } else if (A.kind == ShapeKind::sphere && B.kind == ShapeKind::sphere) {
        const Vector3d apart = A.centre - B.centre;
        if (std::abs(apart.norm() - A.radius - B.radius) <= tolerance)
            touches.push_back({B.centre + apart.normalized() * B.radius, apart.normalized()});
    } else if (A.kind == ShapeKind::sphere) {
        for (const Face& face : B.faces) {
            const Vector3d r_P = A.centre - A.radius * face.n;
            if (std::abs(face.n.dot(r_P) - face.offset) <= tolerance && clipped({r_P}, face, tolerance).size() == 1)
                touches.push_back({r_P, face.n});
        }
    } else if ((A.centre - B.centre).norm() <= A.radius + B.radius + tolerance) {
        add_touches_on_faces(B, A, 1, tolerance, touches);
        add_touches_on_faces(A, B, -1, tolerance, touches);
    }
    return touches;
}

/// How deep two surfaces are inside each other, m, by the faces and centres that keep them apart; not positive: apart.
inline double overlap_of(const Surface& A, const Surface& B) {
    using ingot::ShapeKind;
    if (A.kind == ShapeKind::half_space) return B.kind == ShapeKind::half_space ? 0 : overlap_of(B, A);
    if (A.kind == ShapeKind::box && B.kind == ShapeKind::sphere) return overlap_of(B, A);
    const auto reach = [](const Surface& surface, const Vector3d& n) {  // how far it goes along -n
        if (surface.kind == ShapeKind::sphere) return surface.radius - n.dot(surface.centre);
        double most = -1e300;
        for (const Vector3d& corner : surface.corners) most = std::max(most, -n.dot(corner));
        return most;
    };
    if (B.kind == ShapeKind::half_space) return B.offset + reach(A, B.n);
    double least = A.radius + B.radius - (A.centre - B.centre).norm();
    for (const Face& face : B.faces) least = std::min(least, face.offset + reach(A, face.n));
    for (const Face& face : A.faces) least = std::min(least, face.offset + reach(B, face.n));
    return least;
}

/// How two mu make one.
inline double geometric_mean(double a, double b) { return std::sqrt(a * b); }
inline double product(double a, double b) { return a * b; }

/// Bodies and points of a scene before a step of h: gravity has acted, contacts have not.
inline ContactProblem exact_problem(const std::vector<PlacedBody>& bodies, const Vector3d& gravity, double h, double tolerance,
                                    double (*mixed_mu)(double, double) = geometric_mean) {
    ContactProblem problem;
    problem.h = h;
    std::vector<Surface> surfaces;
    for (const PlacedBody& placed : bodies) {
        surfaces.emplace_back(placed);
        ingot_reference::ContactBody body;
        body.r_CM = surfaces.back().centre;
        if (!placed.def.immovable) {
            const Matrix3d A = ingot_reference::to_eigen(placed.def.state.A);
            const Vector3d I = ingot_reference::to_eigen(placed.def.mass.I_body);
            body.inv_M = 1 / static_cast<double>(placed.def.mass.M);
            body.inv_I_world = A * I.cwiseInverse().asDiagonal() * A.transpose();
            body.v_CM = ingot_reference::to_eigen(placed.def.state.v_CM) + h * gravity;
            body.omega = ingot_reference::to_eigen(placed.omega);
        }
        problem.bodies.push_back(body);
    }
    for (std::size_t a = 0; a < bodies.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (bodies[a].def.immovable && bodies[b].def.immovable) continue;
            for (const Touch& touch : touches_of(surfaces[a], surfaces[b], tolerance)) {
                ContactPoint point;
                point.body_A = static_cast<int>(a);
                point.body_B = static_cast<int>(b);
                point.r_P = touch.r_P;
                point.n = touch.n;
                point.mu = mixed_mu(static_cast<double>(bodies[a].mu), static_cast<double>(bodies[b].mu));
                problem.points.push_back(point);
            }
        }
    }
    return problem;
}

template <class Scene>
std::vector<PlacedBody> bodies_of() {
    std::vector<PlacedBody> bodies;
    for (int body_i = 0; body_i < Scene::body_count; ++body_i) bodies.push_back(Scene::body(body_i));
    return bodies;
}

template <class Scene>
ContactProblem exact_problem_of(double tolerance, double (*mixed_mu)(double, double) = geometric_mean) {
    return exact_problem(bodies_of<Scene>(), ingot_reference::to_eigen(Scene::gravity), static_cast<double>(Scene::h),
                         tolerance, mixed_mu);
}

}  // namespace scenes
