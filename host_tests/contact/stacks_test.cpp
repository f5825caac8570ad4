// SPDX-License-Identifier: MIT
// Cubes on cubes at one step call of 1/60 s: nothing sags, leans or shakes.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/play.h"
#include "replay/snapshot_fields.h"
#include "scenes/stacked.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// Speed under which a body is at rest, m/s: free fall through one step gives it 0.16.
constexpr double rest_speed = 1e-3;

/// 210: shift <= 1.5 mm, settling <= 0.5 mm; 465: shift <= 3 mm. 55 is asked what 210 is.
template <int base>
void expect_pyramid_stands(double shift_mm, double settling_mm) {
    auto scene = play<Pyramid<base>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, Pyramid<base>::seconds);
    figure("shift, mm", 1e3 * scene.shift());
    figure("settling, mm", 1e3 * scene.sink());
    figure("fastest, m/s", scene.fastest());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(1e3 * scene.shift(), shift_mm);
    EXPECT_LE(1e3 * scene.sink(), settling_mm);
    EXPECT_LE(scene.fastest(), rest_speed);
}
TEST(Pyramid, of_55_keeps_its_shape) { expect_pyramid_stands<10>(1.5, 0.5); }
TEST(Pyramid, of_210_keeps_its_shape) { expect_pyramid_stands<20>(1.5, 0.5); }
TEST(Pyramid, of_465_keeps_its_shape) { expect_pyramid_stands<30>(3, 0.5); }

/// 60 s: the top sinks <= 0.2 mm and drifts <= 0.1 mm; tilt < 1e-3 rad.
template <bool renews>
void expect_tower_of_20_stands() {
    auto scene = play<Tower<20>, ingot::AllPairs, renews>();
    ASSERT_TRUE(scene.sound());
    double worst_sink = 0, worst_drift = 0;
    scene.run(OnEarth::h, 60, [&](int) {
        worst_sink = std::max(worst_sink, -scene.moved(20).z());
        worst_drift = std::max(worst_drift, scene.drift(20));
    });
    figure("top sinks, mm", -1e3 * scene.moved(20).z());
    figure("top drifts, mm", 1e3 * scene.drift(20));
    figure("worst sink on the way, mm", 1e3 * worst_sink);
    figure("worst drift on the way, mm", 1e3 * worst_drift);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(-1e3 * scene.moved(20).z(), 0.2);
    EXPECT_LE(1e3 * scene.drift(20), 0.1);
    EXPECT_LE(std::acos(std::min(1.0, scene.A(20)(2, 2))), 1e-3);
}
TEST(Tower, of_20_stands_for_a_minute) { expect_tower_of_20_stands<true>(); }
TEST(Tower, of_20_stands_for_a_minute_on_manifolds_found_anew) { expect_tower_of_20_stands<false>(); }

/// Stands for 60 s: no cube leaves its place by a tenth of its size.
TEST(Tower, of_40_stands_for_a_minute) {
    auto scene = play<Tower<40>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(scene.shift(), 0.1);
    EXPECT_LE(scene.sink(), 0.1);
}

/// C8: the contacts of a tower at rest carry its weight: no cube gains or loses speed.
TEST(Tower, of_10_rests) {
    auto scene = play<Tower<10>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    figure("fastest, m/s", scene.fastest());
    EXPECT_LE(scene.shift(), 1e-3);
    EXPECT_LE(scene.sink(), 1e-3);
    EXPECT_LE(scene.fastest(), rest_speed);
}

/// How far ten cubes of 1 m on each other may sink and shift, m: a column whose every contact is as wrong as the solver lets it be, always to the
/// same side.
///
/// Speeds. Where a sweep corrects no row by more than settled_speed a contact is settled; a point that carries nothing may approach with
/// approach_slack beside that; and speeds of g h round, for which plan_sweeps allows 4 epsilon. No corner of a contact closes or slips
/// faster than their sum, `left`: the test sees to that after each step.
///
/// Sinking. In each substep all ten contacts close by left h. Then position_target takes position_share of each overlap back, at push_speed_max at
/// most, unless that is less than settled_gap; from the ground up; two cubes share evenly, the ground does not move. It is 1 % less by
/// block_diagonal, and an overlap is read too small by four roundings of lengths of 1 m. After the step each height is rounded as r_CM is: in float
/// what is below 0.5 um is lost from 8 m up. Lower heights and a larger `left` never give greater heights in any of these, so no tower sinks further.
///
/// Shifting. Nothing takes a slip back. A contact slips with sqrt(2) left, in two directions; it tilts with 2 left, in rad/s, for its corners are 0.5
/// m from its middle, and moves the top by that times the top's height above it: 50 m for all ten. x and y, near 0, round by epsilon of themselves.
class WorstTower {
public:
    static constexpr int height = 10;

    WorstTower() {
        for (int i = 0; i < height; ++i) z_[i] = start(i);
    }

    void step(double h_of_step) {
        const double h = h_of_step / ingot::limits::steady_substeps;  // the fewest there are: they are the longest
        const double left = left_of(h_of_step);
        constexpr double heights_of_top = 0.5 * height * height;
        double overlap[height], dp[height + 1] = {};  // dp[0] is the ground's
        for (int i = 0; i < height; ++i) overlap[i] = (i == 0 ? 0.5 : static_cast<double>(z_[i - 1]) + 1) - static_cast<double>(z_[i]) - misread;
        for (int substep_i = 0; substep_i < ingot::limits::steady_substeps; ++substep_i) {
            for (int i = 0; i < height; ++i) dp[i + 1] -= (i + 1) * left * h;
            shift_ += left * h * (std::sqrt(2.0) * height + 2 * heights_of_top);
            for (int i = 0; i < height; ++i) take_back(overlap[i] - (dp[i + 1] - dp[i]), h, i, dp);
        }
        for (int i = 0; i < height; ++i) z_[i] = static_cast<scalar>(static_cast<double>(z_[i]) + dp[i + 1]);
        ++steps_;
    }

    /// m/s, after a step of h_of_step.
    static double left_of(double h_of_step) {
        const double h = h_of_step / ingot::limits::steady_substeps;
        return static_cast<double>(ingot::limits::settled_speed) + static_cast<double>(ingot::limits::approach_slack) +
               4 * static_cast<double>(ingot::epsilon * standard_gravity) * h;
    }

    double sink() const {
        double most = 0;
        for (int i = 0; i < height; ++i) most = std::max(most, static_cast<double>(start(i)) - static_cast<double>(z_[i]));
        return most;
    }
    double shift() const { return shift_ * (1 + steps_ * static_cast<double>(ingot::epsilon)); }

private:
    static constexpr double misread = 4 * static_cast<double>(ingot::epsilon);

    static scalar start(int i) { return static_cast<scalar>(i) + scalar(0.5); }
    static void take_back(double overlap, double h, int i, double (&dp)[height + 1]) {
        const double most = static_cast<double>(ingot::limits::push_speed_max) * h;
        const double due = std::min(static_cast<double>(ingot::limits::position_share) * overlap, most);
        if (std::abs(due) <= static_cast<double>(ingot::limits::settled_gap)) return;
        const double back = due / static_cast<double>(ingot::limits::block_diagonal);
        dp[i + 1] += i == 0 ? back : back / 2;
        dp[i] -= i == 0 ? 0 : back / 2;
    }

    scalar z_[height];
    double shift_ = 0;
    int steps_ = 0;
};

/// How fast a corner of a contact slips along x or y, or closes, at most, m/s. A corner may open as it likes.
template <class Scene>
double fastest_corner(const Scene& scene) {
    double fastest = 0;
    for (int i = 1; i <= WorstTower::height; ++i) {
        const bool on_ground = i == 1;
        for (int corner = 0; corner < 4; ++corner) {
            const Vector3d from_upper(corner % 2 == 0 ? 0.5 : -0.5, corner < 2 ? 0.5 : -0.5, -0.5), from_lower = from_upper + Vector3d(0, 0, 1);
            const Vector3d upper = scene.v(i) + scene.omega(i).cross(from_upper);
            const Vector3d lower = on_ground ? Vector3d(0, 0, 0) : Vector3d(scene.v(i - 1) + scene.omega(i - 1).cross(from_lower));
            const Vector3d u = upper - lower;
            fastest = std::max({fastest, std::abs(u.x()), std::abs(u.y()), -u.z()});
        }
    }
    return fastest;
}

/// Steps as they come out of a clock that stutters, from a microsecond to a tenth of a second, in any order: the tower does not notice.
TEST(Tower, of_10_stands_whatever_the_steps) {
    auto scene = play<Tower<WorstTower::height>>();
    ASSERT_TRUE(scene.sound());
    WorstTower worst;
    const scalar steps[] = {scalar(1e-6), scalar(1e-5), scalar(1e-3), scalar(1) / 240, scalar(1) / 144, scalar(1) / 60, scalar(1) / 30, scalar(0.1)};
    double seconds = 0;
    for (int step_i = 0; seconds < 20; ++step_i) {
        const scalar h = steps[static_cast<int>(4 + 4 * scenes::scattered(step_i, 0))];
        (void)scene.step(h);
        worst.step(static_cast<double>(h));
        ASSERT_LE(fastest_corner(scene), WorstTower::left_of(static_cast<double>(h))) << step_i;
        seconds += static_cast<double>(h);
    }
    figure("shift, mm", 1e3 * scene.shift());
    figure("at worst, mm", 1e3 * worst.shift());
    figure("sink, mm", 1e3 * scene.sink());
    figure("at worst, mm", 1e3 * worst.sink());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(scene.shift(), worst.shift());
    EXPECT_LE(scene.sink(), worst.sink());
}

/// Impulses of the normals of each contact in the last substep, as a step of ingot::limits::substeps has them, N s: by the slots of its bodies, out
/// of a snapshot.
std::vector<double> loads_of_tower(const std::vector<uint8_t>& bytes, int height) {
    replay::SnapshotFields snapshot;
    EXPECT_EQ(replay::read_fields(bytes, snapshot), "");
    std::vector<double> loads(static_cast<std::size_t>(height), 0);
    std::size_t lower = 0;
    for (const replay::SnapshotField& field : snapshot.fields) {
        if (field.name == "body_A") lower = static_cast<std::size_t>(field.bits);
        if (field.name == "j") loads.at(lower) += field.value(snapshot.doubles);
    }
    return loads;
}

/// C8: after a minute the contacts of a tower carry what stands on them, each cube's to 1 %, and that of the ground the weight of all. In truth it is
/// settled to settled_speed_of_small of one substep for each cube above: that is what is asked. Tilt <= 1e-3 rad, drift <= 1 mm.
template <int height>
void expect_contacts_carry_the_weight() {
    auto scene = play<Tower<height>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Room<Tower<height>::body_count>>());
    const ingot::Result<std::size_t> size = ingot::save_snapshot(scene.world(), bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    bytes.resize(size.value);
    const std::vector<double> loads = loads_of_tower(bytes, height);
    const double h = static_cast<double>(OnEarth::h) / ingot::limits::substeps, g = static_cast<double>(standard_gravity);
    double worst = 0;
    for (int i = 0; i < height; ++i) {
        const double above = height - i;
        const double force = loads[static_cast<std::size_t>(i)] / h;
        worst = std::max(worst, std::abs(force / (above * g) - 1));
        EXPECT_NEAR(force, above * g, 0.01 * above * g) << i;
    }
    figure("force of a contact, worst error, %", 100 * worst);
    figure("force of the ground, error, %", 100 * (loads[0] / h / (height * g) - 1));
    figure("top drifts, mm", 1e3 * scene.drift(height));
    figure("top tilts, rad", std::acos(std::min(scene.A(height)(2, 2), 1.0)));
    EXPECT_LE(worst, (static_cast<double>(ingot::limits::settled_speed_of_small) * height + 4 * static_cast<double>(ingot::epsilon)) / (g * h));
    EXPECT_LE(scene.drift(height), 1e-3);
    EXPECT_GE(scene.A(height)(2, 2), 1 - 1e-6 / 2);
}
TEST(Tower, of_10_is_carried_by_its_contacts) { expect_contacts_carry_the_weight<10>(); }
TEST(Tower, of_20_is_carried_by_its_contacts) { expect_contacts_carry_the_weight<20>(); }

/// C23: a box at rest for an hour: kinetic energy < 1e-12 J, and its place stays: the position sweep leaves up to settled_gap, and what its place,
/// 0.5 m, is rounded to.
TEST(RestingBox, stays_for_an_hour) {
    auto scene = play<Tower<1>>();
    ASSERT_TRUE(scene.sound());
    double most = 0;
    scene.run(OnEarth::h, 3600, [&](int step_i) {
        if (step_i > 60 && step_i % 60 == 0) most = std::max(most, scene.kinetic(1));
    });
    figure("largest kinetic energy after 1 s, J", most);
    figure("moved, m", scene.moved(1).norm());
    EXPECT_LT(most, 1e-12);
    EXPECT_LE(scene.moved(1).norm(), static_cast<double>(ingot::limits::settled_gap) + 2 * 0.5 * static_cast<double>(ingot::epsilon));
}

/// 1000 kg on 1 kg, 10 s: interpenetration <= 0.1 mm.
template <int light, int top_kg, class Solver = ingot::BlockSweeps>
void expect_load_is_carried(double overlap_mm, double shift_mm) {
    auto scene = play_by<MassRatio<light, top_kg>, Solver>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, MassRatio<light, top_kg>::seconds);
    figure("overlap, mm", 1e3 * scene.deepest_overlap());
    figure("sink, mm", 1e3 * scene.sink());
    figure("shift, mm", 1e3 * scene.shift());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(1e3 * scene.deepest_overlap(), overlap_mm);
    EXPECT_LE(1e3 * scene.shift(), shift_mm);
}
TEST(MassRatio, of_1000_on_1_is_carried) { expect_load_is_carried<1, 1000>(0.1, 1); }
TEST(MassRatio, of_100_on_1_is_carried) { expect_load_is_carried<1, 100>(0.1, 1); }
/// No sweeps carry it: crushed, 960 mm of 1000, with a residual that tells (direct_scenes_test).
TEST(MassRatio, of_1000000_on_1_stands) { expect_load_is_carried<1, 1000000, ingot::HybridIslands<>>(0.1, 1); }
TEST(MassRatio, of_1000_on_nine_of_1_stands) { expect_load_is_carried<9, 1000>(100, 100); }

/// Side by side each cube rests as one alone; in a column as the tower does.
template <bool column>
void expect_ten_boxes_rest() {
    auto scene = play<TenBoxes<column>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, TenBoxes<column>::seconds);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(1e3 * scene.shift(), 0.1);
    EXPECT_LE(1e3 * scene.sink(), 0.2);
    EXPECT_LE(scene.fastest(), rest_speed);
}
TEST(TenBoxes, rest_side_by_side) { expect_ten_boxes_rest<false>(); }
TEST(TenBoxes, rest_in_a_column) { expect_ten_boxes_rest<true>(); }

/// The scenes of the budget of a Cortex-M4F, in which nothing bounces and manifolds are searched for in every step: shift of the cubes, mm.
template <class S>
double shift_in_a_minute() {
    static ingot::World<S> world;
    EXPECT_EQ(set_up(world), Status::ok);
    for (int step_i = 0; step_i < 3600; ++step_i) EXPECT_TRUE(ingot::step(world, S::h).clean());
    double most = 0;
    for (int body_i = 1; body_i < S::max_bodies; ++body_i) {
        const Vector r = world.state(world.body_at(body_i)).value.r_CM;
        most = std::fmax(most, (to_eigen(r) - to_eigen(S::body(body_i).def.state.r_CM)).norm());
    }
    return 1e3 * most;
}
TEST(TenBoxes, of_the_budget_rest_side_by_side) { EXPECT_LE(shift_in_a_minute<scenes::TenBoxesRow>(), 0.1); }
TEST(TenBoxes, of_the_budget_rest_in_a_column) { EXPECT_LE(shift_in_a_minute<scenes::TenBoxesColumn>(), 0.2); }

template <bool springy>
struct Springs : scenes::Stacked<11, 10> {
    static constexpr bool bounces = springy;
};

/// Where no body has a restitution, a scene in which none may bounce is the same to the bit; and it takes in none that has.
TEST(TenBoxes, that_do_not_bounce_need_no_bounces) {
    static ingot::World<Springs<true>> springy;
    static ingot::World<Springs<false>> dull;
    ASSERT_EQ(springy.set_gravity({0, 0, -10}), Status::ok);
    ASSERT_EQ(dull.set_gravity({0, 0, -10}), Status::ok);
    for (int body_i = 0; body_i < 10; ++body_i) {
        PlacedBody placed = TenBoxes<true>::body(body_i);
        placed.def.state.r_CM = placed.def.state.r_CM * scalar(1.1);  // they fall on each other
        ASSERT_TRUE(springy.add(placed.def).ok());
        ASSERT_TRUE(dull.add(placed.def).ok());
    }
    for (int step_i = 0; step_i < 120; ++step_i) {
        ASSERT_TRUE(ingot::step(springy, OnEarth::h).clean());
        ASSERT_TRUE(ingot::step(dull, OnEarth::h).clean());
        ASSERT_EQ(springy.state_hash(), dull.state_hash()) << "step " << step_i;
    }
    PlacedBody ball = TenBoxes<true>::body(10);
    ball.def.restitution = scalar(0.5);
    const uint64_t hash = dull.state_hash();
    EXPECT_EQ(dull.add(ball.def).status, Status::not_in_scene);
    EXPECT_EQ(dull.state_hash(), hash);
    EXPECT_TRUE(springy.add(ball.def).ok());
}

/// C12: the centre of mass 1 mm before the edge: rests for 60 s; 1 mm beyond: tips.
TEST(Overhang, rests_before_the_edge) {
    auto scene = play<Overhang<-1>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, Overhang<-1>::seconds);
    figure("shift, mm", 1e3 * scene.shift());
    figure("tilt, rad", std::acos(std::min(1.0, scene.A(1)(2, 2))));
    EXPECT_LE(scene.shift(), 1e-3);
    EXPECT_LE(std::acos(std::min(1.0, scene.A(1)(2, 2))), 1e-3);
}
TEST(Overhang, tips_beyond_the_edge) {
    auto scene = play<Overhang<1>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 10);
    EXPECT_LT(scene.r(1).z(), 1);
}

/// C18: 60 s without jitter: the speed stays under 1e-3 m/s, nothing turns or wanders by a part in a thousand of its length.
template <bool plate>
void expect_sliver_rests() {
    auto scene = play<Sliver<plate>>();
    ASSERT_TRUE(scene.sound());
    double fastest = 0;
    scene.run(OnEarth::h, Sliver<plate>::seconds, [&](int step_i) {
        if (step_i > 60) fastest = std::max(fastest, scene.fastest());
    });
    figure("fastest after 1 s, m/s", fastest);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_LE(fastest, rest_speed);
    EXPECT_LE(scene.shift(), 1e-3);
    EXPECT_LE(scene.sink(), 1e-3);
}
TEST(Sliver, rod_rests) { expect_sliver_rests<false>(); }
TEST(Sliver, plate_rests) { expect_sliver_rests<true>(); }

}  // namespace
