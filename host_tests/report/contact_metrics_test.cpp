// SPDX-License-Identifier: MIT
// What is measured of contact scenes, on runs that are made up: displacements, overlaps, energies.
#include <gtest/gtest.h>

#include <cmath>

#include "report/contact_race.h"

namespace {

using namespace report;

constexpr double pi = 3.14159265358979323846;

SceneBody body_of(Solid solid, double x, double y, double z) {
    SceneBody body{};
    body.solid = solid;
    body.size[0] = x;
    body.size[1] = y;
    body.size[2] = z;
    body.immovable = solid == Solid::half_space;
    body.M = 1;
    body.I[0] = body.I[1] = body.I[2] = 1;
    body.A[0] = body.A[4] = body.A[8] = 1;
    return body;
}

BodyPose pose_of(double x, double y, double z) {
    BodyPose pose{};
    pose.A[0] = pose.A[4] = pose.A[8] = 1;
    pose.r[0] = x;
    pose.r[1] = y;
    pose.r[2] = z;
    return pose;
}

ContactCase case_of(const char* name, std::vector<SceneBody> bodies, double seconds) {
    ContactCase scene;
    scene.name = name;
    scene.gravity[0] = scene.gravity[1] = 0;
    scene.gravity[2] = -10;
    scene.seconds = seconds;
    scene.bodies = std::move(bodies);
    return scene;
}

double metric(const ContactTally& tally, const std::string& name) {
    for (const Metric& one : tally.metrics())
        if (one.name == name) return one.value;
    ADD_FAILURE() << "no metric " << name;
    return std::nan("");
}

const SceneBody ground = body_of(Solid::half_space, 0, 0, 1), ball = body_of(Solid::ball, 0.5, 0, 0),
                cube = body_of(Solid::box, 0.5, 0.5, 0.5);

/// Turned about y by 45 degrees: an edge below, along y.
BodyPose on_edge(double x, double y, double z) {
    BodyPose pose = pose_of(x, y, z);
    pose.A[0] = pose.A[8] = std::cos(pi / 4);
    pose.A[2] = -std::sin(pi / 4);
    pose.A[6] = std::sin(pi / 4);
    return pose;
}

TEST(Overlap, of_balls_boxes_and_ground) {
    EXPECT_NEAR(overlap_of(ball, pose_of(0, 0, 0), ball, pose_of(0, 0.6, 0.7)), 1 - std::sqrt(0.85), 1e-15);
    EXPECT_NEAR(overlap_of(ball, pose_of(0, 0, 0.375), ground, {}), 0.125, 1e-15);
    EXPECT_NEAR(overlap_of(ground, {}, cube, pose_of(3, 0, 0.625)), -0.125, 1e-15);
    EXPECT_NEAR(overlap_of(cube, pose_of(0, 0, 0), cube, pose_of(0.25, 0.25, 0.75)), 0.25, 1e-15);
}

TEST(Overlap, of_a_cube_on_its_edge) {
    EXPECT_NEAR(overlap_of(cube, on_edge(0, 0, std::sqrt(0.5) - 0.01), ground, {}), 0.01, 1e-15);
}

/// Turned about x by 45 degrees: an edge above, along x.
BodyPose edge_along_x(double x, double y, double z) {
    BodyPose pose = pose_of(x, y, z);
    pose.A[4] = pose.A[8] = std::cos(pi / 4);
    pose.A[5] = std::sin(pi / 4);
    pose.A[7] = -std::sin(pi / 4);
    return pose;
}

TEST(Overlap, of_edges_that_cross_is_along_their_common_normal) {
    const double reach = 2 * std::sqrt(0.5);
    EXPECT_NEAR(overlap_of(cube, on_edge(0, 0, reach - 0.01), cube, edge_along_x(0, 0, 0)), 0.01, 1e-15);
    EXPECT_NEAR(overlap_of(cube, on_edge(0, 0, reach + 0.01), cube, edge_along_x(0, 0, 0)), -0.01, 1e-15) << "no face parts them";
}

TEST(Overlap, of_a_ball_and_an_edge_is_towards_the_edge) {
    const double near = 0.5 + 0.45 * std::sqrt(0.5);
    EXPECT_NEAR(overlap_of(ball, pose_of(near, near, 0), cube, pose_of(0, 0, 0)), 0.05, 1e-15);
    EXPECT_NEAR(overlap_of(cube, pose_of(0, 0, 0), ball, pose_of(0.25, 0, 0)), 0.75, 1e-15) << "its centre is inside: by a face";
}

TEST(Overlap, of_capsules) {
    const SceneBody capsule = body_of(Solid::capsule, 0.25, 1, 0);
    BodyPose lying = pose_of(0, 0.375, 0.5);  // along x
    lying.A[0] = lying.A[8] = 0;
    lying.A[2] = -1;
    lying.A[6] = 1;
    EXPECT_NEAR(overlap_of(capsule, pose_of(0, 0, 1.125), ground, {}), 0.125, 1e-15);
    EXPECT_NEAR(overlap_of(capsule, pose_of(0, 0, 0), capsule, pose_of(0, 0, 2.375)), 0.125, 1e-14) << "end to end";
    EXPECT_NEAR(overlap_of(capsule, pose_of(0, 0, 0), capsule, lying), 0.125, 1e-14) << "crossed";
    EXPECT_NEAR(overlap_of(capsule, pose_of(0.625, 0, 0.75), ball, pose_of(0, 0, 0)), 0.125, 1e-14) << "beside its middle";
    EXPECT_NEAR(overlap_of(cube, pose_of(0, 0, 0), capsule, pose_of(0.625, 0, 0.25)), 0.125, 1e-14) << "along a face";
    EXPECT_NEAR(overlap_of(cube, pose_of(0, 0, 0), capsule, pose_of(0.25, 0, 0)), 0.5, 1e-14) << "its axis is inside";
    EXPECT_LE(overlap_of(cube, pose_of(0, 0, 0), capsule, pose_of(0.7, 0.7, 0)), 0) << "beside an edge";
}

TEST(Overlaps, look_at_every_pair_and_count_those_that_overlap) {
    const ContactCase scene = case_of("pile", {ground, ball, ball, ball}, 1);
    // Chosen so that the third ball comes first along x.
    const Overlaps all = overlaps_of(scene, {{}, pose_of(0, 0, 0.5), pose_of(0.75, 0, 0.5), pose_of(-0.5, 0, 0.25)});
    EXPECT_EQ(all.count, 3);
    EXPECT_NEAR(all.deepest, 1 - std::hypot(0.5, 0.25), 1e-15);
    EXPECT_NEAR(all.sum, 0.25 + 0.25 + (1 - std::hypot(0.5, 0.25)), 1e-15);
}

TEST(Tally, of_a_tower_takes_the_worst_of_all_steps) {
    const ContactCase scene = case_of("tower", {ground, cube, cube}, 1);
    const std::vector<BodyPose> start = {{}, pose_of(0, 0, 0.5), pose_of(0, 0, 1.5)};
    ContactTally tally(scene, start, 1);
    tally.see({{}, pose_of(0.004, 0, 0.5), pose_of(0.003, 0.004, 1.498)}, {}, 0.25);
    tally.see({{}, pose_of(0, 0, 0.497), pose_of(0, 0, 1.499)}, {}, 0.5);
    tally.see({{}, pose_of(0, 0, 0.5), pose_of(0.75, 0, 1.499)}, {}, 0.75);
    tally.see({{}, pose_of(0, 0, 0.5), pose_of(0, 0, 1.4995)}, {}, 1);
    EXPECT_NEAR(metric(tally, "shift"), 750, 1e-9);
    EXPECT_NEAR(metric(tally, "settling"), 3, 1e-9);
    EXPECT_NEAR(metric(tally, "settled"), 0.5, 1e-9);
    EXPECT_NEAR(metric(tally, "sink"), 2, 1e-9);
    EXPECT_EQ(metric(tally, "stood"), 0.5);  // what has fallen stands no more
}

TEST(Tally, of_a_ball_in_flight_keeps_its_energy) {
    const ContactCase scene = case_of("bounce_e1", {ground, ball}, 1);
    const auto at = [](double t) {
        BodyPose pose = pose_of(0, 0, 10 - 5 * t * t);
        pose.v[2] = -10 * t;
        return pose;
    };
    ContactTally tally(scene, {{}, at(0)}, 1);
    for (const double t : {0.25, 0.5, 0.75, 1.0}) tally.see({{}, at(t)}, {}, t);
    EXPECT_LE(metric(tally, "energy_error"), 4e-16);
    BodyPose faster = at(1);
    faster.v[2] *= 1.01;
    tally.see({{}, faster}, {}, 1.25);
    EXPECT_NEAR(metric(tally, "energy_gain"), 50 * 0.0201 / 95, 1e-12);
}

TEST(Tally, of_a_slope_knows_how_far_a_cube_slides) {
    SceneBody plane = ground;
    plane.size[0] = 0.6;
    plane.size[2] = 0.8;
    SceneBody block = cube;
    block.mu = 0.25;
    const ContactCase scene = case_of("incline_mu025", {plane, block}, 2);
    ContactTally tally(scene, {{}, pose_of(0, 0, 0)}, 2);
    const double s = 10 * (0.6 - 0.25 * 0.8) * 4 / 2 * 1.01;
    tally.see({{}, pose_of(0.8 * s, 0, -0.6 * s)}, {}, 2);
    EXPECT_NEAR(metric(tally, "distance_error"), 1, 1e-9);
    EXPECT_NEAR(metric(tally, "lift"), 0, 1e-12);
}

/// Its steps take as long as they are told to.
class Sleeper final : public ContactRun {
public:
    explicit Sleeper(double us) : us_(us) {}
    void step(int) override {
        for (const double from = thread_us(); thread_us() - from < us_;) {
        }
    }
    void read(std::vector<BodyPose>& poses) const override { poses = {{}, pose_of(0, 0, 0.5)}; }

private:
    double us_;
};

TEST(Race, tells_the_slow_from_the_fast) {
    const ContactCase scene = case_of("bounce", {ground, ball}, 1);
    const auto sleeper = [](double us) { return [us] { return std::make_unique<Sleeper>(us); }; };
    const std::vector<double> us = raced(scene, {sleeper(20), sleeper(60)}, 60, 1, 3);
    EXPECT_GE(us[0], 20);
    EXPECT_GE(us[1], 60);
    EXPECT_LT(us[0], us[1]);
}

/// Freezes a body in its fifth step.
class Frozen final : public ContactRun {
public:
    void step(int) override { ++steps_; }
    void read(std::vector<BodyPose>& poses) const override { poses = {{}, pose_of(0, 0, 0.5)}; }
    StepFigures figures() const override { return {0, 1, 0, steps_ >= 5 ? 1 : 0}; }

private:
    int steps_ = 0;
};

TEST(Race, has_no_time_for_a_run_whose_bodies_froze) {
    const ContactCase scene = case_of("bounce", {ground, ball}, 1);
    const std::vector<double> us =
        raced(scene, {[] { return std::make_unique<Frozen>(); }, [] { return std::make_unique<Sleeper>(1); }}, 60, 1, 2);
    EXPECT_TRUE(std::isnan(us[0]));
    EXPECT_GE(us[1], 1);
}

TEST(Followed, ends_where_bodies_freeze) {
    const ContactCase scene = case_of("pit", {ground, ball}, 1);
    double seconds = 0, frozen = 0;
    for (const Metric& one : followed(
             scene, [] { return std::make_unique<Frozen>(); }, 60, 1)) {
        if (std::string(one.name) == "seconds") seconds = one.value;
        if (std::string(one.name) == "frozen") frozen = one.value;
    }
    EXPECT_NEAR(seconds, 5.0 / 60, 1e-12);
    EXPECT_EQ(frozen, 1);
}

TEST(Approach, of_a_run_that_rests_is_zero) {
    const ContactCase scene = case_of("tower", {ground, ball}, 1);
    const std::vector<Approach> points = approach_to_rest(
        scene, [] { return std::make_unique<Sleeper>(1); }, 60);
    ASSERT_EQ(points.size(), 9u);
    EXPECT_EQ(points.back().steps, 256);
    for (const Approach& point : points) EXPECT_EQ(point.distance, 0);
}

}  // namespace
