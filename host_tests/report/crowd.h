// SPDX-License-Identifier: MIT
// The bodies whose steps are timed, the same for every method, build and engine.
#pragma once

#include <Eigen/Dense>
#include <chrono>
#include <cstdint>
#include <limits>

namespace report {

/// A body of the crowd: 1 kg, the moments of a box, up to 5 rad/s, somewhere in a cube of 400 m.
struct CrowdBody {
    Eigen::Vector3d I, omega_body, r;
};

class Crowd {
public:
    CrowdBody next() {
        CrowdBody body;
        body.I = {1, 2 + 0.5 * random(), 2.5};
        body.omega_body = 3 * Eigen::Vector3d(random(), random(), random());
        body.r = 200 * Eigen::Vector3d(random(), random(), random());
        return body;
    }

private:
    /// -1 .. 1, a multiple of 2^-23. Source: Knuth's linear congruence of Numerical Recipes.
    double random() {
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<double>(state_ >> 8) / (1 << 23) - 1;
    }
    std::uint32_t state_ = 1997;
};

/// The least time of advance() over the repetitions, in ns.
template <class Advance>
double least_ns(int repetitions, Advance advance) {
    double least = std::numeric_limits<double>::infinity();
    for (int repetition_i = 0; repetition_i < repetitions; ++repetition_i) {
        const auto begin = std::chrono::steady_clock::now();
        advance();
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
        if (time.count() < least) least = time.count();
    }
    return least;
}

}  // namespace report
