// SPDX-License-Identifier: MIT
// The methods of one build of the kernel. Compiled once for each scalar and lane count.
#include <ingot/ingot.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "driven/flown_in_field.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "variant.h"

namespace report {

Variant INGOT_JOIN(variant_, INGOT_ABI, )();

namespace {

using namespace ingot_reference;
using ingot::scalar;
using Vector3 = FreeBodyCase::Vector3;
using Matrix3 = FreeBodyCase::Matrix3;

template <class Rotation, int bodies, bool moves = false>
struct Scene : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = moves;
    using rotation = Rotation;
};

template <class W>
ingot::BodyId put(W& world, const FreeBodyCase& body) {
    ingot::BodyDef def = definition(1, body.I);
    def.state.A = to_matrix(body.A_0);
    def.state.L = to_vector(body.L);
    return world.add(def).value;
}

long double energy_of(const ingot::BodyState& s, const Vector3& I) {
    const Vector3 y = to_eigen<long double>(s.A).transpose() * to_eigen<long double>(s.L);
    return y.dot(y.cwiseQuotient(I)) / 2;
}

double worst(double a, double b) { return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b); }

template <class Rotation>
FlightErrors fly(const FreeBodyCase& body, int rate) {
    ingot::World<Scene<Rotation, 1>> world{};
    const ingot::BodyId id = put(world, body);
    FlightErrors errors;
    const scalar h = scalar(1) / static_cast<scalar>(rate);
    const ingot::BodyState begin = world.state(id).value;
    const long double energy = energy_of(begin, body.I);
    const Vector3 L_begin = to_eigen<long double>(begin.L);
    long steps = 0;
    double sign = 0, sign_of_table = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;
        for (; steps < static_cast<long>(due); ++steps) (void)ingot::step(world, h);
        const ingot::BodyState s = world.state(id).value;
        const Matrix3 A = to_eigen<long double>(s.A);
        const Vector3 L = to_eigen<long double>(s.L);
        errors.attitude = worst(errors.attitude, attitude_error(A, sample.A));
        errors.energy = worst(errors.energy, static_cast<double>(std::abs(energy_of(s, body.I) / energy - 1)));
        errors.L = worst(errors.L, static_cast<double>(std::abs(L.norm() / L_begin.norm() - 1)));
        errors.L_direction = worst(errors.L_direction, static_cast<double>(L.cross(L_begin).norm() / L.norm() / L_begin.norm()));
        errors.orthogonality = worst(errors.orthogonality, orthogonality_defect(A));
        const double w = static_cast<double>((A.transpose() * L).y()), w_table = static_cast<double>(sample.w_body.y());
        if (w * sign < 0) ++errors.flips;
        if (w_table * sign_of_table < 0) ++errors.flips_of_table;
        if (w != 0) sign = w;
        if (w_table != 0) sign_of_table = w_table;
        ++errors.samples;
    }
    return errors;
}

template <class Rotation>
double fly_long(const FreeBodyCase& body, int rate, double every, const std::vector<Matrix3>& exact) {
    ingot::World<Scene<Rotation, 1>> world{};
    const ingot::BodyId id = put(world, body);
    double error = 0;
    const long steps = std::lround(every * rate);
    for (const Matrix3& A : exact) {
        error = worst(error, attitude_error(to_eigen<long double>(world.state(id).value.A), A));
        for (long step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, scalar(1) / static_cast<scalar>(rate));
    }
    return error;
}

std::vector<Matrix3> solution(const FreeBodyCase& body, int rate, double every, int count) {
    ingot::World<Scene<ingot::MoserVeselov, 1>> world{};
    const ingot::BodyId id = put(world, body);
    std::vector<Matrix3> A;
    const long steps = std::lround(every * rate);
    for (int sample_i = 0; sample_i < count; ++sample_i) {
        A.push_back(to_eigen<long double>(world.state(id).value.A));
        for (long step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, scalar(1) / static_cast<scalar>(rate));
    }
    return A;
}

/// The worst of each stretch between points that are a third of a decade apart.
template <class Rotation>
std::vector<DriftPoint> drift(const FreeBodyCase& body, int rate, long steps) {
    ingot::World<Scene<Rotation, 1>> world{};
    const ingot::BodyId id = put(world, body);
    const ingot::BodyState begin = world.state(id).value;
    const long double energy = energy_of(begin, body.I);
    const Vector3 L = to_eigen<long double>(begin.L);
    std::vector<DriftPoint> points;
    DriftPoint stretch{};
    double next = 100;
    for (long step_i = 1; step_i <= steps; ++step_i) {
        (void)ingot::step(world, scalar(1) / static_cast<scalar>(rate));
        if (step_i % 7 == 0 || step_i == steps) {
            const ingot::BodyState s = world.state(id).value;
            stretch.energy = worst(stretch.energy, static_cast<double>(std::abs(energy_of(s, body.I) / energy - 1)));
            stretch.orthogonality = worst(stretch.orthogonality, orthogonality_defect(to_eigen<long double>(s.A)));
            stretch.L = worst(stretch.L, static_cast<double>((to_eigen<long double>(s.L) - L).norm() / L.norm()));
        }
        if (static_cast<double>(step_i) < next && step_i != steps) continue;
        stretch.steps = static_cast<double>(step_i);
        points.push_back(stretch);
        stretch = {};
        next *= std::cbrt(10.0);
    }
    return points;
}

/// Spins of up to 6 rad/s, moments of a box; the same for every method.
template <class W>
void fill(W& world, int bodies) {
    unsigned seed = 1997;
    const auto random = [&] {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<scalar>(seed >> 8) / static_cast<scalar>(1 << 24) * 2 - 1;
    };
    for (int body_i = 0; body_i < bodies; ++body_i) {
        const Eigen::Vector3d I(1, 2 + 0.5 * static_cast<double>(random()), 2.5);
        ingot::BodyDef def = definition(1, I);
        const ingot::Vector w = {3 * random(), 3 * random(), 3 * random()};
        def.state.L = ingot::scaled(def.mass.I_body, w);
        if (W::scene::translates) def.state.r_CM = {100 * random(), 100 * random(), 100 * random()};
        (void)world.add(def);
    }
}

/// The least time of a step over the repetitions, over the bodies.
template <class W>
double ns_per_body_step(W& world, int bodies, int steps, int repetitions) {
    double least = std::numeric_limits<double>::infinity();
    for (int repetition_i = 0; repetition_i < repetitions; ++repetition_i) {
        const auto begin = std::chrono::steady_clock::now();
        for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, scalar(1) / 60);
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
        least = std::min(least, time.count() / steps / bodies);
    }
    return least;
}

template <class Rotation>
double time_method(int steps) {
    constexpr int bodies = 1024;
    using W = ingot::World<Scene<Rotation, bodies>>;
    const auto world = std::make_unique<W>();
    fill(*world, bodies);
    return ns_per_body_step(*world, bodies, steps, 7);
}

template <int bodies>
double time_default(bool quick) {
    using W = ingot::World<Scene<ingot::MoserVeselov, bodies, true>>;
    const auto world = std::make_unique<W>();
    fill(*world, bodies);
    const int steps = std::max(1, (quick ? 40000 : 200000) / bodies);
    return ns_per_body_step(*world, bodies, steps, 9);
}

double throughput(int bodies, bool quick) {
    switch (bodies) {
        case 1: return time_default<1>(quick);
        case 64: return time_default<64>(quick);
        case 1024: return time_default<1024>(quick);
        case 4096: return time_default<4096>(quick);
        case 65536: return time_default<65536>(quick);
        default: return 0;
    }
}

template <class Rotation>
Method method(const std::string& name, int order, double angle_max, bool symmetric_only = false) {
    return {name, order, symmetric_only, angle_max, fly<Rotation>, fly_long<Rotation>, drift<Rotation>, time_method<Rotation>};
}

template <class Flight_>
double time_flight(int steps) {
    constexpr int bodies = 1024;
    using W = ingot::World<ingot_driven::Flyer<ingot::WeightAboutPoint, Flight_, ingot::MoserVeselov, bodies>>;
    const auto world = std::make_unique<W>();
    world->force_field().r_body = {0, 0, scalar(0.25)};
    world->force_field().weight = {0, 0, -8};
    fill(*world, bodies);
    return ns_per_body_step(*world, bodies, steps, 7);
}

template <class Flight_>
Flight flight() {
    return {Flight_::name, Flight_::order, [](const TopCase& top, int rate) { return ingot_driven::flown<Flight_>(top, rate); },
            [](const DrivenCase& body, int rate) { return ingot_driven::flown<Flight_>(body, rate); }, time_flight<Flight_>};
}

}  // namespace

Variant INGOT_JOIN(variant_, INGOT_ABI, )() {
    using namespace ingot;
    Variant variant;
    variant.scalar = sizeof(scalar) == 4 ? "float" : "double";
    variant.lanes = ingot::lanes;
    variant.methods = {
        method<MoserVeselov>("default", MoserVeselov::order, 8),
        method<Listing1Euler>("listing1_euler", 1, 2),
        method<LieMidpoint>("lie_midpoint", 2, 2),
        method<Rk4Polar>("rk4_polar", 4, 1.5),
        method<DiscreteMoserVeselov<2>>("moser_veselov_2", 2, 8),
        method<DiscreteMoserVeselov<4>>("moser_veselov_4", 4, 8),
        method<DiscreteMoserVeselov<4, false, false, 1>>("moser_veselov_4_plain", 4, 0.5),
        method<DiscreteMoserVeselov<6>>("moser_veselov_6", 6, 8),
        method<DiscreteMoserVeselov<6, false, false>>("moser_veselov_6_plain", 6, 8),
        method<DiscreteMoserVeselov<8>>("moser_veselov_8", 8, 8),
        method<DiscreteMoserVeselov<10>>("moser_veselov_10", 10, 8),
        method<SymmetricTopSplitting<2>>("symmetric_top_splitting_2", 2, 8),
        method<SymmetricTopSplitting<6>>("symmetric_top_splitting_6", 6, 8),
        method<ExactElliptic>("exact_elliptic", 0, 16),
        method<SymmetricTop>("symmetric_top", 0, 100, true),
    };
    variant.flights = {flight<KickDriftKick>(), flight<BlanesMoan4>(), flight<CommutatorFree4>()};
    variant.throughput = throughput;
    variant.solution = solution;
    return variant;
}

}  // namespace report
