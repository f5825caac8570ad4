// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "crowd.h"

using namespace events_stage;
using ingot::Event;
using ingot::EventKind;

namespace {

constexpr double eps = static_cast<double>(ingot::epsilon);

template <class S>
int count_of(const World<S>& world, EventKind kind) {
    return static_cast<int>(std::count_if(world.events().begin(), world.events().end(), [&](const Event& event) { return event.kind == kind; }));
}
/// The one event of the kind in the last step.
template <class S>
Event the(const World<S>& world, EventKind kind) {
    EXPECT_EQ(count_of(world, kind), 1);
    for (const Event& event : world.events())
        if (event.kind == kind) return event;
    return {};
}

TEST(Events, a_falling_ball_hits_at_the_square_root_of_2_g_H) {
    for (const double H : {0.3, 1.0, 4.0, 9.7}) {
        World<Telling> world;
        (void)world.set_gravity({0, 0, -g});
        const BodyId floor = world.add(ground()).value;
        const BodyId falling = world.add(ball(scalar(0.25), {1, 2, static_cast<scalar>(0.25 + H)})).value;
        int steps = 0;
        while (steps < 200 && world.events().count == 0) {
            EXPECT_TRUE(ingot::step(world, h).clean());
            ++steps;
        }
        const Event begin = the(world, EventKind::begin), hit = the(world, EventKind::hit);
        EXPECT_EQ(world.events().count, 2);
        for (const Event& event : {begin, hit}) {
            EXPECT_EQ(event.A, floor);
            EXPECT_EQ(event.B, falling);
            EXPECT_EQ(event.n.z, -1) << "from B to A";
            EXPECT_EQ(event.P.x, 1);
            EXPECT_EQ(event.P.y, 2);
            // v^2 = 2 g H whatever the step: height and v^2 / 2 g each carry a rounding of H a step.
            const double v = std::sqrt(2 * static_cast<double>(g) * H);
            EXPECT_NEAR(event.speed, v, v * (steps + 8) * eps);
        }
        // It stays where it fell, and no more is told.
        for (int step_i = 0; step_i < 100; ++step_i) {
            (void)ingot::step(world, h);
            ASSERT_EQ(world.events().count, 0) << step_i;
        }
        ingot::BodyState state = state_of(world, falling);
        state.r_CM.z += 1;
        EXPECT_EQ(world.set_state(falling, state), Status::ok);
        (void)ingot::step(world, h);
        EXPECT_EQ(the(world, EventKind::end).B, falling);
        EXPECT_EQ(world.events().count, 1);
    }
}

TEST(Events, a_bounce_begins_hits_and_ends) {
    World<Telling> world;
    (void)world.set_gravity({0, 0, -g});
    BodyDef floor = ground();
    floor.restitution = 1;
    (void)world.add(floor);
    (void)world.add(ball(scalar(0.25), {0, 0, scalar(2.25)}));
    int begins = 0, ends = 0, hits = 0;
    const double v = std::sqrt(2 * static_cast<double>(g) * 2);
    for (int step_i = 0; step_i < 640; ++step_i) {
        (void)ingot::step(world, h);
        begins += count_of(world, EventKind::begin);
        hits += count_of(world, EventKind::hit);
        ends += count_of(world, EventKind::end);
        EXPECT_GE(begins - ends, 0);
        EXPECT_LE(begins - ends, 1);
        EXPECT_EQ(begins, hits);
        // The energy of e = 1 is kept to a part in 10^6, so speeds are to half of it.
        for (const Event& event : world.events())
            if (event.kind == EventKind::hit) {
                EXPECT_NEAR(event.speed, v, v * 1e-5);
            }
    }
    // 10 s, a fall of 0.638 s and then 1.277 s from bounce to bounce.
    EXPECT_EQ(hits, 1 + static_cast<int>((10 - v / static_cast<double>(g)) / (2 * v / static_cast<double>(g))));
}

TEST(Events, bodies_at_rest_have_nothing_to_tell) {
    World<Telling> world;
    (void)world.set_gravity({0, 0, -g});
    (void)world.add(ground());
    for (int i = 0; i < 4; ++i)
        (void)world.add(body(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}},
                             {scalar(0.1) * static_cast<scalar>(i), 0, scalar(0.5) + static_cast<scalar>(i)}));
    (void)world.add(ball(scalar(0.5), {5, 0, scalar(0.5)}));
    (void)ingot::step(world, h);
    EXPECT_EQ(count_of(world, EventKind::begin), 5);
    EXPECT_EQ(world.events().count, 5);
    for (int step_i = 0; step_i < 600; ++step_i) {
        (void)ingot::step(world, h);
        ASSERT_EQ(world.events().count, 0) << step_i;
    }
}

TEST(Events, the_speed_of_a_hit_is_that_of_the_points_that_meet) {
    ingot_reference::RandomInput random(11);
    int hits = 0;
    for (int case_i = 0; case_i < 300; ++case_i) {
        World<Telling> world;
        BodyDef defs[2] = {body(ingot::Box{{1, scalar(0.5), scalar(0.75)}}, {}), ball(scalar(0.5), {})};
        BodyId ids[2];
        const Eigen::Vector3d towards = random.direction();
        for (int i = 0; i < 2; ++i) {
            const double speed = random.real(0, 10);
            const Eigen::Vector3d v = towards * (i == 0 ? speed : -speed) + random.vector(1);
            defs[i].state.r_CM = ingot_reference::to_vector(Eigen::Vector3d(towards * (i == 0 ? -1.1 : 1.1)));
            defs[i].state.v_CM = ingot_reference::to_vector(v);
            defs[i].state.A = ingot_reference::to_matrix(random.rotation());
            defs[i].state.L = ingot_reference::to_vector(random.vector(4));
            ids[i] = world.add(defs[i]).value;
        }
        for (int step_i = 0; step_i < 20; ++step_i) {
            Eigen::Vector3d r[2], v[2], omega[2];
            for (int i = 0; i < 2; ++i) {
                const ingot::BodyState state = state_of(world, ids[i]);
                r[i] = ingot_reference::to_eigen(state.r_CM);
                v[i] = ingot_reference::to_eigen(state.v_CM);
                omega[i] = ingot_reference::to_eigen(state.L);  // moments are 1
            }
            (void)ingot::step(world, h);
            if (count_of(world, EventKind::hit) == 0) continue;
            const Event hit = the(world, EventKind::hit);
            const Eigen::Vector3d P = ingot_reference::to_eigen(hit.P), n = ingot_reference::to_eigen(hit.n);
            const double wanted = -n.dot(v[0] + omega[0].cross(P - r[0]) - v[1] - omega[1].cross(P - r[1]));
            // Three products of speeds up to 30 m/s and levers up to 1.5 m.
            EXPECT_NEAR(hit.speed, wanted, 200 * eps);
            EXPECT_EQ(hit.A, ids[0]);
            ++hits;
            break;
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(Events, slower_meetings_than_the_scene_says_are_no_hits) {
    for (const scalar speed : {scalar(0.4375), scalar(0.5), scalar(0.5625)}) {
        World<Telling> world;
        (void)world.add(ball(1, {0, 0, 0}, {speed / 2, 0, 0}));
        (void)world.add(ball(1, {scalar(2.0078125), 0, 0}, {-speed / 2, 0, 0}));
        int begins = 0, hits = 0;
        for (int step_i = 0; step_i < 20; ++step_i) {
            (void)ingot::step(world, h);
            begins += count_of(world, EventKind::begin);
            hits += count_of(world, EventKind::hit);
            for (const Event& event : world.events())
                if (event.kind == EventKind::hit) {
                    EXPECT_EQ(event.speed, speed);
                }
        }
        EXPECT_EQ(begins, 1);
        EXPECT_EQ(hits, speed > scalar(0.5) ? 1 : 0);
    }
}

TEST(Events, who_is_removed_ends_its_contacts_under_the_id_it_had) {
    World<Telling> world;
    (void)world.set_gravity({0, 0, -g});
    const BodyId floor = world.add(ground()).value;
    const BodyDef def = body(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}, {0, 0, scalar(0.5)});
    const BodyId old = world.add(def).value;
    for (int step_i = 0; step_i < 5; ++step_i) (void)ingot::step(world, h);

    // Another body takes its slot and its place before the next step.
    EXPECT_EQ(world.remove(old), Status::ok);
    const BodyId young = world.add(def).value;
    ASSERT_EQ(young.slot, old.slot);
    (void)ingot::step(world, h);
    EXPECT_EQ(world.events().count, 2);
    EXPECT_EQ(the(world, EventKind::end).A, floor);
    EXPECT_EQ(the(world, EventKind::end).B, old);
    EXPECT_FALSE(world.is_alive(the(world, EventKind::end).B));
    EXPECT_EQ(the(world, EventKind::begin).A, floor);
    EXPECT_EQ(the(world, EventKind::begin).B, young);

    // Events of the last step stay as they are told until the next one.
    EXPECT_EQ(world.remove(floor), Status::ok);
    EXPECT_EQ(world.events().count, 2);
    (void)ingot::step(world, h);
    EXPECT_EQ(world.events().count, 1);
    EXPECT_EQ(the(world, EventKind::end).A, floor);
    EXPECT_EQ(the(world, EventKind::end).B, young);
    (void)ingot::step(world, h);
    EXPECT_EQ(world.events().count, 0);
}

struct Short : Telling {
    static constexpr int max_events = 8;
};

TEST(Events, a_full_array_keeps_what_comes_first_and_says_what_it_lost) {
    World<Short> world;
    (void)world.set_gravity({0, 0, -g});
    (void)world.add(ground());
    BodyId balls[5];
    for (int i = 0; i < 5; ++i) balls[i] = world.add(ball(scalar(0.25), {static_cast<scalar>(i), 0, scalar(1.25)})).value;
    StepReport report{};
    for (int step_i = 0; step_i < 60 && world.events().count == 0; ++step_i) report = ingot::step(world, h);
    ASSERT_EQ(world.events().count, 8) << "5 begins and 3 of 5 hits";
    EXPECT_EQ(report.events_lost, 2);
    EXPECT_FALSE(report.clean());
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(world.events()[i].kind, EventKind::begin);
        EXPECT_EQ(world.events()[i].B, balls[i]);
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(world.events()[5 + i].kind, EventKind::hit);
        EXPECT_EQ(world.events()[5 + i].B, balls[i]);
    }
    for (const BodyId& id : balls) (void)world.remove(id);
    EXPECT_TRUE(ingot::step(world, h).clean());
    EXPECT_EQ(count_of(world, EventKind::end), 5);
}

struct Guarded : Telling {
    static constexpr int max_overlaps = 8;
};

TEST(Events, of_sensors_tell_who_enters_and_who_leaves) {
    World<Guarded> world;
    const BodyId zone = world.add(sensor(fixed(ingot::Box{{1, 1, 1}}))).value;
    const BodyId visitor = world.add(ball(scalar(0.5), {-3, 0, 0}, {8, 0, 0})).value;
    int entered = -1, left = -1;
    for (int step_i = 0; step_i < 64; ++step_i) {
        (void)ingot::step(world, h);
        for (const Event& event : world.events()) {
            EXPECT_EQ(event.A, zone);
            EXPECT_EQ(event.B, visitor);
            if (event.kind == EventKind::enter) entered = step_i;
            if (event.kind == EventKind::leave) left = step_i;
        }
    }
    // At the begin of step k it is at -3 + k / 8: it touches from -1.5 to 1.5, both exact.
    EXPECT_EQ(entered, 12);
    EXPECT_EQ(left, 37);

    ingot::BodyState state = state_of(world, visitor);
    state.r_CM = state.v_CM = {};
    (void)world.set_state(visitor, state);
    (void)ingot::step(world, h);
    EXPECT_EQ(the(world, EventKind::enter).B, visitor);
    (void)world.remove(zone);
    (void)ingot::step(world, h);
    EXPECT_EQ(the(world, EventKind::leave).A, zone);
    EXPECT_EQ(world.overlap_count(), 0);
}

double distance_of(const World<Crowd>& world, BodyId a, BodyId b) {
    return (ingot_reference::to_eigen(world.state(a).value.r_CM) - ingot_reference::to_eigen(world.state(b).value.r_CM)).norm();
}

TEST(Events, of_a_crowd_begin_and_end_in_turn) {
    using Ids = std::pair<std::uint64_t, std::uint64_t>;
    const auto number = [](BodyId id) { return static_cast<std::uint64_t>(id.slot) << 32 | id.generation; };
    std::map<Ids, std::pair<BodyId, BodyId>> touching;
    int begins = 0, ends = 0, hits = 0, stale = 0;
    run_crowd([&](const World<Crowd>& world, const World<Crowd>& before) {
        for (const Event& event : world.events()) {
            const Ids ids = {number(event.A), number(event.B)};
            ASSERT_LT(event.A.slot, event.B.slot);
            if (event.kind == EventKind::begin) {
                EXPECT_TRUE(touching.insert({ids, {event.A, event.B}}).second) << "a begin after a begin";
                EXPECT_TRUE(world.is_alive(event.A) && world.is_alive(event.B));
                ++begins;
            } else if (event.kind == EventKind::end) {
                EXPECT_EQ(touching.erase(ids), 1u) << "an end without a begin";
                stale += world.is_alive(event.A) && world.is_alive(event.B) ? 0 : 1;
                ++ends;
            } else {
                EXPECT_EQ(touching.count(ids), 1u) << "a hit of bodies that do not touch";
                EXPECT_GT(event.speed, Crowd::hit_speed);
                ++hits;
            }
        }
        for (const auto& [ids, pair] : touching) {
            ASSERT_TRUE(world.is_alive(pair.first) && world.is_alive(pair.second)) << "an end was forgotten";
            if (pair.first.slot < 5) continue;
            // Centres no further apart than two of the largest radii, the gap, and what the step can close.
            const double speed =
                (ingot_reference::to_eigen(before.state(pair.first).value.v_CM) - ingot_reference::to_eigen(before.state(pair.second).value.v_CM))
                    .norm();
            EXPECT_LE(distance_of(before, pair.first, pair.second), 1.0 + 0.001 + speed * static_cast<double>(h) + 1e-2);
        }
    });
    EXPECT_GT(begins, 500);
    EXPECT_GT(hits, 100);
    EXPECT_GT(stale, 50);
    EXPECT_EQ(begins - ends, static_cast<int>(touching.size()));
}

TEST(Events, cost_their_arrays_where_they_are_named) {
    const size_t notes = sizeof(ingot::ImpactNote) + 2 * sizeof(ingot::PairOfBodies), event = sizeof(Event);
    const size_t more = sizeof(World<Telling>) - sizeof(World<Plain>), least = 32 * notes + 40 * event;
    EXPECT_GE(more + alignof(World<Plain>), least);
    EXPECT_LE(more, least + 8 + 2 * alignof(World<Plain>));
    EXPECT_EQ(sizeof(ingot::PairOfBodies), 16u);
    EXPECT_EQ(sizeof(World<Telling>) - sizeof(World<Short>), 32 * event);
}

}  // namespace
