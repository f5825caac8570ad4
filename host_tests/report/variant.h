// SPDX-License-Identifier: MIT
// What each build of the kernel (scalar, lanes) can be asked for. variant.cpp is compiled once for each and fills one of
// these; no type of the kernel shows, so one program holds them all.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact_case.h"
#include "flight_errors.h"
#include "reference/driven_body_table.h"

namespace report {

using ingot_reference::DrivenCase;
using ingot_reference::FreeBodyCase;
using ingot_reference::TopCase;

/// The worst of a stretch of a long run that ends after `steps`.
struct DriftPoint {
    double steps, energy, orthogonality, L;
};

/// A rotation method.
struct Method {
    std::string name;
    int order;         ///< 0: exact for what it is for
    double angle_max;  ///< rad a step; beyond it the method is not asked
    bool symmetric_only;
    std::function<FlightErrors(const FreeBodyCase&, int rate)> fly;
    /// Largest attitude error, rad, against `exact`, which holds A at whole multiples of `every` seconds.
    std::function<double(const FreeBodyCase&, int rate, int every, const std::vector<Orientation>& exact)> fly_long;
    std::function<std::vector<DriftPoint>(const FreeBodyCase&, int rate, long steps)> drift;
    std::function<double(const FreeBodyCase&, int rate, int steps)> ns_of_case;  ///< a body-step of 64 copies of the body
    std::function<double(int steps)> ns_of_crowd;  ///< a body-step of 1024 bodies that only turn, each in its own way
};

/// A scheme for bodies in a force field.
struct Flight {
    std::string name;
    int order;
    std::function<double(const TopCase&, int rate)> fly_top;  ///< largest attitude error, rad; -1: refused
    std::function<double(const DrivenCase&, int rate)> fly_driven;
    std::function<double(int steps)> ns_of_crowd;
};

struct Variant {
    std::string scalar;
    int lanes;
    std::vector<Method> methods;
    std::vector<Flight> flights;
    /// ns per body-step of the whole public step with the default method; bodies that turn and fall, in one world of 1, 64,
    /// 1024, 4096 or 65536.
    std::function<double(int bodies, bool quick)> throughput;
    double bytes_per_body;  ///< of the world of 4096
    std::vector<ContactCase> contacts;
    std::vector<ContactCase> simbenchmark;
};

/// The builds this program holds and this machine can run.
std::vector<Variant> variants();

}  // namespace report
