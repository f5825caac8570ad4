// SPDX-License-Identifier: MIT
// What draw() draws is what World tells, no more and no less.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstring>
#include <map>
#include <numeric>
#include <utility>

#include "draw/yard.h"

namespace {

using namespace draw_yard;
using ingot::ContactInfo;
using ingot::Draw;
using ingot::Line;
using ingot::Status;

bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
Eigen::Vector3d exact(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }

std::vector<BodyId> bodies_of(const World& world) {
    std::vector<BodyId> ids;
    for (int slot = 0; slot < World::max_bodies; ++slot)
        if (const BodyId id = world.body_at(slot); world.is_alive(id)) ids.push_back(id);
    return ids;
}

/// Yards of many ages: before the first step, in flight, at rest, asleep.
class DrawnYard : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        ASSERT_NE(world, nullptr);
        for (int step_i = 0; step_i < GetParam(); ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).status == Status::ok);
    }
    template <unsigned what>
    NotingPen drawn(const ingot::DrawScale& scale = {}) const {
        NotingPen pen;
        ingot::draw<what>(*world, pen, scale);
        return pen;
    }
    template <std::size_t... flag_i>
    std::size_t sum_of_flags(std::index_sequence<flag_i...>) const {
        return (drawn<1u << flag_i>().strokes.size() + ...);
    }
    std::unique_ptr<World> world = yard();
};
INSTANTIATE_TEST_SUITE_P(Ages, DrawnYard, testing::Values(0, 1, 40, 200));

TEST_P(DrawnYard, shapes_are_where_their_bodies_are) {
    const NotingPen pen = drawn<Draw::shapes | Draw::sleep>();
    std::size_t stroke_i = 0;
    for (const BodyId id : bodies_of(*world)) {
        const ingot::PlacedShape shape = world->placed_shape(id).value;
        const ingot::BodyState state = world->state(id).value;
        EXPECT_TRUE(same(shape.r, state.r_CM) && same(shape.A.c0, state.A.c0) && same(shape.A.c2, state.A.c2));
        EXPECT_EQ(shape.shape.kind, world->shape(id).value.kind);
        const DrawColor color = world->is_sensor(id).value ? DrawColor::sensor
                                : world->is_kinematic(id)  ? DrawColor::kinematic
                                : !world->is_movable(id)   ? DrawColor::immovable
                                : world->is_asleep(id)     ? DrawColor::asleep
                                                           : DrawColor::awake;
        for (int line_i = 0; line_i < ingot::line_count(shape); ++line_i, ++stroke_i) {
            ASSERT_LT(stroke_i, pen.strokes.size());
            const Line line = ingot::line_of(shape, line_i, 1);
            EXPECT_TRUE(same(line.a, pen.strokes[stroke_i].a) && same(line.b, pen.strokes[stroke_i].b));
            EXPECT_EQ(pen.strokes[stroke_i].color, color);
        }
    }
    EXPECT_EQ(stroke_i, pen.strokes.size());
}

TEST_P(DrawnYard, axes_momenta_and_centres_are_those_of_the_state) {
    ingot::DrawScale scale;
    scale.axis = 2;
    scale.L = 3;
    scale.omega = 4;
    const NotingPen pen = drawn<Draw::axes | Draw::L | Draw::omega | Draw::centres>(scale);
    const auto z = pen.of(DrawColor::axis_z), L = pen.of(DrawColor::L), omega = pen.of(DrawColor::omega), centre = pen.of(DrawColor::centre);
    std::size_t i = 0;
    for (const BodyId id : bodies_of(*world)) {
        if (!world->is_movable(id)) continue;
        ASSERT_LT(i, z.size());
        const ingot::BodyState state = world->state(id).value;
        EXPECT_TRUE(same(z[i].a, state.r_CM) && same(z[i].b, state.r_CM + state.A.c2 * scalar(2)));
        EXPECT_TRUE(same(L[i].a, state.r_CM) && same(L[i].b, state.r_CM + state.L * scalar(3)));
        EXPECT_TRUE(same(omega[i].b, state.r_CM + world->omega(id).value * scalar(4)));
        EXPECT_LT((exact(centre[3 * i].a + centre[3 * i].b) / 2 - exact(state.r_CM)).norm(), 1e-5);
        ++i;
    }
    EXPECT_EQ(i, z.size());
    EXPECT_EQ(3 * i, centre.size());
}

TEST_P(DrawnYard, contacts_have_a_point_each_and_their_impulses_add_up) {
    ingot::DrawScale scale;
    scale.impulse = 1;
    const NotingPen pen = drawn<Draw::contacts | Draw::impulses>(scale);
    std::size_t points = 0, touching = 0;
    Eigen::Vector3d told = {0, 0, 0}, shown = {0, 0, 0};
    double largest = 0;
    for (const ContactInfo& contact : world->contacts()) {
        points += static_cast<std::size_t>(contact.point_count);
        touching += contact.point_count > 0 ? 1 : 0;
        told += exact(contact.n) * static_cast<double>(contact.j) + exact(contact.j_friction);
        largest += static_cast<double>(contact.j);
    }
    for (const DrawColor color : {DrawColor::impulse, DrawColor::friction})
        for (const auto& stroke : pen.of(color)) shown += exact(stroke.b) - exact(stroke.a);
    EXPECT_EQ(pen.of(DrawColor::contact).size(), 3 * points);
    EXPECT_EQ(pen.of(DrawColor::impulse).size(), points);
    EXPECT_EQ(pen.of(DrawColor::friction).size(), touching);
    // Each is a difference of two places of up to some 100 m and impulses, told to a rounding of them.
    EXPECT_LE((told - shown).norm(), 4 * static_cast<double>(ingot::epsilon) * (largest + 100 * static_cast<double>(points)));
    EXPECT_EQ(points > 0, GetParam() > 0);
}

TEST_P(DrawnYard, bounds_hold_their_shapes) {
    const auto edges = drawn<Draw::bounds>().of(DrawColor::bounds);
    std::size_t boxes = 0;
    for (const BodyId id : bodies_of(*world)) {
        const ingot::BoundsInfo bounds = world->search_bounds(id).value;
        EXPECT_EQ(bounds.low.x > bounds.high.x, GetParam() == 0);
        const ingot::PlacedShape shape = world->placed_shape(id).value;
        if (GetParam() == 0 || shape.shape.kind == ingot::ShapeKind::half_space) continue;
        ++boxes;
        // A step may take a body as far as the bounds reach, and no further.
        for (int line_i = 0; line_i < ingot::line_count(shape); ++line_i) {
            const Vector end = ingot::line_of(shape, line_i, 1).a;
            EXPECT_TRUE(bounds.low.x <= end.x && end.x <= bounds.high.x && bounds.low.y <= end.y && end.y <= bounds.high.y && bounds.low.z <= end.z &&
                        end.z <= bounds.high.z);
        }
    }
    EXPECT_EQ(edges.size(), boxes * ingot::lines_of_box);
}

TEST_P(DrawnYard, islands_are_what_touches_or_hangs_together) {
    const std::vector<BodyId> ids = bodies_of(*world);
    std::vector<std::size_t> parent(World::max_bodies);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t at) {
        while (parent[at] != at) at = parent[at];
        return at;
    };
    const auto join = [&](BodyId A, BodyId B) {
        if (world->is_movable(A) && world->is_movable(B)) parent[std::max(root(A.slot), root(B.slot))] = std::min(root(A.slot), root(B.slot));
    };
    if (GetParam() > 0) {
        for (const ContactInfo& contact : world->contacts()) join(contact.A, contact.B);
        for (int slot = 0; slot < Yard::max_joints; ++slot)
            if (const auto joint = world->joint_place(world->joint_at(slot)); joint.ok()) join(joint.value.A, joint.value.B);
    }
    std::size_t lines = 0;
    for (const BodyId id : ids) {
        if (!world->is_movable(id)) continue;
        EXPECT_EQ(world->island_of(id).value.slot, root(id.slot)) << id.slot;
        lines += root(id.slot) != id.slot ? 1u : 0u;
    }
    EXPECT_EQ(drawn<Draw::islands>().of(DrawColor::island).size(), lines);
}

TEST_P(DrawnYard, joints_are_where_both_of_their_bodies_have_them) {
    const NotingPen pen = drawn<Draw::joints>();
    EXPECT_EQ(pen.of(DrawColor::joint_axis).size(), 2u);  // of its hinges
    std::size_t joints = 0;
    for (int slot = 0; slot < Yard::max_joints; ++slot) {
        const ingot::JointId id = world->joint_at(slot);
        const ingot::Result<ingot::JointPlace> place = world->joint_place(id);
        if (!place.ok()) continue;
        ++joints;
        const double gap = static_cast<double>(world->joint_gap(id).value);
        EXPECT_LE((exact(place.value.P_A) - exact(place.value.P_B)).norm(), gap + 20 * 8 * static_cast<double>(ingot::epsilon));
        const double askew = (exact(place.value.axis_A) - exact(place.value.axis_B)).norm();
        EXPECT_TRUE(place.value.kind != ingot::JointKind::hinge || askew <= 1e-3) << askew;
    }
    EXPECT_EQ(joints, 4u);
    EXPECT_EQ(pen.of(DrawColor::joint).size(), joints * 3 - 1 + 2 * 3);  // one hangs from the world; a ball joint is a point
}

TEST_P(DrawnYard, calls_are_bounded_and_the_world_stays_as_it_is) {
    const auto before = std::make_unique<World>(*world);
    const NotingPen pen = drawn<Draw::all>();
    EXPECT_EQ(std::memcmp(before.get(), world.get(), sizeof(World)), 0);
    const std::size_t bound =
        World::max_bodies * std::size_t(ingot::lines_of_capsule + ingot::lines_of_box + 9) + Yard::max_manifolds * 17u + Yard::max_joints * 6u;
    EXPECT_LE(pen.strokes.size(), bound);
    for (const auto& stroke : pen.strokes) EXPECT_TRUE(ingot::is_finite(stroke.a) && ingot::is_finite(stroke.b));
    EXPECT_EQ(drawn<0>().strokes.size(), 0u);
    // A flag adds what it names, whatever the others are.
    EXPECT_EQ(pen.strokes.size(), sum_of_flags(std::make_index_sequence<11>()));
}

struct CapablePen : NotingPen {
    std::map<ingot::ShapeKind, int> shapes;
    int points = 0;
    void point(const Vector&, DrawColor) { ++points; }
    void shape(const ingot::PlacedShape& of, DrawColor) { ++shapes[of.shape.kind]; }
};

TEST(Pens, draw_by_themselves_what_they_can) {
    const auto world = yard();
    CapablePen pen;
    ingot::draw<Draw::shapes | Draw::centres>(*world, pen);
    EXPECT_TRUE(pen.strokes.empty());
    EXPECT_EQ(pen.points, 12);
    EXPECT_EQ(pen.shapes[ingot::ShapeKind::box], 7);
    EXPECT_EQ(pen.shapes[ingot::ShapeKind::capsule], 4);
}

TEST(Pens, draw_scenes_that_have_neither_shapes_nor_places) {
    ingot::World<ingot::Scene> world{};
    BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.1), scalar(0.2), scalar(0.3)})).value;
    def.state.L = {0, 0, 1};
    ASSERT_TRUE(world.add(def).ok());
    NotingPen pen;
    ingot::draw<Draw::all>(world, pen);
    EXPECT_EQ(pen.strokes.size(), 3u + 3u + 2u);
}

struct Attic : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 2, max_loops = 2, max_manifolds = 8, max_shapes_of_body = 2;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::RodJoint>;
};

/// A body that has flown out of all numbers has a colour of its own; one of one shape, where there may be two, is drawn once; what the world holds as
/// its B has one arm, and a rod is a line between two points.
TEST(Pens, draw_frozen_bodies_rods_and_what_the_world_holds) {
    ingot::World<Attic> world;
    BodyDef ball = solid(ingot::Sphere{1}, {0, 0, ingot::limits::position_max});
    ball.state.v_CM = {0, 0, ingot::limits::speed_max};
    const BodyId lost = world.add(ball).value;
    ball = solid(ingot::Sphere{1}, {4, 0, 0});
    const BodyId hung = world.add(ball).value;
    ball.state.r_CM = {8, 0, 0};
    const BodyId other = world.add(ball).value;
    ingot::JointDef joint;
    joint.body_A = hung;
    joint.joint = ingot::HingeJoint{};
    joint.P = {4, 0, 2};
    ASSERT_TRUE(world.add_joint(joint).ok());
    joint.body_B = other;
    joint.joint = ingot::RodJoint{};
    joint.P = {4, 0, 0};
    joint.P_B = {8, 0, 0};
    ASSERT_TRUE(world.add_joint(joint).ok());
    EXPECT_EQ(ingot::step(world, scalar(1) / 60).bodies_frozen, 1);
    ASSERT_TRUE(world.is_frozen(lost));
    NotingPen pen;
    ingot::draw<Draw::shapes | Draw::joints>(world, pen);
    EXPECT_GT(pen.of(DrawColor::frozen).size(), 0u);
    EXPECT_EQ(pen.of(DrawColor::awake).size(), 2 * pen.of(DrawColor::frozen).size());
    EXPECT_EQ(pen.of(DrawColor::joint_axis).size(), 1u);
    EXPECT_EQ(pen.of(DrawColor::joint).size(), 2u + 3u + 3u);  // arm and gap; two arms and the rod; the cross of its point
}

template <bool reads>
struct Knocks : ingot::Scene {
    static constexpr int max_bodies = 2, max_contacts = 8;
    static constexpr bool translates = true, reads_contacts = reads;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
template <bool reads>
std::size_t strokes_of_a_knock() {
    ingot::World<Knocks<reads>> world;
    BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    BodyDef ball = solid(ingot::Sphere{1}, {0, 0, 1});
    ball.state.v_CM = {0, 0, -1};
    EXPECT_TRUE(world.add(ground).ok() && world.add(ball).ok());
    EXPECT_EQ(ingot::step(world, scalar(1) / 60).status, Status::ok);
    int contacts = 0;
    for (const ContactInfo& contact : world.contacts()) contacts += contact.j > 0 ? 1 : 0;
    EXPECT_EQ(contacts, 1);
    NotingPen pen;
    ingot::draw<Draw::contacts | Draw::impulses>(world, pen);
    return pen.strokes.size();
}
/// A contact whose place no array keeps is none that can be drawn.
TEST(Pens, draw_contacts_that_have_places) {
    EXPECT_EQ(strokes_of_a_knock<false>(), 0u);
    EXPECT_EQ(strokes_of_a_knock<true>(), 3u + 1u + 1u);  // a cross, its impulse and its friction
}

TEST(Reads, tell_what_is_wrong) {
    auto world = yard();
    const BodyId ground = world->body_at(0);
    EXPECT_EQ(world->placed_shape({}).status, Status::stale_id);
    EXPECT_EQ(world->placed_shape(ground, 1).status, Status::out_of_range);
    EXPECT_EQ(world->search_bounds({}).status, Status::stale_id);
    EXPECT_EQ(world->island_of(ground).status, Status::immovable);
    const ingot::JointId joint = world->joint_at(0);
    ASSERT_EQ(world->remove(joint), Status::ok);
    EXPECT_EQ(world->joint_place(joint).status, Status::stale_id);
    ingot::JointId foreign = joint;
    foreign.world_tag = 7;
    EXPECT_EQ(world->joint_place(foreign).status, Status::foreign_id);
}

}  // namespace
