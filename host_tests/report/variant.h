// SPDX-License-Identifier: MIT
// What each build of the kernel (scalar, lanes) can be asked for. variant.cpp is compiled once for each and fills one of these.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/driven_body_table.h"

namespace report {

/// Errors of a flight against the samples of a table, worst over the samples.
struct FlightErrors {
    double attitude = 0;       ///< rad
    double energy = 0;         ///< relative
    double L = 0;              ///< relative, of |L|
    double L_direction = 0;    ///< rad
    double orthogonality = 0;  ///< largest entry of |A^T A - 1|
    int flips = 0, flips_of_table = 0;  ///< changes of sign of the spin about the middle axis, from sample to sample
    int samples = 0;
};

/// One point of a long run.
struct DriftPoint {
    double steps, energy, orthogonality, L;
};

struct Method {
    std::string name;
    int order;                 ///< 0: exact for what it is for
    bool symmetric_only;
    double angle_max;          ///< rad a step; beyond it the method is not asked
    std::function<FlightErrors(const ingot_reference::FreeBodyCase&, int rate)> fly;
    /// Largest attitude error against `exact`, which holds A at whole multiples of `every` seconds.
    std::function<double(const ingot_reference::FreeBodyCase&, int rate, double every, const std::vector<ingot_reference::FreeBodyCase::Matrix3>& exact)>
        fly_long;
    std::function<std::vector<DriftPoint>(const ingot_reference::FreeBodyCase&, int rate, long steps)> drift;
    std::function<double(int steps)> ns_per_body_step;  ///< of 1024 bodies that only turn
};

struct Flight {
    std::string name;
    int order;
    std::function<double(const ingot_reference::TopCase&, int rate)> fly_top;
    std::function<double(const ingot_reference::DrivenCase&, int rate)> fly_driven;
    std::function<double(int steps)> ns_per_body_step;
};

struct Variant {
    std::string scalar;
    int lanes;
    std::vector<Method> methods;
    std::vector<Flight> flights;
    /// ns per body-step of the whole public step with the default method, bodies that turn and fall; 0 for a count it has no world for.
    std::function<double(int bodies, bool quick)> throughput;
    /// The double default's own solution: orientations at whole multiples of `every` seconds.
    std::function<std::vector<ingot_reference::FreeBodyCase::Matrix3>(const ingot_reference::FreeBodyCase&, int rate, double every, int count)> solution;
};

/// The builds this program holds and this machine can run.
std::vector<Variant> variants();

}  // namespace report
