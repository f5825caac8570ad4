// SPDX-License-Identifier: MIT
// Each ready force field against a motion known in closed form, by every flight that takes it, and the order it shows.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <type_traits>

#include "reference/eigen_driven_body.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;

constexpr bool is_double = sizeof(scalar) == 8;
constexpr double eps = static_cast<double>(ingot::epsilon);

template <class Field, class Flight>
struct OneBody : ingot::Scene {
    static constexpr bool translates = true;
    using force_field = Field;
    using flight = Flight;
};

template <class Field, class Flight>
using WorldOf = ingot::World<OneBody<Field, Flight>>;

using Vector3 = Eigen::Vector3d;

ingot::BodyDef body_at(const Vector3& r, const Vector3& v, const Vector3& I = {1, 1, 1}, double M = 2) {
    ingot::BodyDef def = definition(M, I);
    def.state.r_CM = to_vector(r);
    def.state.v_CM = to_vector(v);
    return def;
}

/// Flies a body for t seconds in so many steps.
template <class Field, class Flight>
ingot::BodyState after(const Field& field, const ingot::BodyDef& def, double t, int steps) {
    WorldOf<Field, Flight> world{};
    world.force_field() = field;
    const ingot::BodyId id = world.add(def).value;
    for (int step_i = 0; step_i < steps; ++step_i) EXPECT_TRUE(ingot::step(world, static_cast<scalar>(t / steps)).clean());
    return world.state(id).value;
}

/// Errors at `steps` and twice as many: within what a scheme of the flight's order makes of a motion whose fastest rate is `rate`,
/// rad/s, and in double of that order. On the oscillator the phase errs by (rate h)^2/24 and (rate h)^4/120 of each radian; three times
/// that is allowed to motions that are no oscillators, and `size` to amplitudes other than 1.
template <class Field, class Flight, class Error>
void expect_error(const char* what, const Field& field, const ingot::BodyDef& def, double t, int steps, double rate, double size, Error error_of) {
    const double x = rate * t / steps, of_radian = Flight::order == 4 ? x * x * x * x / 120 : x * x / 24;
    const double bound = size * (3 * of_radian * rate * t + 40 * eps * steps);
    const double coarse = error_of(after<Field, Flight>(field, def, t, steps)), fine = error_of(after<Field, Flight>(field, def, t, 2 * steps));
    std::printf("    %-18s %-18s %5d steps: %.1e, twice as many: %.1e\n", what, Flight::name, steps, coarse, fine);
    EXPECT_LE(coarse, bound) << what << ' ' << Flight::name;
    if (is_double && fine > 1e3 * eps) { EXPECT_NEAR(std::log2(coarse / fine), Flight::order, 0.3) << what << ' ' << Flight::name; }
}

template <class Flight>
struct FieldsOf : ::testing::Test {};
using Flights = ::testing::Types<ingot::KickDriftKick, ingot::BlanesMoan4, ingot::CommutatorFree4>;
TYPED_TEST_SUITE(FieldsOf, Flights);

/// Roundings of so many steps on values of order 1.
double roundings(int steps) { return 4 * eps * steps; }

/// An ellipse of eccentricity 1/2 and period 2 pi: after one turn the body is where it was.
TYPED_TEST(FieldsOf, point_mass_closes_the_ellipse) {
    ingot::PointMassGravity field{};
    field.mu = 1;
    field.centre = {1, -2, scalar(0.5)};
    const Vector3 centre(1, -2, 0.5), r(0.5, 0, 0), v(0, std::sqrt(3.0) * 0.8, std::sqrt(3.0) * 0.6);
    expect_error<ingot::PointMassGravity, TypeParam>("Kepler", field, body_at(centre + r, v), 2 * std::acos(-1.0), 1024, 8, 0.5,
                                                     [&](const ingot::BodyState& s) { return (to_eigen(s.r_CM) - centre - r).norm(); });
}

TYPED_TEST(FieldsOf, spring_swings_at_its_frequency) {
    ingot::Spring field{};
    field.k = 8;  // of 2 kg: omega = 2 rad/s
    field.anchor = {0, 1, 0};
    const double t = 7;
    const Vector3 exact(std::cos(2 * t), 1 + 0.5 * std::sin(2 * t), 0);
    expect_error<ingot::Spring, TypeParam>("spring", field, body_at({1, 1, 0}, {0, 1, 0}), t, 448, 2, 1.2,
                                           [&](const ingot::BodyState& s) { return (to_eigen(s.r_CM) - exact).norm(); });
}

/// The torque of an asymmetric body in the gravity of a mass far away, which it does not feel as a force.
TYPED_TEST(FieldsOf, gravity_gradient_librates) {
    ingot::GravityGradient field{};
    field.mu = 8;
    field.centre = {0, 0, 0};
    const Vector3 I(1, 2, 2.5), d(2, 1, -1);
    using Real = long double;
    const DrivenBody::Vector3 I_wide = I.cast<Real>(), d_wide = d.cast<Real>();
    DrivenBody reference(I_wide, DrivenBody::Matrix3::Identity(), DrivenBody::Vector3(0.5L, 1, 0.25L));
    reference.advance(4, 8192, [&](Real, const DrivenBody::Matrix3& A) -> DrivenBody::Vector3 {
        const DrivenBody::Vector3 Id = A * I_wide.cwiseProduct(A.transpose() * d_wide);
        return d_wide.cross(Id) * (3 * 8.0L / std::pow(d_wide.squaredNorm(), 2.5L));
    });
    ingot::BodyDef def = body_at(d, Vector3::Zero(), I);
    def.state.L = {scalar(0.5), 1, scalar(0.25)};
    expect_error<ingot::GravityGradient, TypeParam>("gravity gradient", field, def, 4, 128, 3, 1,
                                                    [&](const ingot::BodyState& s) { return attitude_error(to_eigen<Real>(s.A), reference.A()); });
}

TYPED_TEST(FieldsOf, dipole_swings_about_the_field) {
    ingot::MagneticDipole field{};
    field.m_body = {0, scalar(0.5), 2};
    field.B = {1, 0, scalar(0.25)};
    const Vector3 I(1, 2, 2.5), m(0, 0.5, 2), B(1, 0, 0.25);
    using Real = long double;
    DrivenBody reference(I.cast<Real>(), DrivenBody::Matrix3::Identity(), DrivenBody::Vector3(0.5L, 1, 0.25L));
    reference.advance(4, 8192, [&](Real, const DrivenBody::Matrix3& A) -> DrivenBody::Vector3 {
        return DrivenBody::Vector3(A * m.cast<Real>()).cross(DrivenBody::Vector3(B.cast<Real>()));
    });
    ingot::BodyDef def = body_at(Vector3::Zero(), Vector3::Zero(), I);
    def.state.L = {scalar(0.5), 1, scalar(0.25)};
    expect_error<ingot::MagneticDipole, TypeParam>("dipole", field, def, 4, 128, 3, 1,
                                                   [&](const ingot::BodyState& s) { return attitude_error(to_eigen<Real>(s.A), reference.A()); });
}

/// A body that spins at 1 rad/s about z, pushed along its x axis through the centre: the velocity turns on a circle.
TYPED_TEST(FieldsOf, thruster_turns_with_the_body) {
    ingot::ThrusterTable<2> field{};
    field.thruster[0].F_body = {1, 0, 0};
    field.thruster[0].r_body = {-1, 0, 0};
    field.thruster[0].throttle[0] = 1;
    field.thruster[1].F_body = {0, 0, 100};  // off
    const double t = 3;
    ingot::BodyDef def = body_at(Vector3::Zero(), Vector3::Zero());
    def.state.L = {0, 0, 1};
    const Vector3 exact(0.5 * std::sin(t), 0.5 * (1 - std::cos(t)), 0);
    expect_error<ingot::ThrusterTable<2>, TypeParam>("thruster", field, def, t, 96, 1, 1,
                                                     [&](const ingot::BodyState& s) { return (to_eigen(s.v_CM) - exact).norm(); });
}

/// And one off the centre turns it: constant torque, about an axis of inertia.
TYPED_TEST(FieldsOf, thruster_turns_the_body) {
    ingot::ThrusterTable<1> field{};
    field.thruster[0].F_body = {0, scalar(0.5), 0};
    field.thruster[0].r_body = {1, 0, 0};
    field.thruster[0].throttle[0] = scalar(0.5);
    const ingot::BodyState s = after<ingot::ThrusterTable<1>, TypeParam>(field, body_at(Vector3::Zero(), Vector3::Zero(), {1, 2, 2.5}), 4, 256);
    EXPECT_NEAR(static_cast<double>(s.L.z), 1.0, roundings(256));
    const double angle = 0.25 / 2.5 * 4 * 4 / 2;
    EXPECT_NEAR(static_cast<double>(s.A.c0.y), std::sin(angle), 1e-4);
}

template <class Flight>
struct DragOf : ::testing::Test {};
using FlightsOfAnyField = ::testing::Types<ingot::KickDriftKick, ingot::CommutatorFree4>;
TYPED_TEST_SUITE(DragOf, FlightsOfAnyField);

TYPED_TEST(DragOf, linear_drag_decays) {
    ingot::LinearDrag field{};
    field.c = 1;  // of 2 kg: half a second^-1
    field.c_turn = scalar(0.25);
    ingot::BodyDef def = body_at(Vector3::Zero(), {3, -1, 2});
    def.state.L = {0, 0, 2};
    const double t = 3;
    const Vector3 exact = Vector3(3, -1, 2) * std::exp(-t / 2);
    const auto v_error = [&](const ingot::BodyState& s) { return (to_eigen(s.v_CM) - exact).norm(); };
    const auto L_error = [&](const ingot::BodyState& s) { return (to_eigen(s.L) - Vector3(0, 0, 2 * std::exp(-0.25 * t))).norm(); };
    const auto r_error = [&](const ingot::BodyState& s) { return (to_eigen(s.r_CM) - (Vector3(3, -1, 2) - exact) * 2).norm(); };
    expect_error<ingot::LinearDrag, TypeParam>("linear drag, v", field, def, t, 48, 0.5, 4, v_error);
    expect_error<ingot::LinearDrag, TypeParam>("linear drag, L", field, def, t, 48, 0.5, 4, L_error);
    expect_error<ingot::LinearDrag, TypeParam>("linear drag, r", field, def, t, 48, 0.5, 8, r_error);
}

TYPED_TEST(DragOf, quadratic_drag_decays) {
    ingot::QuadraticDrag field{};
    field.c = 1;
    field.c_turn = scalar(0.5);
    ingot::BodyDef def = body_at(Vector3::Zero(), {2, 0, 0});
    def.state.L = {0, 3, 0};
    const double t = 3;
    expect_error<ingot::QuadraticDrag, TypeParam>("quadratic drag, v", field, def, t, 96, 1.5, 3, [&](const ingot::BodyState& s) {
        return std::abs(static_cast<double>(s.v_CM.x) - 2 / (1 + 0.5 * 2 * t));
    });
    expect_error<ingot::QuadraticDrag, TypeParam>("quadratic drag, L", field, def, t, 96, 1.5, 3, [&](const ingot::BodyState& s) {
        return std::abs(static_cast<double>(s.L.y) - 3 / (1 + 0.5 * 3 * t));
    });
}

TYPED_TEST(DragOf, spring_damper_rings_down) {
    ingot::SpringDamper field{};
    field.k = 10;
    field.c = 4;  // of 2 kg: decay 1/s, omega^2 = 5 - 1
    const double t = 4;
    const double exact = std::exp(-t) * (std::cos(2 * t) + 0.5 * std::sin(2 * t));
    expect_error<ingot::SpringDamper, TypeParam>("spring and damper", field, body_at({1, 0, 0}, Vector3::Zero()), t, 128, 2.5, 1,
                                                 [&](const ingot::BodyState& s) { return std::abs(static_cast<double>(s.r_CM.x) - exact); });
}

/// A spring off the centre has a lever: with the mass far heavier than the inertia it is a torsion pendulum.
TYPED_TEST(FieldsOf, spring_off_the_centre_turns_the_body) {
    ingot::Spring field{};
    field.k = 1;
    field.r_body = {1, 0, 0};
    field.anchor = {3, 0, 0};
    ingot::BodyDef def = body_at(Vector3::Zero(), Vector3::Zero(), {1, 1, 1}, 1e9);
    const double angle = 1e-3;
    def.state.A = ingot::axis_angle({0, 0, 1}, static_cast<scalar>(angle));
    const double t = 2, frequency = std::sqrt(3.0);  // torque: k times anchor times lever
    const ingot::BodyState s = after<ingot::Spring, TypeParam>(field, def, t, 256);
    EXPECT_NEAR(static_cast<double>(s.A.c0.y), angle * std::cos(frequency * t), 1e-4 * angle + 300 * eps);
}

}  // namespace
