// SPDX-License-Identifier: MIT
// Every function template of the interface, for scenes of every method: what calls_test.py looks at beside the kernel's own.
#include <ingot/ingot.h>

template <class Method>
struct Everything : ingot::Scene {
    static constexpr int max_bodies = 5, max_contacts = 10;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Method;
    using force_field = ingot::BothFields<ingot::SpringDamper, ingot::PointMassGravity>;
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

// Explicit instantiation takes in every member, called or not.
#define INGOT_ALL_OF(Method)                         \
    template class ingot::World<Everything<Method>>; \
    template int use(ingot::World<Everything<Method>>&)
INGOT_ALL_OF(ingot::MoserVeselov);
INGOT_ALL_OF(ingot::Listing1Euler);
INGOT_ALL_OF(ingot::LieMidpoint);
INGOT_ALL_OF(ingot::Rk4Polar);
INGOT_ALL_OF(ingot::ExactElliptic);
INGOT_ALL_OF(ingot::SymmetricTop);
INGOT_ALL_OF(ingot::SymmetricTopSplitting<6>);

#define INGOT_FLIGHT_OF(...) template ingot::StepReport ingot::step(ingot::World<Flying<__VA_ARGS__>>&, ingot::scalar)
INGOT_FLIGHT_OF(ingot::GravityGradient, ingot::KickDriftKick);
INGOT_FLIGHT_OF(ingot::Spring, ingot::BlanesMoan4);
INGOT_FLIGHT_OF(ingot::BothFields<ingot::QuadraticDrag, ingot::ThrusterTable<2>>, ingot::CommutatorFree4);
INGOT_FLIGHT_OF(ingot::BothFields<ingot::LinearDrag, ingot::MagneticDipole>, ingot::KickDriftKick);
INGOT_FLIGHT_OF(ingot::WeightAboutPoint, ingot::CommutatorFree4);
