// SPDX-License-Identifier: MIT
// A yard of a dozen bodies, in which a scene uses the traits that it names. Included by the units that pairs_of_traits.py writes.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "scenes/compounds.h"

namespace yard {

using ingot::scalar;
using ingot::Vector;

constexpr int max_bodies = 24;

/// Workers that take the last task first.
struct BackToFront {
    static constexpr int workers = 2;
    template <class Task>
    static void run(int count, Task& task) {
        for (int task_i = count - 1; task_i >= 0; --task_i) task(task_i);
    }
};

/// The bodies that a trait may want to do something to.
struct Ids {
    ingot::BodyId ground, wall, cubes[3], ball, bouncer, plank, resting;
};

inline const char* running = "";  ///< the pair

/// A use that is refused tests nothing.
inline void expect(ingot::Status status) {
    if (status == ingot::Status::ok) return;
    std::fprintf(stderr, "pairs_of_traits: %s: a call was refused with status %d\n", running, static_cast<int>(status));
    std::abort();
}

template <class S>
ingot::BodyId add(ingot::World<S>& world, scenes::PlacedBody body) {
    body.def.friction = body.mu;
    if (!S::bounces) body.def.restitution = 0;
    if (!ingot::has_shapes<S>) body.def.shape = {};
    if (!ingot::has_shapes<S>) body.def.restitution = 0;
    if (!S::translates) body.def.state.r_CM = body.def.state.v_CM = {};
    const ingot::Result<ingot::BodyId> id = world.add(body.def);
    expect(id.status);
    return id.value;
}

template <class S>
Ids build(ingot::World<S>& world) {
    const scalar mu = scalar(0.5), half = scalar(0.5);
    if constexpr (S::translates) expect(world.set_gravity({0, 0, -scenes::standard_gravity}));
    Ids ids = {};
    ids.ground = add(world, scenes::half_space({0, 0, 1}, 0, mu));
    ids.wall = add(world, scenes::fixed_box({half, 3, 3}, {7, 0, 3}, mu));
    for (int i = 0; i < 3; ++i) {
        const Vector place = {scalar(0.1) * scalar(i), 0, scalar(i) + half};
        ids.cubes[i] = add(world, scenes::solid_box(i == 2 ? scalar(200) : scalar(1), {half, half, half}, place, mu));
    }
    scenes::PlacedBody ball = scenes::solid_ball(1, scalar(0.25), {-3, scalar(0.1), scalar(0.25)}, mu);
    ball.move({4, 0, 0}, {0, 16, 0});
    ids.ball = add(world, ball);
    scenes::PlacedBody bouncer = scenes::solid_ball(2, scalar(0.3), {3, 2, 1}, mu, scalar(0.75));
    bouncer.move({0, 0, -2}, {1, 2, 3});
    ids.bouncer = add(world, bouncer);
    scenes::PlacedBody plank = scenes::solid_box(2, {1, scalar(0.3), scalar(0.1)}, {scalar(0.25), scalar(0.25), scalar(3.75)}, mu, scalar(0.25));
    plank.turn(scenes::scattered_rotation(2));
    plank.move({}, {1, 4, 2});
    ids.plank = add(world, plank);
    ids.resting = add(world, scenes::unit_cube({-5, -5, half}, mu));
    scenes::PlacedBody slow = scenes::solid_ball(1, scalar(0.25), {-5, -8, scalar(0.25)}, mu);
    slow.move({scalar(0.03125), 0, 0}, {0, scalar(0.125), 0});
    (void)add(world, slow);
    for (int i = 0; i < 3; ++i) {
        scenes::PlacedBody box = scenes::solid_box(1, {scalar(0.3), scalar(0.2), scalar(0.4)}, {scalar(2 * i - 2), 3, 1}, mu, scalar(0.5));
        box.turn(scenes::scattered_rotation(i));
        box.move({0, 0, 1}, {scalar(i * i * i), scalar(0.1), 6});
        (void)add(world, box);
    }
    return ids;
}

/// A roof of four triangles and a step beside it: ridges, a valley and rims.
constexpr Vector hill_corners[] = {{0, 0, 0}, {6, 0, 0}, {6, 2, scalar(0.25)}, {0, 2, scalar(0.25)}, {6, 4, 0}, {0, 4, 0}, {6, 4, 1}, {0, 4, 1}};
constexpr ingot::LevelFace hill_faces[] = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}, {5, 4, 6}, {5, 6, 7}};
inline constexpr auto hill_of = ingot::mesh_of(hill_corners, hill_faces, scalar(1) / 64);
static_assert(hill_of.ok());
inline constexpr ingot::LevelTable hill = hill_of.value.view();

template <class S>
void add_hill(ingot::World<S>& world) {
    ingot::LevelDef def;
    def.r = {-3, scalar(1.5), scalar(0.0625)};
    expect(world.add_level(def).status);
}

template <class S>
void add_sensor(ingot::World<S>& world) {
    scenes::PlacedBody sensor = scenes::fixed_box({1, 1, 1}, {-1, 0, 1}, 0);
    sensor.def.sensor = true;
    (void)add(world, sensor);
}

/// The wall comes nearer, turns, and goes from pose to pose; the lowest cube is a lift and then a turntable.
template <class S>
void move_kinematic(ingot::World<S>& world, const Ids& ids, int step_i) {
    if (step_i == 5) expect(world.set_velocity(ids.wall, {-6, 0, 0}, {0, 0, scalar(0.25)}));
    if (step_i >= 40) expect(world.move_to(ids.wall, {scalar(4) - scalar(step_i - 40) / 16, 0, 3}, ingot::identity_matrix<scalar>()));
    if (step_i == 2) expect(world.set_velocity(ids.cubes[0], {0, 0, scalar(0.5)}));
    if (step_i == 20) expect(world.set_velocity(ids.cubes[0], {}, {0, 0, 2}));
}

/// The bouncer hangs from the world, the plank from the bouncer and from the world, which is a loop, and two cubes are a door and its post.
template <class S>
void join(ingot::World<S>& world, const Ids& ids) {
    if (world.joint_count() != 0) return;  // another trait of the scene has done it
    ingot::JointDef hang;
    hang.body_B = ids.bouncer;
    hang.joint = ingot::BallJoint{};
    hang.P = {3, 2, 3};
    expect(world.add_joint(hang).status);
    ingot::JointDef link = hang;
    link.body_A = ids.bouncer;
    link.body_B = ids.plank;
    link.P = {2, 1, scalar(2.5)};
    expect(world.add_joint(link).status);
    ingot::JointDef tie = hang;
    tie.body_B = ids.plank;
    tie.P = {0, 0, 4};
    expect(world.add_joint(tie).status);
    ingot::JointDef door;
    door.body_A = ids.cubes[1];
    door.body_B = ids.cubes[2];
    door.joint = ingot::HingeJoint{};
    door.P = {scalar(0.5), 0, 2};
    door.axis = {0, 1, 0};
    expect(world.add_joint(door).status);
}
/// And the bouncer falls: the first joint is gone.
template <class S>
void part(ingot::World<S>& world) {
    expect(world.remove(ingot::JointId{0, 0, 1}));
}

template <class S>
void add_hulls(ingot::World<S>& world) {
    for (int i = 0; i < 2; ++i) {
        scenes::PlacedBody rock;
        rock.def.mass = i == 0 ? scenes::rock_hull.mass : scenes::octahedron_hull.mass;
        rock.def.shape = ingot::hull_of<S>(i);
        rock.def.state.r_CM = {scalar(2 * i) - 1, scalar(-2.5), 1};
        rock.mu = scalar(0.5);
        (void)add(world, rock);
    }
}

template <class S>
void add_round_bodies(ingot::World<S>& world) {
    for (int i = 0; i < 2; ++i) {
        scenes::PlacedBody body = scenes::solid_ball(1, scalar(0.3), {scalar(2 * i) - 1, -4, scalar(0.75)}, scalar(0.5));
        body.def.shape = i == 0 ? ingot::Shape(ingot::Capsule{scalar(0.2), scalar(0.3)}) : ingot::Shape(ingot::Cylinder{scalar(0.3), scalar(0.2)});
        body.turn(scenes::scattered_rotation(i + 4));
        (void)add(world, body);
    }
}

template <class S>
void add_compound(ingot::World<S>& world) {
    expect(scenes::add_parts(world, scenes::dumbbell(scalar(0.25), scalar(0.75), scalar(0.5)), 2, {4, -2, 1}, scenes::scattered_rotation(1)).status);
}

template <class Field>
void set_spring(Field& field) {
    field.k = 4;
    field.anchor = {0, 0, 1};
    field.r_body = {0, 0, scalar(0.125)};
}
template <class Field>
void set_drag(Field& field) {
    field.c = scalar(0.25);
    field.c_turn = scalar(0.03125);
}

/// Where there are shapes they are met.
template <class S>
void cast_rays(const ingot::World<S>& world) {
    if constexpr (ingot::has_shapes<S>) {
        const ingot::Result<ingot::QueryHit> down = world.cast_ray({-9, 1, 9}, {0, 0, -18});
        expect(down.status);
        if (!down.value.found()) expect(ingot::Status::bad_shape);
        expect(world.cast_ray({-4, 0, scalar(0.5)}, {8, 1, 0}).status);
    }
}

/// 64 bits of all that the world tells.
class Digest {
public:
    void take(const void* bytes, std::size_t size) {  // FNV-1a
        for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
    }
    template <class Number>
    void take(Number number) {
        take(&number, sizeof number);
    }
    /// The same for every width of indices.
    void take_index(ingot::Index index) { take(static_cast<uint16_t>(index)); }
    void take(const Vector& v) {
        take(v.x);
        take(v.y);
        take(v.z);
    }
    uint64_t value() const { return hash_; }

private:
    uint64_t hash_ = 0xcbf29ce484222325u;
};

template <class S>
void take_world(Digest& digest, const ingot::World<S>& world, const ingot::StepReport& report) {
    digest.take(world.state_hash());
    digest.take_index(report.contacts);
    if constexpr (S::max_contacts > 0)
        for (int i = 0; i < world.contact_count(); ++i) {
            const ingot::ContactInfo contact = world.contact(i).value;
            digest.take_index(contact.A.slot);
            digest.take_index(contact.B.slot);
            digest.take(contact.n);
            digest.take(contact.j);
        }
    if constexpr (S::reads_contacts)
        for (const ingot::ContactInfo& contact : world.contacts()) {
            digest.take(contact.j_friction);
            for (int point_i = 0; point_i < contact.point_count; ++point_i) {
                digest.take(contact.points[point_i].P);
                digest.take(contact.points[point_i].j);
            }
        }
    if constexpr (S::max_overlaps > 0)
        for (int i = 0; i < world.overlap_count(); ++i) {
            const ingot::OverlapInfo overlap = world.overlap(i).value;
            digest.take_index(overlap.visitor.slot);
            digest.take(overlap.visitor_shape);
        }
    if constexpr (S::max_events > 0)
        for (const ingot::Event& event : world.events()) {
            digest.take(static_cast<uint8_t>(event.kind));
            digest.take_index(event.A.slot);
            digest.take_index(event.B.slot);
            if (event.kind == ingot::EventKind::begin || event.kind == ingot::EventKind::hit) digest.take(event.speed);
        }
    if constexpr (S::sleeps) digest.take(world.asleep_count());
}

/// So it lies in .bss, and takes no flash: a record that begins with anything else would bring all of its world along.
template <class S>
void expect_zeros(const ingot::World<S>& world) {
    static constexpr unsigned char zeros[sizeof world] = {};
    if (std::memcmp(&world, zeros, sizeof world) == 0) return;
    std::fprintf(stderr, "pairs_of_traits: %s: the world is not all zero as it begins\n", running);
    std::abort();
}

/// A second of the yard. Prints what pairs.csv keeps: the pair and its hash.
template <class S>
void run(const char* pair) {
    static ingot::World<S> world;
    running = pair;
    expect_zeros(world);
    const Ids ids = build(world);
    S::set_up(world, ids);
    Digest digest;
    for (int step_i = 0; step_i < 60; ++step_i) {
        S::edit(world, ids, step_i);
        const ingot::StepReport report = ingot::step(world, scalar(1) / 60);
        expect(report.status);
        take_world(digest, world, report);
    }
    std::printf("%s,%016llx\n", pair, static_cast<unsigned long long>(digest.value()));
}

}  // namespace yard
