// SPDX-License-Identifier: MIT
// A case of the free-body tables, flown by the kernel's default rotation method and compared sample by sample.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "reference/free_body_table.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"

namespace ingot_stages {

struct Flyer : ingot::Scene {};

struct FlightErrors {
    double attitude = 0;       ///< rad, worst over the samples
    double energy = 0;         ///< relative, worst over the steps
    double orthogonality = 0;  ///< worst over the samples
    bool L_is_kept = true;     ///< bitwise
    bool clean = true;         ///< every report of every step
    double angle_max = 0;      ///< rad, |omega| h, worst over the samples
    int samples = 0;
};

/// 2 E from the primary state, in long double: nothing of what the kernel keeps of the energy goes in.
inline long double twice_energy(const ingot::BodyState& s, const Eigen::Matrix<long double, 3, 1>& I) {
    const Eigen::Matrix<long double, 3, 1> y =
        ingot_reference::to_eigen<long double>(s.A).transpose() * ingot_reference::to_eigen<long double>(s.L);
    return y.dot(y.cwiseQuotient(I));
}

inline bool same_L(const ingot::BodyState& a, const ingot::BodyState& b) {
    return ingot_reference::to_eigen(a.L) == ingot_reference::to_eigen(b.L);
}

/// Flies a case at `rate` steps a second, through a world; samples between two steps are left out.
inline FlightErrors flown(const std::string& table, const std::string& name, int rate) {
    using namespace ingot_reference;
    const FreeBodyCase body(table, name);
    ingot::World<Flyer> world{};
    ingot::BodyDef def = definition(1, body.I);
    def.state.A = to_matrix(body.A_0);
    def.state.L = to_vector(body.L);
    const ingot::BodyId id = world.add(def).value;

    FlightErrors errors;
    const ingot::scalar h = ingot::scalar(1) / static_cast<ingot::scalar>(rate);
    const ingot::BodyState begin = world.state(id).value;
    const long double energy = twice_energy(begin, body.I);
    long steps = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        const long double due = sample.t * rate;
        if (due != std::floor(due)) continue;
        for (; steps < static_cast<long>(due); ++steps) {
            errors.clean = ingot::step(world, h).clean() && errors.clean;
            if (steps % 16 == 0)
                errors.energy = std::max(
                    errors.energy, static_cast<double>(std::abs(twice_energy(world.state(id).value, body.I) / energy - 1)));
        }
        const ingot::BodyState s = world.state(id).value;
        errors.attitude = std::max(errors.attitude, attitude_error(to_eigen<long double>(s.A), sample.A));
        errors.energy = std::max(errors.energy, static_cast<double>(std::abs(twice_energy(s, body.I) / energy - 1)));
        errors.orthogonality = std::max(errors.orthogonality, orthogonality_defect(to_eigen<long double>(s.A)));
        errors.L_is_kept = errors.L_is_kept && same_L(s, begin);
        errors.angle_max = std::max(errors.angle_max, static_cast<double>(sample.w_body.norm()) / rate);
        ++errors.samples;
    }
    std::printf("    %-15s %3d Hz: attitude %.1e rad, energy %.1e, orthogonality %.1e, |omega| h <= %.3f\n", name.c_str(), rate,
                errors.attitude, errors.energy, errors.orthogonality, errors.angle_max);
    return errors;
}

}  // namespace ingot_stages
