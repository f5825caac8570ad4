// SPDX-License-Identifier: MIT
// The catalogue of worlds behind ingot_c.h. A call looks up which world it is given and asks it; nothing here does physics.
#include "ingot_c.h"

#include <ingot/ingot.h>

using ingot::BodyId;
using ingot::JointId;
using ingot::Matrix;
using ingot::Status;
using ingot::Vector;

namespace {

template <int bodies, int manifolds, int joints_of_it, int loops, int events>
struct Catalogued : ingot::Scene {
    static constexpr int max_bodies = bodies, max_manifolds = manifolds, max_joints = joints_of_it, max_overlaps = bodies;
    static constexpr int max_loops = loops, max_events = events;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true, filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::FixedJoint,
                                 ingot::RodJoint, ingot::RopeJoint, ingot::WithLimits, ingot::WithDrives>;
    using broad_phase = ingot::QueryTree;
};
using Small = Catalogued<16, 48, 8, 4, 32>;
using Middle = Catalogued<256, 1024, 64, 16, 512>;
using Large = Catalogued<4096, 16384, 1024, 64, 4096>;

static_assert(static_cast<int>(ingot::ShapeKind::half_space) == INGOT_HALF_SPACE && static_cast<int>(ingot::ShapeKind::box) == INGOT_BOX);
static_assert(static_cast<int>(ingot::JointKind::rope) == INGOT_ROPE && static_cast<int>(ingot::JointKind::hinge) == INGOT_HINGE);
static_assert(static_cast<int>(ingot::DriveKind::motor) == INGOT_MOTOR && static_cast<int>(ingot::EventKind::leave) == INGOT_LEAVE);
static_assert(sizeof(IngotScalar) == sizeof(ingot::scalar), "compile with INGOT_DOUBLE as the kernel is");

}  // namespace

/// What each world begins with, so that a call knows which it is.
struct IngotWorld {
    uint32_t mark;
    int32_t which;
};

namespace {

constexpr uint32_t mark_of_world = 0x746f676e;

template <class S>
struct Entry {
    IngotWorld head;
    ingot::World<S> world;
};

/// Calls ask with the Entry type of a number; `none` where there is no such world.
template <class Answer, class Ask>
Answer for_kind(int32_t which, Answer none, const Ask& ask) {
    switch (which) {
        case INGOT_SMALL: return ask(static_cast<Entry<Small>*>(nullptr));
        case INGOT_MIDDLE: return ask(static_cast<Entry<Middle>*>(nullptr));
        case INGOT_LARGE: return ask(static_cast<Entry<Large>*>(nullptr));
        default: return none;
    }
}
/// The same with the world itself, const where it is.
template <class Answer, class Ask>
Answer for_world(IngotWorld* of, Answer none, const Ask& ask) {
    if (of == nullptr || of->mark != mark_of_world) return none;
    return for_kind(of->which, none, [&](auto* type) { return ask(reinterpret_cast<decltype(type)>(of)->world); });
}
template <class Answer, class Ask>
Answer for_world(const IngotWorld* of, Answer none, const Ask& ask) {
    return for_world(const_cast<IngotWorld*>(of), none, [&](const auto& world) { return ask(world); });
}

constexpr IngotStatus no_world = INGOT_NO_WORLD;

IngotStatus code(Status status) { return static_cast<IngotStatus>(status); }
Vector vector(const IngotScalar* v) { return {v[0], v[1], v[2]}; }
Matrix matrix(const IngotScalar* A) { return {vector(A), vector(A + 3), vector(A + 6)}; }
void write(IngotScalar* to, const Vector& v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}
void write(IngotScalar* to, const Matrix& A) {
    write(to, A.c0);
    write(to + 3, A.c1);
    write(to + 6, A.c2);
}

// Ids as numbers: worlds of this interface have no tags.
template <class Id>
uint64_t number_of(const Id& id) {
    return static_cast<uint64_t>(id.generation) << 32 | static_cast<uint32_t>(id.slot);
}
template <class Id>
Id id_of(uint64_t number) {
    const uint32_t slot = static_cast<uint32_t>(number);
    if (slot > static_cast<uint32_t>(ingot::index_max)) return {};
    return {static_cast<ingot::Index>(slot), 0, static_cast<uint32_t>(number >> 32)};
}

ingot::Result<ingot::BodyDef> body_of(const IngotBodyDef& from) {
    ingot::BodyDef def;
    if (from.shape < 0 || from.shape > INGOT_HALF_SPACE || from.shape == static_cast<int>(ingot::ShapeKind::hull)) return {Status::not_in_scene, {}};
    if (from.kind < INGOT_MOVABLE || from.kind > INGOT_KINEMATIC) return {Status::out_of_range, {}};
    def.shape = {static_cast<ingot::ShapeKind>(from.shape), vector(from.size), from.offset};
    def.immovable = from.kind == INGOT_IMMOVABLE;
    def.kinematic = from.kind == INGOT_KINEMATIC;
    def.restitution = from.restitution;
    def.friction = from.friction;
    def.sensor = from.sensor != 0;
    def.filter = {from.category, from.mask};
    def.state = {vector(from.r), vector(from.v), matrix(from.A), vector(from.omega)};
    if (from.kind != INGOT_MOVABLE) return {Status::ok, def};
    const ingot::Result<ingot::MassProperties> mass = ingot::principal(ingot::solid_of_shape(from.density, def.shape));
    def.mass = mass.value;
    // A solid of one of these shapes has its principal axes along those of the shape.
    def.state.L = ingot::angular_momentum_of_spin(def.state.A, def.mass.I_body, vector(from.omega));
    return {mass.status, def};
}

ingot::JointRange range_of(const IngotRange& from) {
    return from.limited == 0 ? ingot::JointRange{} : ingot::JointRange{from.lower, from.upper};
}
ingot::JointLimits limits_of(const IngotLimits& from) {
    ingot::JointLimits limits = {{range_of(from.range[0]), range_of(from.range[1])}, from.restitution};
    if (from.cone != 0) limits.range[1].upper = from.cone;  // of a cone there is no lower end
    return limits;
}
ingot::Result<ingot::JointDrive> drive_of(const IngotDrive& from) {
    if (from.kind < INGOT_NO_DRIVE || from.kind > INGOT_MOTOR) return {Status::out_of_range, {}};
    const ingot::scalar most = from.max_torque == 0 ? ingot::unlimited : from.max_torque;
    const ingot::DriveKind kind = static_cast<ingot::DriveKind>(from.kind);
    return {Status::ok, {kind, from.stiffness, from.damping, from.target, from.target_rate, from.feedforward, most}};
}

ingot::Result<ingot::JointDef> joint_of(const IngotJointDef& from) {
    if (from.kind < INGOT_BALL || from.kind > INGOT_ROPE) return {Status::not_in_scene, {}};
    ingot::JointDef def;
    def.body_A = id_of<BodyId>(from.A);
    def.body_B = id_of<BodyId>(from.B);
    if (from.kind == INGOT_ROD)
        def.joint = ingot::RodJoint{from.length};
    else if (from.kind == INGOT_ROPE)
        def.joint = ingot::RopeJoint{from.length};
    else
        def.joint = {static_cast<ingot::JointKind>(from.kind), limits_of(from.limits), {}};
    def.P = vector(from.P);
    def.axis = vector(from.axis);
    if (from.axis_B[0] != 0 || from.axis_B[1] != 0 || from.axis_B[2] != 0) def.axis_B = vector(from.axis_B);
    def.P_B = vector(from.P_B);
    def.bodies_meet = from.bodies_meet != 0;
    return {Status::ok, def};
}

void write(IngotHit& to, const ingot::QueryHit& hit) {
    to.body = number_of(hit.body);
    to.fraction = hit.fraction;
    write(to.P, hit.P);
    write(to.n, hit.n);
}

}  // namespace

uint32_t ingot_determinism_version(void) { return INGOT_DETERMINISM_VERSION; }
size_t ingot_scalar_size(void) { return sizeof(IngotScalar); }
const char* ingot_status_name(IngotStatus status) {
    if (status == INGOT_NO_WORLD) return "no_world: no memory that ingot_world_begin has made a world of";
    return status < 0 || status > INGOT_NO_WORLD ? "no status" : ingot::name(static_cast<Status>(status));
}

size_t ingot_world_size(int32_t which) {
    return for_kind(which, size_t{0}, [](auto* type) { return sizeof(*type); });
}
size_t ingot_world_alignment(void) { return alignof(Entry<Large>); }

IngotWorld* ingot_world_begin(int32_t which, void* memory, size_t bytes) {
    const size_t needed = ingot_world_size(which);
    if (memory == nullptr || needed == 0 || bytes < needed || reinterpret_cast<uintptr_t>(memory) % ingot_world_alignment() != 0) return nullptr;
    uint8_t* const to = static_cast<uint8_t*>(memory);
    for (size_t i = 0; i < needed; ++i) to[i] = 0;  // a world of zeros is an empty world
    IngotWorld* const world = static_cast<IngotWorld*>(memory);
    *world = {mark_of_world, which};
    return world;
}

IngotStatus ingot_set_gravity(IngotWorld* world, const IngotScalar g[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_gravity(vector(g))); });
}
IngotStatus ingot_step(IngotWorld* world, IngotScalar h, IngotReport* report) {
    return for_world(world, no_world, [&](auto& of) {
        const ingot::StepReport step = ingot::step(of, h);
        if (report != nullptr)
            *report = {step.contacts,          step.contacts_lost, step.bodies_frozen,  step.sweeps,
                       step.sweeps_unfinished, step.residual,      step.clean() ? 1 : 0};
        return code(step.status);
    });
}
uint64_t ingot_state_hash(const IngotWorld* world) {
    return for_world(world, uint64_t{0}, [](const auto& of) { return of.state_hash(); });
}
IngotScalar ingot_kinetic_energy(const IngotWorld* world) {
    return for_world(world, IngotScalar{0}, [](const auto& of) { return of.kinetic_energy(); });
}
size_t ingot_snapshot_size(int32_t which) {
    return for_kind(which, size_t{0}, [](auto* type) {
        using Scene = typename decltype(type->world)::scene;
        return ingot::snapshot_size<Scene>();
    });
}
size_t ingot_save_snapshot(const IngotWorld* world, void* bytes, size_t room) {
    return for_world(world, size_t{0}, [&](const auto& of) { return ingot::save_snapshot(of, static_cast<uint8_t*>(bytes), room).value; });
}
IngotStatus ingot_load_snapshot(IngotWorld* world, const void* bytes, size_t size) {
    return for_world(world, no_world, [&](auto& of) { return code(ingot::load_snapshot(of, static_cast<const uint8_t*>(bytes), size)); });
}

void ingot_body_def(IngotBodyDef* def) {
    *def = {};
    def->A[0] = def->A[4] = def->A[8] = 1;
    def->friction = IngotScalar(0.5);
    def->density = 1000;
    def->category = ingot::meets_all.category;
    def->mask = ingot::meets_all.mask;
}
IngotStatus ingot_add_body(IngotWorld* world, const IngotBodyDef* def, IngotBody* body) {
    *body = 0;
    return for_world(world, no_world, [&](auto& of) {
        const ingot::Result<ingot::BodyDef> read = body_of(*def);
        if (!read.ok()) return code(read.status);
        const ingot::Result<BodyId> id = of.add(read.value);
        *body = number_of(id.value);
        return code(id.status);
    });
}
IngotStatus ingot_remove_body(IngotWorld* world, IngotBody body) {
    return for_world(world, no_world, [&](auto& of) { return code(of.remove(id_of<BodyId>(body))); });
}
int32_t ingot_body_count(const IngotWorld* world) {
    return for_world(world, int32_t{0}, [](const auto& of) { return int32_t{of.body_count()}; });
}
IngotStatus ingot_state(const IngotWorld* world, IngotBody body, IngotState* state) {
    *state = {};
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::Result<ingot::BodyState> read = of.state(id_of<BodyId>(body));
        if (!read.ok()) return code(read.status);
        write(state->r, read.value.r_CM);
        write(state->v, read.value.v_CM);
        write(state->A, read.value.A);
        write(state->L, read.value.L);
        return code(Status::ok);
    });
}
IngotStatus ingot_set_state(IngotWorld* world, IngotBody body, const IngotState* state) {
    return for_world(world, no_world, [&](auto& of) {
        return code(of.set_state(id_of<BodyId>(body), {vector(state->r), vector(state->v), matrix(state->A), vector(state->L)}));
    });
}
IngotStatus ingot_mass(const IngotWorld* world, IngotBody body, IngotScalar* mass) {
    *mass = 0;
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::Result<ingot::scalar> read = of.mass(id_of<BodyId>(body));
        *mass = read.value;
        return code(read.status);
    });
}
IngotStatus ingot_set_filter(IngotWorld* world, IngotBody body, uint32_t category, uint32_t mask) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_filter(id_of<BodyId>(body), {category, mask})); });
}
IngotStatus ingot_set_velocity(IngotWorld* world, IngotBody body, const IngotScalar v[3], const IngotScalar omega[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_velocity(id_of<BodyId>(body), vector(v), vector(omega))); });
}
IngotStatus ingot_move_to(IngotWorld* world, IngotBody body, const IngotScalar r[3], const IngotScalar A[9]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.move_to(id_of<BodyId>(body), vector(r), matrix(A))); });
}
IngotStatus ingot_add_force(IngotWorld* world, IngotBody body, const IngotScalar F[3], const IngotScalar P[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.add_force(id_of<BodyId>(body), vector(F), vector(P))); });
}
IngotStatus ingot_add_torque(IngotWorld* world, IngotBody body, const IngotScalar tau[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.add_torque(id_of<BodyId>(body), vector(tau))); });
}
IngotStatus ingot_apply_angular_impulse(IngotWorld* world, IngotBody body, const IngotScalar k[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.apply_angular_impulse(id_of<BodyId>(body), vector(k))); });
}
IngotStatus ingot_wake(IngotWorld* world, IngotBody body) {
    return for_world(world, no_world, [&](auto& of) { return code(of.wake(id_of<BodyId>(body))); });
}
IngotStatus ingot_sleep(IngotWorld* world, IngotBody body) {
    return for_world(world, no_world, [&](auto& of) { return code(of.sleep(id_of<BodyId>(body))); });
}
IngotStatus ingot_apply_impulse(IngotWorld* world, IngotBody body, const IngotScalar j[3], const IngotScalar P[3]) {
    return for_world(world, no_world, [&](auto& of) { return code(of.apply_impulse(id_of<BodyId>(body), vector(j), vector(P))); });
}
int32_t ingot_is_asleep(const IngotWorld* world, IngotBody body) {
    return for_world(world, int32_t{0}, [&](const auto& of) { return int32_t{of.is_asleep(id_of<BodyId>(body)) ? 1 : 0}; });
}

int32_t ingot_contact_count(const IngotWorld* world) {
    return for_world(world, int32_t{0}, [](const auto& of) { return int32_t{of.contact_count()}; });
}
IngotStatus ingot_contact(const IngotWorld* world, int32_t index, IngotContact* contact) {
    *contact = {};
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::Result<ingot::ContactInfo> read = of.contact(index);
        if (!read.ok()) return code(read.status);
        contact->A = number_of(read.value.A);
        contact->B = number_of(read.value.B);
        write(contact->n, read.value.n);
        contact->separation = read.value.separation;
        contact->j = read.value.j;
        contact->point_count = read.value.point_count;
        for (int i = 0; i < read.value.point_count; ++i) write(contact->P[i], read.value.points[i].P);  // up to four
        return code(Status::ok);
    });
}
IngotStatus ingot_cast_ray(const IngotWorld* world, const IngotScalar from[3], const IngotScalar way[3], IngotHit* hit) {
    *hit = {};
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::Result<ingot::QueryHit> read = of.cast_ray(vector(from), vector(way));
        if (!read.ok()) return code(read.status);
        write(*hit, read.value);
        return code(Status::ok);
    });
}

IngotStatus ingot_cast_ray_all(const IngotWorld* world, const IngotScalar from[3], const IngotScalar way[3], IngotHit* hits, int32_t capacity,
                               int32_t* count) {
    *count = 0;
    return for_world(world, no_world, [&](const auto& of) {
        ingot::QueryHit found[INGOT_HITS_MAX];
        const int room = capacity < INGOT_HITS_MAX ? static_cast<int>(capacity) : int{INGOT_HITS_MAX};
        const ingot::Result<int> there = of.cast_ray_all(vector(from), vector(way), found, room);
        if (!there.ok()) return code(there.status);
        for (int i = 0; i < there.value && i < room; ++i) write(hits[i], found[i]);  // up to INGOT_HITS_MAX
        *count = there.value;
        return code(Status::ok);
    });
}
int32_t ingot_event_count(const IngotWorld* world) {
    return for_world(world, int32_t{0}, [](const auto& of) { return int32_t{of.events().count}; });
}
IngotStatus ingot_event(const IngotWorld* world, int32_t index, IngotEvent* event) {
    *event = {};
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::EventView events = of.events();
        if (index < 0 || index >= events.count) return code(Status::out_of_range);
        const ingot::Event& read = events[index];
        event->kind = static_cast<int32_t>(read.kind);
        event->A = number_of(read.A);
        event->B = number_of(read.B);
        write(event->P, read.P);
        write(event->n, read.n);
        event->speed = read.speed;
        return code(Status::ok);
    });
}

IngotStatus ingot_add_joint(IngotWorld* world, const IngotJointDef* def, IngotJoint* joint) {
    *joint = 0;
    return for_world(world, no_world, [&](auto& of) {
        const ingot::Result<ingot::JointDef> read = joint_of(*def);
        if (!read.ok()) return code(read.status);
        const ingot::Result<JointId> id = of.add_joint(read.value);
        *joint = number_of(id.value);
        return code(id.status);
    });
}
IngotStatus ingot_remove_joint(IngotWorld* world, IngotJoint joint) {
    return for_world(world, no_world, [&](auto& of) { return code(of.remove(id_of<JointId>(joint))); });
}
IngotStatus ingot_joint_gap(const IngotWorld* world, IngotJoint joint, IngotScalar* gap) {
    *gap = 0;
    return for_world(world, no_world, [&](const auto& of) {
        const ingot::Result<ingot::scalar> read = of.joint_gap(id_of<JointId>(joint));
        *gap = read.value;
        return code(read.status);
    });
}
IngotStatus ingot_joint_state(const IngotWorld* world, IngotJoint joint, IngotJointState* state) {
    *state = {};
    return for_world(world, no_world, [&](const auto& of) {
        const JointId id = id_of<JointId>(joint);
        const ingot::Result<ingot::scalar> gap = of.joint_gap(id);
        if (!gap.ok()) return code(gap.status);
        state->gap = gap.value;
        // What a kind has not answers not_in_scene, and the value 0.
        for (int which = 0; which < 2; ++which) {
            state->angle[which] = of.joint_angle(id, which).value;
            state->rate[which] = of.joint_rate(id, which).value;
            state->torque[which] = of.drive_torque(id, which).value;
        }
        state->travel = of.joint_travel(id).value;
        state->speed = of.joint_speed(id).value;
        state->length = of.joint_length(id).value;
        state->distance = of.joint_distance(id).value;
        const ingot::Result<Vector> of_ball = of.ball_torque(id);
        if (of_ball.ok()) write(state->torque, of_ball.value);
        return code(Status::ok);
    });
}
IngotStatus ingot_set_joint_limits(IngotWorld* world, IngotJoint joint, const IngotLimits* limits) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_joint_limits(id_of<JointId>(joint), limits_of(*limits))); });
}
IngotStatus ingot_set_joint_drive(IngotWorld* world, IngotJoint joint, const IngotDrive* drive, int32_t which) {
    return for_world(world, no_world, [&](auto& of) {
        const ingot::Result<ingot::JointDrive> read = drive_of(*drive);
        return code(read.ok() ? of.set_joint_drive(id_of<JointId>(joint), read.value, which) : read.status);
    });
}
IngotStatus ingot_set_ball_drive(IngotWorld* world, IngotJoint joint, const IngotDrive* drive, const IngotScalar target[3]) {
    return for_world(world, no_world, [&](auto& of) {
        const ingot::Result<ingot::JointDrive> read = drive_of(*drive);
        return code(read.ok() ? of.set_ball_drive(id_of<JointId>(joint), read.value, vector(target)) : read.status);
    });
}
IngotStatus ingot_set_joint_target(IngotWorld* world, IngotJoint joint, IngotScalar target, IngotScalar target_rate, int32_t which) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_joint_target(id_of<JointId>(joint), target, target_rate, which)); });
}
IngotStatus ingot_set_joint_length(IngotWorld* world, IngotJoint joint, IngotScalar length) {
    return for_world(world, no_world, [&](auto& of) { return code(of.set_joint_length(id_of<JointId>(joint), length)); });
}
