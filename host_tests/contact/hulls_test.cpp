// SPDX-License-Identifier: MIT
// Convex hulls as bodies of a world: they stand, slide, tip and rest as what they are the hull of, and meet every other shape.
#include <gtest/gtest.h>

#include <cstring>

#include "contact/play.h"
#include "reference/ball_and_brick.h"
#include "scenes/hulls.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot::Shape;
using ingot::ShapeKind;

constexpr double rest_speed = 1e-3;  // m/s: free fall through one step gives 0.16

template <int bodies>
using HullRoom = Hulled<room_size(bodies), 8 * room_size(bodies)>;

/// The bodies of a scene of cubes, their boxes replaced by the hull of a cube.
template <class Scene>
Play<HullRoom<Scene::body_count>> play_with_hulls() {
    std::vector<PlacedBody> bodies = bodies_of<Scene>();
    for (PlacedBody& body : bodies)
        if (body.def.shape.kind == ShapeKind::box) body.def.shape = ingot::hull_of<HullRoom<Scene::body_count>>(cube_form);
    return {bodies, Scene::gravity};
}

/// What Tower.of_20 asks of boxes.
TEST(HullCube, tower_of_20_stands_as_one_of_boxes) {
    auto scene = play_with_hulls<Tower<20>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    figure("top sinks, mm", -1e3 * scene.moved(20).z());
    figure("top drifts, mm", 1e3 * scene.drift(20));
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(-1e3 * scene.moved(20).z(), 0.2);
    EXPECT_LE(1e3 * scene.drift(20), 0.1);
    EXPECT_LE(scene.fastest(), rest_speed);
}

/// What Incline asks of the box.
TEST(HullCube, holds_and_slides_on_an_incline_as_the_box) {
    auto holds = play_with_hulls<Incline<70>>();
    ASSERT_TRUE(holds.sound());
    holds.run(OnEarth::h, 10);
    EXPECT_LE(1e3 * std::abs(to_eigen(thirty_degrees.down()).dot(holds.moved(1))), 0.001);

    auto slides = play_with_hulls<Incline<40>>();
    slides.run(OnEarth::h, 2);
    const double way = to_eigen(thirty_degrees.down()).dot(slides.moved(1));
    const double exact = static_cast<double>(ingot_reference::BrickOnIncline(9.81L, 0.4L, 0.5L, std::sqrt(0.75L), 0).at(2).s);
    figure("error of the way, %", 100 * (way / exact - 1));
    EXPECT_LE(std::abs(way / exact - 1), 1e-5);
}

/// Least of r . n over the corners of a hull body, m.
template <class S>
double lowest(Play<S>& scene, int body_i, const Vector3d& n) {
    const ingot::ConvexHull& hull = S::hulls[static_cast<int>(scene.placed(body_i).def.shape.size.y)];
    double least = 1e30;
    for (int i = 0; i < hull.vertex_count; ++i) least = std::min(least, n.dot(scene.r(body_i) + scene.A(body_i) * to_eigen(hull.vertices[i])));
    return least;
}
/// The corners no higher than this above the ground.
template <class S>
int corners_below(Play<S>& scene, int body_i, double height) {
    const ingot::ConvexHull& hull = S::hulls[static_cast<int>(scene.placed(body_i).def.shape.size.y)];
    int count = 0;
    for (int i = 0; i < hull.vertex_count; ++i) count += (scene.r(body_i) + scene.A(body_i) * to_eigen(hull.vertices[i])).z() <= height;
    return count;
}

/// Dropped in any position each ends on a face: three corners or more on the ground, none in it.
class DroppedHull : public ::testing::TestWithParam<int> {};
TEST_P(DroppedHull, comes_to_rest_on_a_face) {
    using S = HullRoom<2>;
    for (int turn_i = 0; turn_i < 8; ++turn_i) {
        PlacedBody body = hull_body<S>(static_cast<HullForm>(GetParam()), {0, 0, scalar(1.5)}, scalar(0.6));
        body.turn(scattered_rotation(turn_i));
        body.move({}, {1, scalar(0.5), scalar(0.25)});  // one of them would stand on an edge for good
        Play<S> scene({flat_ground(scalar(0.6)), body}, OnEarth::gravity);
        ASSERT_TRUE(scene.sound());
        const double energy = scene.energy();
        scene.run(OnEarth::h, 8);
        EXPECT_TRUE(scene.reports().clean());
        EXPECT_LE(scene.fastest(), rest_speed) << turn_i;
        EXPECT_LE(scene.fastest_spin(), 1e-2) << turn_i;
        EXPECT_LT(scene.energy(), energy);
        EXPECT_NEAR(lowest(scene, 1, {0, 0, 1}), 0, 1e-3) << turn_i;
        EXPECT_GE(corners_below(scene, 1, 1e-3), 3) << turn_i;
    }
}
INSTANTIATE_TEST_SUITE_P(Hull, DroppedHull, ::testing::Values(cube_form, tetrahedron_form, octahedron_form, rock_form));

/// 36 octahedra in a pit: at rest after 10 s, all of them inside and none through the floor.
TEST(OctahedronPile, comes_to_rest) {
    using S = HullRoom<41>;
    std::vector<PlacedBody> bodies;
    for (int wall_i = 0; wall_i < 5; ++wall_i) bodies.push_back(pit_wall(wall_i, 3, scalar(0.5)));
    for (int i = 0; i < 36; ++i) {
        PlacedBody body = hull_body<S>(octahedron_form, {scalar(i % 3) - 1, scalar(i / 3 % 3) - 1, 1 + scalar(i / 9)}, scalar(0.5));
        body.turn(scattered_rotation(i));
        bodies.push_back(body);
    }
    Play<S> scene(bodies, OnEarth::gravity);
    ASSERT_TRUE(scene.sound());
    double most = scene.energy();
    bool rises = false;
    scene.run(OnEarth::h, 10, [&](int) {
        const double now = scene.energy();
        rises = rises || now > most * (1 + 1e-4);  // what SpherePile allows of a step
        most = now;
    });
    figure("fastest, m/s", scene.fastest());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_FALSE(rises);
    EXPECT_LE(scene.fastest(), 1e-2);
    for (int i = 5; i < 41; ++i)
        for (const Vector3d& n : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0)})
            EXPECT_GE(lowest(scene, i, n), (n.z() > 0 ? 0 : -1.5) - 2e-3) << i;
}

struct Companion {
    const char* name;
    Shape shape;
    double height;  ///< m, of its centre above what it stands on
};
const Companion companions[] = {{"sphere", ingot::Sphere{scalar(0.5)}, 0.5},
                                {"capsule", ingot::Capsule{scalar(0.25), scalar(0.25)}, 0.5},
                                {"box", ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.5)}}, 0.5},
                                {"cylinder", ingot::Cylinder{scalar(0.375), scalar(0.5)}, 0.5},
                                {"hull", ingot::hull_of<HullRoom<3>>(cube_form), 0.5}};

/// Each shape let down on a fixed hull of a cube, and the hull let down on each fixed: the one above rests at the height of the two.
class HullAndOther : public ::testing::TestWithParam<Companion> {};
TEST_P(HullAndOther, rest_on_each_other) {
    using S = HullRoom<3>;
    const Companion& other = GetParam();
    for (const bool hull_above : {false, true}) {
        PlacedBody cube = hull_body<S>(cube_form, {0, 0, scalar(0.5)}, scalar(0.6)),
                   body = solid_ball(1, scalar(0.4), {0, 0, scalar(other.height)}, scalar(0.6));
        body.def.shape = other.shape;
        PlacedBody &below = hull_above ? body : cube, &above = hull_above ? cube : body;
        const double top = hull_above ? 2 * other.height : 1, rest = top + (hull_above ? 0.5 : other.height);
        above.def.state.r_CM.z = scalar(rest + 0.05);
        below.def.immovable = true;
        Play<S> scene({below, above}, OnEarth::gravity);
        ASSERT_TRUE(scene.sound());
        scene.run(OnEarth::h, 3);
        EXPECT_TRUE(scene.reports().clean()) << "no pair is without a routine";
        EXPECT_NEAR(scene.r(1).z(), rest, 1e-3) << hull_above;
        EXPECT_LE(scene.fastest(), rest_speed) << hull_above;
    }
}
INSTANTIATE_TEST_SUITE_P(Hull, HullAndOther, ::testing::ValuesIn(companions), [](const auto& tested) { return std::string(tested.param.name); });

/// A number that names no hull, a size that is not its own, and what is no number: refused, and the world is what it was.
TEST(HullOfWorld, that_the_scene_has_not_is_refused) {
    using S = HullRoom<3>;
    static ingot::World<S> world, before;
    ASSERT_EQ(world.add(hull_body<S>(rock_form, {0, 0, 1}, 1).def).status, Status::ok);
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), radius = S::hulls[0].radius;
    const std::pair<Shape, Status> wrong[] = {{ingot::hull_of<S>(4), Status::bad_shape},
                                              {ingot::hull_of<S>(-1), Status::bad_shape},
                                              {ingot::Hull{radius, 4}, Status::bad_shape},
                                              {ingot::Hull{radius, -1}, Status::bad_shape},
                                              {ingot::Hull{radius * scalar(1.25), 0}, Status::bad_shape},
                                              {Shape{ShapeKind::hull, {radius, scalar(0.5), 0}, 0}, Status::bad_shape},
                                              {Shape{ShapeKind::hull, {radius, scalar(1e30f), 0}, 0}, Status::bad_shape},
                                              {Shape{ShapeKind::hull, {radius, nan, 0}, 0}, Status::not_finite},
                                              {Shape{ShapeKind::hull, {nan, 0, 0}, 0}, Status::not_finite}};
    for (const auto& [shape, status] : wrong) {
        ingot::BodyDef def = hull_body<S>(cube_form, {}, 1).def;
        def.shape = shape;
        EXPECT_EQ(world.add(def).status, status);
        EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);
    }
    ingot::World<Room<1>> without;
    EXPECT_EQ(without.add(hull_body<S>(cube_form, {}, 1).def).status, Status::not_in_scene);
}

/// The frame of a body is that of its hull: the solid of the hull in it has its centre at the origin and no products of inertia.
TEST(HullOfBody, lies_along_the_principal_axes) {
    const struct {
        const ingot::ConvexHull hull;
        const ingot::MassProperties& mass;
    } all[] = {{tetrahedron_hull.hull.value.view(), tetrahedron_hull.mass}, {rock_hull.hull.value.view(), rock_hull.mass}};
    for (const auto& [hull, mass] : all) {
        const ingot::MassDistribution solid = ingot::with_mass(ingot::solid_hull(1, hull).value, mass.M);
        const double size = 3, eps = static_cast<double>(ingot::epsilon);  // m: of the points as given, whose roundings stay
        EXPECT_LE(to_eigen(solid.r_CM).norm(), 16 * eps * size);
        for (const scalar product : {solid.I.xy, solid.I.xz, solid.I.yz}) EXPECT_LE(std::abs(static_cast<double>(product)), 64 * eps * size * size);
        EXPECT_NEAR(solid.I.xx, mass.I_body.x, 64 * eps * size * size);
        EXPECT_NEAR(solid.I.yy, mass.I_body.y, 64 * eps * size * size);
        EXPECT_NEAR(solid.I.zz, mass.I_body.z, 64 * eps * size * size);
    }
}

/// The same questions to a hull of a cube and to the box, of bodies that stand alike.
TEST(HullQueries, answer_as_those_of_the_box) {
    using S = HullRoom<1>;
    static ingot::World<S> hulls, boxes;
    PlacedBody body = hull_body<S>(cube_form, {1, 2, 3}, 1);
    body.turn(scattered_rotation(3));
    const ingot::BodyId id = hulls.add(body.def).value;
    body.def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    ASSERT_EQ(boxes.add(body.def).value, id);
    int met = 0, near = 0, overlapping = 0;
    for (int i = 0; i < 800; ++i) {
        const Vector from = Vector{1, 2, 3} + Vector{scattered(i, 0), scattered(i, 1), scattered(i, 2)} * 2,
                     way = {scattered(i, 3) * 4, scattered(i, 4) * 4, scattered(i, 5) * 4};
        const ingot::PlacedShape ball = {ingot::Sphere{scalar(0.25)}, from, ingot::identity_matrix<scalar>(), nullptr};
        const double tolerance = 64 * static_cast<double>(ingot::epsilon) * 8;
        const ingot::QueryHit ray = hulls.cast_ray(from, way).value, ray_box = boxes.cast_ray(from, way).value;
        EXPECT_EQ(ray.body, ray_box.body);
        EXPECT_NEAR(ray.fraction, ray_box.fraction, 16 * tolerance);
        met += ray.found();
        const ingot::QueryHit cast = hulls.cast_shape(ball, way).value, cast_box = boxes.cast_shape(ball, way).value;
        EXPECT_EQ(cast.body, cast_box.body);
        EXPECT_NEAR(cast.fraction, cast_box.fraction, 4 * static_cast<double>(ingot::limits::cast_gap) + 16 * tolerance);
        const ingot::QueryNearest nearest = hulls.find_nearest(from, 1).value, nearest_box = boxes.find_nearest(from, 1).value;
        EXPECT_EQ(nearest.body, nearest_box.body);
        EXPECT_NEAR(nearest.distance, nearest_box.distance, 16 * tolerance);
        near += nearest.found();
        ingot::BodyId found[1];
        const int count = hulls.find_overlaps(ball, found, 1).value;
        EXPECT_EQ(count, boxes.find_overlaps(ball, found, 1).value);
        overlapping += count;
    }
    EXPECT_GT(met, 20);
    EXPECT_GT(near, 100);
    EXPECT_GT(overlapping, 20);
}

/// The pile with other hulls.
struct OtherHulls : HullPile {
    static constexpr ingot::ConvexHull hulls[] = {cube_hull.hull.value.view(), tetrahedron_hull.hull.value.view(), rock_hull.hull.value.view(),
                                                  octahedron_hull.hull.value.view()};
};

TEST(HullSnapshot, goes_on_to_the_bit_and_is_of_its_hulls) {
    static ingot::World<HullPile> world, restored;
    static ingot::World<OtherHulls> others;
    static uint8_t bytes[ingot::snapshot_size<HullPile>()], again[sizeof bytes];
    ASSERT_EQ(set_up(world), Status::ok);
    for (int i = 0; i < 60; ++i) ASSERT_TRUE(scenes::well_but_for_impacts(ingot::step(world, HullPile::h)));
    const auto size = ingot::save_snapshot(world, bytes, sizeof bytes);
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(restored, bytes, size.value), Status::ok);
    EXPECT_EQ(ingot::load_snapshot(others, bytes, size.value), Status::other_scene);
    for (int i = 0; i < 60; ++i) {
        (void)ingot::step(world, HullPile::h);
        (void)ingot::step(restored, HullPile::h);
        ASSERT_EQ(restored.state_hash(), world.state_hash()) << i;
    }
    const auto size_2 = ingot::save_snapshot(world, bytes, sizeof bytes);
    ASSERT_EQ(ingot::save_snapshot(restored, again, sizeof again).value, size_2.value);
    EXPECT_EQ(std::memcmp(bytes, again, size_2.value), 0);
}

}  // namespace
