// SPDX-License-Identifier: MIT
// Random numbers, directions, orientations and solids: the same on every run and with every standard library.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <random>

namespace ingot_reference {

class RandomInput {
public:
    explicit RandomInput(std::uint64_t seed) : bits_(seed) {}

    std::uint64_t bits() { return bits_(); }

    /// Uniform in [low, high).
    double real(double low, double high) { return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53); }

    /// Uniform in {low, ..., high}.
    int integer(int low, int high) { return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1)); }

    /// Of either sign, with a magnitude spread evenly over the binades 2^low .. 2^high.
    double of_any_size(int low, int high) {
        const double x = real(1, 2);
        const int binade = integer(low, high);
        return std::ldexp((bits_() & 1) != 0 ? x : -x, binade);
    }

    /// Each component uniform in [-size, size).
    Eigen::Vector3d vector(double size) {
        const double x = real(-size, size), y = real(-size, size);
        return {x, y, real(-size, size)};
    }

    /// Uniform on the unit sphere (von Neumann: the points of the cube that lie in the ball).
    Eigen::Vector3d direction() {
        for (;;) {
            const Eigen::Vector3d v = vector(1);
            const double length = v.norm();
            if (length > 0.01 && length < 1) return v / length;
        }
    }

    /// Uniform over all orientations: a uniform point of the unit sphere in four dimensions, as a quaternion.
    Eigen::Matrix3d rotation() {
        for (;;) {
            const Eigen::Vector3d v = vector(1);
            Eigen::Quaterniond q(real(-1, 1), v.x(), v.y(), v.z());
            const double length = q.norm();
            if (length < 0.01 || length > 1) continue;
            q.coeffs() /= length;
            return q.toRotationMatrix();
        }
    }

    /// Principal moments of a box of mass M whose edges are between 0.3 and 2 m: three different ones, ratio at most 20.
    Eigen::Vector3d moments(double M) {
        const double x = real(0.3, 2), y = real(0.3, 2), z = real(0.3, 2);
        return M / 12 * Eigen::Vector3d(y * y + z * z, z * z + x * x, x * x + y * y);
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace ingot_reference
