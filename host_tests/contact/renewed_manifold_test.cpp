// SPDX-License-Identifier: MIT
// A manifold that is moved along with its bodies against one found anew.
#include <gtest/gtest.h>

#include <ingot/narrow_phase/manifold_anchors.h>

#include "collide/placed.h"
#include "contact/play.h"

namespace {

using namespace ingot_contact;
using ingot::BodyFrame;
using ingot::Manifold;
using ingot::ManifoldAnchors;
using ingot::PlacedShape;
using ingot_collide::placed;
using ingot_collide::turned;
using ingot_reference::RandomInput;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;

constexpr double recycled_slip = static_cast<double>(ingot::limits::recycled_slip);
constexpr double margin = static_cast<double>(ingot::limits::contact_margin);

struct Pose {
    Eigen::Vector3d r;
    Matrix3d A;

    /// This, moved as a whole by another.
    Pose moved_by(const Pose& by) const { return {by.r + by.A * r, by.A * A}; }
};

/// A box that lies on another, or on a half space, a little askew.
struct Lying {
    ingot::Shape on_top, below;
    Pose top, bottom;
    double R;  ///< m, the lesser bounding radius

    PlacedShape shape(const Pose& at, const ingot::Shape& of) const { return placed(of, at.r, at.A); }
    Manifold found(const Manifold* before = nullptr) const {
        Manifold manifold{};
        const PlacedShape A = shape(top, on_top), B = shape(bottom, below);
        if (below.kind == ingot::ShapeKind::half_space)
            ingot::collide_box_half_space(A, B, static_cast<scalar>(margin), manifold, before);
        else
            ingot::collide_box_box(A, B, static_cast<scalar>(margin), manifold, before);
        return manifold;
    }
    BodyFrame frame(const Pose& at) const { return {to_vector(at.r), to_matrix(at.A)}; }
    bool renewed(double slip, double with_margin, const ManifoldAnchors& anchors, Manifold& manifold) const {
        const ingot::RenewLimits within = {static_cast<scalar>(slip), static_cast<scalar>(with_margin), ingot::limits::contact_margin / 2};
        return ingot::renew_from_anchors(frame(top), frame(bottom), within, anchors, manifold);
    }
    ManifoldAnchors anchors(const Manifold& manifold) const {
        ManifoldAnchors of{};
        ingot::anchor(frame(top), frame(bottom), manifold, static_cast<scalar>(margin), of);
        return of;
    }
};

/// Angles at which the edges of the two faces cross are at least this, rad: a crossing of edges then moves by at most 1 / sin of it
/// times what the bodies slip.
constexpr double least_crossing = 0.3;

Lying random_lying(RandomInput& random, bool on_half_space) {
    Lying scene;
    const Eigen::Vector3d half(random.real(0.3, 0.6), random.real(0.3, 0.6), random.real(0.1, 0.4));
    const Eigen::Vector3d half_below(random.real(0.3, 0.6), random.real(0.3, 0.6), random.real(0.1, 0.4));
    scene.on_top = ingot::Box{to_vector(half)};
    scene.bottom = {Eigen::Vector3d::Zero(), Matrix3d::Identity()};
    const double tilt = random.real(0, 0.01), height = random.real(-0.005, 0.005);
    const Matrix3d A = turned(Eigen::Vector3d(random.real(-1, 1), random.real(-1, 1), 0.001), tilt) *
                       turned(Eigen::Vector3d::UnitZ(), random.real(least_crossing, 1.5707963 - least_crossing));
    scene.R = half.norm();
    if (on_half_space) {
        scene.below = ingot::HalfSpace{{0, 0, 1}, 0};
        scene.top = {{0, 0, half.z() + height}, A};
    } else {
        scene.below = ingot::Box{to_vector(half_below)};
        scene.R = std::min(scene.R, half_below.norm());
        scene.top = {{random.real(-0.2, 0.2), random.real(-0.2, 0.2), half.z() + half_below.z() + height}, A};
    }
    const Pose anywhere = {random.vector(3), random.rotation()};
    scene.top = scene.top.moved_by(anywhere);
    if (!on_half_space) scene.bottom = scene.bottom.moved_by(anywhere);
    if (on_half_space) {  // the half space stays the one it is
        scene.bottom = anywhere;
    }
    return scene;
}

/// Moves the upper body against the lower one by a part of what a manifold outlives: across, up and down, and turned.
void nudge(RandomInput& random, Lying& scene, double share) {
    const Matrix3d small = turned(random.direction(), 0.2 * share * recycled_slip);
    scene.top.A = small * scene.top.A;
    scene.top.r += random.direction() * (0.2 * share * recycled_slip * scene.R);
}

/// Separations carry the rounding of places up to 6 m away, in a few products.
constexpr double rounding = 64 * static_cast<double>(ingot::epsilon);

/// Bodies that have not moved against each other, wherever they have gone together, keep their manifold; it goes with them.
TEST(RenewedManifold, goes_with_its_bodies) {
    RandomInput random(5);
    int points = 0;
    for (int case_i = 0; case_i < 500; ++case_i) {
        Lying scene = random_lying(random, case_i % 3 == 0);
        const Manifold first = scene.found();
        if (first.count == 0) continue;
        const ManifoldAnchors anchors = scene.anchors(first);
        const Pose by = {random.vector(2), random.rotation()};
        scene.top = scene.top.moved_by(by);
        scene.bottom = scene.bottom.moved_by(by);
        Manifold manifold = first;
        ASSERT_TRUE(scene.renewed(recycled_slip * scene.R, margin, anchors, manifold)) << case_i;
        ASSERT_EQ(manifold.count, first.count);
        EXPECT_LE((to_eigen(manifold.n) - by.A * to_eigen(first.n)).norm(), rounding);
        for (int i = 0; i < first.count; ++i) {
            EXPECT_NEAR(static_cast<double>(manifold.points[i].separation), static_cast<double>(first.points[i].separation), rounding);
            EXPECT_LE((to_eigen(manifold.points[i].P) - (by.r + by.A * to_eigen(first.points[i].P))).norm(), rounding);
            EXPECT_EQ(manifold.points[i].feature, first.points[i].feature);
            ++points;
        }
    }
    EXPECT_GT(points, 1000);
}

/// Where bodies have moved by less than it outlives, the features are those of a search, and separations differ by no more than slip
/// times what the faces are askew: a corner's by slip * recycled_slip; a crossing of edges moves along them by slip / sin(crossing).
TEST(RenewedManifold, agrees_with_one_found_anew) {
    RandomInput random(6);
    int compared = 0, renewed_count = 0, found_count = 0;
    double worst = 0;
    for (int case_i = 0; case_i < 3000; ++case_i) {
        Lying scene = random_lying(random, case_i % 3 == 0);
        const Manifold first = scene.found();
        if (first.count == 0) continue;
        const ManifoldAnchors anchors = scene.anchors(first);
        nudge(random, scene, random.real(0, 1));
        const double slip = recycled_slip * scene.R;
        Manifold manifold = first;
        ++found_count;
        if (!scene.renewed(slip, margin, anchors, manifold)) continue;
        ++renewed_count;
        const Manifold anew = scene.found(&first);
        const double askew = 0.01 + 2 * recycled_slip;  // rad, of the two faces
        const double bound = slip * (askew / std::sin(least_crossing) + recycled_slip) + rounding;
        for (int i = 0; i < manifold.count; ++i) {
            for (int k = 0; k < anew.count; ++k) {
                if (manifold.points[i].feature != anew.points[k].feature) continue;
                const double apart = std::abs(static_cast<double>(manifold.points[i].separation) - static_cast<double>(anew.points[k].separation));
                worst = std::max(worst, apart / bound);
                EXPECT_LE(apart, bound) << case_i << " point " << i;
                ++compared;
            }
        }
        // The deepest point of a search is there, to the slip: nothing comes nearer unseen.
        const double deepest = static_cast<double>(ingot_collide::least(manifold)), exact = static_cast<double>(ingot_collide::least(anew));
        EXPECT_LE(deepest - exact, 2 * slip + rounding) << case_i;
    }
    figure("renewed, share", static_cast<double>(renewed_count) / found_count);
    figure("points compared", compared);
    figure("worst, share of the bound", worst);
    EXPECT_GT(compared, 3 * renewed_count / 2);
    EXPECT_GT(renewed_count, 1000);
}

bool same(const Manifold& a, const Manifold& b) {
    bool equal = a.count == b.count && to_eigen(a.n) == to_eigen(b.n);
    for (int i = 0; i < a.count && equal; ++i)
        equal = to_eigen(a.points[i].P) == to_eigen(b.points[i].P) && a.points[i].separation == b.points[i].separation &&
                a.points[i].feature == b.points[i].feature;
    return equal;
}

/// Bodies that have slipped too far, turned too far, or come with a wider margin are searched for anew, and the manifold is left as it was.
TEST(RenewedManifold, is_refused_where_bodies_have_moved) {
    RandomInput random(7);
    for (int case_i = 0; case_i < 500; ++case_i) {
        const Lying scene = random_lying(random, case_i % 3 == 0);
        const Manifold first = scene.found();
        if (first.count == 0) continue;
        const ManifoldAnchors anchors = scene.anchors(first);
        const double slip = recycled_slip * scene.R;
        const Eigen::Vector3d n = to_eigen(first.n), across = n.cross(random.direction()).normalized();
        Manifold manifold = first;

        Lying slipped = scene;
        slipped.top.r += across * (1.1 * slip);
        EXPECT_FALSE(slipped.renewed(slip, margin, anchors, manifold)) << case_i;
        Lying tilted = scene;
        tilted.top.A = turned(across, 1.1 * recycled_slip) * tilted.top.A;
        tilted.top.r = to_eigen(first.points[0].P) + turned(across, 1.1 * recycled_slip) * (scene.top.r - to_eigen(first.points[0].P));
        EXPECT_FALSE(tilted.renewed(slip, margin, anchors, manifold)) << case_i;
        Lying lifted = scene;
        lifted.top.r += n * (3 * margin);
        EXPECT_FALSE(lifted.renewed(slip, margin, anchors, manifold)) << case_i;
        EXPECT_FALSE(scene.renewed(slip, 2 * margin, anchors, manifold)) << "a wider margin";
        ManifoldAnchors nothing = anchors;
        nothing.margin = 0;
        EXPECT_FALSE(scene.renewed(slip, margin, nothing, manifold)) << "anchors that know nothing";
        Lying lost = scene;
        lost.top.r.x() = std::numeric_limits<double>::quiet_NaN();
        EXPECT_FALSE(lost.renewed(slip, margin, anchors, manifold)) << "NaN";
        EXPECT_TRUE(same(manifold, first)) << case_i;
        EXPECT_TRUE(scene.renewed(slip, margin, anchors, manifold)) << case_i;
    }
}

}  // namespace
