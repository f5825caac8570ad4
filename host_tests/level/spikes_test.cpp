// SPDX-License-Identifier: MIT
// Fields and meshes of spikes, as steep and thin as heights by chance make them: nobody in the air is pushed out through the far side of one, nor
// faster than overlaps are taken back.
#include <gtest/gtest.h>

#include <algorithm>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;

constexpr int cells = 12, grain = 256, rates[] = {30, 60, 120, 240, 1000};

/// Cells of a metre, every height by chance.
Field spikes(Random& random, double relief) {
    const int most = static_cast<int>(grain * relief);
    Field made = field(random, cells + 1, cells + 1, random() % 2 == 0, 0, [&](int, int) { return between(random, 0, most); });
    made.view.heights.spacing_x = made.view.heights.spacing_y = 1;
    made.view.step = scalar(1) / grain;
    level_tool::finish_heights(made, cells + 1, cells + 1);
    return made;
}

BodyDef thrown(Random& random, const LevelTable& level) {
    BodyDef def = goer(random, static_cast<Goer>(random() % goers_count), static_cast<scalar>(about(random, 0.05, 0.6)), 0);
    const auto by = [&random](double low, double high) { return static_cast<scalar>(within(random, low, high)); };
    def.friction = by(0, 0.8);
    def.restitution = random() % 3 == 0 ? by(0, 1) : 0;
    Vector r = level.middle() + Vector{by(-4, 4), by(-4, 4), 0};
    r.z = level.high.z + by(0.7, 2);
    def.state = ingot::body_state(def.mass, {r, any_rotation(random)}, {{by(-4, 4), by(-4, 4), 0}, {}});
    return def;
}

/// Of a body in the air, by a ray from above; m, how deep it may be told to be: its centre no deeper than its least half extent, and what is of it
/// beyond that.
double depth_allowed(const World<OnLevel>& world, const LevelTable& level, BodyId id) {
    const ingot::Shape shape = world.shape(id).value;
    const bool hull = shape.kind == ingot::ShapeKind::hull;
    const Vector r = world.state(id).value.r_CM;
    const scalar high = level.high.z + 1, depth = high - level.low.z + 1;
    ingot::LevelHit hit;
    const double reach = hull ? 1.5 : static_cast<double>(ingot::bounding_radius(shape));
    if (!cast_ray_on_level(level, {r.x, r.y, high}, {0, 0, -depth}, hit) || !(r.z > high - depth * hit.fraction + scalar(1e-3))) return 1e9;
    return static_cast<double>(ingot::least_half_extent(shape, hull ? Slab::hulls : nullptr)) + 2 * reach;
}

/// The back of a spike is not ground below who stands before it. Bodies of all shapes, some beside each other.
TEST(Spikes, push_nobody_in_the_air_out_of_their_far_side) {
    int met = 0;
    for (int draw = 0; draw < ingot_reference::draws(120); ++draw) {
        Random random(static_cast<uint64_t>(81030 + draw));
        const Field ground = spikes(random, about(random, 0.3, 2.7));
        auto& world = empty_world<OnLevel>();
        const BodyId level = add_level(world, ground.view, static_cast<scalar>(within(random, 0, 0.8)));
        std::vector<BodyId> ids;
        for (int i = between(random, 1, 4); i > 0; --i) ids.push_back(world.add(thrown(random, ground.view)).value);
        const int rate = rates[random() % 5];
        for (int step_i = 0; step_i < 2 * rate; ++step_i) {
            std::vector<double> allowed;
            for (const BodyId id : ids) allowed.push_back(depth_allowed(world, ground.view, id));
            ASSERT_EQ(ingot::step(world, 1 / static_cast<scalar>(rate)).bodies_frozen, 0);
            for (const ingot::ContactInfo& contact : world.contacts()) {
                for (size_t i = 0; i < ids.size(); ++i) {
                    if (!((contact.A == ids[i] && contact.B == level) || (contact.A == level && contact.B == ids[i]))) continue;
                    ++met;
                    ASSERT_GE(static_cast<double>(contact.separation), -allowed[i]) << "draw " << draw << ", step " << step_i << ", Hz " << rate;
                }
            }
        }
    }
    EXPECT_GT(met, 1000);
}

Ground spikes_of_mesh(Random& random, double relief) {
    const int most = static_cast<int>(grain * relief);
    Ground made;
    std::vector<int> heights;
    for (int i = 0; i < (cells + 1) * (cells + 1); ++i) heights.push_back(between(random, 0, most));
    const Soup soup = terrain(random, cells, grain, [&](int x, int y) { return heights[static_cast<size_t>(x + (cells + 1) * y)]; });
    take_mesh(soup, 1.0 / grain, made);
    return made;
}

/// m, by how much the centre of a body is behind the plane of a contact; negative: before it. to_body: unit, from the ground.
double behind(const Vector& centre, const ingot::ContactInfo& contact, const Vector& to_body) {
    double most = -1e9;
    for (int i = 0; i < contact.point_count; ++i) {
        const Vector on_ground = contact.points[i].P - to_body * (contact.points[i].separation / 2);
        most = std::max(most, static_cast<double>(dot(to_body, on_ground - centre)));
    }
    return most;
}

/// m: some tens of roundings of places up to 12 m away, in float.
constexpr double roundings = 1e-4;

/// Of one body that falls on a mesh or a field. A contact that has the centre behind it is no deeper than the least half extent, and no step moves it
/// further than its energy does, and each of its contacts at push_speed_max.
TEST(Spikes, move_nobody_faster_than_overlaps_are_taken_back) {
    int met = 0;
    for (int draw = 0; draw < ingot_reference::draws(240); ++draw) {
        Random random(static_cast<uint64_t>(3000 + draw));
        const double relief = about(random, 0.3, 2.7);
        Ground ground;
        if (draw % 2 == 0) {
            ground = spikes_of_mesh(random, relief);
        } else {
            ground.field = spikes(random, relief);
            ground.view = ground.field.view;
        }
        auto& world = empty_world<OnLevel>();
        const BodyId level = add_level(world, ground.view, static_cast<scalar>(within(random, 0, 0.8)));
        const BodyDef def = thrown(random, ground.view);
        const BodyId id = world.add(def).value;
        const bool hull = def.shape.kind == ingot::ShapeKind::hull;
        const double least = static_cast<double>(ingot::least_half_extent(def.shape, hull ? Slab::hulls : nullptr));
        const double M = static_cast<double>(def.mass.M), g = 9.81;
        const int rate = rates[random() % 5];
        const double h = 1.0 / rate;
        for (int step_i = 0; step_i < 2 * rate; ++step_i) {
            const bool in_the_air = depth_allowed(world, ground.view, id) < 1e8;
            const Vector r = world.state(id).value.r_CM;
            const double before = static_cast<double>(world.kinetic_energy());
            ASSERT_EQ(ingot::step(world, 1 / static_cast<scalar>(rate)).bodies_frozen, 0);
            int contacts = 0;
            for (const ingot::ContactInfo& contact : world.contacts()) {
                ++contacts;
                ++met;
                const Vector to_body = contact.A == level ? -contact.n : contact.n;
                if (!in_the_air || !(behind(r, contact, to_body) > roundings)) continue;
                const auto separation = static_cast<double>(contact.separation);
                EXPECT_GE(separation, -least - roundings) << "draw " << draw << ", step " << step_i << ", Hz " << rate;
            }
            const double energy = std::max(before, static_cast<double>(world.kinetic_energy()));
            const double fastest = std::sqrt(2 * energy / M) + g * h + static_cast<double>(ingot::limits::push_speed_max) * contacts;
            const double way = length(world.state(id).value.r_CM - r);
            ASSERT_LE(way, fastest * h + 1e-5) << "draw " << draw << ", step " << step_i << ", Hz " << rate;
        }
    }
    EXPECT_GT(met, 1000);
}

}  // namespace
