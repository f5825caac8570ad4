// SPDX-License-Identifier: MIT
// Small fast things and large triangles: what would meet the plane of one beside it flies on, what meets its inside does not pass.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;
using V = Eigen::Vector3d;

struct Shots : OnLevel {
    static constexpr bool continuous = true;
    static constexpr bool filters = true;
    static constexpr int max_bodies = 24;
    static inline LevelTable levels[1] = {};
};

V exact(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
Vector rounded(const V& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

/// One triangle from 2 to 60 m wide, and how far a point of its plane is within its rim, m; outside it is negative.
struct Sheet {
    Ground ground;
    V corners[3], n;

    explicit Sheet(Random& random) {
        for (;;) {
            Soup soup;
            const int wide = between(random, 500, 15000);
            for (V& corner : corners) {
                soup.points.push_back(lattice_point(between(random, 0, wide), between(random, 0, wide), between(random, 0, wide / 4)));
                corner = V(soup.points.back().x, soup.points.back().y, soup.points.back().z) / 256;
            }
            const V across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            if (across.norm() < 0.2 * wide / 256 * wide / 256) continue;
            n = across.normalized();
            soup.faces = {{0, 1, 2, 0}};
            take_mesh(soup, 1.0 / 256, ground);
            return;
        }
    }
    double within_rim(const V& p) const {
        double least = 1e30;
        for (int i = 0; i < 3; ++i) {
            const V along = (corners[(i + 1) % 3] - corners[i]).normalized();
            least = std::min(least, n.cross(along).dot(p - corners[i]));
        }
        return least;
    }
};

/// Balls of centimetres, some metres a step, from one side of the plane to the other: also those that begin over the inside and leave the plane
/// beside the rim, or come in below it.
TEST(FastBesideRims, meet_what_is_there_and_nothing_else) {
    int stopped = 0, passed = 0, below = 0;
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) {
        Random random(static_cast<uint64_t>(7100 + draw));
        const Sheet sheet(random);
        auto& world = empty_world<Shots>();
        ASSERT_EQ(world.set_gravity({}), Status::ok);
        Shots::levels[0] = sheet.ground.view;
        ASSERT_TRUE(world.add_level({}).ok());
        const double rates[] = {30, 60, 240, 1000}, rate = rates[draw % 4], h = static_cast<double>(static_cast<scalar>(1 / rate));
        struct Shot {
            BodyId id;
            V from, v;
            bool meets;
        };
        std::vector<Shot> shots;
        for (int i = 0; i < 16; ++i) {
            // Through a point of the plane, inside or beside; each end of the way of its step is above or below somewhere else.
            const auto inside = [&] {
                const double a = share(random), b = share(random) * (1 - a);
                return V(sheet.corners[0] + (sheet.corners[1] - sheet.corners[0]) * a + (sheet.corners[2] - sheet.corners[0]) * b);
            };
            const double wide = (sheet.corners[1] - sheet.corners[0]).norm(), R = within(random, 0.01, 0.05);
            V to_side = inside() - inside();
            if (to_side.norm() < 0.1) continue;
            to_side.normalize();
            V at = inside();
            if (i % 2 == 0) at += to_side * within(random, 0, wide);
            const V aside = to_side * within(random, -1, 1) * wide * 0.7;
            const double up = within(random, 0.3, 3), down = within(random, 0.3, 3);
            V from = at + sheet.n * up - aside * (up / (up + down)), to = at - sheet.n * down + aside * (down / (up + down));
            if (i % 4 == 0) {  // in below it
                to = inside() - sheet.n * down;
                from = at + (at - to) * (up / down);
            }
            const double rim = sheet.within_rim(at), slope = (to - from).norm() / (up + down);
            // Round it is as wide as its radius, along a slope as much further: nearer to the rim either answer may be right.
            if (std::abs(rim) < 3 * R * (1 + slope) || (to - from).norm() * rate > 2000) continue;
            BodyDef def;
            def.shape = ingot::Sphere{static_cast<scalar>(R)};
            def.mass = ingot::principal(ingot::solid_sphere(1000, static_cast<scalar>(R))).value;
            def.filter = {2, 1};  // they meet the level alone
            def.state.r_CM = rounded(from);
            def.state.v_CM = rounded((to - from) * rate);
            const auto id = world.add(def);
            ASSERT_TRUE(id.ok());
            shots.push_back({id.value, exact(def.state.r_CM), exact(def.state.v_CM), rim > 0});
            below += rim < 0 && sheet.within_rim(to) > 0 ? 1 : 0;
        }
        (void)ingot::step(world, static_cast<scalar>(h));
        for (const Shot& shot : shots) {
            const V r = exact(world.state(shot.id).value.r_CM), free = shot.from + shot.v * h;
            if (shot.meets) {
                EXPECT_GE(sheet.n.dot(r - sheet.corners[0]), 0) << draw << ": it has got through";
                ++stopped;
            } else {
                const double rounding = 64 * static_cast<double>(ingot::epsilon) * (free.norm() + shot.from.norm());
                EXPECT_LE((r - free).norm(), rounding) << draw << ": nothing is there";
                ++passed;
            }
        }
    }
    EXPECT_GT(stopped, ingot_reference::draws(400));
    EXPECT_GT(passed, ingot_reference::draws(400));
    EXPECT_GT(below, ingot_reference::draws(100));
}

}  // namespace
