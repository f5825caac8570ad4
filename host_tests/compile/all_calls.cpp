// SPDX-License-Identifier: MIT
// Every function template of the interface, for scenes of every method: what calls_test.py looks at beside the kernel's own.
#include <ingot/ingot.h>

template <class Method>
struct Everything : ingot::Scene {
    static constexpr int max_bodies = 5, max_contacts = 10;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Method;
    using force_field = ingot::BothFields<ingot::SpringDamper, ingot::PointMassGravity>;
};

/// Contacts with friction, and all that is told of them.
template <class BroadPhase>
struct Stacking : ingot::Scene {
    static constexpr int max_bodies = 5, max_manifolds = 10, max_overlaps = 3, max_events = 7;
    static constexpr bool translates = true, filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
    using broad_phase = BroadPhase;
};

/// The same, asleep at times, with all that surfaces may have.
template <class BroadPhase>
struct Sleeping : Stacking<BroadPhase> {
    static constexpr int max_events = 0;
    static constexpr bool sleeps = true, rolling_resistance = true, surface_velocities = true;
};

template <class Field, class Flight>
struct Flying : ingot::Scene {
    static constexpr bool translates = true;
    using force_field = Field;
    using flight = Flight;
};

template <class Scene>
int use(ingot::World<Scene>& world);
template <class Scene>
int use(ingot::World<Scene>& world) {
    const ingot::MassDistribution box = ingot::solid_box(1, {1, 2, 3});
    const ingot::Vector corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const ingot::MeshTriangle faces[4] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::combined(box, ingot::solid_mesh(1, corners, 4, faces, 4).value)).value;
    def.state.A = ingot::rotation_about({0, 0, 1}, 1).value;
    return world.add(def).ok() && ingot::step(world, 1).clean() ? 0 : 1;
}

template <class Scene>
int keep(ingot::World<Scene>& world);
template <class Scene>
int keep(ingot::World<Scene>& world) {
    static uint8_t bytes[ingot::snapshot_size<Scene>()];
    const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes, sizeof bytes);
    return ingot::load_snapshot(world, bytes, size.value) == ingot::Status::ok ? 0 : 1;
}

/// Members of every world that translates and has shapes.
template <class Scene>
bool use_members(ingot::World<Scene>& world) {
    const ingot::Vector x = {1, 0, 0};
    const ingot::BodyId id = world.body_at(0);
    const ingot::PlacedShape ball = {ingot::Sphere{1}, x, ingot::identity_matrix<ingot::scalar>(), nullptr};
    ingot::BodyId found[2];
    bool ok = world.set_tag(1) == ingot::Status::ok && world.set_gravity(x) == ingot::Status::ok && world.gravity().x > 0;
    ok = world.is_alive(id) && !world.is_frozen(id) && world.body_count() > 0 && world.mass(id).ok() && world.omega(id).ok() && ok;
    ok = world.state(id).ok() && world.set_state(id, {}) == ingot::Status::ok && ok;
    ok = world.add_force(id, x, x) == ingot::Status::ok && world.add_central_force(id, x) == ingot::Status::ok && ok;
    ok = world.add_torque(id, x) == ingot::Status::ok && world.apply_impulse(id, x, x) == ingot::Status::ok && ok;
    ok = world.apply_central_impulse(id, x) == ingot::Status::ok && world.apply_angular_impulse(id, x) == ingot::Status::ok && ok;
    ok = world.collide(id, world.body_at(1), x, x, 1).ok() && world.kinetic_energy() > 0 && world.kinetic_energy(id).ok() && ok;
    ok = world.linear_momentum().x > 0 && world.linear_momentum(id).ok() && world.angular_momentum().x > 0 && world.angular_momentum(id).ok() && ok;
    ok = world.cast_ray(x, x).ok() && world.cast_shape(ball, x).ok() && world.find_overlaps(ball, found, 2).ok() && world.find_nearest(x, 1).ok() &&
         ok;
    ingot::Mover mover;
    ingot::MoverPlane planes[ingot::movers::planes_max];
    ok = world.move(mover, {x}, 1) == ingot::Status::ok && world.collide_mover(mover, planes).ok() && world.cast_mover(mover, x).ok() && ok;
    ok = ingot::solve_planes(x, planes, 1).ok() && ingot::clip_velocity(x, planes, 1).ok() && ok;
    return world.state_hash() != 0 && world.step_count() > 0 && world.remove(id) == ingot::Status::ok && ok;
}
/// Those of impacts and fields.
template <class Method>
bool use_impacts(ingot::World<Everything<Method>>& world);
template <class Method>
bool use_impacts(ingot::World<Everything<Method>>& world) {
    return use_members(world) && world.contact_count() > 0 && world.contact(0).ok() && world.force_field().first.k >= 0 && world.time() > 0;
}
/// Those of contacts with friction.
template <class BroadPhase>
bool use_stack(ingot::World<Stacking<BroadPhase>>& world);
template <class BroadPhase>
bool use_stack(ingot::World<Stacking<BroadPhase>>& world) {
    const ingot::BodyId id = world.body_at(0);
    return use_members(world) && world.filter(id).ok() && world.set_filter(id, {}) == ingot::Status::ok && world.overlap_count() > 0 &&
           world.overlap(0).ok() && world.events().count > 0;
}

/// Those of sleep.
template <class BroadPhase>
bool use_sleep(ingot::World<Sleeping<BroadPhase>>& world);
template <class BroadPhase>
bool use_sleep(ingot::World<Sleeping<BroadPhase>>& world) {
    const ingot::BodyId id = world.body_at(0);
    return use_members(world) && world.set_filter(id, {}) == ingot::Status::ok && world.is_asleep(id) && world.wake(id) == ingot::Status::ok &&
           world.sleep(id) == ingot::Status::ok && world.asleep_count() > 0 && world.asleep_island_count() > 0 &&
           world.set_rolling_resistance(id, 1) == ingot::Status::ok && world.rolling_resistance(id).ok() &&
           world.set_surface_velocity(id, {}) == ingot::Status::ok && world.surface_velocity(id).ok();
}

#define INGOT_ALL_OF(Method)                                        \
    template bool use_impacts(ingot::World<Everything<Method>>&); \
    template int use(ingot::World<Everything<Method>>&);            \
    template int keep(ingot::World<Everything<Method>>&)
INGOT_ALL_OF(ingot::MoserVeselov);
INGOT_ALL_OF(ingot::Listing1Euler);
INGOT_ALL_OF(ingot::LieMidpoint);
INGOT_ALL_OF(ingot::Rk4Polar);
INGOT_ALL_OF(ingot::ExactElliptic);
INGOT_ALL_OF(ingot::SymmetricTop);
INGOT_ALL_OF(ingot::SymmetricTopSplitting<6>);

template bool use_stack(ingot::World<Stacking<ingot::AllPairs>>&);
template int use(ingot::World<Stacking<ingot::AllPairs>>&);
template bool use_stack(ingot::World<Stacking<ingot::SortedTree>>&);
template int use(ingot::World<Stacking<ingot::SortedTree>>&);
template bool use_stack(ingot::World<Stacking<ingot::QueryTree>>&);
template int use(ingot::World<Stacking<ingot::QueryTree>>&);
template bool use_sleep(ingot::World<Sleeping<ingot::AllPairs>>&);
template int use(ingot::World<Sleeping<ingot::AllPairs>>&);
template int keep(ingot::World<Sleeping<ingot::AllPairs>>&);

#define INGOT_FLIGHT_OF(...) template ingot::StepReport ingot::step(ingot::World<Flying<__VA_ARGS__>>&, ingot::scalar)
INGOT_FLIGHT_OF(ingot::GravityGradient, ingot::KickDriftKick);
INGOT_FLIGHT_OF(ingot::Spring, ingot::BlanesMoan4);
INGOT_FLIGHT_OF(ingot::BothFields<ingot::QuadraticDrag, ingot::ThrusterTable<2>>, ingot::CommutatorFree4);
INGOT_FLIGHT_OF(ingot::BothFields<ingot::LinearDrag, ingot::MagneticDipole>, ingot::KickDriftKick);
INGOT_FLIGHT_OF(ingot::WeightAboutPoint, ingot::CommutatorFree4);
