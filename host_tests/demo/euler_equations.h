// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace demo {

/// Euler's equations of a free body in its principal axes, I omega' = (I omega) x omega, by Runge-Kutta of order 4 in
/// extended precision at 1000 substeps a step: the reference beside which the demo plots the kernel's motion.
struct EulerEquations {
    using Number = long double;
    Number I[3] = {1, 1, 1}, omega[3] = {};

    EulerEquations() = default;
    EulerEquations(const ingot::Vector& moments, const ingot::Vector& spin)
        : I{moments.x, moments.y, moments.z}, omega{spin.x, spin.y, spin.z} {}

    void advance(Number h) {
        constexpr int substeps = 1000;
        for (int substep_i = 0; substep_i < substeps; ++substep_i) runge_kutta(h / substeps);
    }

private:
    void rate(const Number (&w)[3], Number (&dw)[3]) const {
        for (int i = 0; i < 3; ++i) {
            const int k = (i + 1) % 3, l = (i + 2) % 3;
            dw[i] = (I[k] - I[l]) * w[k] * w[l] / I[i];
        }
    }

    void runge_kutta(Number h) {
        Number k1[3], k2[3], k3[3], k4[3], w[3];
        rate(omega, k1);
        for (int i = 0; i < 3; ++i) w[i] = omega[i] + h / 2 * k1[i];
        rate(w, k2);
        for (int i = 0; i < 3; ++i) w[i] = omega[i] + h / 2 * k2[i];
        rate(w, k3);
        for (int i = 0; i < 3; ++i) w[i] = omega[i] + h * k3[i];
        rate(w, k4);
        for (int i = 0; i < 3; ++i) omega[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
};

}  // namespace demo
