/* SPDX-License-Identifier: MIT */
/* Two stories. A column of five boxes and a pendulum; a kick; a step is played again from a snapshot. And machines: an arm with a servo and limits, a
 * ball joint with a cone and a spring, a cart with a motor, a rod, a rope, what is fixed; a sensor, a ghost, a platform; events. Prints both hashes of
 * each world of the catalogue. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ingot_c.h"

static int failed = 0;
#define CHECK(what)                                                    \
    do {                                                               \
        if (!(what)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #what); \
            failed = 1;                                                \
        }                                                              \
    } while (0)

static uint64_t tell(IngotWorld* world, int32_t which) {
    static const IngotScalar g[3] = {0, 0, -9.75f}, kick[3] = {60, 20, 0}, origin[3] = {0, 0, 10}, down[3] = {0, 0, -20};
    IngotBodyDef def;
    IngotBody ground, boxes[5], bob;
    IngotJointDef hinge;
    IngotJoint joint;
    IngotReport report;
    IngotState state, before;
    IngotHit hit;
    IngotContact contact;
    IngotScalar gap;
    void* snapshot;
    size_t size;
    uint64_t hash;
    int i;

    CHECK(ingot_set_gravity(world, g) == INGOT_OK);
    ingot_body_def(&def);
    def.kind = INGOT_IMMOVABLE;
    def.shape = INGOT_HALF_SPACE;
    def.size[2] = 1;
    CHECK(ingot_add_body(world, &def, &ground) == INGOT_OK);
    for (i = 0; i < 5; ++i) {
        ingot_body_def(&def);
        def.shape = INGOT_BOX;
        def.size[0] = def.size[1] = def.size[2] = 0.25f;
        def.density = 500;
        def.r[2] = 0.25f + 0.5f * (IngotScalar)i;
        CHECK(ingot_add_body(world, &def, &boxes[i]) == INGOT_OK);
    }
    ingot_body_def(&def);
    def.shape = INGOT_SPHERE;
    def.size[0] = 0.25f;
    def.r[0] = 2;
    def.r[2] = 4;
    def.omega[1] = 0.5f;
    CHECK(ingot_add_body(world, &def, &bob) == INGOT_OK);
    memset(&hinge, 0, sizeof hinge);
    hinge.kind = INGOT_HINGE;
    hinge.B = bob;
    hinge.P[0] = 3;
    hinge.P[2] = 4;
    hinge.axis[1] = 1;
    CHECK(ingot_add_joint(world, &hinge, &joint) == INGOT_OK);

    for (i = 0; i < 60; ++i) CHECK(ingot_step(world, 0.015625f, &report) == INGOT_OK && report.clean);
    CHECK(ingot_contact_count(world) == 5 && ingot_contact(world, 0, &contact) == INGOT_OK && contact.A == ground && contact.B == boxes[0]);
    CHECK(contact.point_count == 4 && contact.n[2] == -1 && contact.j > 0);
    CHECK(ingot_cast_ray(world, origin, down, &hit) == INGOT_OK && hit.body == boxes[4] && hit.n[2] > 0.99f);
    CHECK(ingot_joint_gap(world, joint, &gap) == INGOT_OK && gap < 1e-4f);
    CHECK(ingot_apply_impulse(world, boxes[4], kick, hit.P) == INGOT_OK);
    size = ingot_snapshot_size(which);
    snapshot = malloc(size);
    size = ingot_save_snapshot(world, snapshot, size);
    CHECK(size > 0 && ingot_state(world, bob, &before) == INGOT_OK);
    for (i = 0; i < 60; ++i) CHECK(ingot_step(world, 0.015625f, NULL) == INGOT_OK);
    hash = ingot_state_hash(world);
    CHECK(ingot_load_snapshot(world, snapshot, size) == INGOT_OK);
    CHECK(ingot_state(world, bob, &state) == INGOT_OK && memcmp(&state, &before, sizeof state) == 0);
    for (i = 0; i < 60; ++i) CHECK(ingot_step(world, 0.015625f, NULL) == INGOT_OK);
    CHECK(ingot_state_hash(world) == hash);
    free(snapshot);

    CHECK(ingot_body_count(world) == 7 && ingot_remove_joint(world, joint) == INGOT_OK && ingot_remove_body(world, bob) == INGOT_OK);
    CHECK(ingot_state(world, bob, &state) == 2 && strncmp(ingot_status_name(2), "stale_id", 8) == 0 && state.A[0] == 0);
    CHECK(ingot_add_body(world, &def, &bob) == INGOT_OK && ingot_is_asleep(world, bob) == 0 && ingot_kinetic_energy(world) >= 0);
    def.shape = 5;
    CHECK(ingot_add_body(world, &def, &bob) != INGOT_OK && bob == 0);
    hinge.kind = 9;
    CHECK(ingot_add_joint(world, &hinge, &joint) != INGOT_OK && joint == 0);
    return hash;
}

/* A body with a shape of this size at r. */
static IngotBody put(IngotWorld* world, int32_t kind, int32_t shape, IngotScalar size, IngotScalar x, IngotScalar y, IngotScalar z) {
    IngotBodyDef def;
    IngotBody body;
    ingot_body_def(&def);
    def.kind = kind;
    def.shape = shape;
    def.size[0] = def.size[1] = def.size[2] = size;
    def.r[0] = x;
    def.r[1] = y;
    def.r[2] = z;
    CHECK(ingot_add_body(world, &def, &body) == INGOT_OK);
    return body;
}
static IngotJoint join(IngotWorld* world, int32_t kind, IngotBody B, IngotScalar y, IngotScalar z, const IngotLimits* limits) {
    IngotJointDef def;
    IngotJoint joint;
    IngotState state;
    memset(&def, 0, sizeof def);
    CHECK(ingot_state(world, B, &state) == INGOT_OK);
    memcpy(def.P_B, state.r, sizeof def.P_B);
    def.kind = kind;
    def.B = B;
    def.P[1] = y;
    def.P[2] = z;
    def.axis[kind == INGOT_HINGE ? 1 : kind == INGOT_SLIDER ? 0 : 2] = 1;
    if (limits != NULL) def.limits = *limits;
    CHECK(ingot_add_joint(world, &def, &joint) == INGOT_OK);
    return joint;
}
static int is_near(IngotScalar a, IngotScalar b, IngotScalar within) { return a - b < within && b - a < within; }

static uint64_t machines(IngotWorld* world) {
    static const IngotScalar g[3] = {0, 0, -9.75f}, along[3] = {0.5f, 0, 0}, still[3] = {0, 0, 0}, spin[3] = {0, 0, 0.125f}, far[3] = {-9, 20, 0.5f},
                             way[3] = {20, 0, 0}, aside[3] = {0.25f, 0, 0};
    IngotDrive servo = {INGOT_TUNED, 2, 1, 0.125f, 0, 0, 0}, spring = {INGOT_SPRING, 40, 4, 0, 0, 0, 0};
    const IngotDrive motor = {INGOT_MOTOR, 0, 0, 0, 0.5f, 0, 4000};
    IngotLimits swing, rail, cone;
    IngotBodyDef sphere;
    IngotBody ground, arm, bob, cart, hung, roped, ghost, sensor, platform, rider, twin, dropped;
    IngotJoint hinge, ball, slider, rod, rope, fixed;
    IngotJointState joint;
    IngotEvent event;
    IngotHit hits[4];
    IngotScalar mass;
    int32_t count = 0, told[5] = {0, 0, 0, 0, 0}, i, step;

    memset(&swing, 0, sizeof swing);
    rail = cone = swing;
    swing.range[0].limited = rail.range[0].limited = 1;
    swing.range[0].lower = -0.5f;
    swing.range[0].upper = 0.25f;
    rail.range[0].upper = 0.25f;
    cone.cone = 0.5f;
    CHECK(ingot_set_gravity(world, g) == INGOT_OK);
    ingot_body_def(&sphere);
    sphere.kind = INGOT_IMMOVABLE;
    sphere.shape = INGOT_HALF_SPACE;
    sphere.size[2] = 1;
    CHECK(ingot_add_body(world, &sphere, &ground) == INGOT_OK);
    arm = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 1, 0, 2);
    bob = put(world, INGOT_MOVABLE, INGOT_SPHERE, 0.25f, 0, 4, 2);
    cart = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 0, 8, 1);
    hung = put(world, INGOT_MOVABLE, INGOT_SPHERE, 0.25f, 0.5f, 12, 2);
    roped = put(world, INGOT_MOVABLE, INGOT_SPHERE, 0.25f, 0.5f, 16, 2);
    twin = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 0.5f, 24, 2);
    platform = put(world, INGOT_KINEMATIC, INGOT_BOX, 0.25f, 0, 20, 0.5f);
    rider = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 0, 20, 1);
    ghost = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 8, 0, 1);
    dropped = put(world, INGOT_MOVABLE, INGOT_BOX, 0.25f, 12, 0, 1);
    sphere.kind = INGOT_IMMOVABLE;
    sphere.shape = INGOT_SPHERE;
    sphere.size[0] = 1;
    sphere.r[0] = 12;
    sphere.sensor = 1;
    CHECK(ingot_add_body(world, &sphere, &sensor) == INGOT_OK);
    hinge = join(world, INGOT_HINGE, arm, 0, 2, &swing);
    ball = join(world, INGOT_BALL, bob, 4, 3, &cone);
    slider = join(world, INGOT_SLIDER, cart, 8, 1, &rail);
    rod = join(world, INGOT_ROD, hung, 12, 3, NULL);
    rope = join(world, INGOT_ROPE, roped, 16, 3, NULL);
    fixed = join(world, INGOT_FIXED, twin, 24, 2, NULL);
    CHECK(ingot_set_joint_drive(world, hinge, &servo, 0) == INGOT_OK && ingot_set_ball_drive(world, ball, &spring, aside) == INGOT_OK);
    CHECK(ingot_set_joint_drive(world, slider, &motor, 0) == INGOT_OK && ingot_set_joint_length(world, rope, 1.25f) == INGOT_OK);
    CHECK(ingot_set_filter(world, ghost, 2, 0) == INGOT_OK && ingot_set_velocity(world, platform, along, still) == INGOT_OK);
    CHECK(ingot_apply_angular_impulse(world, hung, spin) == INGOT_OK);
    for (step = 0; step < 90; ++step) {
        CHECK(ingot_add_torque(world, bob, spin) == INGOT_OK && ingot_step(world, 0.015625f, NULL) == INGOT_OK);
        for (i = 0; i < ingot_event_count(world); ++i) {
            CHECK(ingot_event(world, i, &event) == INGOT_OK && event.kind >= 0 && event.kind <= INGOT_LEAVE);
            ++told[event.kind];
            if (event.kind == INGOT_HIT) CHECK(event.B == dropped || event.A == dropped);
        }
    }
    CHECK(told[INGOT_BEGIN] == 2 && told[INGOT_HIT] == 1 && told[INGOT_ENTER] == 1 && told[INGOT_LEAVE] == 0);
    CHECK(ingot_joint_state(world, hinge, &joint) == INGOT_OK && joint.angle[0] > 0.125f); /* it gives way: what it gives bears the arm of 125 kg */
    CHECK(is_near(joint.torque[0], -125 * 9.75f * (1 - joint.angle[0] * joint.angle[0] / 2), 1));
    CHECK(ingot_set_joint_target(world, hinge, 1, 0, 0) == INGOT_OK);
    CHECK(ingot_joint_state(world, ball, &joint) == INGOT_OK && joint.torque[0] != 0);
    CHECK(ingot_joint_state(world, slider, &joint) == INGOT_OK && is_near(joint.travel, 0.25f, 0.001f));
    CHECK(ingot_joint_state(world, rod, &joint) == INGOT_OK && is_near(joint.distance, joint.length, 1e-4f) && joint.angle[0] == 0);
    CHECK(ingot_joint_state(world, rope, &joint) == INGOT_OK && joint.length == 1.25f && joint.distance < 1.2501f);
    CHECK(ingot_joint_state(world, fixed, &joint) == INGOT_OK && joint.gap < 1e-4f);
    CHECK(ingot_cast_ray_all(world, far, way, hits, 4, &count) == INGOT_OK && count == 1 && hits[0].body == platform);
    CHECK(ingot_mass(world, twin, &mass) == INGOT_OK && is_near(mass, 125, 1e-3f) && ingot_mass(world, ground, &mass) == INGOT_OK && mass == 0);
    CHECK(ingot_sleep(world, rider) != INGOT_NO_WORLD && ingot_wake(world, rider) == INGOT_OK);
    swing.range[0].upper = 0.5f;
    CHECK(ingot_set_joint_limits(world, hinge, &swing) == INGOT_OK);
    CHECK(ingot_remove_body(world, dropped) == INGOT_OK);
    for (step = 0; step < 90; ++step) CHECK(ingot_step(world, 0.015625f, NULL) == INGOT_OK);
    CHECK(ingot_joint_state(world, hinge, &joint) == INGOT_OK && is_near(joint.angle[0], 0.5f, 0.001f));
    CHECK(ingot_set_joint_limits(world, rod, &swing) != INGOT_OK && ingot_event(world, -1, &event) != INGOT_OK && event.A == 0);
    servo.kind = 4;
    CHECK(ingot_set_joint_drive(world, hinge, &servo, 0) != INGOT_OK);
    return ingot_state_hash(world);
}

int main(void) {
    int32_t which;
    for (which = INGOT_SMALL; which <= INGOT_LARGE; ++which) {
        const size_t size = ingot_world_size(which), alignment = ingot_world_alignment();
        char* const memory = malloc(size + alignment);
        char* const at = memory + (alignment - (uintptr_t)memory % alignment) % alignment;
        IngotWorld* const world = ingot_world_begin(which, at, size);
        CHECK(world != NULL && ingot_world_begin(which, at, size - 1) == NULL && ingot_world_begin(which, at + 1, size) == NULL);
        if (world != NULL) printf("%016llx\n", (unsigned long long)tell(world, which));
        if (ingot_world_begin(which, at, size) == world) printf("%016llx\n", (unsigned long long)machines(world));
        memset(at, 0, sizeof(uint32_t));
        CHECK(ingot_step(world, 0.015625f, NULL) == INGOT_NO_WORLD && ingot_body_count(world) == 0);
        free(memory);
    }
    CHECK(ingot_world_size(3) == 0 && ingot_world_size(-1) == 0 && ingot_world_begin(3, &which, 4) == NULL);
    CHECK(ingot_step(NULL, 0.015625f, NULL) == INGOT_NO_WORLD && ingot_state_hash(NULL) == 0);
    return failed;
}
