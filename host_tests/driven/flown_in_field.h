// SPDX-License-Identifier: MIT
// A case of the tables top or driven, flown in a world with a force field, and compared sample by sample.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "reference/driven_body_table.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"

// The kernel's own namespace of scalar and lanes keeps builds apart that meet in one program.
namespace ingot_driven { inline namespace INGOT_ABI {

template <class Field, class Flight, class Rotation = ingot::MoserVeselov, int bodies = 1>
struct Flyer : ingot::Scene {
    static constexpr int max_bodies = bodies;
    using force_field = Field;
    using flight = Flight;
    using rotation = Rotation;
};

/// The torque of a DrivenCase.
struct SwingingTorque : ingot::ForceField {
    static constexpr bool depends_on_velocity = false;
    ingot::Vector tau_body, constant, cosine, sine;
    ingot::scalar nu;
    ingot::Wrench operator()(const ingot::BodyMotion& body) const {
        const ingot::scalar angle = nu * body.t;
        return ingot::Wrench::torque(body.A * ingot::splat(tau_body) + ingot::splat(constant + cosine * std::cos(angle) + sine * std::sin(angle)));
    }
};

inline ingot::WeightAboutPoint field_of(const ingot_reference::TopCase& top) {
    ingot::WeightAboutPoint field{};
    field.r_body = ingot_reference::to_vector(top.r_body);
    field.weight = {0, 0, -static_cast<ingot::scalar>(top.weight)};
    return field;
}

inline SwingingTorque field_of(const ingot_reference::DrivenCase& body) {
    SwingingTorque field{};
    field.tau_body = ingot_reference::to_vector(body.tau_body);
    field.constant = ingot_reference::to_vector(body.constant);
    field.cosine = ingot_reference::to_vector(body.cosine);
    field.sine = ingot_reference::to_vector(body.sine);
    field.nu = static_cast<ingot::scalar>(body.nu);
    return field;
}

struct Sampled {
    const ingot_reference::FreeBodyCase::Sample* reference;
    ingot::BodyState state;
};

/// Flies a case at `rate` steps a second; tells each sample. Returns the largest attitude error, rad, and -1 if a report was not
/// clean.
template <class Flight, class Rotation = ingot::MoserVeselov, class Case>
double flown(const Case& body, int rate, const std::function<void(const Sampled&)>& see = {}) {
    using namespace ingot_reference;
    using Field = decltype(field_of(body));
    ingot::World<Flyer<Field, Flight, Rotation>> world{};
    world.force_field() = field_of(body);
    ingot::BodyDef def = definition(1, body.I);
    def.state.A = to_matrix(body.A_0);
    def.state.L = to_vector(body.L);
    const ingot::BodyId id = world.add(def).value;

    double worst = 0;
    long steps = 0;
    bool clean = true;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;
        for (; steps < static_cast<long>(due); ++steps)
            clean = ingot::step(world, ingot::scalar(1) / static_cast<ingot::scalar>(rate)).clean() && clean;
        const ingot::BodyState state = world.state(id).value;
        worst = std::max(worst, attitude_error(to_eigen<long double>(state.A), sample.A));
        if (see) see({&sample, state});
    }
    return clean && worst == worst ? worst : -1;
}

} }  // namespace ingot_driven
