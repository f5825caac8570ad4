// SPDX-License-Identifier: MIT
// Cases of the tables top and driven: a free body's case, and what turns it.
#pragma once

#include "free_body_table.h"

namespace ingot_reference {

/// A heavy top: moments about the fixed point.
struct TopCase : FreeBodyCase {
    long double weight;  ///< N, along -z
    Vector3 r_body;      ///< m, from the fixed point to the centre of mass

    explicit TopCase(const std::string& name) : FreeBodyCase("top", name) {
        const CsvTable params("top_params.csv");
        const std::size_t row = params.row_with("case", name);
        const std::vector<long double> r = params.numbers<long double>(row, {"r1", "r2", "r3"});
        weight = params.number<long double>(row, "mg");
        r_body = Vector3(r[0], r[1], r[2]);
    }

    /// Kinetic energy and that of the weight, J.
    long double energy(const Matrix3& A, const Vector3& L_now) const {
        const Vector3 y = A.transpose() * L_now;
        return y.dot(y.cwiseQuotient(I)) / 2 + weight * (A * r_body).z();
    }
};

/// A body under a torque that is constant in body axes, plus one that swings in world axes.
struct DrivenCase : FreeBodyCase {
    Vector3 tau_body;
    long double nu;                ///< rad/s
    Vector3 constant, cosine, sine;  ///< N m, world: constant + cosine cos(nu t) + sine sin(nu t)

    explicit DrivenCase(const std::string& name) : FreeBodyCase("driven", name) {
        const CsvTable params("driven_params.csv");
        const std::size_t row = params.row_with("case", name);
        const auto column = [&](const std::string& stem) {
            const std::vector<long double> x = params.numbers<long double>(row, {stem + "1", stem + "2", stem + "3"});
            return Vector3(x[0], x[1], x[2]);
        };
        tau_body = column("tb");
        nu = params.number<long double>(row, "nu");
        constant = column("c");
        cosine = column("cc");
        sine = column("cs");
    }
};

}  // namespace ingot_reference
