// SPDX-License-Identifier: MIT
// Every function that a user calls, as a function of its own: roots of the call graphs whose depth stands in calls.csv. They are linked, and
// never run. Each is called in the scene that names most of what it looks at; where the scene makes the difference, in several.
//
// The name behind call_ is the one in the table. calls.py fails on public functions that are not called here.
#include "../scenes/all_scenes.h"
#include <ingot/platform/recorder.h>

// A C name, for the script to find; noipa, so that nothing is known of the arguments.
#define CALL(name) extern "C" __attribute__((noipa)) decltype(auto) call_##name
#pragma GCC diagnostic ignored "-Wmissing-declarations"  // nobody calls them

using namespace ingot;
using ingot::platform::Agreement;

namespace {

// Bodies that turn, by each method.
template <class Method>
struct Turning : Scene {
    using rotation = Method;
};

/// Bodies that fly in a field, by each scheme; the field of all that takes velocities, the other that takes none.
struct Orbiting : Scene {
    static constexpr bool translates = true;
    using force_field = BothFields<GravityGradient, MagneticDipole>;
};
struct ByBlanesMoan : Orbiting {
    using flight = BlanesMoan4;
};
struct Dragged : Orbiting {
    using force_field = BothFields<QuadraticDrag, ThrusterTable<2>>;
};
struct ByCommutatorFree : Dragged {
    using flight = CommutatorFree4;
};

struct Floating : Scene {
    static constexpr bool translates = true, gravity_shares = true, body_forces = true, damping = true, user_data = true;
};
struct Locked : Scene {
    static constexpr bool translates = true, axis_locks = true;
};

/// Impacts without friction, in a field.
struct Colliding : Scene {
    static constexpr int max_bodies = 9, max_contacts = 24;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
    using force_field = BothFields<SpringDamper, PointMassGravity>;
};

/// Contacts with friction, of all shapes, by sweeps: what the scenes below have in common.
struct Touching : Scene {
    static constexpr int max_bodies = 9, max_manifolds = 24, max_overlaps = 8;
    static constexpr bool translates = true, filters = true;
    using shapes = Shapes<Sphere, Capsule, Box, Cylinder, Hull, HalfSpace>;
    static constexpr ConvexHull hulls[] = {scenes::cube_hull.hull.value.view()};
    using broad_phase = SortedTree;
};
struct Telling : Touching {
    static constexpr int max_events = 24;
};
/// All that can be named together: most calls are of this scene.
struct Sleeping : Telling {
    static constexpr bool sleeps = true;
    using solver = HybridIslands<>;
};
struct Conveyors : Touching {
    static constexpr bool sleeps = true, rolling_resistance = true, surface_velocities = true;
};
struct ManyShapes : Touching {
    static constexpr int max_shapes_of_body = 3;
    static constexpr bool rolling_resistance = true, surface_velocities = true;
    using force_field = BothFields<SpringDamper, PointMassGravity>;
};
struct Carrying : Sleeping {
    static constexpr bool kinematic_bodies = true;
};
struct Following : Telling {
    static constexpr bool continuous = true;
    using shapes = Shapes<Sphere, Capsule, Box, Cylinder, HalfSpace>;
    static constexpr NoHulls hulls = {};
};
struct FollowingDirectly : Following {
    using solver = HybridIslands<>;
};
struct Asking : Touching {
    static constexpr int max_shapes_of_body = 3;
    static constexpr bool sleeps = true;
    using broad_phase = QueryTree;
};
struct Hinged : Scene {
    static constexpr int max_bodies = 8, max_joints = 8;
    static constexpr bool translates = true;
    using joints = Joints<BallJoint, HingeJoint, SliderJoint, UniversalJoint, FixedJoint>;
};
struct Limited : Hinged {
    using joints = Joints<BallJoint, HingeJoint, SliderJoint, UniversalJoint, FixedJoint, WithLimits>;
};
struct Servoed : Hinged {
    using joints = Joints<BallJoint, HingeJoint, SliderJoint, UniversalJoint, FixedJoint, WithLimits, WithDrives>;
};
struct ServoedRagdolls : Telling {
    static constexpr int max_joints = 8;
    using joints = Joints<BallJoint, HingeJoint, WithLimits, WithDrives>;
};
struct LimitedRagdolls : Telling {
    static constexpr int max_joints = 8;
    using joints = Joints<BallJoint, HingeJoint, SliderJoint, WithLimits>;
};
struct BreakingRagdolls : Telling {
    static constexpr int max_joints = 8;
    using joints = Joints<BallJoint, HingeJoint, SliderJoint, WithLimits, WithBreaking>;
};
struct Ragdolls : Telling {
    static constexpr int max_joints = 8;
    using joints = Joints<BallJoint, HingeJoint>;
};
struct Light : Telling {
    static constexpr bool bounces = false, sleeps = true;
    using solver = SequentialImpulses;
};

}  // namespace

// The step, by what the scene names.
CALL(step_turning_moser_veselov)(World<Turning<MoserVeselov>>& world, scalar h) { return step(world, h); }
CALL(step_turning_listing1)(World<Turning<Listing1Euler>>& world, scalar h) { return step(world, h); }
CALL(step_turning_lie_midpoint)(World<Turning<LieMidpoint>>& world, scalar h) { return step(world, h); }
CALL(step_turning_rk4)(World<Turning<Rk4Polar>>& world, scalar h) { return step(world, h); }
CALL(step_turning_elliptic)(World<Turning<ExactElliptic>>& world, scalar h) { return step(world, h); }
CALL(step_turning_symmetric_top)(World<Turning<SymmetricTop>>& world, scalar h) { return step(world, h); }
CALL(step_turning_splitting)(World<Turning<SymmetricTopSplitting<6>>>& world, scalar h) { return step(world, h); }
CALL(step_in_field_kick_drift_kick)(World<Dragged>& world, scalar h) { return step(world, h); }
CALL(step_in_field_blanes_moan)(World<ByBlanesMoan>& world, scalar h) { return step(world, h); }
CALL(step_in_field_commutator_free)(World<ByCommutatorFree>& world, scalar h) { return step(world, h); }
CALL(step_impacts)(World<Colliding>& world, scalar h) { return step(world, h); }
CALL(step_sweeps)(World<Telling>& world, scalar h) { return step(world, h); }
CALL(step_point_sweeps)(World<Light>& world, scalar h) { return step(world, h); }
CALL(step_hybrid_islands)(World<Sleeping>& world, scalar h) { return step(world, h); }
CALL(step_belts)(World<Conveyors>& world, scalar h) { return step(world, h); }
CALL(step_query_tree)(World<Asking>& world, scalar h) { return step(world, h); }
CALL(step_compounds)(World<ManyShapes>& world, scalar h) { return step(world, h); }
CALL(step_joints)(World<Hinged>& world, scalar h) { return step(world, h); }
CALL(step_joints_in_contact)(World<Ragdolls>& world, scalar h) { return step(world, h); }
CALL(add_joint)(World<Ragdolls>& world, const JointDef& def) { return world.add_joint(def); }
CALL(remove_joint)(World<Ragdolls>& world, JointId id) { return world.remove(id); }
CALL(is_alive_joint)(const World<Ragdolls>& world, JointId id) { return world.is_alive(id); }
CALL(joint_count)(const World<Ragdolls>& world) { return world.joint_count(); }
CALL(joint_at)(const World<Ragdolls>& world, int slot) { return world.joint_at(slot); }
CALL(joint_gap)(const World<Ragdolls>& world, JointId id) { return world.joint_gap(id); }
CALL(step_limited_joints)(World<Limited>& world, scalar h) { return step(world, h); }
CALL(step_limited_joints_in_contact)(World<LimitedRagdolls>& world, scalar h) { return step(world, h); }
CALL(step_driven_joints)(World<Servoed>& world, scalar h) { return step(world, h); }
CALL(step_driven_joints_in_contact)(World<ServoedRagdolls>& world, scalar h) { return step(world, h); }
CALL(set_joint_drive)(World<Servoed>& world, JointId id, const JointDrive& drive, int which) { return world.set_joint_drive(id, drive, which); }
CALL(set_ball_drive)(World<Servoed>& world, JointId id, const JointDrive& drive, const Vector (&vectors)[3]) {
    return world.set_ball_drive(id, drive, vectors[0], vectors[1], vectors[2]);
}
CALL(set_joint_target)(World<Servoed>& world, JointId id, scalar target, scalar rate) { return world.set_joint_target(id, target, rate); }
CALL(set_ball_target)(World<Servoed>& world, JointId id, const Vector& target, const Vector& rate) {
    return world.set_ball_target(id, target, rate);
}
CALL(joint_drive)(const World<Servoed>& world, JointId id, int which) { return world.joint_drive(id, which); }
CALL(drive_torque)(const World<Servoed>& world, JointId id, int which) { return world.drive_torque(id, which); }
CALL(ball_torque)(const World<Servoed>& world, JointId id) { return world.ball_torque(id); }
CALL(step_breaking_joints_in_contact)(World<BreakingRagdolls>& world, scalar h) { return step(world, h); }
CALL(joint_reaction)(const World<BreakingRagdolls>& world, JointId id) { return world.joint_reaction(id); }
CALL(set_joint_strength)(World<BreakingRagdolls>& world, JointId id, const JointStrength& strength) {
    return world.set_joint_strength(id, strength);
}
CALL(joint_strength)(const World<BreakingRagdolls>& world, JointId id) { return world.joint_strength(id); }
CALL(set_joint_enabled)(World<BreakingRagdolls>& world, JointId id, bool enabled) { return world.set_joint_enabled(id, enabled); }
CALL(is_joint_enabled)(const World<BreakingRagdolls>& world, JointId id) { return world.is_joint_enabled(id); }
CALL(is_joint_broken)(const World<BreakingRagdolls>& world, JointId id) { return world.is_joint_broken(id); }
CALL(broken_joints)(const World<BreakingRagdolls>& world) {
    scalar sum = 0;
    for (const JointBreak& broken : world.broken_joints()) sum += broken.reaction.force.x;
    return sum;
}
CALL(read_dynamics)(const World<ServoedRagdolls>& world, BodyId id, FigureDynamics<8>& to) { return world.read_dynamics(id, to); }
CALL(direction_rates)(FigureDynamics<8>& of, scalar* rates, int count) { return of.direction_rates(rates, count); }
CALL(inverse_dynamics)(FigureDynamics<8>& of, const scalar* accelerations, scalar* torques, int count) {
    return of.inverse_dynamics(accelerations, torques, count);
}
CALL(gravity_torques)(FigureDynamics<8>& of, scalar* torques, int count) { return of.gravity_torques(torques, count); }
CALL(transpose_torques)(FigureDynamics<8>& of, BodyId id, const Vector& P, const Vector& F, scalar* torques, int count, BodyId up_to) {
    return of.transpose_torques(id, P, F, {}, torques, count, up_to);
}
CALL(mass_matrix)(FigureDynamics<8>& of, scalar* matrix, int count) { return of.mass_matrix(matrix, count); }
CALL(effective_inertia)(FigureDynamics<8>& of, int direction_i) { return of.effective_inertia(direction_i); }
CALL(figure)(const World<Ragdolls>& world, BodyId id) { return world.figure(id); }
CALL(figure_of_joint)(const World<Ragdolls>& world, JointId id) { return world.figure(id); }
CALL(set_joint_limits)(World<LimitedRagdolls>& world, JointId id, const JointLimits& limits) { return world.set_joint_limits(id, limits); }
CALL(joint_angle)(const World<LimitedRagdolls>& world, JointId id, int which) { return world.joint_angle(id, which); }
CALL(joint_rate)(const World<LimitedRagdolls>& world, JointId id, int which) { return world.joint_rate(id, which); }
CALL(ball_turn)(const World<LimitedRagdolls>& world, JointId id) { return world.ball_turn(id); }
CALL(ball_rate)(const World<LimitedRagdolls>& world, JointId id) { return world.ball_rate(id); }
CALL(joint_travel)(const World<LimitedRagdolls>& world, JointId id) { return world.joint_travel(id); }
CALL(joint_speed)(const World<LimitedRagdolls>& world, JointId id) { return world.joint_speed(id); }
CALL(step_continuous)(World<Following>& world, scalar h) { return step(world, h); }
CALL(step_continuous_hybrid_islands)(World<FollowingDirectly>& world, scalar h) { return step(world, h); }

// Snapshots.
CALL(save_snapshot)(const World<Conveyors>& world, uint8_t* bytes, size_t room) { return save_snapshot(world, bytes, room); }
CALL(load_snapshot)(World<Conveyors>& world, const uint8_t* bytes, size_t size) { return load_snapshot(world, bytes, size); }
CALL(save_snapshot_of_compounds)(const World<ManyShapes>& world, uint8_t* bytes, size_t room) { return save_snapshot(world, bytes, room); }
CALL(load_snapshot_of_compounds)(World<ManyShapes>& world, const uint8_t* bytes, size_t size) { return load_snapshot(world, bytes, size); }

// Bodies.
CALL(add)(World<Sleeping>& world, const BodyDef& def) { return world.add(def); }
CALL(add_to_compounds)(World<ManyShapes>& world, const BodyDef& def) { return world.add(def); }
CALL(add_compound)(World<ManyShapes>& world, const BodyDef& def, const ShapeDef* shapes, int count) { return world.add(def, shapes, count); }
CALL(add_compound_of_array)(World<ManyShapes>& world, const BodyDef& def, const ShapeDef (&shapes)[3]) { return world.add(def, shapes); }
CALL(remove)(World<Sleeping>& world, BodyId id) { return world.remove(id); }
CALL(remove_compound)(World<ManyShapes>& world, BodyId id) { return world.remove(id); }
CALL(is_alive)(const World<Sleeping>& world, BodyId id) { return world.is_alive(id); }
CALL(is_frozen)(const World<Sleeping>& world, BodyId id) { return world.is_frozen(id); }
CALL(body_count)(const World<Sleeping>& world) { return world.body_count(); }
CALL(body_at)(const World<Sleeping>& world, int slot) { return world.body_at(slot); }

// State, forces, impulses.
CALL(state)(const World<Sleeping>& world, BodyId id) { return world.state(id); }
CALL(set_state)(World<Sleeping>& world, BodyId id, const BodyState& state) { return world.set_state(id, state); }
CALL(set_state_of_compound)(World<ManyShapes>& world, BodyId id, const BodyState& state) { return world.set_state(id, state); }
CALL(mass)(const World<Sleeping>& world, BodyId id) { return world.mass(id); }
CALL(omega)(const World<Sleeping>& world, BodyId id) { return world.omega(id); }
CALL(set_mass)(World<Sleeping>& world, BodyId id, const MassProperties& mass) { return world.set_mass(id, mass); }
CALL(inertia)(const World<Sleeping>& world, BodyId id) { return world.inertia(id); }
CALL(set_movable)(World<Sleeping>& world, BodyId id, const MassProperties& mass) { return world.set_movable(id, mass); }
CALL(set_immovable)(World<Sleeping>& world, BodyId id) { return world.set_immovable(id); }
CALL(is_movable)(const World<Sleeping>& world, BodyId id) { return world.is_movable(id); }
CALL(set_friction)(World<Sleeping>& world, BodyId id, scalar mu) { return world.set_friction(id, mu); }
CALL(friction)(const World<Sleeping>& world, BodyId id) { return world.friction(id); }
CALL(set_restitution)(World<Sleeping>& world, BodyId id, scalar e) { return world.set_restitution(id, e); }
CALL(restitution)(const World<Sleeping>& world, BodyId id) { return world.restitution(id); }
CALL(set_shape)(World<Sleeping>& world, BodyId id, const Shape& shape) { return world.set_shape(id, shape); }
CALL(set_shape_of_compound)(World<ManyShapes>& world, BodyId id, const Shape& shape, int shape_i) { return world.set_shape(id, shape, shape_i); }
CALL(shape)(const World<Sleeping>& world, BodyId id) { return world.shape(id); }
CALL(set_shape_place)(World<ManyShapes>& world, BodyId id, const ShapePlace& place, int shape_i) {
    return world.set_shape_place(id, place, shape_i);
}
CALL(shape_place)(const World<ManyShapes>& world, BodyId id, int shape_i) { return world.shape_place(id, shape_i); }
CALL(set_sensor)(World<Sleeping>& world, BodyId id, bool sensor) { return world.set_sensor(id, sensor); }
CALL(is_sensor)(const World<Sleeping>& world, BodyId id) { return world.is_sensor(id); }
CALL(add_force)(World<Sleeping>& world, BodyId id, const Vector& F, const Vector& P) { return world.add_force(id, F, P); }
CALL(add_central_force)(World<Sleeping>& world, BodyId id, const Vector& F) { return world.add_central_force(id, F); }
CALL(add_torque)(World<Sleeping>& world, BodyId id, const Vector& tau) { return world.add_torque(id, tau); }
CALL(add_body_force)(World<Floating>& world, BodyId id, const Vector& F, const Vector& r) { return world.add_body_force(id, F, r); }
CALL(add_body_torque)(World<Floating>& world, BodyId id, const Vector& tau) { return world.add_body_torque(id, tau); }
CALL(set_damping)(World<Floating>& world, BodyId id, const Damping& damping) { return world.set_damping(id, damping); }
CALL(damping)(const World<Floating>& world, BodyId id) { return world.damping(id); }
CALL(set_locks)(World<Locked>& world, BodyId id, unsigned locks) { return world.set_locks(id, locks); }
CALL(locks)(const World<Locked>& world, BodyId id) { return world.locks(id); }
CALL(set_user_data)(World<Floating>& world, BodyId id, uint32_t word) { return world.set_user_data(id, word); }
CALL(set_velocity)(World<Carrying>& world, BodyId id, const Vector& v_CM, const Vector& omega) { return world.set_velocity(id, v_CM, omega); }
CALL(move_to)(World<Carrying>& world, BodyId id, const Vector& r_CM, const Matrix& A) { return world.move_to(id, r_CM, A); }
CALL(set_kinematic)(World<Carrying>& world, BodyId id) { return world.set_kinematic(id); }
CALL(is_kinematic)(const World<Carrying>& world, BodyId id) { return world.is_kinematic(id); }
CALL(user_data)(const World<Floating>& world, BodyId id) { return world.user_data(id); }
CALL(apply_impulse)(World<Sleeping>& world, BodyId id, const Vector& j, const Vector& P) { return world.apply_impulse(id, j, P); }
CALL(apply_central_impulse)(World<Sleeping>& world, BodyId id, const Vector& j) { return world.apply_central_impulse(id, j); }
CALL(apply_angular_impulse)(World<Sleeping>& world, BodyId id, const Vector& k) { return world.apply_angular_impulse(id, k); }
CALL(collide)(World<Sleeping>& world, BodyId A, BodyId B, const Vector& P, const Vector& n, scalar e) { return world.collide(A, B, P, n, e); }
CALL(set_gravity)(World<Sleeping>& world, const Vector& gravity) { return world.set_gravity(gravity); }
CALL(gravity)(const World<Sleeping>& world) { return world.gravity(); }
CALL(force_field)(World<Colliding>& world) { return (world.force_field()); }
CALL(force_field_of_const)(const World<Colliding>& world) { return (world.force_field()); }
CALL(time)(const World<Colliding>& world) { return world.time(); }
CALL(kinetic_energy)(const World<Sleeping>& world) { return world.kinetic_energy(); }
CALL(linear_momentum)(const World<Sleeping>& world) { return world.linear_momentum(); }
CALL(angular_momentum)(const World<Sleeping>& world) { return world.angular_momentum(); }
CALL(kinetic_energy_of_body)(const World<Sleeping>& world, BodyId id) { return world.kinetic_energy(id); }
CALL(linear_momentum_of_body)(const World<Sleeping>& world, BodyId id) { return world.linear_momentum(id); }
CALL(angular_momentum_of_body)(const World<Sleeping>& world, BodyId id) { return world.angular_momentum(id); }

// Contacts, filters, materials, sensors, events.
CALL(contact_count)(const World<Colliding>& world) { return world.contact_count(); }
CALL(contact)(const World<Colliding>& world, int index) { return world.contact(index); }
CALL(contact_of_sleepers)(const World<Sleeping>& world, int index) { return world.contact(index); }
CALL(contacts)(const World<Sleeping>& world) {
    scalar sum = 0;
    for (const ContactInfo& contact : world.contacts()) sum += contact.j;
    return sum;
}
CALL(contacts_of)(const World<Sleeping>& world, BodyId id) {
    scalar sum = 0;
    for (const ContactInfo& contact : world.contacts_of(id)) sum += contact.j;
    return sum;
}
CALL(contact_sum)(const World<Sleeping>& world, BodyId id) { return world.contact_sum(id); }
CALL(filter)(const World<Sleeping>& world, BodyId id) { return world.filter(id); }
CALL(set_filter)(World<Sleeping>& world, BodyId id, const BodyFilter& filter) { return world.set_filter(id, filter); }
CALL(set_rolling_resistance)(World<Conveyors>& world, BodyId id, scalar lever) { return world.set_rolling_resistance(id, lever); }
CALL(rolling_resistance)(const World<Conveyors>& world, BodyId id) { return world.rolling_resistance(id); }
CALL(set_surface_velocity)(World<Conveyors>& world, BodyId id, const Vector& velocity) { return world.set_surface_velocity(id, velocity); }
CALL(surface_velocity)(const World<Conveyors>& world, BodyId id) { return world.surface_velocity(id); }
CALL(set_gravity_share)(World<Floating>& world, BodyId id, scalar share) { return world.set_gravity_share(id, share); }
CALL(gravity_share)(const World<Floating>& world, BodyId id) { return world.gravity_share(id); }
CALL(overlap_count)(const World<Sleeping>& world) { return world.overlap_count(); }
CALL(overlap)(const World<Sleeping>& world, int index) { return world.overlap(index); }
CALL(events)(const World<Sleeping>& world) { return world.events(); }

// Sleep.
CALL(room_needed)(const World<Sleeping>& world, const ingot::StepReport& report, ingot::RoomNeeded& most) {
    most.raise(world.room_needed(report));
}
CALL(is_asleep)(const World<Sleeping>& world, BodyId id) { return world.is_asleep(id); }
CALL(wake)(World<Sleeping>& world, BodyId id) { return world.wake(id); }
CALL(sleep)(World<Sleeping>& world, BodyId id) { return world.sleep(id); }
CALL(asleep_count)(const World<Sleeping>& world) { return world.asleep_count(); }
CALL(awake_count)(const World<Sleeping>& world) { return world.awake_count(); }
CALL(awake_island_count)(const World<Sleeping>& world) { return world.awake_island_count(); }
CALL(asleep_island_count)(const World<Sleeping>& world) { return world.asleep_island_count(); }

// Queries.
CALL(cast_ray)(const World<Sleeping>& world, const Vector& from, const Vector& way, const QueryFilter& filter) {
    return world.cast_ray(from, way, filter);
}
CALL(cast_ray_all)(const World<Sleeping>& world, const Vector& from, const Vector& way, QueryHit* found, int capacity, const QueryFilter& filter) {
    return world.cast_ray_all(from, way, found, capacity, filter);
}
CALL(cast_shape_all)(const World<Sleeping>& world, const PlacedShape& shape, const Vector& way, QueryHit* found, int capacity,
                     const QueryFilter& filter) {
    return world.cast_shape_all(shape, way, found, capacity, filter);
}
CALL(cast_ray_at_compounds)(const World<ManyShapes>& world, const Vector& from, const Vector& way, const QueryFilter& filter) {
    return world.cast_ray(from, way, filter);
}
CALL(cast_shape)(const World<Sleeping>& world, const PlacedShape& shape, const Vector& way, const QueryFilter& filter) {
    return world.cast_shape(shape, way, filter);
}
CALL(cast_shape_at_compounds)(const World<ManyShapes>& world, const PlacedShape& shape, const Vector& way, const QueryFilter& filter) {
    return world.cast_shape(shape, way, filter);
}
CALL(find_overlaps)(const World<Sleeping>& world, const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter) {
    return world.find_overlaps(shape, found, capacity, filter);
}
CALL(find_overlaps_of_compounds)(const World<ManyShapes>& world, const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter) {
    return world.find_overlaps(shape, found, capacity, filter);
}
CALL(cast_ray_by_tree)(const World<Asking>& world, const Vector& from, const Vector& way, const QueryFilter& filter) {
    return world.cast_ray(from, way, filter);
}
CALL(cast_shape_by_tree)(const World<Asking>& world, const PlacedShape& shape, const Vector& way, const QueryFilter& filter) {
    return world.cast_shape(shape, way, filter);
}
CALL(find_overlaps_by_tree)(const World<Asking>& world, const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter) {
    return world.find_overlaps(shape, found, capacity, filter);
}
CALL(find_nearest_by_tree)(const World<Asking>& world, const Vector& point, scalar within, const QueryFilter& filter) {
    return world.find_nearest(point, within, filter);
}
CALL(find_nearest)(const World<Sleeping>& world, const Vector& point, scalar within, const QueryFilter& filter) {
    return world.find_nearest(point, within, filter);
}
CALL(find_nearest_of_compounds)(const World<ManyShapes>& world, const Vector& point, scalar within, const QueryFilter& filter) {
    return world.find_nearest(point, within, filter);
}

// Characters.
CALL(move)(World<Asking>& world, Mover& mover, const MoverInput& input, scalar h) { return world.move(mover, input, h); }
CALL(move_among_compounds)(World<ManyShapes>& world, Mover& mover, const MoverInput& input, scalar h) { return world.move(mover, input, h); }
CALL(collide_mover)(const World<Sleeping>& world, const Mover& mover, MoverPlane (&planes)[movers::planes_max]) {
    return world.collide_mover(mover, planes);
}
CALL(cast_mover)(const World<Sleeping>& world, const Mover& mover, const Vector& way) { return world.cast_mover(mover, way); }
CALL(solve_planes)(const Vector& way, const MoverPlane* planes, int count) { return solve_planes(way, planes, count); }
CALL(clip_velocity)(const Vector& v, const MoverPlane* planes, int count) { return clip_velocity(v, planes, count); }

// The world as a whole.
CALL(state_hash)(const World<Sleeping>& world) { return world.state_hash(); }
CALL(step_count)(const World<Sleeping>& world) { return world.step_count(); }
CALL(set_tag)(World<Sleeping>& world, uint16_t tag) { return world.set_tag(tag); }

// Mass properties. Of constants the compiler works them out.
CALL(solid_sphere)(scalar density, scalar radius) { return solid_sphere(density, radius); }
CALL(solid_box)(scalar density, const Vector& half_extents) { return solid_box(density, half_extents); }
CALL(solid_cylinder)(scalar density, scalar radius, scalar half_length) { return solid_cylinder(density, radius, half_length); }
CALL(solid_capsule)(scalar density, scalar radius, scalar half_length) { return solid_capsule(density, radius, half_length); }
CALL(solid_cone)(scalar density, scalar radius, scalar height) { return solid_cone(density, radius, height); }
CALL(solid_ellipsoid)(scalar density, const Vector& semi_axes) { return solid_ellipsoid(density, semi_axes); }
CALL(solid_hemisphere)(scalar density, scalar radius) { return solid_hemisphere(density, radius); }
CALL(solid_tetrahedron)(scalar density, const Vector (&p)[4]) { return solid_tetrahedron(density, p[0], p[1], p[2], p[3]); }
CALL(solid_mesh)(scalar density, const Vector* vertices, int vertex_count, const MeshTriangle* triangles, int triangle_count) {
    return solid_mesh(density, vertices, vertex_count, triangles, triangle_count);
}
CALL(solid_of_shape)(scalar density, const Shape& shape) { return solid_of_shape(density, shape); }
CALL(solid_of_shapes)(scalar density, const ShapeDef (&parts)[3]) { return solid_of_shapes(density, parts); }
CALL(with_mass)(const MassDistribution& solid, scalar M) { return with_mass(solid, M); }
CALL(placed)(const MassDistribution& part, const Matrix& A, const Vector& r) { return placed(part, A, r); }
CALL(combined)(const MassDistribution& a, const MassDistribution& b) { return combined(a, b); }
CALL(without)(const MassDistribution& solid, const MassDistribution& hole) { return without(solid, hole); }
CALL(inertia_about)(const MassDistribution& solid, const Vector& point) { return inertia_about(solid, point); }
CALL(principal)(const MassDistribution& solid) { return principal(solid); }

// Hulls, of as many points as there may be.
using Points = Vector[limits::hull_vertices_max];
CALL(convex_hull)(const Points& points) { return convex_hull(points); }
CALL(convex_hull_of_body)(const Points& points, const MassProperties& mass) { return convex_hull_of_body(points, mass); }
// Levels, of two triangles and of two cells.
using Corners = Vector[4];
using Faces = LevelFace[2];
using Heights = uint16_t[6];
constexpr Corners corners_of_level = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 1}};
constexpr Faces faces_of_level = {{0, 1, 2}, {0, 2, 3}};
constexpr auto level_of_two = mesh_of(corners_of_level, faces_of_level);
CALL(mesh_of)(const Corners& corners, const Faces& faces, scalar step) { return mesh_of(corners, faces, step); }
CALL(trimmed)() { return trimmed<level_of_two>(); }
CALL(height_field_of)(const Heights& heights, scalar spacing, scalar step) { return height_field_of<3, 2>(heights, spacing, spacing, step); }
CALL(byte_heights_of)(const Heights& heights, scalar spacing, scalar step) { return byte_heights_of<3, 2>(heights, spacing, spacing, step); }
CALL(with_materials)(const LevelTable& level, const LevelMaterial* materials, int count) { return with_materials(level, materials, count); }
CALL(with_materials_of_array)(const LevelTable& level, const LevelMaterial (&materials)[2]) { return with_materials(level, materials); }
struct Levelled : Scene {
    static constexpr int max_bodies = 9, max_manifolds = 24;
    static constexpr bool translates = true;
    using shapes = Shapes<Sphere, Box, Cylinder, Level>;
    static constexpr LevelTable levels[] = {level_of_two.value.view()};
};
CALL(add_level)(World<Levelled>& world, const LevelDef& def) { return world.add_level(def); }
CALL(step_on_level)(World<Levelled>& world, scalar h) { return step(world, h); }
CALL(cast_ray_at_levels)(const World<Levelled>& world, const Vector& from, const Vector& way, const QueryFilter& filter) {
    return world.cast_ray(from, way, filter);
}
CALL(move_on_levels)(World<Levelled>& world, Mover& mover, const MoverInput& input, scalar h) { return world.move(mover, input, h); }
CALL(cast_shape_at_levels)(const World<Levelled>& world, const PlacedShape& shape, const Vector& way, const QueryFilter& filter) {
    return world.cast_shape(shape, way, filter);
}

CALL(hull_of)(int form) { return hull_of<Sleeping>(form); }
CALL(solid_hull)(scalar density, const ConvexHull& hull) { return solid_hull(density, hull); }

// Frames, points of a body, the impulse of Fig. 4.
CALL(user_pose)(const MassProperties& mass, const BodyState& state) { return user_pose(mass, state); }
CALL(user_motion)(const MassProperties& mass, const BodyState& state) { return user_motion(mass, state); }
CALL(body_state)(const MassProperties& mass, const UserPose& pose, const UserMotion& motion) { return body_state(mass, pose, motion); }
CALL(axis_angle)(const Vector& n, scalar angle) { return axis_angle(n, angle); }
CALL(interpolated)(const BodyState& from, const BodyState& to, scalar fraction) { return interpolated(from, to, fraction); }
CALL(interpolated_pose)(const UserPose& from, const UserPose& to, scalar fraction) { return interpolated(from, to, fraction); }
CALL(quaternion_of)(const Matrix& A) { return quaternion_of(A); }
CALL(rotation_of)(const Quaternion& q) { return rotation_of(q); }
CALL(rotation_about)(const Vector& n, scalar angle) { return rotation_about(n, angle); }
CALL(point_position)(const Vector& o, const Matrix& A, const Vector& r_body) { return point_position(o, A, r_body); }
CALL(point_velocity)(const Vector& v, const Vector& omega, const Vector& r) { return point_velocity(v, omega, r); }
CALL(point_acceleration)(const Vector& a, const Vector& alpha, const Vector& omega, const Vector& r) {
    return point_acceleration(a, alpha, omega, r);
}
CALL(orientation_rate)(const Vector& omega, const Matrix& A) { return orientation_rate(omega, A); }
CALL(inverse_inertia_world)(const Matrix& A, const Vector& inv_I_body) { return inverse_inertia_world(A, inv_I_body); }
CALL(spin_of)(const Matrix& A, const Vector& inv_I_body, const Vector& L) { return spin_of(A, inv_I_body, L); }
CALL(is_within_runaway)(const Vector& omega) { return is_within_runaway(omega); }
CALL(angular_momentum_of_spin)(const Matrix& A, const Vector& I_body, const Vector& omega) { return angular_momentum_of_spin(A, I_body, omega); }
CALL(collision_impulse)(const CollidingBody& A, const CollidingBody& B, const Vector& n, scalar e) { return collision_impulse(A, B, n, e); }
CALL(check_floating_point)() { return check_floating_point(); }
CALL(check_floating_point_of_kernel)() { return check_floating_point_of_kernel(); }

// The recorder of the platform.
using Recorder = platform::Recorder<600, 16, 60, 1000>;
CALL(recorder_record)(Recorder& recorder, uint32_t number, const uint8_t* input, size_t size, uint64_t hash) {
    return recorder.record(number, input, size, hash);
}
CALL(recorder_keep_state)(Recorder& recorder, const uint8_t* state, size_t size) { return recorder.keep_state(state, size); }
CALL(recorder_compare)(const Recorder& recorder, uint32_t number, uint64_t hash) { return recorder.compare(number, hash); }
CALL(recorder_write)(const Recorder& recorder, volatile uint8_t* line) {
    recorder.write([line](uint8_t byte) { *line = byte; });
}
