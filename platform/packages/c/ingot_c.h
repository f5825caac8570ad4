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

/* Worlds there are: bodies, pairs that touch, joints, of which close loops or are rods and ropes, events of a step. All have sleep, kinematic bodies,
 * sensors, filters, limits and drives of joints. Bodies have one shape each, of any kind but hulls and levels, whose tables the compiler makes. */
enum {
    INGOT_SMALL = 0,  /* 16, 48, 8, 4, 32 */
    INGOT_MIDDLE = 1, /* 256, 1024, 64, 16, 512 */
    INGOT_LARGE = 2   /* 4096, 16384, 1024, 64, 4096 */
};

enum { INGOT_SPHERE = 1, INGOT_CAPSULE, INGOT_BOX, INGOT_CYLINDER, INGOT_HALF_SPACE = 6 };
enum { INGOT_MOVABLE = 0, INGOT_IMMOVABLE = 1, INGOT_KINEMATIC = 2 };
enum { INGOT_BALL = 1, INGOT_HINGE, INGOT_SLIDER, INGOT_UNIVERSAL, INGOT_FIXED, INGOT_ROD, INGOT_ROPE };
enum { INGOT_NO_DRIVE = 0, INGOT_SPRING, INGOT_TUNED, INGOT_MOTOR };
enum { INGOT_BEGIN = 0, INGOT_END, INGOT_HIT, INGOT_ENTER, INGOT_LEAVE };
enum { INGOT_HITS_MAX = 64 }; /* of one ray */

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
    uint32_t category, mask; /* bits: what the body is, and what it meets; two meet where each is of a category that the other's mask names */
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

/* What a step tells of two bodies. They are told until the next step; a body that was removed is stale. */
typedef struct IngotEvent {
    int32_t kind;                  /* INGOT_BEGIN ...: they touch, they touch no more, they met faster than 1 m/s; B is in the sensor A, is not */
    IngotBody A, B;
    IngotScalar P[3], n[3], speed; /* m, unit from B to A, m/s at which they met; of INGOT_BEGIN and INGOT_HIT */
} IngotEvent;

/* Where the free directions of a joint end. All of B against A, 0 as they are joined. Zeros: nowhere. */
typedef struct IngotRange {
    int32_t limited; /* 0: it has no ends */
    IngotScalar lower, upper;
} IngotRange;
typedef struct IngotLimits {
    IngotRange range[2];     /* hinge: angle, rad; slider: travel, m; ball: twist; universal: angles about the axes of A and of B */
    IngotScalar cone;        /* rad, of a ball joint: how far its axis swings, 0.01 to 3; 0: it has none */
    IngotScalar restitution; /* 0 to 1 */
} IngotLimits;

/* Of zeros but for kind, bodies, P and axis it is a joint without limits. */
typedef struct IngotJointDef {
    int32_t kind;          /* INGOT_BALL ... */
    IngotBody A, B;        /* 0: the world */
    IngotScalar P[3];      /* m, world; of a rod and a rope on A */
    IngotScalar axis[3];   /* unit, world: of a hinge, a slider, A of a universal joint, B of a ball joint with limits */
    IngotScalar axis_B[3]; /* of B of a universal joint, at right angles to axis; zeros: x */
    IngotScalar P_B[3];    /* m, world, on B: of a rod and a rope */
    IngotScalar length;    /* m, of a rod and a rope; 0: as far as they are now */
    IngotLimits limits;
    int32_t bodies_meet;   /* 1: the two may touch each other */
} IngotJointDef;

/* Torque feedforward - stiffness (angle - target) - damping (rate - target_rate), implicit; of a slider read force and travel. */
typedef struct IngotDrive {
    int32_t kind;                   /* INGOT_SPRING; INGOT_TUNED: stiffness in Hz, damping as a ratio; INGOT_MOTOR: keeps target_rate; 0: none */
    IngotScalar stiffness, damping; /* N m/rad, N m s/rad */
    IngotScalar target, target_rate, feedforward; /* rad, rad/s, N m */
    IngotScalar max_torque;         /* N m; 0: no bound */
} IngotDrive;

/* How a joint stands; what its kind has not is 0. */
typedef struct IngotJointState {
    IngotScalar angle[2], rate[2]; /* rad, rad/s: hinge; universal about A, B; ball: twist, swing */
    IngotScalar travel, speed;     /* m, m/s: slider */
    IngotScalar length, distance;  /* m: rod, rope: as it should be, as it is */
    IngotScalar torque[3];         /* N m, of a slider N: what drives gave in the last step; of a ball joint in the axes of A */
    IngotScalar gap;               /* m: how far its sides are apart where they should not be */
} IngotJointState;

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
INGOT_C_API void ingot_body_def(IngotBodyDef* def); /* all zero, but A = 1, friction 0.5, density 1000, category 1, mask all */
INGOT_C_API IngotStatus ingot_add_body(IngotWorld* world, const IngotBodyDef* def, IngotBody* body);
INGOT_C_API IngotStatus ingot_remove_body(IngotWorld* world, IngotBody body);
INGOT_C_API int32_t ingot_body_count(const IngotWorld* world);
INGOT_C_API IngotStatus ingot_state(const IngotWorld* world, IngotBody body, IngotState* state);
INGOT_C_API IngotStatus ingot_set_state(IngotWorld* world, IngotBody body, const IngotState* state);
INGOT_C_API IngotStatus ingot_mass(const IngotWorld* world, IngotBody body, IngotScalar* mass); /* kg; 0 of what does not move by forces */
INGOT_C_API IngotStatus ingot_set_filter(IngotWorld* world, IngotBody body, uint32_t category, uint32_t mask);
/* Kinematic bodies: to a pose by the end of the next step, pushing what is in the way; or on and on with a velocity, m/s, rad/s. */
INGOT_C_API IngotStatus ingot_move_to(IngotWorld* world, IngotBody body, const IngotScalar r[3], const IngotScalar A[9]);
INGOT_C_API IngotStatus ingot_set_velocity(IngotWorld* world, IngotBody body, const IngotScalar v[3], const IngotScalar omega[3]);
/* Of the next step, at a point of the world: N, m. A torque: N m. */
INGOT_C_API IngotStatus ingot_add_force(IngotWorld* world, IngotBody body, const IngotScalar F[3], const IngotScalar P[3]);
INGOT_C_API IngotStatus ingot_add_torque(IngotWorld* world, IngotBody body, const IngotScalar tau[3]);
/* At once: N s, m; N m s. */
INGOT_C_API IngotStatus ingot_apply_impulse(IngotWorld* world, IngotBody body, const IngotScalar j[3], const IngotScalar P[3]);
INGOT_C_API IngotStatus ingot_apply_angular_impulse(IngotWorld* world, IngotBody body, const IngotScalar k[3]);
INGOT_C_API int32_t ingot_is_asleep(const IngotWorld* world, IngotBody body);
INGOT_C_API IngotStatus ingot_wake(IngotWorld* world, IngotBody body);  /* and what it hangs together with */
INGOT_C_API IngotStatus ingot_sleep(IngotWorld* world, IngotBody body);

/* Contacts of the last step, and what is on a way. */
INGOT_C_API int32_t ingot_contact_count(const IngotWorld* world);
INGOT_C_API IngotStatus ingot_contact(const IngotWorld* world, int32_t index, IngotContact* contact);
INGOT_C_API IngotStatus ingot_cast_ray(const IngotWorld* world, const IngotScalar from[3], const IngotScalar way[3], IngotHit* hit);
/* All bodies on the way, as they are met, into hits[capacity], INGOT_HITS_MAX of them at most; count: how many there are, which may be more. */
INGOT_C_API IngotStatus ingot_cast_ray_all(const IngotWorld* world, const IngotScalar from[3], const IngotScalar way[3], IngotHit* hits,
                                           int32_t capacity, int32_t* count);
/* Events of the last step, in an order that is the same everywhere. */
INGOT_C_API int32_t ingot_event_count(const IngotWorld* world);
INGOT_C_API IngotStatus ingot_event(const IngotWorld* world, int32_t index, IngotEvent* event);

/* Joints. */
INGOT_C_API IngotStatus ingot_add_joint(IngotWorld* world, const IngotJointDef* def, IngotJoint* joint);
INGOT_C_API IngotStatus ingot_remove_joint(IngotWorld* world, IngotJoint joint);
INGOT_C_API IngotStatus ingot_joint_gap(const IngotWorld* world, IngotJoint joint, IngotScalar* gap); /* m */
INGOT_C_API IngotStatus ingot_joint_state(const IngotWorld* world, IngotJoint joint, IngotJointState* state);
INGOT_C_API IngotStatus ingot_set_joint_limits(IngotWorld* world, IngotJoint joint, const IngotLimits* limits);
/* which: 0, and 1 of a universal joint about the axis of B. */
INGOT_C_API IngotStatus ingot_set_joint_drive(IngotWorld* world, IngotJoint joint, const IngotDrive* drive, int32_t which);
/* Of a ball joint to a turn of B against A, a vector in the axes of A, rad; target and target_rate of drive are not looked at. */
INGOT_C_API IngotStatus ingot_set_ball_drive(IngotWorld* world, IngotJoint joint, const IngotDrive* drive, const IngotScalar target[3]);
INGOT_C_API IngotStatus ingot_set_joint_target(IngotWorld* world, IngotJoint joint, IngotScalar target, IngotScalar target_rate, int32_t which);
INGOT_C_API IngotStatus ingot_set_joint_length(IngotWorld* world, IngotJoint joint, IngotScalar length); /* m, of a rod and a rope */

#ifdef __cplusplus
}
#endif

#endif
