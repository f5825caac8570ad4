// SPDX-License-Identifier: MIT
// What the page calls. Two stages, each a world and what the page does in it, in memory that may be copied as a whole: a copy put back is the past.
// The same file, compiled for the host, makes the table of hashes that the page compares with (native_hashes.cpp).
#include "viewer.h"

#ifdef __wasm__
#include "timed_step.h"  // ahead of what includes the step
#endif
#include "../scenes/walker.h"
#include "scenes.h"

namespace viewer { namespace {

using ingot::BodyId;
using ingot::BodyState;
using ingot::JointId;
using ingot::Matrix;
using ingot::Status;

constexpr int shots_max = 24, stage_count = 2;
constexpr scalar mouse_hertz = 4;
constexpr scalar target_hertz = 8;  ///< a target does not know what hangs on the body: stiffer, so that a ragdoll hangs where it is held
constexpr scalar mouse_reach = 20;  ///< N for 1 N of weight: what the mouse pulls with at most

/// Of the largest world of a kind: all but Machines are smaller than Fine, Chosen and that.
constexpr unsigned larger(unsigned a, unsigned b) { return a > b ? a : b; }
#ifdef VIEWER_CONTACTS_ALONE
constexpr unsigned room_of_world = larger(sizeof(ingot::World<Fine>), sizeof(ingot::World<Chosen>));
#else
constexpr unsigned room_of_world = larger(sizeof(ingot::World<Machines>), larger(sizeof(ingot::World<Fine>), sizeof(ingot::World<Chosen>)));
#endif

/// Who walks, in the two scenes that have somebody.
struct Walks {
    ingot::Mover mover;
    int32_t steered;  ///< keys have taken over from the way around
    scenes::Walker biped;
    scenes::WalkState state;
};

/// All zero: nothing is there. No member has a value to begin with, so that stages are no part of the module.
struct Stage {
    int32_t scene, kind;        ///< numbers in scene_list, and Kind
    int32_t grabbed;            ///< number of the body that the mouse holds, and 1; 0: none
    JointId target;             ///< by which it holds it, in worlds that have targets
    Vector hold;                ///< m, where: in the frame of the body, in others
    Vector pointer;             ///< m, where the mouse is
    scalar throttle, steering;  ///< -1 to 1
    float L_scale;              ///< m for 1 kg m^2/s
    float force_scale;          ///< m for 1 N
    float h;                    ///< s, of the last step
    int32_t shots;
    BodyId shot[shots_max];
    ingot::StepReport report;
    Walks walks;
    alignas(64) unsigned char world[room_of_world];
};
static_assert(__is_trivially_copyable(Stage));
static_assert(ingot::draw_color_count == 19, "engine.js names them");

// Zero bytes are a valid empty world, and an empty stage.
alignas(64) unsigned char stages[stage_count][sizeof(Stage)];
Stage& stage_at(int stage_i) { return *reinterpret_cast<Stage*>(stages[stage_i & 1]); }

template <class S>
ingot::World<S>& world_of(Stage& stage) {
    return *reinterpret_cast<ingot::World<S>*>(stage.world);
}
/// Asks with the world of a stage.
template <class Answer, class Ask>
Answer for_world(Stage& stage, Answer none, const Ask& ask) {
    return for_kind(stage.kind, none, [&](auto named) { return ask(world_of<typename decltype(named)::scene>(stage), named); });
}

// What the page reads.

constexpr int shapes_max = Things::max_bodies + 8, shape_floats = 20;
constexpr int lines_max = 24576, line_floats = 7;
constexpr int points_max = 16384, point_floats = 4;
constexpr int triangles_max = 1280, triangle_floats = 10;
float triangle_room[triangles_max * triangle_floats];
float shape_room[shapes_max * shape_floats];
float line_room[lines_max * line_floats];
float point_room[points_max * point_floats];
float answer[32];
int32_t counts[3];  ///< of shapes, lines, points

void put(float* to, const Vector& v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}
void put(float* to, const Matrix& A) {
    put(to, A.c0);
    put(to + 3, A.c1);
    put(to + 6, A.c2);
}

/// A pen of the kernel's drawing that writes numbers down. Of what is not asked for it writes nothing.
/// Impulses that point downwards, which the ground has of what lies on it, are shown as that has them: above the ground.
struct Pen {
    unsigned colors;  ///< bits of ingot::DrawColor

    bool wants(ingot::DrawColor color) const { return (colors >> static_cast<unsigned>(color) & 1u) != 0; }
    void line(const Vector& a, const Vector& b, ingot::DrawColor color) const {
        if (!wants(color) || counts[1] == lines_max) return;
        float* const to = line_room + counts[1]++ * line_floats;
        const bool is_impulse = color == ingot::DrawColor::impulse || color == ingot::DrawColor::friction;
        put(to, a);
        put(to + 3, is_impulse && b.z < a.z ? a + (a - b) : b);
        to[6] = static_cast<float>(color);
    }
    void point(const Vector& P, ingot::DrawColor color) const {
        if (!wants(color) || counts[2] == points_max) return;
        float* const to = point_room + counts[2]++ * point_floats;
        put(to, P);
        to[3] = static_cast<float>(color);
    }
    void shape(const ingot::PlacedShape& shape, ingot::DrawColor color) const {
        if (counts[0] == shapes_max) return;
        float* const to = shape_room + counts[0]++ * shape_floats;
        to[0] = static_cast<float>(shape.shape.kind);
        put(to + 1, shape.shape.size);
        if (shape.shape.kind == ingot::ShapeKind::half_space) to[16] = shape.shape.offset;
        put(to + 4, shape.r);
        put(to + 7, shape.A);
        to[17] = static_cast<float>(color);
    }
};

/// The number of the body, and the one that stands for its island, beside each shape: shapes come in the order of slots, one a body.
template <class S>
void name_shapes(const ingot::World<S>& world) {
    int shape_i = 0;
    for (int slot = 0; slot < S::max_bodies && shape_i < counts[0]; ++slot) {
        const BodyId id = world.body_at(slot);
        if (id.generation == 0) continue;
        float* const to = shape_room + shape_i++ * shape_floats;
        to[18] = static_cast<float>(slot);
        const ingot::Result<BodyId> island = world.island_of(id);
        to[19] = island.ok() ? static_cast<float>(island.value.slot) : -1.0f;
    }
}
template <class S>
void draw_stage(const ingot::World<S>& world, unsigned colors, const ingot::DrawScale& scale) {
    Pen pen{colors};
    if constexpr (ingot::has_shapes<S>) {
        ingot::draw<ingot::Draw::all>(world, pen, scale);
        name_shapes(world);
    } else {
        ingot::draw<ingot::Draw::of_movable>(world, pen, scale);
        const BodyState state = world.state(world.body_at(0)).value;
        pen.shape({ingot::Box{brick}, {}, state.A}, ingot::DrawColor::awake);
    }
}

/// The character, which is none of a world's: body -1.
void draw_mover(const ingot::Mover& mover) {
    Pen{}.shape({mover.capsule, mover.r, ingot::identity_matrix<scalar>()}, ingot::DrawColor::kinematic);
    shape_room[(counts[0] - 1) * shape_floats + 18] = -1;
}

// Scenes.

/// How long arrows are: the longest L is a metre and a half to begin with, and so is what bears the heaviest body; less in a heap, where all bear
/// each other.
template <class S>
void set_scales(Stage& stage, const ingot::World<S>& world) {
    scalar L_sq = 0, heaviest = 0, total = 0;
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const BodyId id = world.body_at(slot);
        if (id.generation == 0 || !world.is_movable(id)) continue;
        L_sq = ingot::max(L_sq, ingot::length_sq(world.state(id).value.L));
        if constexpr (S::translates) {
            const scalar M = world.mass(id).value;
            heaviest = ingot::max(heaviest, M);
            total += M;
        }
    }
    stage.L_scale = L_sq > 0 ? scalar(1.5) / ingot::sqrt(L_sq) : scalar(0.1);
    stage.force_scale = heaviest > 0 ? ingot::min(scalar(1.5) / heaviest, 6 / total) / scalar(9.81) : 0;
}
template <class S>
bool set_up(Stage& stage, const SceneInfo& scene) {
    using World = ingot::World<S>;
    const auto add = [](void* world, const ingot::BodyDef& def) { return static_cast<World*>(world)->add(def).ok(); };
    const auto join = [](void* world, const ingot::JointDef& def, int A, int B) {
        if constexpr (ingot::has_joints<S>) {
            World& of = *static_cast<World*>(world);
            ingot::JointDef named = def;
            named.body_A = of.body_at(A);
            named.body_B = of.body_at(B);
            return of.add_joint(named).ok();
        }
        return false;
    };
    const auto drive = [](void* world, int joint_i, const ingot::JointDrive& of, int which) {
        if constexpr (ingot::has_joint_drives<S>) {
            World& driven = *static_cast<World*>(world);
            return driven.set_joint_drive(driven.joint_at(joint_i), of, which) == Status::ok;
        }
        return false;
    };
    const auto gear = [](void* world, int joint_A, int joint_B, scalar ratio) {
        if constexpr (ingot::has_gears<S>) {
            World& of = *static_cast<World*>(world);
            return of.add_gear(of.joint_at(joint_A), of.joint_at(joint_B), ratio).ok();
        }
        return false;
    };
    const auto level = [](void* world, const ingot::LevelDef& def) {
        if constexpr (ingot::has_levels<S>) return static_cast<World*>(world)->add_level(def).ok();
        return false;
    };
    Builder builder(stage.world, add, join, drive, gear, level);
    scene.set_up(builder);
    bool good = builder.good();
    if constexpr (ingot::has_levels<S>) good = add_walks(stage, world_of<S>(stage)) && good;
    if constexpr (S::translates)
        if (scene.set_up != spinning && scene.set_up != flip) good = world_of<S>(stage).set_gravity({0, 0, scalar(-9.81)}) == Status::ok && good;
    set_scales(stage, world_of<S>(stage));
    return good;
}

// Who walks.

inline constexpr scalar stroll_radius = 4, stroll_speed = scalar(1.6);
[[maybe_unused]] bool strolls(const Stage& stage) { return scene_list[stage.scene].set_up == stroll; }
[[maybe_unused]] bool walks(const Stage& stage) { return scene_list[stage.scene].set_up == biped; }
template <class S>
bool add_walks(Stage& stage, ingot::World<S>& world) {
    if (walks(stage)) return scenes::add_walker(world, {}, scalar(0.6), stage.walks.biped) == Status::ok;
    if (strolls(stage)) {
        stage.walks.mover = {};
        stage.walks.mover.r = {stroll_radius, 0, 1};
    }
    return true;
}
/// Before a step.
template <class S>
void walk_on(Stage& stage, ingot::World<S>& world, scalar h) {
    if (walks(stage)) (void)scenes::walk(world, stage.walks.biped, scenes::Gait{}, stage.walks.state, h);
}
/// After a step. Unless keys have taken over it goes round, and back to its circle from where it was.
template <class S>
void stroll_on(Stage& stage, ingot::World<S>& world, scalar h) {
    if (!strolls(stage)) return;
    ingot::Mover& mover = stage.walks.mover;
    Vector v = {stage.throttle * stroll_speed, stage.steering * stroll_speed, 0};
    if (stage.walks.steered == 0) {
        const Vector out = {mover.r.x, mover.r.y, 0};
        const scalar R = ingot::sqrt(ingot::max(ingot::length_sq(out), scalar(0.01)));
        v = (Vector{-out.y, out.x, 0} * stroll_speed + out * (stroll_radius - R)) * (1 / R);
    }
    (void)world.move(mover, {v}, h);
}

// The mouse.

/// kg: of all that hangs together with a body.
template <class S>
scalar mass_with_joints(const ingot::World<S>& world, BodyId id) {
    if constexpr (ingot::has_joints<S>) {
        const auto figure = world.figure(id);
        return figure.ok() ? figure.value.mass : scalar(0);
    }
    return world.mass(id).value;
}
template <class S>
void release(Stage& stage, ingot::World<S>& world) {
    if constexpr (ingot::has_targets<S>)
        if (stage.grabbed != 0) (void)world.remove(stage.target);
    stage.grabbed = 0;
}
template <class S>
void grab(Stage& stage, ingot::World<S>& world, int slot, const Vector& P) {
    release(stage, world);
    const BodyId id = world.body_at(slot);
    if (id.generation == 0 || !world.is_movable(id)) return;
    if constexpr (ingot::has_targets<S>) {
        ingot::JointDef def;
        def.body_B = id;
        def.joint = ingot::TargetJoint{};
        def.P = P;
        const ingot::Result<JointId> joint = world.add_joint(def);
        if (!joint.ok()) return;
        stage.target = joint.value;
        (void)world.set_target_drive(joint.value, {target_hertz, 1, mouse_reach * scalar(9.81) * mass_with_joints(world, id), 0});
    }
    const BodyState state = world.state(id).value;
    stage.hold = ingot::transpose_times(state.A, P - state.r_CM);
    stage.pointer = P;
    stage.grabbed = slot + 1;
}
template <class S>
void move(Stage& stage, ingot::World<S>& world, const Vector& P) {
    stage.pointer = P;
    if constexpr (ingot::has_targets<S>)
        if (stage.grabbed != 0) (void)world.set_target(stage.target, P);
}
/// In worlds without targets the mouse is a spring at the point, critically damped, and as strong as the step can bear: implicit in speed and place,
/// so no rate makes it ring. A point away from the centre gives way more easily than the centre, by 3.5 at most for a solid: a quarter of the mass.
template <class S>
void pull(Stage& stage, ingot::World<S>& world, scalar h) {
    if constexpr (!ingot::has_targets<S> && ingot::has_shapes<S>) {
        if (stage.grabbed == 0) return;
        const BodyId id = world.body_at(stage.grabbed - 1);
        if (id.generation == 0) return release(stage, world);
        const BodyState state = world.state(id).value;
        const Vector arm = state.A * stage.hold, omega = world.omega(id).value;
        const scalar M = mass_with_joints(world, id), w = 2 * scalar(3.14159265) * mouse_hertz, m = M / 4;
        const Vector away = state.r_CM + arm - stage.pointer, v = ingot::point_velocity(state.v_CM, omega, arm);
        Vector F = (away * (w * w) + v * (2 * w + w * w * h)) * (-m / (1 + 2 * w * h + w * w * h * h)) - world.gravity() * M;
        const scalar most = mouse_reach * scalar(9.81) * M, F_sq = ingot::length_sq(F);
        if (F_sq > most * most) F = F * (most / ingot::sqrt(F_sq));
        (void)world.add_force(id, F, state.r_CM + arm);
        (void)world.add_torque(id, state.L * scalar(-2));  // half a second: what is held stops turning
    }
}

template <class S>
void shoot(Stage& stage, ingot::World<S>& world, const Vector& from, const Vector& v) {
    if constexpr (ingot::has_shapes<S>) {
        BodyId& slot = stage.shot[stage.shots % shots_max];
        if (slot.generation != 0) (void)world.remove(slot);
        ingot::BodyDef def = solid(ingot::Sphere{scalar(0.3)}, 20, from, half, scalar(0.3));
        def.state.v_CM = v;
        const ingot::Result<BodyId> id = world.add(def);
        slot = id.value;
        if (id.ok()) ++stage.shots;
    }
}

/// Arrow keys, in the scene with the car.
template <class S>
void steer(Stage& stage, ingot::World<S>& world) {
    if constexpr (ingot::has_wheels<S>) {
        stage.walks.steered = 1;
        if (scene_list[stage.scene].set_up == gears)
            (void)world.set_joint_drive(world.joint_at(0), ingot::MotorDrive{stage.throttle < 0 ? scalar(-2) : scalar(2), 800});
        if (scene_list[stage.scene].set_up != car) return;
        for (int i = 0; i < 4; ++i) {
            const JointId wheel = world.joint_at(i);
            if (i < 2)
                (void)world.set_joint_target(wheel, stage.steering * scalar(0.5), 0, ingot::WheelJoint::steering);
            else
                (void)world.set_joint_drive(wheel, ingot::MotorDrive{30 * stage.throttle, 400}, ingot::WheelJoint::spin);
        }
    }
}

/// J: of motion and height.
template <class S>
double energy_of(const ingot::World<S>& world) {
    double energy = static_cast<double>(world.kinetic_energy());
    if constexpr (S::translates)
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = world.body_at(slot);
            if (id.generation == 0 || !world.is_movable(id)) continue;
            energy -= static_cast<double>(world.mass(id).value) * static_cast<double>(ingot::dot(world.gravity(), world.state(id).value.r_CM));
        }
    return energy;
}

void clear(Stage& stage) {
    // Words, not bytes: a megabyte of them is cleared whenever a scene is opened.
    uint64_t* const words = reinterpret_cast<uint64_t*>(&stage);
    for (unsigned i = 0; i < sizeof(Stage) / sizeof(uint64_t); ++i) words[i] = 0;
}

}}  // namespace viewer

using namespace viewer;

// Scenes.

int viewer_scene_count() { return scene_count; }
int viewer_kind_count() { return kind_count; }
const char* viewer_scene_text(int scene_i, int which) {
    const SceneInfo& scene = scene_list[scene_i];
    const char* const texts[4] = {scene.id, scene.group, scene.title, scene.text};
    return texts[which & 3];
}
const float* viewer_camera(int scene_i) { return &scene_list[scene_i].camera.x; }
float viewer_wall(int scene_i) { return scene_list[scene_i].wall; }
int viewer_kind_of(int scene_i) { return scene_list[scene_i].kind; }
unsigned viewer_kinds_of(int scene_i) { return scene_list[scene_i].kinds; }

// Stages.

int viewer_open(int stage_i, int scene_i, int kind) {
    if (scene_i < 0 || scene_i >= scene_count || kind < 0 || kind >= kind_count || (scene_list[scene_i].kinds >> kind & 1u) == 0) return 0;
    Stage& stage = stage_at(stage_i);
    clear(stage);
    stage.scene = scene_i;
    stage.kind = kind;
    return for_kind(kind, false, [&](auto named) { return set_up<typename decltype(named)::scene>(stage, scene_list[scene_i]); }) ? 1 : 0;
}
int viewer_step(int stage_i, float h) {
    Stage& stage = stage_at(stage_i);
    return for_world(stage, 0, [&](auto& world, [[maybe_unused]] auto named) {
        stage.h = h;
        pull(stage, world, h);
        if constexpr (ingot::has_levels<typename decltype(named)::scene>) walk_on(stage, world, h);
        stage.report = ingot::step(world, h);
        if constexpr (ingot::has_levels<typename decltype(named)::scene>) stroll_on(stage, world, h);
        return static_cast<int>(stage.report.status);
    });
}
uint64_t viewer_hash(int stage_i) {
    Stage& stage = stage_at(stage_i);
    uint64_t hash = for_world(stage, uint64_t(0), [](auto& world, auto) { return world.state_hash(); });
    const uint32_t* const place = reinterpret_cast<const uint32_t*>(&stage.walks.mover.r);  // no world knows of it
    for (int i = 0; i < 3; ++i) hash = hash * 0x100000001b3u ^ place[i];
    return hash;
}
unsigned char* viewer_bytes(int stage_i) { return stages[stage_i & 1]; }
unsigned viewer_size(int stage_i) {
    Stage& stage = stage_at(stage_i);
    const unsigned head = static_cast<unsigned>(stage.world - reinterpret_cast<unsigned char*>(&stage));
    return for_world(stage, head, [&](auto& world, auto) { return head + static_cast<unsigned>(sizeof(world)); });
}

void viewer_input(int stage_i, int what, float a, float b, float c, float d, float e, float f) {
    Stage& stage = stage_at(stage_i);
    for_world(stage, 0, [&](auto& world, auto named) {
        using S = typename decltype(named)::scene;
        if constexpr (ingot::has_shapes<S>) {
            if (what == VIEWER_GRAB) grab(stage, world, static_cast<int>(d), {a, b, c});
            if (what == VIEWER_MOVE) move(stage, world, {a, b, c});
            if (what == VIEWER_RELEASE) release(stage, world);
            if (what == VIEWER_SHOOT) shoot(stage, world, {a, b, c}, {d, e, f});
            if (what == VIEWER_STEER) {
                stage.throttle = a;
                stage.steering = b;
                steer(stage, world);
            }
        }
        return 0;
    });
}

// Reads.

int viewer_pick(int stage_i, float x, float y, float z, float dx, float dy, float dz) {
    return for_world(stage_at(stage_i), -1, [&](auto& world, auto named) {
        using S = typename decltype(named)::scene;
        if constexpr (ingot::has_shapes<S>) {
            const auto hit = world.cast_ray({x, y, z}, {dx, dy, dz});
            if (!hit.ok() || hit.value.body.generation == 0) return -1;
            put(answer, hit.value.P);
            put(answer + 3, hit.value.n);
            answer[6] = world.is_movable(hit.value.body) ? 1.0f : 0.0f;
            return static_cast<int>(hit.value.body.slot);
        }
        return -1;
    });
}
int viewer_body(int stage_i, int slot) {
    const Stage& stage = stage_at(stage_i);
    return for_world(stage_at(stage_i), 0, [&](auto& world, auto named) {
        using S = typename decltype(named)::scene;
        if (slot < 0 && strolls(stage)) {
            put(answer, stage.walks.mover.r);
            return 1;
        }
        const BodyId id = world.body_at(slot);
        if (id.generation == 0) return 0;
        const BodyState state = world.state(id).value;
        put(answer, state.r_CM);
        put(answer + 3, state.A);
        put(answer + 12, state.L);
        put(answer + 15, world.omega(id).value);
        if constexpr (S::translates) {
            put(answer + 18, state.v_CM);
            answer[21] = world.mass(id).value;
        }
        answer[22] = world.kinetic_energy(id).value;
        return 1;
    });
}
int viewer_report(int stage_i) {
    Stage& stage = stage_at(stage_i);
    const ingot::StepReport& report = stage.report;
    const float numbers[] = {static_cast<float>(report.contacts),
                             static_cast<float>(report.sweeps),
                             report.residual,
                             static_cast<float>(report.sweeps_unfinished),
                             static_cast<float>(report.contacts_lost),
                             static_cast<float>(report.impacts_deferred),
                             static_cast<float>(report.spins_clamped),
                             static_cast<float>(report.bodies_frozen),
                             static_cast<float>(report.direct),
                             report.clean() ? 1.0f : 0.0f,
                             static_cast<float>(report.joints_lost)};
    for (unsigned i = 0; i < sizeof(numbers) / sizeof(numbers[0]); ++i) answer[i] = numbers[i];
    return for_world(stage, 0, [&](auto& world, auto named) {
        using S = typename decltype(named)::scene;
        answer[16] = static_cast<float>(world.body_count());
        for (int i = 17; i < 22; ++i) answer[i] = 0;
        if constexpr (S::sleeps) {
            answer[17] = static_cast<float>(world.awake_count());
            answer[18] = static_cast<float>(world.asleep_count());
            answer[19] = static_cast<float>(world.awake_island_count());
            answer[20] = static_cast<float>(world.asleep_island_count());
        } else {
            answer[17] = 1;
        }
        if constexpr (ingot::has_joints<S>) answer[21] = static_cast<float>(world.joint_count());
        return 1;
    });
}
double viewer_energy(int stage_i) {
    return for_world(stage_at(stage_i), 0.0, [](auto& world, auto) { return energy_of(world); });
}
const int32_t* viewer_draw(int stage_i, unsigned colors, float scale) {
    counts[0] = counts[1] = counts[2] = 0;
    ingot::DrawScale sizes;
    sizes.axis = scalar(0.6) * scale;
    const Stage& stage = stage_at(stage_i);
    sizes.impulse = stage.h > 0 ? stage.force_scale / stage.h * scale : 0;
    sizes.L = stage.L_scale * scale;
    return for_world(stage_at(stage_i), static_cast<const int32_t*>(counts), [&](auto& world, auto) {
        draw_stage(world, colors, sizes);
        if (strolls(stage)) draw_mover(stage.walks.mover);
        return static_cast<const int32_t*>(counts);
    });
}
int viewer_level(int stage_i) {
    return for_world(stage_at(stage_i), 0, []([[maybe_unused]] auto& world, auto named) {
        using S = typename decltype(named)::scene;
        int count = 0;
        if constexpr (ingot::has_levels<S>)
            for (int slot = 0; slot < S::max_bodies; ++slot) {
                const BodyId id = world.body_at(slot);
                if (id.generation == 0 || world.shape(id).value.kind != ingot::ShapeKind::level) continue;
                const ingot::LevelTable& level = S::levels[ingot::level_number(world.shape(id).value)];
                const Vector middle = (level.low + level.high) * half;  // where its body is
                ingot::for_triangles_in(level, level.low, level.high, [&](const ingot::LevelTriangle& triangle) {
                    if (count == triangles_max) return;
                    float* const to = triangle_room + count++ * triangle_floats;
                    for (int i = 0; i < 3; ++i) put(to + 3 * i, triangle.corners[i] - middle);
                    to[9] = static_cast<float>(triangle.material);
                });
            }
        return count;
    });
}
const float* viewer_triangles() { return triangle_room; }
const float* viewer_shapes() { return shape_room; }
const float* viewer_lines() { return line_room; }
const float* viewer_points() { return point_room; }
const float* viewer_answer() { return answer; }
/// kg m^2, along the body's axes, of the body of the scene that turns.
const float* viewer_moments() {
    static float moments[3];
    const ingot::MassDistribution box = ingot::with_mass(ingot::solid_box(1000, brick), 1);
    put(moments, Vector{box.I.xx, box.I.yy, box.I.zz});
    return moments;
}
