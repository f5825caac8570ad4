// SPDX-License-Identifier: MIT
// What turns far within a step keeps its energy as it lands, tumbles and rolls: rows of the begin of the step are not those of its middle.
#include "laws/thrown_bodies.h"

#include <cstdio>

#include "reference/brief_types.h"
#include "reference/draws.h"

namespace {

using namespace thrown_bodies;

template <class S>
class Turning : public ::testing::Test {};
using Engines = ingot_reference::BriefTypes<1, Room<ingot::BlockSweeps, false>, Room<ingot::HybridIslands<8, 24>, false>>;
TYPED_TEST_SUITE(Turning, Engines);

constexpr double g = 9.81;
constexpr double rates[] = {30, 60, 120, 240, 1000};

/// A needle that spins about what is across it, up to 1.7 rad a step at 60 Hz, falls on a floor and is thrown up, and falls. Of a step of sixteen
/// substeps; in each its tips may sink by the sagitta of their arc, and are lifted by that.
TYPED_TEST(Turning, needles_that_land_gain_nothing) {
    RandomInput random(81);
    double worst = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(80); ++case_i) {
        const double e = case_i % 3 == 0 ? 0 : case_i % 3 == 1 ? random.real(0, 1) : 1, h = 1 / rates[case_i % 5];
        const double half = 0.5, radius = half / random.real(20, 100), spin = random.real(40, 100);
        Thrown<TypeParam> needle(g, {e, random.real(0, 1)});
        needle.wall({0, 1, 0}, 0);
        const Vector3d v = {random.real(-2, 2), -2, random.real(-2, 2)}, r = {0, half + radius + 0.05, 0};
        needle.body(ingot::Capsule{scalar(radius), scalar(half)}, r, v, any_vector(spin, random), random);
        const double M = 4000 * radius * radius * (half + radius), scale = needle.energy();
        const double sagitta = half / 2 * std::pow(std::min(spin * h / 16, static_cast<double>(ingot::limits::turn_of_substep)), 2);
        const double allowed = 4 * gain_of_step<TypeParam> + 16 * M * g * sagitta / scale;
        const double gain = largest_gain(needle, h, 1) / allowed;
        EXPECT_LE(gain, 1) << "case " << case_i << " e " << e << " 1/h " << 1 / h << " spin " << spin << " allowed " << allowed;
        worst = std::max(worst, gain);
    }
    printf("    largest gain of a step, of what is allowed %.3g\n", worst);
}

/// A disc whose lowest point is at rest.
struct RollingDisc {
    double radius, half_length;
    Matrix3d A;
    Vector3d P, omega;  ///< m, from its centre to its lowest point
};
template <class S>
double share_left_after_a_second(const RollingDisc& disc, double mu, double h) {
    Thrown<S> thrown(g, {0, mu});
    thrown.wall({0, 1, 0}, 0);
    thrown.body_at(ingot::Cylinder{scalar(disc.radius), scalar(disc.half_length)}, -disc.P, -disc.omega.cross(disc.P), disc.omega, disc.A);
    const double begin = thrown.energy();
    (void)largest_gain(thrown, h, 1);
    return thrown.energy() / begin;
}
/// Tilted by so much from lying.
RollingDisc tilted(double radius, double half_length, double tilt) {
    RollingDisc disc = {radius, half_length, {}, {}, {}};
    const Vector3d axis = {std::sin(tilt), std::cos(tilt), 0}, down = {std::cos(tilt), -std::sin(tilt), 0};
    disc.A << down, axis.cross(down), axis;
    disc.P = down * radius - axis * half_length;
    return disc;
}

/// Euler's disc: what rolls round on its rim loses nothing by it. Of second order in the angle by which its lowest point goes round in a substep.
TYPED_TEST(Turning, discs_that_roll_round_on_their_rim_keep_their_energy) {
    RandomInput random(82);
    double worst = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const double h = 1 / rates[case_i % 5], radius = random.real(0.2, 0.5), tilt = random.real(0.3, 0.7);
        RollingDisc disc = tilted(radius, radius * random.real(0.02, 0.1), tilt);
        const double round = std::sqrt(4 * g / (radius * std::sin(tilt)));
        disc.omega = -disc.P.normalized() * round * std::sin(tilt);
        const double turned = round * h / TypeParam::effort.substeps, allowed = turned * turned + 1e-5;
        const double off = std::abs(share_left_after_a_second<TypeParam>(disc, 1, h) - 1) / allowed;
        EXPECT_LE(off, 1) << "case " << case_i << " radius " << radius << " tilt " << tilt << " 1/h " << 1 / h << " allowed " << allowed;
        worst = std::max(worst, off);
    }
    printf("    change of the energy in a second, of what is allowed %.3g\n", worst);
}

/// A coin that rolls on one of its rims, aslant by so much that the other is further from the floor than limits::touching_gap.
TYPED_TEST(Turning, coins_that_roll_aslant_keep_their_energy) {
    RandomInput random(83);
    double worst = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const double h = 1 / rates[case_i % 5], radius = random.real(0.2, 0.5), lean = random.real(0.2, 0.3);
        RollingDisc disc = tilted(radius, radius * random.real(0.03, 0.05), std::acos(-1.0) / 2 - lean);
        disc.omega = disc.A.col(2) * std::sqrt(random.real(1, 4) * g / radius);
        const double turned = disc.omega.norm() * h / TypeParam::effort.substeps, allowed = turned * turned + 1e-5;
        const double off = std::abs(share_left_after_a_second<TypeParam>(disc, 1, h) - 1) / allowed;
        EXPECT_LE(off, 1) << "case " << case_i << " radius " << radius << " lean " << lean << " 1/h " << 1 / h << " allowed " << allowed;
        worst = std::max(worst, off);
    }
    printf("    change of the energy in a second, of what is allowed %.3g\n", worst);
}

}  // namespace
