// SPDX-License-Identifier: MIT
// One case of the tables free_asymmetric or free_symmetric: the body, and where it is at each sample.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "csv_table.h"

namespace ingot_reference {

/// The rotation of a quaternion, scalar first, of any length.
inline Eigen::Matrix<long double, 3, 3> rotation_of_quaternion(const std::vector<long double>& q) {
    const long double a = q[0], b = q[1], c = q[2], d = q[3];
    Eigen::Matrix<long double, 3, 3> A;
    A << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
        a * a - b * b + c * c - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
        a * a - b * b - c * c + d * d;
    return A / (a * a + b * b + c * c + d * d);
}

struct FreeBodyCase {
    using Vector3 = Eigen::Matrix<long double, 3, 1>;
    using Matrix3 = Eigen::Matrix<long double, 3, 3>;

    struct Sample {
        long double t;
        Matrix3 A;
        Vector3 w_body;
    };

    Vector3 I;  ///< principal moments
    Vector3 w_body_0;
    Matrix3 A_0;
    Vector3 L;  ///< world axes
    std::vector<Sample> samples;

    /// `table` is "free_asymmetric" or "free_symmetric".
    FreeBodyCase(const std::string& table, const std::string& name) {
        const CsvTable params(table + "_params.csv"), rows(table + ".csv");
        const std::size_t row = params.row_with("case", name);
        const auto column = [](const std::vector<long double>& x) { return Vector3(x[0], x[1], x[2]); };
        I = column(params.numbers<long double>(row, {"I1", "I2", "I3"}));
        w_body_0 = column(params.numbers<long double>(row, {"w1_0", "w2_0", "w3_0"}));
        A_0 = rotation_of_quaternion(params.numbers<long double>(row, {"q0", "q1", "q2", "q3"}));
        L = A_0 * I.cwiseProduct(w_body_0);
        for (const std::size_t sample_row : rows.rows_with("case", name)) {
            const std::vector<long double> a =
                rows.numbers<long double>(sample_row, {"A11", "A12", "A13", "A21", "A22", "A23", "A31", "A32", "A33"});
            Sample sample;
            sample.t = rows.number<long double>(sample_row, "t");
            sample.A << a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8];
            sample.w_body = column(rows.numbers<long double>(sample_row, {"w1", "w2", "w3"}));
            samples.push_back(sample);
        }
    }
};

}  // namespace ingot_reference
