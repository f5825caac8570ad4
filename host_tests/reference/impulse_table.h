// SPDX-License-Identifier: MIT
// The rows of impulse.csv: a collision, its impulse and the motion after it.
#pragma once

#include <vector>

#include "csv_table.h"
#include "eigen_impulse.h"
#include "free_body_table.h"

namespace ingot_reference {

struct ImpulseCase {
    using Vector3 = Eigen::Matrix<long double, 3, 1>;
    using Matrix3 = Eigen::Matrix<long double, 3, 3>;

    std::size_t row;
    long double M_A, M_B;  ///< kg; M_B = 0 where B is fixed
    Vector3 I_A, I_B;      ///< principal moments; 0 where B is fixed
    Matrix3 A_A, A_B;
    ImpulseBody<long double> A, B;  ///< before
    Vector3 n;
    long double e, j;
    Vector3 v_A_after, v_B_after, omega_A_after, omega_B_after;

    bool B_is_fixed() const { return B.inv_M == 0; }
};

inline std::vector<ImpulseCase> impulse_cases() {
    const CsvTable table("impulse.csv");
    std::vector<ImpulseCase> cases;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        const auto number = [&](const std::string& name) { return table.number<long double>(row, name); };
        const auto column = [&](const std::string& name) {
            return ImpulseCase::Vector3(number(name + "x"), number(name + "y"), number(name + "z"));
        };
        const auto moments = [&](const std::string& name) {
            return ImpulseCase::Vector3(number(name + "1"), number(name + "2"), number(name + "3"));
        };
        const auto attitude = [&](const std::string& q) {
            return rotation_of_quaternion({number(q + "0"), number(q + "1"), number(q + "2"), number(q + "3")});
        };
        ImpulseCase c;
        c.row = row;
        c.A_A = attitude("qA");
        c.A_B = attitude("qB");
        c.I_A = moments("IA");
        c.A.inv_M = 1 / number("mA");
        c.M_A = number("mA");
        c.A.inv_I_world = c.A_A * c.I_A.cwiseInverse().asDiagonal() * c.A_A.transpose();
        c.B.inv_M = number("inv_mB");
        if (c.B_is_fixed()) {
            c.M_B = 0;
            c.I_B.setZero();
            c.B.inv_I_world.setZero();
        } else {
            c.M_B = 1 / c.B.inv_M;
            c.I_B = moments("IB");
            c.B.inv_I_world = c.A_B * c.I_B.cwiseInverse().asDiagonal() * c.A_B.transpose();
        }
        c.A.v = column("vA");
        c.B.v = column("vB");
        c.A.omega = column("wA");
        c.B.omega = column("wB");
        c.A.r_P = column("rA");
        c.B.r_P = column("rB");
        c.n = column("n");
        c.e = number("e");
        c.j = number("j");
        c.v_A_after = column("vA2");
        c.v_B_after = column("vB2");
        c.omega_A_after = column("wA2");
        c.omega_B_after = column("wB2");
        cases.push_back(c);
    }
    return cases;
}

}  // namespace ingot_reference
