// SPDX-License-Identifier: MIT
// Compares a flight with the samples of a table; the same for the kernel and for its peers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/free_body_table.h"
#include "reference/measure.h"

namespace report {

/// Errors of a flight against the samples of a table, worst over the samples.
struct FlightErrors {
    double attitude = 0;                ///< rad
    double energy = 0;                  ///< relative
    double L = 0;                       ///< relative, of |L|
    double L_direction = 0;             ///< rad
    double orthogonality = 0;           ///< largest entry of |A^T A - 1|
    int flips = 0, flips_of_table = 0;  ///< changes of sign of the spin about the middle axis, from sample to sample
};

/// The larger; infinity once something was not a number.
inline double worst(double a, double b) { return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b); }

inline double relative(long double now, long double begin) { return static_cast<double>(std::abs(now / begin - 1)); }

using Vector3 = ingot_reference::FreeBodyCase::Vector3;
using Orientation = ingot_reference::FreeBodyCase::Matrix3;

/// Kinetic energy of a body with orientation A and angular momentum L, world, J.
inline long double energy_of(const Orientation& A, const Vector3& L, const Vector3& I) {
    const Vector3 y = A.transpose() * L;
    return y.dot(y.cwiseQuotient(I)) / 2;
}

class ErrorTally {
public:
    /// A and L: what the flight begins with, after whatever rounding brought it into the engine.
    ErrorTally(const ingot_reference::FreeBodyCase& body, const Orientation& A, const Vector3& L)
        : I_(body.I), L_(L), energy_(energy_of(A, L, body.I)) {
        for (int i = 0; i < 3; ++i)
            if (I_(i) != I_.maxCoeff() && I_(i) != I_.minCoeff()) middle_axis_ = i;
    }

    void see(const ingot_reference::FreeBodyCase::Sample& sample, const Orientation& A, const Vector3& L) {
        errors.attitude = worst(errors.attitude, ingot_reference::attitude_error(A, sample.A));
        errors.energy = worst(errors.energy, relative(energy_of(A, L, I_), energy_));
        errors.L = worst(errors.L, relative(L.norm(), L_.norm()));
        errors.L_direction =
            worst(errors.L_direction, std::atan2(static_cast<double>(L.cross(L_).norm()), static_cast<double>(L.dot(L_))));
        errors.orthogonality = worst(errors.orthogonality, ingot_reference::orthogonality_defect(A));
        count_flip((A.transpose() * L)(middle_axis_), spin_, errors.flips);
        count_flip(sample.w_body(middle_axis_), spin_of_table_, errors.flips_of_table);
    }

    FlightErrors errors;

private:
    static void count_flip(long double spin, long double& before, int& flips) {
        if (spin * before < 0) ++flips;
        if (spin != 0) before = spin;
    }

    Vector3 I_, L_;
    long double energy_, spin_ = 0, spin_of_table_ = 0;
    int middle_axis_ = 0;
};

}  // namespace report
