// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "party.h"
#include "scenes/compounds.h"
#include "scenes/contact/materials.h"
#include "scenes/contact/piles.h"
#include "scenes/contact/stacks.h"

namespace company {

namespace {

using scenes::fixed_box;
using scenes::PlacedBody;
using scenes::scattered;
using scenes::solid_ball;
using scenes::solid_box;

const scalar mu = scalar(0.6);

/// The bodies of a contact scene that are not its ground.
template <class S>
std::vector<Member> members_of() {
    std::vector<Member> members;
    for (int body_i = 0; body_i < S::body_count; ++body_i) {
        const PlacedBody body = S::body(body_i);
        if (body.def.shape.kind != ingot::ShapeKind::half_space) members.push_back({body});
    }
    return members;
}

/// Four immovable walls around a square of this side, and a roof if asked for: half spaces would stand in everybody's way.
std::vector<Member> pit(scalar side, scalar height, bool roof = false) {
    const scalar thick = scalar(0.5), out = side / 2 + thick;
    std::vector<Member> walls = {{fixed_box({thick, out + thick, height / 2}, {out, 0, height / 2}, mu)},
                                 {fixed_box({thick, out + thick, height / 2}, {-out, 0, height / 2}, mu)},
                                 {fixed_box({out + thick, thick, height / 2}, {0, out, height / 2}, mu)},
                                 {fixed_box({out + thick, thick, height / 2}, {0, -out, height / 2}, mu)}};
    if (roof) walls.push_back({fixed_box({out + thick, out + thick, thick}, {0, 0, height + thick}, mu)});
    return walls;
}

template <class... More>
std::vector<Member> together(std::vector<Member> members, const More&... more) {
    (members.insert(members.end(), more.begin(), more.end()), ...);
    return members;
}

std::vector<Member> balls_on_a_grid(int n, scalar radius, scalar lowest) {
    std::vector<Member> balls;
    const scalar pitch = radius * scalar(2.25);
    for (int i = 0; i < n * n * n; ++i) {
        const auto place = [&](int cell, int channel) {
            return pitch * (static_cast<scalar>(cell) + scalar(0.5)) + radius * scalar(0.1) * scattered(i, channel);
        };
        const scalar half_side = pitch * scalar(n) / 2;
        const Vector r = {place(i % n, 0) - half_side, place(i / n % n, 1) - half_side, place(i / (n * n), 2) + lowest};
        balls.push_back({solid_ball(1, radius, r, scalar(0.5))});
    }
    return balls;
}

PlacedBody moving(PlacedBody body, const Vector& v, const Vector& omega = {}) {
    body.move(v, omega);
    return body;
}
PlacedBody turned(PlacedBody body, const ingot::Matrix& A) {
    body.turn(A);
    return body;
}

Party rolling_balls() {
    Party party = {"rolling_balls", pit(scalar(16), 2)};
    const scalar radii[] = {scalar(0.2), scalar(0.35), scalar(0.5)}, speeds[] = {1, 3, 6};
    for (int i = 0; i < 3; ++i) {
        Member ball = {moving(solid_ball(scalar(1 + i), radii[i], {-6, scalar(2 * i - 2), radii[i]}, mu, scalar(0.25)), {speeds[i], scalar(0.1), 0},
                              {0, speeds[i] / radii[i], 0})};
        ball.rolling_lever = scalar(0.002) * scalar(i);
        party.members.push_back(ball);
    }
    return party;
}

Party bouncing_things() {
    Party party = {"bouncing_things", {}};
    const scalar e[] = {scalar(0.3), scalar(0.6), scalar(0.9), 1};
    for (int i = 0; i < 4; ++i) party.members.push_back({solid_ball(1, scalar(0.3), {scalar(i) * 2 - 3, 0, 1 + scalar(i) / 2}, scalar(0.3), e[i])});
    PlacedBody box = turned(solid_box(2, {scalar(0.4), scalar(0.3), scalar(0.2)}, {0, 3, 2}, mu, scalar(0.5)), scenes::scattered_rotation(3));
    party.members.push_back({moving(box, {0, 0, -1}, {1, 2, 0})});
    return party;
}

Party slope() {
    const scenes::Slope slope = scenes::thirty_degrees;
    Party party = {"slope", pit(scalar(14), 2)};
    PlacedBody plane = turned(fixed_box({5, 3, scalar(0.2)}, {0, 0, scalar(2.75)}, scalar(0.7)), slope.A());
    party.members.push_back({plane});
    for (int i = 0; i < 3; ++i) {
        const scalar friction = i == 0 ? scalar(0.9) : i == 1 ? scalar(0.2) : scalar(0.5);
        const Vector middle = {0, scalar(i) * scalar(1.75) - scalar(1.75), scalar(2.75)};
        const Vector r = middle + slope.up() * scalar(i == 2 ? 0.5 : 0.3) + slope.down() * -2;
        PlacedBody brick = turned(solid_box(1, {scalar(0.4), scalar(0.3), scalar(0.1)}, r, friction), slope.A());
        if (i == 2) brick = solid_ball(1, scalar(0.3), r, friction);
        party.members.push_back({i == 1 ? moving(brick, slope.down() * -3) : brick});
    }
    return party;
}

Party dominoes() {
    Party party = {"dominoes", {}};
    for (int i = 0; i < 8; ++i)
        party.members.push_back(
            {solid_box(1, {scalar(0.06), scalar(0.24), scalar(0.48)}, {scalar(0.45) * scalar(i) - 2, 0, scalar(0.48)}, scalar(0.4))});
    party.members.push_back({moving(solid_ball(2, scalar(0.25), {-4, 0, scalar(0.25)}, mu), {4, 0, 0}, {0, 16, 0})});
    return party;
}

Party cylinders_and_capsules() {
    Party party = {"cylinders_and_capsules", {}};
    const auto round = [](bool capsule, const Vector& r) {
        PlacedBody body;
        body.def.mass = scenes::mass_of(ingot::with_mass(ingot::solid_cylinder(1, scalar(0.3), scalar(0.4)), 1));
        body.def.shape = capsule ? ingot::Shape(ingot::Capsule{scalar(0.3), scalar(0.3)}) : ingot::Shape(ingot::Cylinder{scalar(0.3), scalar(0.4)});
        body.def.state.r_CM = r;
        body.mu = mu;
        return body;
    };
    for (int i = 0; i < 3; ++i) party.members.push_back({round(false, {0, 0, scalar(0.4) + scalar(0.8) * scalar(i)})});
    party.members.push_back({moving(turned(round(false, {3, 0, scalar(0.3)}), scenes::along_y), {1, 0, 0}, {0, scalar(3.25), 0})});
    party.members.push_back({moving(turned(round(true, {-3, 0, scalar(0.3)}), scenes::along_y), {1, 0, 0}, {0, 3, 0})});
    party.members.push_back({turned(round(true, {-3, 2, 1}), scenes::scattered_rotation(5))});
    PlacedBody needle;
    needle.def.mass = scenes::mass_of(ingot::with_mass(ingot::solid_capsule(1, scalar(0.05), scalar(0.5)), 1));
    needle.def.shape = ingot::Capsule{scalar(0.05), scalar(0.5)};
    needle.def.state.r_CM = {0, 4, 1};
    needle.mu = scalar(0.3);
    needle.def.restitution = scalar(0.2);
    party.members.push_back({moving(turned(needle, scenes::along_y), {0, 0, -1}, {20, 0, 0})});
    return party;
}

/// Bodies that touch nothing, some of them too fast for the turn of a step.
Party flyers() {
    Party party = {"flyers", {}};
    for (int i = 0; i < 6; ++i) {
        PlacedBody body = solid_box(1, {scalar(0.5), scalar(0.2) + scalar(0.05) * scalar(i), scalar(0.1)}, {scalar(i) * 2 - 5, 0, 1000}, 0);
        body.turn(scenes::scattered_rotation(i));
        party.members.push_back({moving(body, {0, scalar(0.1) * scalar(i), 1}, {scalar(i * i * i), scalar(0.5), scalar(i)})});
    }
    return party;
}

Party belts() {
    Party party = {"belts", pit(scalar(14), 2)};
    Member table = {fixed_box({2, 1, scalar(0.25)}, {0, 0, scalar(0.25)}, 1)};
    table.surface_velocity = {1, scalar(0.25), 0};
    party.members.push_back(table);
    for (int i = 0; i < 3; ++i) {
        Member parcel = {solid_box(1, {scalar(0.25), scalar(0.2), scalar(0.15)}, {scalar(i) - scalar(1.25), 0, scalar(0.65)}, mu)};
        party.members.push_back(parcel);
    }
    Member crawler = {solid_box(3, {scalar(0.4), scalar(0.3), scalar(0.1)}, {0, -3, scalar(0.1)}, 1)};
    crawler.surface_velocity = {-1, scalar(0.25), 0};
    party.members.push_back(crawler);
    Member ball = {moving(solid_ball(1, scalar(0.25), {-3, 3, scalar(0.25)}, mu), {2, 0, 0}, {0, 8, 0})};
    ball.rolling_lever = scalar(0.01);
    party.members.push_back(ball);
    return party;
}

/// A heavy plate on light balls: what sweeps do not settle.
Party plate_on_balls() {
    Party party = {"plate_on_balls", {}};
    for (int i = 0; i < 9; ++i)
        party.members.push_back({solid_ball(scalar(0.1), scalar(0.25), {scalar(i % 3) - 1, scalar(i / 3) - 1, scalar(0.25)}, mu)});
    party.members.push_back({solid_box(1000, {scalar(1.5), scalar(1.5), scalar(0.1)}, {0, 0, scalar(0.6)}, mu)});
    return party;
}

Party overlapping() {
    Party party = {"overlapping", {}};
    for (int i = 0; i < 4; ++i)
        party.members.push_back({solid_box(scalar(1 + i), {scalar(0.5), scalar(0.5), scalar(0.5)},
                                           {scalar(0.9) * scalar(i) - 1, scalar(0.1) * scalar(i), scalar(0.45)}, mu)});
    return party;
}

/// A closed room with a stack, and bullets that stay in it.
Party bullets() {
    Party party = {"bullets", pit(scalar(10), 5, true)};
    party.is_fast = true;
    const scalar half = scalar(0.2);
    for (int i = 0; i < 5; ++i) party.members.push_back({solid_box(4, {half, half, half}, {1, 0, half + 2 * half * scalar(i)}, mu)});
    for (int i = 0; i < 3; ++i) {
        const Vector r = {-4, scalar(0.05) * scalar(i), scalar(0.5) + scalar(0.4) * scalar(i)};
        party.members.push_back({moving(solid_ball(scalar(0.1), scalar(0.05), r, mu, scalar(0.4)), {100 + 100 * scalar(i), 0, 0})});
    }
    return party;
}

template <unsigned N>
Member compound(const scenes::Parts<N>& parts, const Vector& r, int turn_i) {
    Member member;
    member.body.def.mass = parts.mass(1);
    member.body.def.state = ingot::body_state(member.body.def.mass, {r, scenes::scattered_rotation(turn_i)});
    member.parts.assign(parts.parts, parts.parts + N);
    return member;
}

/// The same with hammers, jacks and dumbbells, which turn.
Party flying_tools() {
    Party party = {"flying_tools", pit(scalar(10), 5, true)};
    party.is_fast = true;
    const scalar half = scalar(0.2);
    for (int i = 0; i < 3; ++i) party.members.push_back({solid_box(4, {half, half, half}, {1, 0, half + 2 * half * scalar(i)}, mu)});
    for (int i = 0; i < 3; ++i) {
        const Vector r = {-3, scalar(1.5) * scalar(i - 1), 1};
        Member tool = i == 0   ? compound(scenes::hammer(mu), r, i)
                      : i == 1 ? compound(scenes::jack(mu), r, i)
                               : compound(scenes::dumbbell(scalar(0.25), scalar(0.75), mu), r, i);
        tool.body = moving(tool.body, {60 + 60 * scalar(i), 0, 0}, {3, 10, 5});
        party.members.push_back(tool);
    }
    return party;
}

/// A ball through a sensor, one that the boxes do not meet, and a stack.
Party watched() {
    Party party = {"watched", pit(scalar(12), 2)};
    party.members.push_back({solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, {2, 0, scalar(0.5)}, mu)});
    party.members.push_back({solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, {2, 0, scalar(1.5)}, mu)});
    party.members.push_back({moving(solid_ball(1, scalar(0.3), {-4, scalar(0.2), scalar(0.3)}, mu, scalar(0.5)), {5, 0, 0}, {0, 15, 0})});
    Member ghost = {moving(solid_ball(1, scalar(0.3), {-4, scalar(-0.5), scalar(0.3)}, mu, scalar(0.5)), {4, 0, 0}, {0, 12, 0})};
    ghost.body.def.filter = {2, 1};
    party.members.push_back(ghost);
    PlacedBody sensor = fixed_box({1, 2, 1}, {-1, 0, 1}, mu);
    sensor.def.sensor = true;
    party.members.push_back({sensor});
    return party;
}

Party furniture() {
    Party party = {"furniture", pit(4, 3)};
    for (int i = 0; i < 8; ++i) {
        const Vector r = {scalar(i % 2) - scalar(0.5), scalar(i / 2 % 2) - scalar(0.5), 1 + scalar(i / 4) * scalar(1.5)};
        party.members.push_back(i % 4 == 0   ? compound(scenes::hammer(mu), r, i)
                                : i % 4 == 1 ? compound(scenes::jack(mu), r, i)
                                : i % 4 == 2 ? compound(scenes::table(mu), r, i)
                                             : compound(scenes::dumbbell(scalar(0.25), scalar(0.75), mu), r, i));
    }
    return party;
}
Party rocks() {
    Party party = {"rocks", pit(4, 3)};
    for (int i = 0; i < 8; ++i) {
        PlacedBody rock = scenes::hull_body<scenes::Hulled<1, 1>>(static_cast<scenes::HullForm>(i % 4), {}, mu);
        rock.def.state.r_CM = {scalar(i % 2) - scalar(0.5), scalar(i / 2 % 2) - scalar(0.5), 1 + scalar(i / 4) * scalar(1.25)};
        party.members.push_back({turned(rock, scenes::scattered_rotation(i))});
    }
    return party;
}

Party heap_of_boxes() {
    Party party = {"heap_of_boxes", pit(scalar(2.5), 6)};
    for (int i = 0; i < 18; ++i) {
        const auto half = [&](int channel) { return scalar(0.25) + scalar(0.1) * scattered(i, channel); };
        PlacedBody box = solid_box(scalar(1 + i % 3), {half(0), half(1), half(2)},
                                   {scalar(i % 2) - scalar(0.5), scalar(i / 2 % 2) - scalar(0.5), scalar(0.75) + scalar(i / 4)}, scalar(0.5));
        party.members.push_back({turned(box, scenes::scattered_rotation(i))});
    }
    return party;
}

/// Cubes of 2 cm: beside what is large they are the first to fall.
Party sugar_cubes() {
    Party party = {"sugar_cubes", {}};
    const scalar half = scalar(0.01);
    for (int i = 0; i < 5; ++i)
        party.members.push_back({solid_box(scalar(0.01), {half, half, half}, {0, 0, half + 2 * half * scalar(i)}, mu)});
    party.members.push_back({solid_ball(scalar(0.01), half, {scalar(0.05), 0, scalar(0.03)}, mu)});
    return party;
}

Party springy_heap() {
    Party party = heap_of_boxes();
    party.name = "springy_heap";
    for (Member& member : party.members) member.body.def.restitution = scalar(0.2);
    return party;
}

std::vector<Member> stack(int height) {
    std::vector<Member> cubes;
    for (int i = 0; i < height; ++i) cubes.push_back({scenes::unit_cube({0, 0, scalar(i) + scalar(0.5)}, mu)});
    return cubes;
}

}  // namespace

std::vector<Party> all_parties() {
    return {{"tower_10", stack(10)},
            {"tower_20", stack(20)},
            {"heavy_on_light", members_of<scenes::MassRatio<1, 1000>>()},
            {"heavy_on_three", members_of<scenes::MassRatio<3, 100>>()},
            {"pyramid", members_of<scenes::Pyramid<6>>()},
            {"heap_of_balls", together(pit(scalar(2.5), 4), balls_on_a_grid(4, scalar(0.25), scalar(0.25)))},
            heap_of_boxes(),
            springy_heap(),
            {"uneven_boxes", together(pit(scalar(3), 4), members_of<scenes::UnevenBoxes<9, 100>>())},
            {"planks", members_of<scenes::FallingPlanks>()},
            rolling_balls(),
            bouncing_things(),
            slope(),
            dominoes(),
            cylinders_and_capsules(),
            flyers(),
            belts(),
            plate_on_balls(),
            overlapping(),
            sugar_cubes(),
            bullets(),
            flying_tools(),
            watched(),
            furniture(),
            rocks()};
}

Party crowd_of_balls(int n) {
    return {"crowd_of_balls", together(pit(scalar(n) * scalar(1.125), 2 * scalar(n)), balls_on_a_grid(n, scalar(0.5), scalar(0.5)))};
}

Party wall_of_cubes(int base) {
    Party party = {"wall_of_cubes", {}};
    for (int row = 0; row < base; ++row)
        for (int place = 0; place < base - row; ++place)
            party.members.push_back(
                {scenes::unit_cube({(scalar(place) - scalar(base - row - 1) / 2) * scalar(1.1), 0, scalar(row) + scalar(0.5)}, mu)});
    return party;
}

std::vector<Party> restless_parties() {
    // Bodies come while others lie there.
    Party comers = {"comers", pit(4, 4)};
    for (int i = 0; i < 8; ++i) {
        Member one = {i % 2 == 0 ? solid_ball(1, scalar(0.4), {scalar(0.3) * scalar(i) - 1, 0, 3}, mu, scalar(0.3))
                                 : turned(solid_box(2, {scalar(0.4), scalar(0.3), scalar(0.5)}, {scalar(0.2) * scalar(i) - 1, scalar(0.3), 3}, mu),
                                          scenes::scattered_rotation(i))};
        one.born = 8 * i;
        comers.members.push_back(one);
    }
    // A stack loses its lowest cube, then what it stands on, then everything.
    Party goers = {"goers", together({{fixed_box({2, 2, scalar(0.5)}, {0, 0, scalar(0.5)}, mu)}}, stack(5))};
    for (std::size_t i = 1; i < goers.members.size(); ++i) goers.members[i].body.def.state.r_CM.z += 1;
    goers.edits = {{10, Edit::remove, 1}, {30, Edit::remove, 0}, {50, Edit::remove, 3},
                   {60, Edit::remove, 2}, {70, Edit::remove, 4}, {71, Edit::remove, 5}};
    // Pushed, put elsewhere, given other filters.
    Party pushed = {"pushed", together(pit(8, 8), stack(4), balls_on_a_grid(2, scalar(0.4), 6))};
    pushed.edits = {{5, Edit::impulse, 4, {2, 1, 0}},    {12, Edit::angular_impulse, 6, {0, 0, 3}}, {20, Edit::force, 7, {0, 30, 5}, 30},
                    {25, Edit::put, 5, {2, 2, 1}},       {33, Edit::wake, 4},                       {40, Edit::put, 8, {0, 0, scalar(0.6)}},
                    {44, Edit::filter, 9, {2, 1, 0}},    {55, Edit::impulse, 10, {0, -3, 4}},       {56, Edit::put, 0, {5, 0, 2}},
                    {70, Edit::sleep, 6},                {80, Edit::impulse, 6, {-4, 0, 0}}};
    // Driven out of range: it freezes.
    Party runaway = {"runaway", stack(3)};
    runaway.members.push_back({solid_ball(scalar(1e-3), scalar(0.5), {4, 0, scalar(0.5)}, mu)});
    runaway.edits = {{20, Edit::force, 3, {0, 0, scalar(1e14)}, 10}, {50, Edit::remove, 3}};
    return {comers, goers, pushed, runaway};
}

std::vector<Party> sleepy_parties() {
    // Asleep from the start, and for ever.
    Party asleep = {"asleep", stack(4)};
    for (int i = 0; i < 4; ++i) asleep.edits.push_back({0, Edit::sleep, i});
    // Woken again and again.
    Party woken = asleep;
    woken.name = "woken";
    for (const int step : {30, 55, 60}) woken.edits.push_back({step, Edit::wake, 2});
    woken.edits.push_back({75, Edit::impulse, 3, {1, 0, 0}});
    // Met by what comes.
    Party met = asleep;
    met.name = "met";
    met.members.push_back({moving(solid_ball(2, scalar(0.4), {-5, scalar(0.1), scalar(0.4)}, mu), {5, 0, 0}, {0, scalar(12.5), 0})});
    // Somebody takes away what they lean on.
    Party robbed = {"robbed", together({{fixed_box({2, 2, scalar(0.5)}, {0, 0, scalar(0.5)}, mu)}}, stack(3))};
    for (std::size_t i = 1; i < robbed.members.size(); ++i) robbed.members[i].body.def.state.r_CM.z += 1;
    for (int i = 1; i < 4; ++i) robbed.edits.push_back({0, Edit::sleep, i});
    robbed.edits.push_back({40, Edit::remove, 0});
    return {asleep, woken, met, robbed};
}

Party party(const char* name) {
    for (const std::vector<Party>& parties : {all_parties(), restless_parties(), sleepy_parties()})
        for (const Party& one : parties)
            if (one.name == name) return one;
    std::abort();
}

}  // namespace company
