/* SPDX-License-Identifier: MIT */
/* A column of five boxes and a pendulum; a kick; a step is played again from a snapshot. Prints the hash of each world of the catalogue. */
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
    IngotJointDef hinge = {INGOT_HINGE, 0, 0, {3, 0, 4}, {0, 1, 0}};
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
    hinge.B = bob;
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

int main(void) {
    int32_t which;
    for (which = INGOT_SMALL; which <= INGOT_LARGE; ++which) {
        const size_t size = ingot_world_size(which), alignment = ingot_world_alignment();
        char* const memory = malloc(size + alignment);
        char* const at = memory + (alignment - (uintptr_t)memory % alignment) % alignment;
        IngotWorld* const world = ingot_world_begin(which, at, size);
        CHECK(world != NULL && ingot_world_begin(which, at, size - 1) == NULL && ingot_world_begin(which, at + 1, size) == NULL);
        if (world != NULL) printf("%016llx\n", (unsigned long long)tell(world, which));
        memset(at, 0, sizeof(uint32_t));
        CHECK(ingot_step(world, 0.015625f, NULL) == INGOT_NO_WORLD && ingot_body_count(world) == 0);
        free(memory);
    }
    CHECK(ingot_world_size(3) == 0 && ingot_world_size(-1) == 0 && ingot_world_begin(3, &which, 4) == NULL);
    CHECK(ingot_step(NULL, 0.015625f, NULL) == INGOT_NO_WORLD && ingot_state_hash(NULL) == 0);
    return failed;
}
