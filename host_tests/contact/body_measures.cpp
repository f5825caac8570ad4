// SPDX-License-Identifier: MIT
#include "body_measures.h"

#include "collide/convex_oracle.h"
#include "reference/kernel_types.h"
#include "scenes/contact/exact_problem.h"

namespace ingot_contact {

using ingot_reference::to_eigen;
using scenes::PlacedBody;
using scenes::Surface;

namespace {

bool is_ball(const PlacedBody& body) { return body.def.shape.kind == ingot::ShapeKind::sphere; }
/// What the oracle knows: boxes and balls. By faces alone, a ball beside an edge of a box would count as inside.
bool is_known(const PlacedBody& body) { return is_ball(body) || body.def.shape.kind == ingot::ShapeKind::box; }
ingot_oracle::Convex convex(const PlacedBody& body) {
    const ingot::BodyState& state = body.def.state;
    const auto r = to_eigen<long double>(state.r_CM), size = to_eigen<long double>(body.def.shape.size);
    return is_ball(body) ? ingot_oracle::point(r, size.x()) : ingot_oracle::box(r, to_eigen<long double>(state.A), size);
}

}  // namespace

Eigen::Vector3d omega_of(const PlacedBody& body) {
    const Eigen::Matrix3d A = to_eigen(body.def.state.A);
    return A * (A.transpose() * to_eigen(body.def.state.L)).cwiseQuotient(to_eigen(body.def.mass.I_body));
}

double kinetic_energy_of(const PlacedBody& body) {
    if (body.def.immovable) return 0;
    const double M = static_cast<double>(body.def.mass.M);
    return (M * to_eigen(body.def.state.v_CM).squaredNorm() + to_eigen(body.def.state.L).dot(omega_of(body))) / 2;
}

double overlap_by_faces(const PlacedBody& A, const PlacedBody& B) { return scenes::overlap_of(Surface(A), Surface(B)); }

double overlap_of(const PlacedBody& A, const PlacedBody& B) {
    if (!is_known(A) || !is_known(B)) return overlap_by_faces(A, B);
    return -static_cast<double>(ingot_oracle::signed_distance(convex(A), convex(B)));
}

std::vector<double> overlaps_of(const std::vector<PlacedBody>& bodies) {
    std::vector<Surface> surfaces;
    for (const PlacedBody& body : bodies) surfaces.emplace_back(body);
    std::vector<double> found;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (bodies[i].def.immovable && bodies[k].def.immovable) continue;
            const Surface &a = surfaces[i], &b = surfaces[k];
            const bool bounded = a.kind != ingot::ShapeKind::half_space && b.kind != ingot::ShapeKind::half_space;
            if (bounded && (a.centre - b.centre).norm() > a.radius + b.radius) continue;
            if (!(scenes::overlap_of(a, b) > 0)) continue;
            const double deep = overlap_of(bodies[i], bodies[k]);
            if (deep > 0) found.push_back(deep);
        }
    }
    return found;
}

}  // namespace ingot_contact
