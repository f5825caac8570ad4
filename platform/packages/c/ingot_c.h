/* SPDX-License-Identifier: MIT */
/* ingot for C99, and for what speaks to C: Python's ctypes, Rust, C#, Lua.
 *
 * A world is one of a catalogue, in memory of the caller: bytes that can be copied, kept and put back with memcpy, to memory of the same alignment.
 *
 *     IngotWorld* world = ingot_world_begin(INGOT_SMALL, memory, size_of_memory);   ingot_world_size(INGOT_SMALL) bytes
 *     IngotBodyDef def;
 *     ingot_body_def(&def);
 *     def.shape = INGOT_BOX;
 *     def.size[0] = def.size[1] = def.size[2] = 0.5f;
 *     IngotBody crate;
 *     if (ingot_add_body(world, &def, &crate) != 0) ...
 *     ingot_step(world, 1.0f / 60, &report);
 *
 * Calls answer 0, or a number whose sentence ingot_status_name has, and have then changed nothing; what is given out is zero then. Units are SI;
 * vectors are in world axes, a matrix A is nine numbers, the columns one after another: a body's axes as the world sees them. Nothing allocates, and
 * nothing is kept but in the world. A world of NULL, or of memory that is none, is answered with INGOT_NO_WORLD. Other pointers point to something,
 * but where NULL is said to mean something. Bodies and joints of one world mean nothing in another, and are not told apart there. */
#ifndef INGOT_C_H
#define INGOT_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(INGOT_C_BUILDS)
#define INGOT_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define INGOT_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define INGOT_C_API __attribute__((visibility("default")))
#else
#define INGOT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* As the library was built: ingot_scalar_size() tells those who cannot read this. */
#if defined(INGOT_DOUBLE) && INGOT_DOUBLE
typedef double IngotScalar;
#else
typedef float IngotScalar;
#endif

/* Worlds there are: bodies, pairs that touch, joints. All have every shape but hulls, sleep, kinematic bodies and sensors. */
enum {
    INGOT_SMALL = 0,  /* 16, 48, 8 */
    INGOT_MIDDLE = 1, /* 256, 1024, 64 */
    INGOT_LARGE = 2   /* 4096, 16384, 1024 */
};

enum { INGOT_SPHERE = 1, INGOT_CAPSULE, INGOT_BOX, INGOT_CYLINDER, INGOT_HALF_SPACE = 6 };
enum { INGOT_MOVABLE = 0, INGOT_IMMOVABLE = 1, INGOT_KINEMATIC = 2 };
enum { INGOT_BALL = 1, INGOT_HINGE, INGOT_SLIDER, INGOT_UNIVERSAL, INGOT_FIXED };

enum { INGOT_OK = 0, INGOT_NO_WORLD = 255 };
typedef int32_t IngotStatus;

typedef struct IngotWorld IngotWorld;
typedef uint64_t IngotBody;  /* 0: none */
typedef uint64_t IngotJoint; /* 0: none */

typedef struct IngotBodyDef {
    int32_t kind;           /* INGOT_MOVABLE ... */
    int32_t shape;          /* INGOT_SPHERE ...; 0: none */
    IngotScalar size[3];    /* sphere: radius; capsule, cylinder, along z: radius, half length; box: half extents; half space: outward unit normal */
    IngotScalar offset;     /* m, of the face of a half space */
    IngotScalar density;    /* kg/m^3 */
    IngotScalar r[3], A[9]; /* m; a rotation */
    IngotScalar v[3], omega[3];
    IngotScalar restitution, friction;
    int32_t sensor;
} IngotBodyDef;

typedef struct IngotState {
    IngotScalar r[3], v[3], A[9], L[3]; /* of a kinematic body L is its angular velocity, as in BodyState */
} IngotState;

typedef struct IngotReport {
    int32_t contacts, contacts_lost, bodies_frozen, sweeps, sweeps_unfinished;
    IngotScalar residual; /* m/s */
    int32_t clean;        /* 1: the step did all it was asked for */
} IngotReport;

typedef struct IngotHit {
    IngotBody body;       /* 0: the ray meets none */
    IngotScalar fraction; /* of the way */
    IngotScalar P[3], n[3];
} IngotHit;

typedef struct IngotContact {
    IngotBody A, B;
    IngotScalar n[3];            /* from B to A */
    IngotScalar separation, j;   /* m, N s */
    int32_t point_count;
    IngotScalar P[4][3];
} IngotContact;

typedef struct IngotJointDef {
    int32_t kind;    /* INGOT_BALL ... */
    IngotBody A, B;  /* 0: the world */
    IngotScalar P[3], axis[3];
} IngotJointDef;

/* The library. */
INGOT_C_API uint32_t ingot_determinism_version(void);
INGOT_C_API size_t ingot_scalar_size(void);
INGOT_C_API const char* ingot_status_name(IngotStatus status);

/* Worlds. Size 0: there is none of this number. */
INGOT_C_API size_t ingot_world_size(int32_t which);
INGOT_C_API size_t ingot_world_alignment(void);
/* An empty world in the caller's memory. NULL: no such world, too few bytes, or not aligned. There is no end: memory that is not used is free. */
INGOT_C_API IngotWorld* ingot_world_begin(int32_t which, void* memory, size_t bytes);
INGOT_C_API IngotStatus ingot_set_gravity(IngotWorld* world, const IngotScalar g[3]);
INGOT_C_API IngotStatus ingot_step(IngotWorld* world, IngotScalar h, IngotReport* report); /* report: or NULL */
INGOT_C_API uint64_t ingot_state_hash(const IngotWorld* world);                            /* 0: no world */
INGOT_C_API IngotScalar ingot_kinetic_energy(const IngotWorld* world);                     /* J */
/* The portable form. Size 0: no such world, or not enough bytes. */
INGOT_C_API size_t ingot_snapshot_size(int32_t which);
INGOT_C_API size_t ingot_save_snapshot(const IngotWorld* world, void* bytes, size_t room);
INGOT_C_API IngotStatus ingot_load_snapshot(IngotWorld* world, const void* bytes, size_t size);

/* Bodies. */
INGOT_C_API void ingot_body_def(IngotBodyDef* def); /* all zero, but A = 1, friction 0.5, density 1000 */
INGOT_C_API IngotStatus ingot_add_body(IngotWorld* world, const IngotBodyDef* def, IngotBody* body);
INGOT_C_API IngotStatus ingot_remove_body(IngotWorld* world, IngotBody body);
INGOT_C_API int32_t ingot_body_count(const IngotWorld* world);
INGOT_C_API IngotStatus ingot_state(const IngotWorld* world, IngotBody body, IngotState* state);
INGOT_C_API IngotStatus ingot_set_state(IngotWorld* world, IngotBody body, const IngotState* state);
INGOT_C_API IngotStatus ingot_move_to(IngotWorld* world, IngotBody body, const IngotScalar r[3], const IngotScalar A[9]);
INGOT_C_API IngotStatus ingot_add_force(IngotWorld* world, IngotBody body, const IngotScalar F[3], const IngotScalar P[3]);
INGOT_C_API IngotStatus ingot_apply_impulse(IngotWorld* world, IngotBody body, const IngotScalar j[3], const IngotScalar P[3]);
INGOT_C_API int32_t ingot_is_asleep(const IngotWorld* world, IngotBody body);

/* Contacts of the last step, and what is on a way. */
INGOT_C_API int32_t ingot_contact_count(const IngotWorld* world);
INGOT_C_API IngotStatus ingot_contact(const IngotWorld* world, int32_t index, IngotContact* contact);
INGOT_C_API IngotStatus ingot_cast_ray(const IngotWorld* world, const IngotScalar from[3], const IngotScalar way[3], IngotHit* hit);

/* Joints. */
INGOT_C_API IngotStatus ingot_add_joint(IngotWorld* world, const IngotJointDef* def, IngotJoint* joint);
INGOT_C_API IngotStatus ingot_remove_joint(IngotWorld* world, IngotJoint joint);
INGOT_C_API IngotStatus ingot_joint_gap(const IngotWorld* world, IngotJoint joint, IngotScalar* gap); /* m */

#ifdef __cplusplus
}
#endif

#endif
