// SPDX-License-Identifier: MIT
// Heavy tops about a fixed point, and swinging torques: the hard cases T1 to T4 and R16, against tables of 32 digits.
//
// Bounds in float: L takes kicks of h |tau|, each rounded to epsilon |L|. Over N steps that random walk turns the motion by
// sqrt(N) epsilon omega t, 2e-4 rad for the tops at 64 Hz; where the case multiplies errors, it is said.
#include "driven/flown_in_field.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace ingot_driven;
using namespace ingot_reference;
using ingot::BlanesMoan4;
using ingot::CommutatorFree4;
using ingot::KickDriftKick;

constexpr bool is_double = sizeof(ingot::scalar) == 8;

/// Roundings of L, see the top of this file.
double float_floor(const FreeBodyCase& body, int rate) {
    const double t = static_cast<double>(body.samples.back().t), omega = static_cast<double>(body.w_body_0.norm());
    return is_double ? 0 : std::sqrt(t * rate) * static_cast<double>(ingot::epsilon) * std::max(omega, 5.0) * t;
}

double tilt_of(const ingot::BodyState& state) { return std::acos(std::min(1.0, std::max(-1.0, static_cast<double>(state.A.c2.z)))); }
double tilt_of(const FreeBodyCase::Sample& sample) { return std::acos(static_cast<double>(sample.A(2, 2))); }

double angle_between(double a, double b) {
    const double pi = std::acos(-1.0);
    return std::remainder(a - b, 2 * pi);
}

/// The azimuth of the top's axis.
double azimuth_of(const ingot::BodyState& state) { return std::atan2(static_cast<double>(state.A.c2.y), static_cast<double>(state.A.c2.x)); }
double azimuth_of(const FreeBodyCase::Sample& sample) {
    return std::atan2(static_cast<double>(sample.A(1, 2)), static_cast<double>(sample.A(0, 2)));
}

/// T1: the tilt stays, the azimuth goes at the rate of the table.
template <class Flight>
void expect_regular_precession(const char* name, int rate) {
    const TopCase top(name);
    double tilt = 0, azimuth = 0, angle = 0;
    flown<Flight>(top, rate, [&](const Sampled& at) {
        tilt = std::max(tilt, std::abs(tilt_of(at.state) - tilt_of(top.samples.front())));
        azimuth = std::max(azimuth, std::abs(angle_between(azimuth_of(at.state), azimuth_of(*at.reference))));
    });
    // The rate of precession: p of I1 cos p^2 - I3 w3 p + mg r3 = 0 is w2 / sin tilt here, where the top starts.
    angle = static_cast<double>(top.w_body_0.y() / std::sin(tilt_of(top.samples.front())) * top.samples.back().t);
    std::printf("    %-13s %-18s %3d Hz: tilt %.1e rad, azimuth %.1e of %.0f rad\n", name, Flight::name, rate, tilt, azimuth, angle);
    EXPECT_LE(tilt, 1e-3) << name;
    EXPECT_LE(azimuth, 1e-3 * angle) << name;
}

TEST(HardCases, T1_regular_precession) {
    for (const char* name : {"regular_slow", "regular_fast"}) {
        expect_regular_precession<KickDriftKick>(name, 64);
        expect_regular_precession<BlanesMoan4>(name, 64);
    }
    expect_regular_precession<CommutatorFree4>("regular_slow", 64);
    expect_regular_precession<CommutatorFree4>("regular_fast", 256);  // 34 rad/s: half a radian a step at 64 Hz
}

struct TurningPoints {
    double least, most;  ///< tilt, rad
};

/// Where a symmetric top turns: E and L_z leave f(u) = 2 I1 (E - L3^2/2 I3 - mg r u)(1 - u^2) - (L_z - L3 u)^2 >= 0 for the cosine u
/// of its tilt, a cubic with two roots in [-1, 1].
TurningPoints turning_points(const TopCase& top) {
    const FreeBodyCase::Sample& at = top.samples.front();
    const long double L_3 = top.I.z() * top.w_body_0.z(), L_z = top.L.z(), mgr = top.weight * top.r_body.z();
    const long double E = top.energy(at.A, top.L) - L_3 * L_3 / (2 * top.I.z());
    const auto f = [&](long double u) { return 2 * top.I.x() * (E - mgr * u) * (1 - u * u) - (L_z - L_3 * u) * (L_z - L_3 * u); };
    // A cubic with f -> +inf at +inf: between its roots in [-1, 1] it is positive, and greatest at the lesser root of f'.
    const long double a = 2 * top.I.x() * mgr, b = -2 * top.I.x() * E - L_3 * L_3, c = -2 * top.I.x() * mgr + 2 * L_z * L_3;
    const long double peak = (-b - std::sqrt(b * b - 3 * a * c)) / (3 * a);
    const auto root = [&](long double inside, long double outside) {
        for (int halving_i = 0; halving_i < 200; ++halving_i) {
            const long double middle = (inside + outside) / 2;
            (f(middle) >= 0 ? inside : outside) = middle;
        }
        return static_cast<double>(std::acos(inside));
    };
    return {root(peak, 1), root(peak, -1)};
}

/// T2: the axis turns back where the integrals say.
template <class Flight>
void expect_turning_points(const char* name, int rate) {
    const TopCase top(name);
    ingot::World<Flyer<ingot::WeightAboutPoint, Flight>> world{};
    world.force_field() = field_of(top);
    ingot::BodyDef def = definition(1, top.I);
    def.state.A = to_matrix(top.A_0);
    def.state.L = to_vector(top.L);
    const ingot::BodyId id = world.add(def).value;
    TurningPoints found{9, 0};
    for (int step_i = 0; step_i <= 20 * rate; ++step_i) {
        const double tilt = tilt_of(world.state(id).value);
        found.least = std::min(found.least, tilt);
        found.most = std::max(found.most, tilt);
        ASSERT_TRUE(ingot::step(world, ingot::scalar(1) / static_cast<ingot::scalar>(rate)).clean());
    }
    // Steps miss the extreme by at most half a step of h: tilt'' h^2 / 8, with tilt'' <= w3 L3 / I1 times the swing.
    const TurningPoints exact = turning_points(top);
    const double frequency = static_cast<double>(top.I.z() * top.w_body_0.z() / top.I.x());
    const double missed = frequency * frequency * (exact.most - exact.least) / 2 / (8.0 * rate * rate);
    std::printf("    %-13s %-18s %3d Hz: tilt from %.4f to %.4f rad, exact %.4f to %.4f\n", name, Flight::name, rate, found.least, found.most,
                exact.least, exact.most);
    EXPECT_NEAR(found.least, exact.least, 1e-3 + missed) << name;
    EXPECT_NEAR(found.most, exact.most, 1e-3 + missed) << name;
}

/// The same flight without the low digits of A: it errs by their roundings more, a few in each step, along each of two turns.
TEST(HardCases, T2_without_low_digits) {
    using Plain = ingot::DiscreteMoserVeselov<6, false, true>;
    static_assert(!Plain::compensates && ingot::MoserVeselov::compensates, "the two differ in this");
    const TopCase top("looping");
    const double with = flown<CommutatorFree4>(top, 256), without = flown<CommutatorFree4, Plain>(top, 256);
    const double steps = 256 * static_cast<double>(top.samples.back().t);
    std::printf("    looping 256 Hz: attitude %.1e rad with low digits, %.1e without\n", with, without);
    EXPECT_GE(with, 0);
    EXPECT_GE(without, 0);
    EXPECT_LE(without, with + 8 * static_cast<double>(ingot::epsilon) * steps);
}

TEST(HardCases, T2_nutation) {
    for (const char* name : {"cuspidal", "looping", "wavy"}) {
        expect_turning_points<KickDriftKick>(name, 64);
        expect_turning_points<BlanesMoan4>(name, 64);
        expect_turning_points<CommutatorFree4>(name, 256);

        const TopCase top(name);
        const double exact = flown<BlanesMoan4>(top, 256), free = flown<CommutatorFree4>(top, 256);
        std::printf("    %-13s 256 Hz: attitude %.1e rad (Blanes-Moan), %.1e (commutator-free)\n", name, exact, free);
        EXPECT_GE(std::min(exact, free), 0);
        EXPECT_LE(exact, is_double ? 1e-10 : 1e-2) << name;
        EXPECT_LE(free, is_double ? 1e-5 : 1e-2) << name;
    }
    // The issue of the default: the looping top at 64 Hz.
    const double looping = flown<KickDriftKick>(TopCase("looping"), 64);
    EXPECT_GE(looping, 0);
    EXPECT_LE(looping, 2e-3);
}

/// Seconds until the tilt passes `limit`, interpolated between steps; the case's end if it never does.
double time_to_tilt(const TopCase& top, double limit, int rate) {
    ingot::World<Flyer<ingot::WeightAboutPoint, KickDriftKick>> world{};
    world.force_field() = field_of(top);
    ingot::BodyDef def = definition(1, top.I);
    def.state.A = to_matrix(top.A_0);
    def.state.L = to_vector(top.L);
    const ingot::BodyId id = world.add(def).value;
    double before = tilt_of(world.state(id).value);
    const int steps = static_cast<int>(top.samples.back().t * rate);
    for (int step_i = 1; step_i <= steps; ++step_i) {
        EXPECT_TRUE(ingot::step(world, ingot::scalar(1) / static_cast<ingot::scalar>(rate)).clean());
        const double tilt = tilt_of(world.state(id).value);
        if (tilt >= limit) return (step_i - 1 + (limit - before) / (tilt - before)) / rate;
        before = tilt;
    }
    return static_cast<double>(top.samples.back().t);
}

/// The same of the table, which has a sample every quarter of a second: the tilt grows as exp(rate t) while it is small.
double time_to_tilt_of_table(const TopCase& top, double limit) {
    for (std::size_t i = 1; i < top.samples.size(); ++i) {
        const double before = tilt_of(top.samples[i - 1]), after = tilt_of(top.samples[i]);
        if (after < limit) continue;
        const double share = std::log(limit / before) / std::log(after / before);
        return static_cast<double>(top.samples[i - 1].t) + share * static_cast<double>(top.samples[i].t - top.samples[i - 1].t);
    }
    return static_cast<double>(top.samples.back().t);
}

TEST(HardCases, T3_sleeping_top) {
    const TopCase stable("sleeping_stable"), unstable("sleeping_unstable");
    double tilt = 0;
    flown<KickDriftKick>(stable, 64, [&](const Sampled& at) { tilt = std::max(tilt, tilt_of(at.state)); });
    EXPECT_LT(tilt, 10 * tilt_of(stable.samples.front()));

    const double expected = time_to_tilt_of_table(unstable, 0.5), found = time_to_tilt(unstable, 0.5, 64);
    std::printf("    stable: tilt up to %.2e rad from %.2e; unstable: 0.5 rad after %.3f s, table %.3f s\n", tilt,
                tilt_of(stable.samples.front()), found, expected);
    EXPECT_LT(expected, 10.0);
    EXPECT_NEAR(found, expected, 0.05 * expected);
}

/// Fast tops at coarse steps: 2 rad a step and less. Substeps of no more than 1/4 rad make them what a step of so much is, to twice it: the spin
/// changes a little on the way, and with it the number of substeps.
TEST(HardCases, T2_commutator_free_at_coarse_steps) {
    for (const char* name : {"regular_slow", "regular_fast", "cuspidal", "looping", "wavy"}) {
        const TopCase top(name);
        int fine = 16;
        while (static_cast<double>(top.w_body_0.norm()) / fine > 0.25) fine *= 2;
        const double wanted = flown<CommutatorFree4>(top, fine);
        EXPECT_GT(wanted, 0);
        for (int rate = 16; rate < fine; rate *= 2) {
            const double error = flown<CommutatorFree4>(top, rate);
            std::printf("    %-13s %3d Hz: %.1e rad, at %d Hz %.1e\n", name, rate, error, fine, wanted);
            EXPECT_GE(error, 0);
            EXPECT_LE(error, 2 * wanted + 10 * float_floor(top, fine));
        }
    }
}

/// A body takes the substeps of its own spin, in whatever tile it is: the same bits alone and beside faster ones. Beyond 4 rad a step it is reported.
TEST(HardCases, T2_commutator_free_substeps_are_of_each_body) {
    const TopCase top("looping");
    using Scene = Flyer<ingot::WeightAboutPoint, CommutatorFree4, ingot::MoserVeselov, 8>;
    ingot::World<Scene> crowd{};
    crowd.force_field() = field_of(top);
    ingot::BodyDef def = definition(1, top.I);
    def.state.A = to_matrix(top.A_0);
    ingot::BodyId ids[8];
    const auto spin = [&](int i) { return to_vector(Eigen::Vector3d(top.L.cast<double>() * std::pow(0.5, 4 - i))); };
    for (int i = 0; i < 8; ++i) {
        def.state.L = spin(i);
        ids[i] = crowd.add(def).value;
    }
    int reported = 0;
    for (int step_i = 0; step_i < 64; ++step_i) reported += ingot::step(crowd, ingot::scalar(1) / 64).spins_clamped;
    // 24 rad/s times 2^(i - 4): 0.02 to 3 rad a step, but for a nutation that may reach beyond.
    EXPECT_EQ(reported, 0);
    for (int i = 0; i < 8; ++i) {
        ingot::World<Scene> alone{};
        alone.force_field() = field_of(top);
        def.state.L = spin(i);
        const ingot::BodyId id = alone.add(def).value;
        for (int step_i = 0; step_i < 64; ++step_i) (void)ingot::step(alone, ingot::scalar(1) / 64);
        EXPECT_EQ(to_eigen(alone.state(id).value.A), to_eigen(crowd.state(ids[i]).value.A)) << i;
        EXPECT_EQ(to_eigen(alone.state(id).value.L), to_eigen(crowd.state(ids[i]).value.L)) << i;
    }
    def.state.L = to_vector(Eigen::Vector3d(top.L.cast<double>() * 16));
    ingot::World<Scene> fast{};
    ASSERT_TRUE(fast.add(def).ok());
    EXPECT_EQ(ingot::step(fast, ingot::scalar(1) / 64).spins_clamped, 1);
}

TEST(HardCases, T4_chaotic_top) {
    const TopCase top("asymmetric_chaotic");
    const double exact = flown<BlanesMoan4>(top, 64), free = flown<CommutatorFree4>(top, 64), plain = flown<KickDriftKick>(top, 64);
    std::printf("    chaotic, 64 Hz: attitude %.1e rad (Blanes-Moan), %.1e (commutator-free), %.1e (kick-drift-kick)\n", exact, free, plain);
    EXPECT_GE(std::min({exact, free, plain}), 0);
    EXPECT_LE(exact, is_double ? 1e-7 : 1e-3);  // float: roundings of the first second grow a hundredfold in ten
    EXPECT_LE(free, is_double ? 1e-4 : 1e-3);
    EXPECT_LE(plain, 5e-2);
}

/// Slope of log error against log h over three halvings; the least squares line.
template <class Flight, class Case>
double slope_of(const Case& body, int first_rate) {
    double mean_x = 0, mean_y = 0, xy = 0, xx = 0;
    std::vector<double> x, y;
    for (int halving_i = 0; halving_i < 4; ++halving_i) {
        const int rate = first_rate << halving_i;
        const double error = flown<Flight>(body, rate);
        EXPECT_GT(error, 0);
        x.push_back(-std::log2(static_cast<double>(rate)));
        y.push_back(std::log2(error));
        mean_x += x.back() / 4;
        mean_y += y.back() / 4;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mean_x) * (y[i] - mean_y);
        xx += (x[i] - mean_x) * (x[i] - mean_x);
    }
    return xy / xx;
}

TEST(HardCases, R16_torque_in_body_axes_and_in_world_axes) {
    for (const char* name : {"body_spin_up", "body_asymmetric", "world_rotating", "world_mixed"}) {
        const DrivenCase body(name);
        const double exact = flown<BlanesMoan4>(body, 64), free = flown<CommutatorFree4>(body, 64), plain = flown<KickDriftKick>(body, 64);
        std::printf("    %-16s 64 Hz: attitude %.1e rad (Blanes-Moan), %.1e (commutator-free), %.1e (kick-drift-kick)\n", name, exact, free, plain);
        EXPECT_GE(std::min({exact, free, plain}), 0);
        EXPECT_LE(exact, 1e-4 + 10 * float_floor(body, 64)) << name;
        EXPECT_LE(free, 1e-4 + 10 * float_floor(body, 64)) << name;
        EXPECT_LE(plain, 0.1) << name;
    }
    if (!is_double) return;  // float is at its floor before the slopes show
    for (const char* name : {"body_asymmetric", "world_rotating", "world_mixed"}) {
        const DrivenCase body(name);
        const double two = slope_of<KickDriftKick>(body, 64), four = slope_of<CommutatorFree4>(body, 64);  // no substeps
        std::printf("    %-16s order %.2f (kick-drift-kick), %.2f (commutator-free)\n", name, two, four);
        EXPECT_NEAR(two, 2, 0.3) << name;
        EXPECT_NEAR(four, 4, 0.3) << name;
    }
    const double four = slope_of<BlanesMoan4>(TopCase("asymmetric_chaotic"), 16);
    std::printf("    chaotic top: order %.2f (Blanes-Moan)\n", four);
    EXPECT_NEAR(four, 4, 0.3);
}

}  // namespace
