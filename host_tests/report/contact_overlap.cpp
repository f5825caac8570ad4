// SPDX-License-Identifier: MIT
// How deep bodies are inside each other. A ball is a point and a radius about it, a capsule a stretch of a line; a box has no radius.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_metrics.h"

namespace report {

namespace {

using Vector3d = Eigen::Vector3d;
using Matrix3d = Eigen::Matrix3d;

/// Of the ball about the centre that holds the body.
double radius_of(const SceneBody& body) {
    switch (body.solid) {
        case Solid::ball:
            return body.size[0];
        case Solid::capsule:
            return body.size[0] + body.size[1];
        case Solid::box:
            return vector(body.size).norm();
        default:
            return std::numeric_limits<double>::infinity();
    }
}

/// A body where it is.
struct Placed {
    const SceneBody& body;
    Matrix3d A;
    Vector3d r;

    Placed(const SceneBody& of, const BodyPose& pose) : body(of), A(matrix(pose.A)), r(vector(pose.r)) {}
    bool is_box() const { return body.solid == Solid::box; }
    double radius() const { return is_box() ? 0 : body.size[0]; }
    double half_length() const { return body.solid == Solid::capsule ? body.size[1] : 0; }

    /// How far it reaches from its centre along n, a unit vector.
    double reach(const Vector3d& n) const {
        if (is_box()) return (A.transpose() * n).cwiseAbs().dot(vector(body.size));
        return radius() + half_length() * std::abs(n.dot(A.col(2)));
    }
    /// From a point to what its radius is about; 0 inside a box.
    double distance(const Vector3d& p) const {
        if (is_box()) return ((A.transpose() * (p - r)).cwiseAbs() - vector(body.size)).cwiseMax(0).norm();
        const Vector3d along = A.col(2) * half_length();
        const double part = half_length() > 0 ? std::clamp((p - r).dot(A.col(2)), -half_length(), half_length()) / half_length() : 0;
        return (p - r - part * along).norm();
    }
};

/// From the stretch of a line in a ball or capsule to another body. The distance is a convex function along it: thirds close in.
double distance_between(const Placed& round, const Placed& other) {
    const auto at = [&](double s) { return other.distance(round.r + s * round.A.col(2)); };
    double low = -round.half_length(), high = round.half_length();
    if (high == 0) return at(0);
    for (int i = 0; i < 80; ++i) {
        const double third = (high - low) / 3;
        if (at(low + third) < at(high - third))
            high -= third;
        else
            low += third;
    }
    return at((low + high) / 2);
}

/// The least overlap along the normals of faces and the common normals of edges: exact for what has faces and edges.
double overlap_along_axes(const Placed& a, const Placed& b) {
    const Vector3d apart = a.r - b.r;
    double least = std::numeric_limits<double>::infinity();
    const auto try_axis = [&](const Vector3d& n) { least = std::min(least, a.reach(n) + b.reach(n) - std::abs(n.dot(apart))); };
    for (const Placed* one : {&a, &b})
        for (int axis = 0; one->is_box() && axis < 3; ++axis) try_axis(one->A.col(axis));
    for (int i = a.is_box() ? 0 : 2; i < 3; ++i) {
        for (int k = b.is_box() ? 0 : 2; k < 3; ++k) {
            const Vector3d n = a.A.col(i).cross(b.A.col(k));
            if (n.squaredNorm() > 1e-12) try_axis(n.normalized());  // else parallel: the faces tell
        }
    }
    return least;
}

double overlap_with_half_space(const Placed& a, const SceneBody& ground) {
    const Vector3d n = vector(ground.size);
    return ground.offset - (n.dot(a.r) - a.reach(n));
}

}  // namespace

double overlap_of(const SceneBody& body_a, const BodyPose& pose_a, const SceneBody& body_b, const BodyPose& pose_b) {
    const Placed a(body_a, pose_a), b(body_b, pose_b);
    if (body_b.solid == Solid::half_space) return overlap_with_half_space(a, body_b);
    if (body_a.solid == Solid::half_space) return overlap_with_half_space(b, body_a);
    const double near = radius_of(body_a) + radius_of(body_b) - (a.r - b.r).norm();
    if (!(near > 0)) return near;
    if (a.is_box() && b.is_box()) return std::min(near, overlap_along_axes(a, b));
    const double distance = a.is_box() ? distance_between(b, a) : distance_between(a, b);
    if (distance > 0) return a.radius() + b.radius() - distance;
    return std::min(near, overlap_along_axes(a, b));
}

Overlaps overlaps_of(const ContactCase& scene, const std::vector<BodyPose>& poses) {
    Overlaps all;
    const auto add = [&](std::size_t a, std::size_t b) {
        const double overlap = overlap_of(scene.bodies[a], poses[a], scene.bodies[b], poses[b]);
        if (!(overlap > 0)) return;
        all.sum += overlap;
        all.deepest = std::max(all.deepest, overlap);
        ++all.count;
    };
    std::vector<std::size_t> along_x, grounds;
    for (std::size_t i = 0; i < poses.size(); ++i)
        (scene.bodies[i].solid == Solid::half_space ? grounds : along_x).push_back(i);
    const auto low = [&](std::size_t i) { return poses[i].r[0] - radius_of(scene.bodies[i]); };
    std::sort(along_x.begin(), along_x.end(), [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
    for (std::size_t i = 0; i < along_x.size(); ++i) {
        const std::size_t a = along_x[i];
        for (const std::size_t ground : grounds) add(a, ground);
        const double high = poses[a].r[0] + radius_of(scene.bodies[a]);
        for (std::size_t j = i + 1; j < along_x.size() && low(along_x[j]) < high; ++j) add(a, along_x[j]);
    }
    return all;
}

}  // namespace report
