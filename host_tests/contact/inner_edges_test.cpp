// SPDX-License-Identifier: MIT
// Floors of many fixed shapes are floors: what slides or rolls over flush boxes and hulls goes as it does on one slab. And edges that are there are
// felt: lips, steps, walls, rims and ramps as if nothing were looked for.
//
// The oracle is the same body on one slab, in the same test.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "contact/play.h"

namespace {

using ingot::Matrix;
using ingot_contact::BodyId;
using ingot_contact::scalar;
using ingot_contact::Status;
using ingot_contact::to_eigen;
using ingot_contact::Vector;
using ingot_contact::Vector3d;

constexpr scalar third = scalar(0.17320508);
constexpr auto cube_tile = ingot::convex_hull<8>({{scalar(-0.25), scalar(-0.25), scalar(-0.25)}, {scalar(0.25), scalar(-0.25), scalar(-0.25)},
                                                  {scalar(-0.25), scalar(0.25), scalar(-0.25)},  {scalar(0.25), scalar(0.25), scalar(-0.25)},
                                                  {scalar(-0.25), scalar(-0.25), scalar(0.25)},  {scalar(0.25), scalar(-0.25), scalar(0.25)},
                                                  {scalar(-0.25), scalar(0.25), scalar(0.25)},   {scalar(0.25), scalar(0.25), scalar(0.25)}});
constexpr auto nut = ingot::convex_hull<12>(
    {{scalar(0.2), 0, scalar(-0.1)}, {scalar(0.1), third, scalar(-0.1)}, {scalar(-0.1), third, scalar(-0.1)}, {scalar(-0.2), 0, scalar(-0.1)},
     {scalar(-0.1), -third, scalar(-0.1)}, {scalar(0.1), -third, scalar(-0.1)}, {scalar(0.2), 0, scalar(0.1)}, {scalar(0.1), third, scalar(0.1)},
     {scalar(-0.1), third, scalar(0.1)}, {scalar(-0.2), 0, scalar(0.1)}, {scalar(-0.1), -third, scalar(0.1)}, {scalar(0.1), -third, scalar(0.1)}});

template <class Solver, bool joins = true>
struct Floor : ingot::Scene {
    static constexpr int max_bodies = 2600;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 400;
    static constexpr int max_pairs = 6000;
    static constexpr bool hides_internal_edges = joins;
    using broad_phase = ingot::SortedTree;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {cube_tile.value.view(), nut.value.view()};
};
constexpr int tile_form = 0, nut_form = 1;

enum Kind { ball, box, coin, rolling_capsule, sliding_capsule, wheel, hull, kinds };
enum Layout { grid, uneven_below, t_seams, sunk_in_half_space, hulls_only, boxes_and_hulls, layouts };

Matrix turned(const Vector& axis, double angle) {
    const Eigen::AngleAxisd turn(angle, to_eigen(axis));
    const Eigen::Matrix3d A = turn.toRotationMatrix();
    const auto column = [&](int i) { return Vector{static_cast<scalar>(A(0, i)), static_cast<scalar>(A(1, i)), static_cast<scalar>(A(2, i))}; };
    return {column(0), column(1), column(2)};
}

class Draws {
public:
    explicit Draws(unsigned seed) : random_(seed) {}
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(random_()) / 4294967296.0); }
    int one_of(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

private:
    std::mt19937 random_;
};

/// One way over a floor.
struct Trip {
    int kind, layout, rate;
    double r, tile, heading, speed, mu, ramp, seconds;
    bool in_company;
    unsigned seed;

    std::string text() const {
        static const char* const names[] = {"ball", "box", "coin", "rolling capsule", "sliding capsule", "wheel", "hull"};
        return std::string(names[kind]) + " r " + std::to_string(r) + " tile " + std::to_string(tile) + " layout " + std::to_string(layout) +
               " heading " + std::to_string(heading) + " speed " + std::to_string(speed) + " rate " + std::to_string(rate) + " mu " +
               std::to_string(mu) + " ramp " + std::to_string(ramp) + " seed " + std::to_string(seed);
    }
};

Trip draw_trip(int kind, unsigned seed) {
    Draws draw(seed);
    Trip trip{};
    trip.kind = kind;
    trip.seed = seed;
    trip.r = kind == hull ? 0.2 : 0.1 * std::pow(4, draw.between(0, 1));
    trip.layout = draw.one_of(layouts);
    trip.tile = trip.layout >= hulls_only ? 0.5 : trip.r * std::pow(20, draw.between(0, 1));  // half to ten times as large
    const double headings[] = {0, M_PI / 2, M_PI / 4, draw.between(0, 2 * M_PI)};
    trip.heading = headings[draw.one_of(4)];
    trip.speed = 0.5 * std::pow(40, draw.between(0, 1));
    const int rates[] = {30, 60, 120, 240, 1000};
    trip.rate = rates[draw.one_of(5)];
    const double frictions[] = {0, 0.1, 0.3, 0.6, 1};
    trip.mu = frictions[draw.one_of(5)];
    trip.ramp = draw.one_of(4) == 0 ? draw.between(0, 0.2) : 0;
    trip.seconds = std::min(trip.rate == 1000 ? 1.0 : 2.0, std::max(0.2, std::min(60 * trip.tile, 30.0) / trip.speed));
    trip.in_company = draw.one_of(3) == 0;
    return trip;
}

struct Track {
    std::vector<Vector3d> r, v;  ///< after each step
    std::vector<double> height;  ///< m, above where it began, across the floor
    int lost = 0;
};

template <class S>
class Ground {
public:
    explicit Ground(const Trip& trip)
        : trip_(trip), world_(new ingot::World<S>{}),
          F_(turned({static_cast<scalar>(-std::sin(trip.heading)), static_cast<scalar>(std::cos(trip.heading)), 0}, trip.ramp)),
          way_(trip.speed * trip.seconds + 1 + 4.9 * std::sin(trip.ramp) * trip.seconds * trip.seconds) {
        sound_ = world_->set_gravity({0, 0, scalar(-9.81)}) == Status::ok;
    }
    bool sound() const { return sound_; }

    void add_slab() { add_fixed(ingot::Box{{static_cast<scalar>(way_ + 5), static_cast<scalar>(way_ + 5), 1}}, 0, 0, 1); }

    void add_tiles() {
        Draws draw(trip_.seed + 1);
        const double s = trip_.tile, reach = 4 * trip_.r + 1.5 * s + trip_.speed / trip_.rate, x_0 = draw.between(0, s), y_0 = draw.between(0, s);
        const int n = static_cast<int>((way_ + 2 * reach) / s) + 3;
        const auto near = [&](double x, double y) {
            const double c = std::cos(trip_.heading), d = std::sin(trip_.heading), along = x * c + y * d, across = y * c - x * d;
            return along > -reach - s && along < way_ + reach + s && std::abs(across) < reach + s;
        };
        if (trip_.layout == t_seams) {
            for (int k = -n; k <= n; ++k) {
                double length = 0;
                for (double x = -(way_ + 2 * reach) - s; x < way_ + 3 * reach; x += length) {
                    length = s * draw.between(0.5, 1.5);
                    if (near(x + length / 2, k * s + y_0)) add_box(x + length / 2, k * s + y_0, length / 2, s / 2, s / 2);
                }
            }
            return;
        }
        if (trip_.layout == sunk_in_half_space) add_fixed(ingot::HalfSpace{{0, 0, 1}, 0}, 0, 0, 0);
        for (int i = -n; i <= n; ++i)
            for (int k = -n; k <= n; ++k) {
                if (trip_.layout == sunk_in_half_space && ((i + k) & 1) != 0) continue;
                const double x = i * s + x_0, y = k * s + y_0, depth = trip_.layout == uneven_below ? s * draw.between(0.05, 1) : s / 2;
                if (!near(x, y)) continue;
                if (trip_.layout == hulls_only || (trip_.layout == boxes_and_hulls && ((i + k) & 1) != 0))
                    add_fixed(ingot::hull_of<S>(tile_form), x, y, 0.25);
                else
                    add_box(x, y, s / 2, s / 2, depth);
            }
    }

    void add_box_at(const Vector& half_extents, const Vector& r, double pitch) {
        ingot::BodyDef def;
        def.immovable = true;
        def.shape = ingot::Box{half_extents};
        def.friction = static_cast<scalar>(trip_.mu);
        def.state.A = turned({0, 1, 0}, pitch);
        def.state.r_CM = r;
        def.state.v_CM = def.state.L = {};
        sound_ = sound_ && world_->add(def).ok();
    }

    /// A ball that bounces far away.
    void add_company() {
        add_fixed(ingot::Box{{1, 1, 1}}, -300, 0, 1);
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_sphere(1000, scalar(0.2))).value;
        def.shape = ingot::Sphere{scalar(0.2)};
        def.restitution = scalar(0.5);
        def.state.A = F_;
        def.state.r_CM = F_ * Vector{-300, 0, 1};
        def.state.v_CM = def.state.L = {};
        sound_ = sound_ && world_->add(def).ok();
    }

    Track run(double tilted) {
        const BodyId id = add_body(tilted);
        Track track;
        const Vector up = F_ * Vector{0, 0, 1};
        const int steps = static_cast<int>(std::lround(trip_.seconds * trip_.rate));
        for (int step_i = 0; step_i < steps; ++step_i) {
            track.lost += ingot::step(*world_, scalar(1) / static_cast<scalar>(trip_.rate)).contacts_lost;
            const ingot::BodyState state = world_->state(id).value;
            track.r.push_back(to_eigen(state.r_CM));
            track.v.push_back(to_eigen(state.v_CM));
            track.height.push_back(to_eigen(up).dot(track.r.back()));
        }
        return track;
    }

private:
    void add_fixed(const ingot::Shape& shape, double x, double y, double depth) {
        ingot::BodyDef def;
        def.immovable = true;
        def.shape = shape;
        def.friction = static_cast<scalar>(trip_.mu);
        def.state.A = F_;
        def.state.r_CM = F_ * Vector{static_cast<scalar>(x), static_cast<scalar>(y), static_cast<scalar>(-depth)};
        def.state.v_CM = def.state.L = {};
        sound_ = sound_ && world_->add(def).ok();
    }
    void add_box(double x, double y, double h_x, double h_y, double depth) {
        add_fixed(ingot::Box{{static_cast<scalar>(h_x), static_cast<scalar>(h_y), static_cast<scalar>(depth)}}, x, y, depth);
    }

    BodyId add_body(double tilted) {
        const auto r = static_cast<scalar>(trip_.r);
        const double c = std::cos(trip_.heading), s = std::sin(trip_.heading);
        const Vector along = {static_cast<scalar>(c), static_cast<scalar>(s), 0}, across = {static_cast<scalar>(-s), static_cast<scalar>(c), 0};
        const Matrix on_side = turned({1, 0, 0}, M_PI / 2), lengthways = turned({0, 1, 0}, M_PI / 2);
        Matrix A = turned({0, 0, 1}, trip_.heading);
        scalar height = r;
        ingot::BodyDef def;
        ingot::MassDistribution solid{};
        switch (trip_.kind) {
            case ball: solid = ingot::solid_sphere(1000, r), def.shape = ingot::Sphere{r}; break;
            case box:
                height = r * scalar(0.6);
                solid = ingot::solid_box(1000, {r, r * scalar(0.8), height}), def.shape = ingot::Box{{r, r * scalar(0.8), height}};
                break;
            case coin:
                height = r * scalar(0.25);
                solid = ingot::solid_cylinder(1000, r, height), def.shape = ingot::Cylinder{r, height};
                break;
            case rolling_capsule:
            case sliding_capsule:
                A = A * (trip_.kind == rolling_capsule ? on_side : lengthways);
                solid = ingot::solid_capsule(1000, r, r * scalar(1.2)), def.shape = ingot::Capsule{r, r * scalar(1.2)};
                break;
            case wheel:
                A = A * on_side;
                solid = ingot::solid_cylinder(1000, r, r * scalar(0.4)), def.shape = ingot::Cylinder{r, r * scalar(0.4)};
                break;
            default:
                height = scalar(0.1);
                solid = ingot::solid_hull(1000, nut.value.view()).value, def.shape = ingot::hull_of<S>(nut_form);
                break;
        }
        const bool rolls = trip_.kind == ball || trip_.kind == rolling_capsule || trip_.kind == wheel;
        const auto speed = static_cast<scalar>(trip_.speed);
        def.friction = static_cast<scalar>(trip_.mu);
        def.mass = ingot::principal(solid).value;
        def.state = ingot::body_state(def.mass, {F_ * Vector{0, 0, height}, F_ * turned(along, tilted) * A},
                                      {F_ * along * speed, rolls ? F_ * across * (speed / r) : Vector{}});
        const ingot::Result<BodyId> id = world_->add(def);
        sound_ = sound_ && id.ok();
        return id.value;
    }

    Trip trip_;
    std::unique_ptr<ingot::World<S>> world_;
    Matrix F_;  ///< of the floor: it falls along the heading
    double way_;
    bool sound_ = false;
};

/// How far two tracks part, up to where the first comes to rest: a capsule that has stopped may roll away, on whatever it lies.
struct Parted {
    double speed = 0, way = 0, hop = 0;  ///< of the speed at the begin; of the way; m
    bool within(double share, double height) const { return speed <= share && way <= share && hop <= height; }
};
Parted parted(const Trip& trip, const Track& slab, const Track& other) {
    Parted most;
    double way = 0;
    Vector3d before = Vector3d::Zero(), r = Vector3d::Zero();
    for (std::size_t i = 0; i < slab.r.size(); ++i) {
        if (i > 0) way += (slab.r[i] - before).norm();
        before = slab.r[i];
        if (slab.v[i].norm() < 0.02 * trip.speed) break;
        r = other.r[i] - slab.r[i];
        most.speed = std::abs(other.v[i].norm() - slab.v[i].norm()) / trip.speed;
        most.way = r.norm() / (way + slab.v[0].norm() / trip.rate);
        most.hop = std::max(most.hop, other.height[i] - slab.height[i]);
    }
    return most;
}

/// Speed and way within 0.1 %, no hop above 0.5 mm. A trip on which a tilt of 1e-4 parts two bodies on one slab by more than that asks for nothing:
/// wheels that turn by a radian or more in a step fall over.
template <class Solver>
void expect_as_on_one_slab(int kind, int trips) {
    using S = Floor<Solver>;
    constexpr double share = 1e-3, height = 5e-4;
    int asked = 0;
    Parted worst;
    for (int trip_i = 0; trip_i < trips; ++trip_i) {
        const Trip trip = draw_trip(kind, static_cast<unsigned>(1000 * kind + trip_i));
        Track tracks[3];
        for (int which = 0; which < 3; ++which) {
            Ground<S> ground(trip);
            if (which == 2)
                ground.add_tiles();
            else
                ground.add_slab();
            if (which == 2 && trip.in_company) ground.add_company();
            tracks[which] = ground.run(which == 1 ? 1e-4 : 0);
            ASSERT_TRUE(ground.sound()) << trip.text();
            ASSERT_EQ(tracks[which].lost, 0) << trip.text();
        }
        if (!parted(trip, tracks[0], tracks[1]).within(share, height)) continue;
        ++asked;
        const Parted by = parted(trip, tracks[0], tracks[2]);
        EXPECT_LE(by.speed, share) << trip.text();
        EXPECT_LE(by.way, share) << trip.text();
        EXPECT_LE(by.hop, height) << trip.text();
        worst = {std::max(worst.speed, by.speed), std::max(worst.way, by.way), std::max(worst.hop, by.hop)};
    }
    EXPECT_GE(asked, trips / 2);
    ingot_contact::figure("asked", asked);
    ingot_contact::figure("worst error of speed, %", 100 * worst.speed);
    ingot_contact::figure("worst error of way, %", 100 * worst.way);
    ingot_contact::figure("worst hop, mm", 1e3 * worst.hop);
}

class InnerEdges : public ::testing::TestWithParam<int> {};
TEST_P(InnerEdges, block_sweeps_go_as_on_one_slab) { expect_as_on_one_slab<ingot::BlockSweeps>(GetParam(), 60); }
TEST_P(InnerEdges, hybrid_islands_go_as_on_one_slab) { expect_as_on_one_slab<ingot::HybridIslands<>>(GetParam(), 20); }
TEST_P(InnerEdges, sequential_impulses_go_as_on_one_slab) { expect_as_on_one_slab<ingot::SequentialImpulses>(GetParam(), 20); }
INSTANTIATE_TEST_SUITE_P(Kinds, InnerEdges, ::testing::Range(0, static_cast<int>(kinds)));

// The law's other side. A slab lies under all of these floors, so that a scene that looks for no inner edges has none to stumble on, and of edges
// that are there: both have to be met alike.
struct FixedBox {
    Vector half_extents, r;
    double pitch;  ///< rad, about y
};
struct Edge {
    const char* what;
    std::vector<FixedBox> boxes;
};
const FixedBox slab = {{12, 4, 1}, {4, 0, -1}, 0};
const Edge real_edges[] = {
    {"a lip of 1 mm", {slab, {{4, 3, 1}, {8, 0, scalar(-0.999)}, 0}}},
    {"a step of 50 mm up", {slab, {{4, 3, 1}, {8, 0, scalar(-0.95)}, 0}}},
    {"a step of 50 mm down", {{{12, 4, 1}, {4, 0, scalar(-1.05)}, 0}, {{4, 3, 1}, {0, 0, -1}, 0}}},
    {"a wall on a slab", {slab, {{1, 3, 1}, {5, 0, 1}, 0}}},
    {"a rim", {{{4, 3, 1}, {0, 0, -1}, 0}}},
};

template <bool joins>
Track over_edge(const Trip& trip, const Edge& edge) {
    Ground<Floor<ingot::BlockSweeps, joins>> ground(trip);
    for (const FixedBox& box : edge.boxes) ground.add_box_at(box.half_extents, box.r, box.pitch);
    Track track = ground.run(0);
    EXPECT_TRUE(ground.sound());
    return track;
}

/// As without the law, a tenth of a second after the edge, to 5 % of the speed: whoever lands on an edge has contacts in the slab below it, which the
/// law takes away, and impacts multiply what differs. A contact that is missing is the whole speed.
class RealEdges : public ::testing::TestWithParam<int> {};
TEST_P(RealEdges, are_felt) {
    for (const Edge& edge : real_edges)
        for (unsigned seed = 0; seed < 12; ++seed) {
            Trip trip = draw_trip(GetParam(), seed);
            trip.heading = trip.ramp = 0;
            trip.speed = std::max(trip.speed, 4.0);
            trip.mu = std::min(trip.mu, 0.1);
            trip.seconds = 1.5;
            trip.rate = std::min(trip.rate, 240);
            const Track joined = over_edge<true>(trip, edge), plain = over_edge<false>(trip, edge);
            std::size_t steps = 0;
            while (steps < plain.r.size() && plain.r[steps].x() < 4 - 2.5 * trip.r) ++steps;
            ASSERT_LT(steps, plain.r.size()) << edge.what << ", " << trip.text();
            steps = std::min(plain.r.size(), steps + static_cast<std::size_t>(trip.rate / 10 + 1));
            EXPECT_LE((joined.v[steps - 1] - plain.v[steps - 1]).norm(), 0.05 * trip.speed) << edge.what << ", " << trip.text();
            EXPECT_LE((joined.r[steps - 1] - plain.r[steps - 1]).norm(), 0.05 * trip.speed * 0.1 + 1e-3) << edge.what << ", " << trip.text();
        }
}
INSTANTIATE_TEST_SUITE_P(Kinds, RealEdges, ::testing::Range(0, static_cast<int>(kinds)));

/// What rolls onto a ramp rolls up the ramp: neither into it nor off it, although the slab goes on inside.
TEST(RealRamp, is_climbed) {
    constexpr double pitch = 0.2;
    const Edge ramp = {"a ramp up", {slab, {{3, 3, scalar(0.5)}, {scalar(6.85), 0, scalar(0.06)}, -pitch}}};
    for (const int kind : {static_cast<int>(ball), static_cast<int>(rolling_capsule), static_cast<int>(wheel)})
        for (unsigned seed = 0; seed < 12; ++seed) {
            Trip trip = draw_trip(kind, seed);
            trip.heading = trip.ramp = 0;
            trip.speed = 2 + trip.speed / 4;
            trip.rate = std::min(trip.rate, 240);
            trip.seconds = 4.8 / trip.speed;
            const Track track = over_edge<true>(trip, ramp);
            const Vector3d v = track.v.back(), n(-std::sin(pitch), 0, std::cos(pitch));
            EXPECT_GT(track.r.back().x(), 4.3) << trip.text();
            EXPECT_LE(std::abs(n.dot(v)), 1e-3 * v.norm()) << trip.text();
        }
}

/// Bodies of all kinds, thrown onto a grid and left to tumble for ten seconds: whoever has not left it over its rim ends above it. One that another
/// lands on may be in the floor for a step or two.
TEST(InnerEdgesOfAGrid, let_nothing_through) {
    using S = Floor<ingot::BlockSweeps>;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Draws draw(seed);
        const double tile = draw.between(0.25, 0.8);
        const int rates[] = {30, 60, 120, 60};
        const int n = static_cast<int>(4 / tile), rate = rates[seed - 1];
        auto world = std::make_unique<ingot::World<S>>();
        bool sound = world->set_gravity({0, 0, scalar(-9.81)}) == Status::ok;
        ingot::BodyDef fixed;
        fixed.immovable = true;
        fixed.state.A = ingot::identity_matrix<scalar>();
        fixed.state.v_CM = fixed.state.L = {};
        for (int i = -n; i <= n; ++i)
            for (int k = -n; k <= n; ++k) {
                const auto half = static_cast<scalar>(tile / 2), depth = static_cast<scalar>(draw.between(0.2, 0.5));
                fixed.shape = ingot::Box{{half, half, depth}};
                fixed.state.r_CM = {static_cast<scalar>(i * tile), static_cast<scalar>(k * tile), -depth};
                sound = sound && world->add(fixed).ok();
            }
        std::vector<BodyId> ids;
        for (int body_i = 0; body_i < 50; ++body_i) {
            const auto r = static_cast<scalar>(draw.between(0.1, 0.25));
            const auto up_to = [&draw](double most) {
                return Vector{static_cast<scalar>(draw.between(-most, most)), static_cast<scalar>(draw.between(-most, most)),
                              static_cast<scalar>(draw.between(-most, most))};
            };
            ingot::BodyDef def;
            ingot::MassDistribution solid{};
            switch (body_i % 5) {
                case 0: solid = ingot::solid_box(1000, {r, r * scalar(0.7), r / 2}), def.shape = ingot::Box{{r, r * scalar(0.7), r / 2}}; break;
                case 1: solid = ingot::solid_sphere(1000, r), def.shape = ingot::Sphere{r}; break;
                case 2: solid = ingot::solid_cylinder(1000, r, r / 2), def.shape = ingot::Cylinder{r, r / 2}; break;
                case 3: solid = ingot::solid_capsule(1000, r / 2, r), def.shape = ingot::Capsule{r / 2, r}; break;
                default: solid = ingot::solid_hull(1000, nut.value.view()).value, def.shape = ingot::hull_of<S>(nut_form); break;
            }
            const Vector place = up_to(1), spin = up_to(20), velocity = up_to(3);
            def.mass = ingot::principal(solid).value;
            def.restitution = static_cast<scalar>(draw.between(0, 0.5));
            def.state = ingot::body_state(def.mass, {{2 * place.x, 2 * place.y, scalar(1.5) + place.z}, turned({0, 0, 1}, draw.between(0, 6))},
                                          {{velocity.x, velocity.y, velocity.z - 4}, spin});
            const ingot::Result<BodyId> id = world->add(def);
            sound = sound && id.ok();
            ids.push_back(id.value);
        }
        ASSERT_TRUE(sound);
        const double rim = n * tile;  // within it: half a tile from the end of the floor
        std::vector<bool> left(ids.size());
        int below = 0;  // bodies, summed over the steps
        for (int step_i = 0; step_i < 10 * rate; ++step_i) {
            ASSERT_EQ(ingot::step(*world, scalar(1) / static_cast<scalar>(rate)).contacts_lost, 0);
            for (std::size_t i = 0; i < ids.size(); ++i) {
                const Vector3d r = to_eigen(world->state(ids[i]).value.r_CM);
                left[i] = left[i] || std::abs(r.x()) > rim || std::abs(r.y()) > rim;
                below += !left[i] && r.z() < 0;
            }
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const Vector3d r = to_eigen(world->state(ids[i]).value.r_CM);
            EXPECT_TRUE(left[i] || r.z() > 0.04) << "seed " << seed << ", body " << i << " at " << r.transpose();  // the least half extent is 0.05
        }
        EXPECT_LE(below, 10) << "seed " << seed;
        EXPECT_LT(std::count(left.begin(), left.end(), true), 35);
    }
}

}  // namespace
