// SPDX-License-Identifier: MIT
// Compiles as it is, and with none of the macros that CMakeLists.txt defines one by one.
#ifdef LANES_OF_LIBRARY
#undef INGOT_LANES
#define INGOT_LANES 3
#endif
#ifdef FAST_MATH
#define __FAST_MATH__ 1
#endif
#ifdef FLUSHING_MVE
#define __ARM_FEATURE_MVE 3
#endif
#ifdef FLUSHING_ALTIVEC
#define __ALTIVEC__ 1
#endif
#ifdef FLUSHING_NEON
#define __clang__ 1
#define __ARM_NEON 1
#endif
#ifdef DOUBLE_OF_LIBGCC
#define __arm__ 1
#undef INGOT_DOUBLE
#define INGOT_DOUBLE 1
#endif
#ifdef WIDE_REGISTERS
#include <float.h>
#undef FLT_EVAL_METHOD
#define FLT_EVAL_METHOD 2
#endif
#include <ingot/ingot.h>

#ifdef STATUS_IGNORED
#pragma GCC diagnostic error "-Wunused-result"
#endif

inline constexpr auto tetrahedron = ingot::convex_hull<4>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
inline constexpr auto flat = ingot::convex_hull<4>({{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}});

/// A field that changes with the time.
struct Gusts : ingot::ForceField {
    ingot::Wrench operator()(const ingot::BodyMotion& body) const { return ingot::Wrench::force(body.v_CM * ingot::splat<ingot::lane>(body.t)); }
};

/// Workers that do nothing.
template <int count>
struct Workers {
    static constexpr int workers = count;
    template <class Task>
    static void run(int, Task&) {}
};

/// By names that are checked, which are the same traits.
struct Checked : ingot::Scene {
    INGOT_TRAIT(max_bodies) = 3;
    INGOT_TRAIT(translates) = true;
    INGOT_TRAIT(length_unit) = 2;
    INGOT_TRAIT(effort) = ingot::low_effort;
    INGOT_TRAIT_TYPE(rotation) = ingot::LieMidpoint;
#ifdef MISSPELT_NUMBER
    INGOT_TRAIT(max_contcts) = 4;
#endif
#ifdef MISSPELT_TYPE
    INGOT_TRAIT_TYPE(solvr) = ingot::FrictionlessImpacts;
#endif
};
static_assert(Checked::max_bodies == 3 && Checked::translates && Checked::length_unit == 2 && Checked::effort.substeps == ingot::low_effort.substeps);
static_assert(Checked::max_contacts == 0 && __is_same(Checked::rotation, ingot::LieMidpoint));

#ifdef NOT_A_SCENE
struct Wrong {
#else
struct Wrong : ingot::Scene {
#endif
#ifdef CONTACTS_WITHOUT_SHAPES
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
#endif
#ifdef NO_BODIES
    static constexpr int max_bodies = 0;
#endif
#ifdef TOO_MANY_BODIES
    static constexpr int max_bodies = 65537;
#endif
#ifdef TOO_MANY_CONTACTS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 65536;
    using solver = ingot::FrictionlessImpacts;
#endif
#ifdef TOO_MANY_MANIFOLDS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 65535;
#endif
#ifdef IMPACTS_AND_MANIFOLDS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 4;
    static constexpr int max_manifolds = 4;
#endif
#ifdef TOO_MANY_PAIRS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    static constexpr int max_pairs = 65536;
#endif
#ifdef TOO_MANY_PAIRS_OF_MANIFOLDS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 40000;
#endif
#ifdef TOO_MANY_BODIES_WITH_MANIFOLDS
    static constexpr bool translates = true;
    static constexpr int max_bodies = 65536;
    static constexpr int max_manifolds = 4;
#endif
#ifdef MANIFOLDS_OF_LISTING1
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using rotation = ingot::Listing1Euler;
#endif
#ifdef MANIFOLDS_WITHOUT_TRANSLATION
    static constexpr int max_manifolds = 4;
#endif
#ifdef CONTACTS_READ_WITHOUT_SHAPES
    static constexpr bool translates = true, reads_contacts = true;
#endif
#ifdef CONTACTS_WITHOUT_THEIR_SOLVER
    static constexpr bool translates = true;
    static constexpr int max_contacts = 4;
    using shapes = ingot::Shapes<ingot::Sphere>;
#endif
#ifdef ISLANDS_WITHOUT_MANIFOLDS
    using solver = ingot::HybridIslands<>;
#endif
#ifdef MANIFOLDS_OF_IMPACTS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere>;
#endif
#ifdef COLLIDES_BUT_DOES_NOT_TRANSLATE
    static constexpr int max_contacts = 4;
    using solver = ingot::FrictionlessImpacts;
#endif
#ifdef HULLS_OF_IMPACTS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 4;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Hull>;
    static constexpr ingot::ConvexHull hulls[] = {tetrahedron.value.view()};
#endif
#ifdef HULL_WITHOUT_HULLS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using shapes = ingot::Shapes<ingot::Hull>;
#endif
#ifdef HULLS_WITHOUT_HULL
    static constexpr ingot::ConvexHull hulls[] = {tetrahedron.value.view()};
#endif
#ifdef HULL_OF_NOTHING
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using shapes = ingot::Shapes<ingot::Hull>;
    static constexpr ingot::ConvexHull hulls[] = {tetrahedron.value.view(), flat.value.view()};
#endif
#ifdef NO_SHAPES_OF_BODY
    static constexpr int max_shapes_of_body = 0;
#endif
#ifdef COMPOUNDS_WITHOUT_CONTACTS
    static constexpr int max_shapes_of_body = 2;
#endif
#ifdef TOO_MANY_SHAPES
    static constexpr bool translates = true;
    static constexpr int max_bodies = 20000, max_manifolds = 4, max_shapes_of_body = 4;
#endif
#ifdef TOO_MANY_PAIRS_OF_SHAPES
    static constexpr bool translates = true;
    static constexpr int max_bodies = 1000, max_manifolds = 4, max_shapes_of_body = 12;
#endif
#ifdef NOTHING_BOUNCES_WITHOUT_CONTACTS
    static constexpr bool bounces = false;
#endif
#ifdef POINT_SWEEPS_WITHOUT_CONTACTS
    static constexpr bool bounces = false;
    using solver = ingot::SequentialImpulses;
#endif
#ifdef NOTHING_BOUNCES_DIRECTLY
    static constexpr int max_manifolds = 4;
    static constexpr bool bounces = false;
    using solver = ingot::HybridIslands<>;
#endif
#ifdef FILTERS_WITHOUT_CONTACTS
    static constexpr bool filters = true;
#endif
#ifdef TOO_MANY_OVERLAPS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4, max_overlaps = 65536;
#endif
#ifdef SENSORS_WITHOUT_CONTACTS
    static constexpr int max_overlaps = 4;
#endif
#ifdef TOO_MANY_EVENTS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4, max_events = 65536;
#endif
#ifdef EVENTS_WITHOUT_CONTACTS
    static constexpr int max_events = 4;
#endif
#ifdef CONTINUOUS_WITHOUT_CONTACTS
    static constexpr bool continuous = true;
#endif
#ifdef HIT_SPEED_BELOW_ZERO
    static constexpr ingot::scalar hit_speed = -1;
#endif
#ifdef SLEEP_WITHOUT_CONTACTS
    static constexpr bool sleeps = true;
#endif
#ifdef SLEEP_IN_A_FIELD
    static constexpr bool translates = true, sleeps = true;
    static constexpr int max_manifolds = 4;
    using force_field = Gusts;
#endif
#ifdef LENGTH_UNIT_WITHOUT_CONTACTS
    static constexpr ingot::scalar length_unit = 2;
#endif
#ifdef LENGTH_UNIT_OF_NO_THING
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using shapes = ingot::Shapes<ingot::Sphere>;
    static constexpr ingot::scalar length_unit = 0;
#endif
#ifdef SLEEP_SPEED_BELOW_ZERO
    static constexpr ingot::scalar sleep_speed = -1;
#endif
#ifdef SLEEP_TIME_BELOW_ZERO
    static constexpr ingot::scalar sleep_time = -1;
#endif
#ifdef ROLLING_WITHOUT_CONTACTS
    static constexpr bool rolling_resistance = true;
#endif
#ifdef BELTS_WITHOUT_CONTACTS
    static constexpr bool surface_velocities = true;
#endif
#ifdef SUBSTEPS_OF_METHOD
    using rotation = ingot::DiscreteMoserVeselov<6, true, true, 3>;
#endif
#ifdef ORDER_OF_SPLITTING
    using rotation = ingot::SymmetricTopSplitting<4>;
#endif
#ifdef FLIGHT_WITHOUT_FIELD
    using flight = ingot::CommutatorFree4;
#endif
#ifdef FLIGHT_AGAINST_VELOCITY
    using force_field = ingot::LinearDrag;
    using flight = ingot::BlanesMoan4;
#endif
#ifdef FIELD_OF_MORE_THAN_NUMBERS
    struct Owner : ingot::MagneticDipole {
        Owner() = default;
        Owner(const Owner&) {}
    };
    using force_field = Owner;
#endif
#ifdef FIELD_WITHOUT_NUMBERS
    struct Secret : ingot::ForceField {
        ingot::scalar k;
        ingot::Wrench operator()(const ingot::BodyMotion& body) const { return ingot::Wrench::force(body.r_CM * ingot::splat<ingot::lane>(k)); }
    };
    using force_field = Secret;
#endif
#ifdef SUMS_OF_LISTING_1
    static constexpr bool compensated_sums = true;
    using rotation = ingot::Listing1Euler;
#endif
#ifdef BUDGET_WITHOUT_CONTACTS
    static constexpr int work_budget = 100;
#endif
#ifdef EFFORT_WITHOUT_FRICTION
    static constexpr ingot::Effort effort = ingot::low_effort;
#endif
#ifdef EFFORT_OF_THREE_SUBSTEPS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 20;
    static constexpr ingot::Effort effort = {3, 3};
    using shapes = ingot::Shapes<ingot::Box>;
#endif
#ifdef EFFORT_WITHOUT_SWEEPS
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 20;
    static constexpr ingot::Effort effort = {4, 0};
    using shapes = ingot::Shapes<ingot::Box>;
#endif
#ifdef NO_WORKERS
    using workers = Workers<0>;
#endif
#ifdef TOO_MANY_BODIES_FOR_WORKERS
    static constexpr bool translates = true;
    static constexpr int max_bodies = 65530, max_manifolds = 20;
    using shapes = ingot::Shapes<ingot::Box>;
    using workers = Workers<16>;
#endif
#ifdef BUDGET_TOO_SMALL
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 20, work_budget = 119;
    using shapes = ingot::Shapes<ingot::Box>;
#endif
#ifdef BUDGET_TOO_SMALL_FOR_IMPACTS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 20, work_budget = 79;
    using shapes = ingot::Shapes<ingot::Box>;
    using solver = ingot::FrictionlessImpacts;
#endif
#ifdef SUMS_IN_A_FIELD
    static constexpr bool compensated_sums = true;
    using force_field = ingot::Spring;
#endif
#ifdef LOCKS_OF_LISTING_1
    static constexpr bool axis_locks = true;
    using rotation = ingot::Listing1Euler;
#endif
#ifdef LEVELS_WITHOUT_CONTACTS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Level>;
    static constexpr ingot::LevelTable levels[1] = {};
#endif
#ifdef LEVELS_WITHOUT_THEIR_SHAPE
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 8;
    using shapes = ingot::Shapes<ingot::Sphere>;
    static constexpr ingot::LevelTable levels[1] = {};
#endif
#ifdef LEVELS_OF_FAST_BODIES
    static constexpr bool translates = true, continuous = true;
    static constexpr int max_manifolds = 8;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Level>;
    static constexpr ingot::LevelTable levels[1] = {};
#endif
#ifdef LOCKS_IN_A_FIELD
    static constexpr bool translates = true, axis_locks = true;
    using force_field = ingot::PointMassGravity;
    using flight = ingot::BlanesMoan4;
#endif
#ifdef LOCKS_SOLVED_DIRECTLY
    static constexpr bool translates = true, axis_locks = true;
    static constexpr int max_manifolds = 8;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
    using solver = ingot::HybridIslands<>;
#endif
#ifdef LOCKS_WITH_JOINTS
    static constexpr bool translates = true, axis_locks = true;
    static constexpr int max_joints = 4;
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef TOO_MANY_FOR_KINEMATIC_BODIES
    static constexpr bool translates = true, kinematic_bodies = true;
    static constexpr int max_bodies = 40000, max_manifolds = 30000;
#endif
#ifdef KINEMATIC_WITHOUT_SHAPES
    static constexpr bool kinematic_bodies = true;
#endif
#ifdef GRAVITY_SHARES_WITHOUT_TRANSLATION
    static constexpr bool gravity_shares = true;
#endif
#ifdef TOO_MANY_JOINTS
    static constexpr bool translates = true;
    static constexpr int max_joints = 40000;
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef LOOPS_WITH_LIMITS
    static constexpr bool translates = true;
    static constexpr int max_joints = 2, max_loops = 1;
    using joints = ingot::Joints<ingot::BallJoint, ingot::WithLimits>;
#endif
#ifdef TOO_MANY_LOOPS
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_loops = 2;
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef JOINTS_WITHOUT_TRANSLATION
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef JOINTS_OF_NO_KIND
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
#endif
#ifdef KINDS_WITHOUT_JOINTS
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef JOINTS_SOLVED_OTHERWISE
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_manifolds = 4;
    using joints = ingot::Joints<ingot::BallJoint>;
    using shapes = ingot::Shapes<ingot::Box>;
    using solver = ingot::SequentialImpulses;
#endif
#ifdef JOINTS_WITHOUT_FRICTION
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_contacts = 4;
    using joints = ingot::Joints<ingot::BallJoint>;
    using shapes = ingot::Shapes<ingot::Box>;
    using solver = ingot::FrictionlessImpacts;
#endif
#ifdef JOINTS_OF_LISTING_1
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::BallJoint>;
    using rotation = ingot::Listing1Euler;
#endif
#ifdef LIMITS_OF_NOTHING
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::FixedJoint, ingot::WithLimits>;
#endif
#ifdef WHEELS_WITHOUT_DRIVES
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::WheelJoint>;
#endif
#ifdef DRIVES_OF_NOTHING
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::FixedJoint, ingot::WithDrives>;
#endif
#if defined(DRIVE_WITHOUT_DRIVES) || defined(LIMIT_WITHOUT_LIMITS) || defined(REACTION_WITHOUT_REACTIONS) || \
    defined(LENGTH_WITHOUT_TIES) || defined(TARGET_WITHOUT_TARGETS) || defined(GEAR_WITHOUT_GEARS)
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::BallJoint>;
#endif
#ifdef STRENGTH_WITHOUT_BREAKING
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::BallJoint, ingot::WithReactions>;
#endif
#ifdef REACTIONS_WITHOUT_JOINTS
    using joints = ingot::Joints<ingot::WithReactions>;
#endif
#ifdef FIGURE_MOTION_WITH_LIMITS
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::WithLimits>;
    using figure_motion = ingot::EnergyMomentum<>;
#endif
#ifdef TIES_WITHOUT_LOOPS
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::RodJoint>;
#endif
#ifdef GEARS_OF_NOTHING
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_loops = 1;
    using joints = ingot::Joints<ingot::BallJoint, ingot::GearJoint>;
#endif
#ifdef SERVOS_WITHOUT_LOOPS
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::ServoJoint, ingot::WithDrives>;
#endif
#ifdef SERVOS_WITHOUT_DRIVES
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_loops = 1;
    using joints = ingot::Joints<ingot::BallServoJoint>;
#endif
#ifdef FIGURE_MOTION_WITH_TIES
    static constexpr bool translates = true;
    static constexpr int max_joints = 1, max_loops = 1;
    using joints = ingot::Joints<ingot::RopeJoint>;
    using figure_motion = ingot::EnergyMomentum<>;
#endif
#ifdef FIGURE_MOTION_WITHOUT_JOINTS
    static constexpr bool translates = true;
    using figure_motion = ingot::EnergyMomentum<>;
#endif
#ifdef FIGURE_MOTION_OF_ORDER_3
    static constexpr bool translates = true;
    static constexpr int max_joints = 1;
    using joints = ingot::Joints<ingot::BallJoint>;
    using figure_motion = ingot::EnergyMomentum<ingot::Snap::keep, 3>;
#endif
#ifdef ISLAND_WITHOUT_ROOM
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using solver = ingot::HybridIslands<0>;
#endif
#ifdef ORDER_OF_METHOD
    using rotation = ingot::DiscreteMoserVeselov<5>;
#endif
};

static ingot::World<Wrong> world;

int main() {
    const ingot::BodyId id = world.add({}).value;
#ifdef FORCE_WITHOUT_TRANSLATION
    (void)world.add_force(id, {}, {});
#endif
#ifdef GRAVITY_WITHOUT_TRANSLATION
    (void)world.set_gravity({});
#endif
#ifdef CONTACTS_WITHOUT_CONTACTS
    (void)world.contact_count();
#endif
#ifdef FILTER_WITHOUT_FILTERS
    (void)world.set_filter(id, {});
#endif
#ifdef OVERLAPS_WITHOUT_SENSORS
    (void)world.overlap_count();
#endif
#ifdef EVENTS_WITHOUT_EVENTS
    (void)world.events();
#endif
#ifdef WAKE_WITHOUT_SLEEP
    (void)world.wake(id);
#endif
#ifdef SHAPES_WITHOUT_COMPOUNDS
    (void)world.add({}, nullptr, 0);
#endif
#ifdef QUERY_WITHOUT_SHAPES
    (void)world.cast_ray({}, {});
#endif
#ifdef BOUNDS_WITHOUT_MANIFOLDS
    (void)world.search_bounds(id);
#endif
#ifdef LEVER_WITHOUT_ROLLING
    (void)world.set_rolling_resistance(id, 1);
#endif
#ifdef BELT_WITHOUT_BELTS
    (void)world.set_surface_velocity(id, {});
#endif
#ifdef SHARE_WITHOUT_SHARES
    (void)world.set_gravity_share(id, 1);
#endif
#ifdef BODY_FORCE_WITHOUT_BODY_FORCES
    (void)world.add_body_torque(id, {});
#endif
#ifdef LEVEL_WITHOUT_LEVELS
    (void)world.add_level({});
#endif
#ifdef LOCKS_WITHOUT_LOCKS
    (void)world.set_locks(id, 0);
#endif
#ifdef DAMPING_WITHOUT_DAMPING
    (void)world.set_damping(id, {});
#endif
#ifdef PLATFORM_WITHOUT_KINEMATIC_BODIES
    (void)world.set_velocity(id, {});
#endif
#ifdef JOINT_WITHOUT_JOINTS
    (void)world.add_joint({});
#endif
#ifdef DRIVE_WITHOUT_DRIVES
    (void)world.set_joint_drive({}, {});
#endif
#ifdef LENGTH_WITHOUT_TIES
    (void)world.set_joint_length({}, 1);
#endif
#ifdef TARGET_WITHOUT_TARGETS
    (void)world.set_target_drive({}, {});
#endif
#ifdef GEAR_WITHOUT_GEARS
    (void)world.add_gear({}, {}, 1);
#endif
#ifdef LIMIT_WITHOUT_LIMITS
    (void)world.set_joint_limits({}, {});
#endif
#ifdef REACTION_WITHOUT_REACTIONS
    (void)world.joint_reaction({});
#endif
#ifdef STRENGTH_WITHOUT_BREAKING
    (void)world.set_joint_strength({}, {});
#endif
#ifdef WORD_WITHOUT_USER_DATA
    (void)world.set_user_data(id, 1);
#endif
#ifdef FIELD_WITHOUT_FIELD
    (void)world.force_field();
#endif
#ifdef FIELD_WITHOUT_NUMBERS
    uint8_t bytes[1];
    (void)ingot::save_snapshot(world, bytes, sizeof bytes);
#endif
#ifdef STATUS_IGNORED
    world.remove(id);
#endif
    (void)id;
    return ingot::step(world, 1).clean() ? 0 : 1;
}
