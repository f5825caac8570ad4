// SPDX-License-Identifier: MIT
// The methods of one build of the kernel. Compiled once for each scalar and lane count.
#include "variant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "crowd.h"
#include "driven/flown_in_field.h"
#include "flyers.h"
#include "reference/measure.h"

namespace report {

Variant INGOT_JOIN(variant_, INGOT_ABI, )();
std::vector<ContactCase> INGOT_JOIN(contact_cases_, INGOT_ABI, )();  // contact_cases.cpp
std::vector<ContactCase> INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )();

namespace {

using namespace ingot_reference;
using ingot::scalar;
scalar step_at(int rate) { return scalar(1) / static_cast<scalar>(rate); }

long double energy_of(const ingot::BodyState& s, const Vector3& I) {
    return report::energy_of(to_eigen<long double>(s.A), to_eigen<long double>(s.L), I);
}

template <class Flyer>
FlightErrors flown(const FreeBodyCase& body, int rate) {
    Flyer flyer(body);
    const ingot::BodyState begin = flyer.state();
    ErrorTally tally(body, to_eigen<long double>(begin.A), to_eigen<long double>(begin.L));
    long steps = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;  // between two steps
        for (; steps < static_cast<long>(due); ++steps) flyer.step(step_at(rate));
        const ingot::BodyState s = flyer.state();
        tally.see(sample, to_eigen<long double>(s.A), to_eigen<long double>(s.L));
    }
    return tally.errors;
}

template <class Rotation>
FlightErrors fly(const FreeBodyCase& body, int rate) {
    return FlyerInWorld<Rotation>::takes(body) ? flown<FlyerInWorld<Rotation>>(body, rate)
                                               : flown<FlyerOnStage<Rotation>>(body, rate);
}

template <class Rotation>
double fly_long(const FreeBodyCase& body, int rate, int every, const std::vector<Orientation>& exact) {
    FlyerInWorld<Rotation> flyer(body);
    double error = 0;
    for (const Orientation& A : exact) {
        error = worst(error, attitude_error(to_eigen<long double>(flyer.state().A), A));
        for (int step_i = 0; step_i < rate * every; ++step_i) flyer.step(step_at(rate));
    }
    return error;
}

/// The worst of each stretch between points that are a third of a decade apart.
template <class Rotation>
std::vector<DriftPoint> drift(const FreeBodyCase& body, int rate, long steps) {
    FlyerInWorld<Rotation> flyer(body);
    const ingot::BodyState begin = flyer.state();
    const long double energy = energy_of(begin, body.I);
    const Vector3 L = to_eigen<long double>(begin.L);
    std::vector<DriftPoint> points;
    DriftPoint stretch{};
    // 100, 215, 464, 1000 ...: whole numbers, so that every compiler ends its stretches at the same steps.
    constexpr long third_of_decade[] = {100, 215, 464};
    int point_i = 0;
    long next = third_of_decade[0], decade = 1;
    for (long step_i = 1; step_i <= steps; ++step_i) {
        flyer.step(step_at(rate));
        // Primes, so that no period of the motion or of the polar step hides anything.
        if (step_i % (step_i < 10000 ? 7 : 61) == 0 || step_i == steps) {
            const ingot::BodyState s = flyer.state();
            stretch.energy = worst(stretch.energy, relative(energy_of(s, body.I), energy));
            stretch.orthogonality = worst(stretch.orthogonality, orthogonality_defect(to_eigen<long double>(s.A)));
            stretch.L = worst(stretch.L, static_cast<double>((to_eigen<long double>(s.L) - L).norm() / L.norm()));
        }
        if (step_i < next && step_i != steps) continue;
        stretch.steps = static_cast<double>(step_i);
        points.push_back(stretch);
        stretch = {};
        if (++point_i % 3 == 0) decade *= 10;
        next = third_of_decade[point_i % 3] * decade;
    }
    return points;
}

template <class W>
void fill(W& world, int bodies) {
    Crowd crowd;
    for (int body_i = 0; body_i < bodies; ++body_i) {
        const CrowdBody body = crowd.next();
        ingot::BodyDef def = definition(1, body.I);
        def.state.L = to_vector(body.I.cwiseProduct(body.omega_body));
        if (W::scene::translates) def.state.r_CM = to_vector(body.r);
        (void)world.add(def);
    }
    if constexpr (W::scene::translates) (void)world.set_gravity({0, 0, scalar(-9.81)});
}

template <class W>
double ns_per_body_step(W& world, int rate, int steps, int repetitions) {
    return least_ns(repetitions,
                    [&] {
                        for (int step_i = 0; step_i < steps; ++step_i) (void)ingot::step(world, step_at(rate));
                    }) /
           steps / W::max_bodies;
}

template <class Rotation>
double ns_of_case(const FreeBodyCase& body, int rate, int steps) {
    using W = ingot::World<SceneOf<Rotation, 64>>;
    const auto world = std::make_unique<W>();
    for (int copy_i = 0; copy_i < W::max_bodies; ++copy_i) (void)world->add(definition_of(body));
    return ns_per_body_step(*world, rate, steps, 7);
}

template <class Rotation>
double ns_of_crowd(int steps) {
    using W = ingot::World<SceneOf<Rotation, 1024>>;
    const auto world = std::make_unique<W>();
    fill(*world, W::max_bodies);
    return ns_per_body_step(*world, 60, steps, 7);
}

template <class Rotation>
Method method(const char* name, int order, double angle_max, bool symmetric_only) {
    return {name,
            order,
            angle_max,
            symmetric_only,
            fly<Rotation>,
            fly_long<Rotation>,
            drift<Rotation>,
            ns_of_case<Rotation>,
            ns_of_crowd<Rotation>};
}

template <class Flight_>
double ns_of_driven_crowd(int steps) {
    using W = ingot::World<ingot_driven::Flyer<ingot::WeightAboutPoint, Flight_, ingot::MoserVeselov, 1024>>;
    const auto world = std::make_unique<W>();
    world->force_field().r_body = {0, 0, scalar(0.25)};
    world->force_field().weight = {0, 0, -8};
    fill(*world, W::max_bodies);
    return ns_per_body_step(*world, 60, steps, 7);
}

template <class Flight_>
Flight flight() {
    return {Flight_::name, Flight_::order, [](const TopCase& top, int rate) { return ingot_driven::flown<Flight_>(top, rate); },
            [](const DrivenCase& body, int rate) { return ingot_driven::flown<Flight_>(body, rate); },
            ns_of_driven_crowd<Flight_>};
}

template <int bodies>
using MovingWorld = ingot::World<SceneOf<ingot::MoserVeselov, bodies, true>>;

template <int bodies>
double ns_of_moving(bool quick) {
    const auto world = std::make_unique<MovingWorld<bodies>>();
    fill(*world, bodies);
    return ns_per_body_step(*world, 60, std::max(1, (quick ? 40000 : 200000) / bodies), 9);
}

double throughput(int bodies, bool quick) {
    switch (bodies) {
        case 1:
            return ns_of_moving<1>(quick);
        case 64:
            return ns_of_moving<64>(quick);
        case 1024:
            return ns_of_moving<1024>(quick);
        case 4096:
            return ns_of_moving<4096>(quick);
        default:
            return ns_of_moving<65536>(quick);
    }
}

}  // namespace

Variant INGOT_JOIN(variant_, INGOT_ABI, )() {
    using namespace ingot;
    Variant variant;
    variant.scalar = sizeof(scalar) == 4 ? "float" : "double";
    variant.lanes = ingot::lanes;
    variant.methods = {
#define INGOT_METHOD(name, order, angle_max, symmetric_only, ...) method<__VA_ARGS__>(#name, order, angle_max, symmetric_only),
#include "methods.def"
#undef INGOT_METHOD
    };
    variant.flights = {flight<KickDriftKick>(), flight<BlanesMoan4>(), flight<CommutatorFree4>()};
    variant.throughput = throughput;
    variant.bytes_per_body = static_cast<double>(sizeof(MovingWorld<4096>)) / 4096;
    variant.contacts = INGOT_JOIN(contact_cases_, INGOT_ABI, )();
    variant.simbenchmark = INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )();
    return variant;
}

}  // namespace report
