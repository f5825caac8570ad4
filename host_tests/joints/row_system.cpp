// SPDX-License-Identifier: MIT
#include "joints/row_system.h"

#include <cmath>

#include "joints/equations.h"

namespace ingot_figures {

FigureInertia::FigureInertia(const FigureScene& scene, const FigureState& state) {
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const FigureBody& body = scene.body(body_i);
        const Matrix3d A = state.body(body_i).A();
        const bool moves = body.M > 0;
        inv_M_.push_back(moves ? 1 / body.M : 0);
        inv_I_.push_back(moves ? Matrix3d(A * body.I_body.cwiseInverse().asDiagonal() * A.transpose()) : Matrix3d(Matrix3d::Zero()));
        I_.push_back(A * body.I_body.asDiagonal() * A.transpose());
    }
}

RowSystem::RowSystem(const FigureInertia& inertia, const std::vector<FigureRow>& rows) : inertia_(inertia), rows_(rows) {}

MatrixXd RowSystem::in_energy_metric() const {
    MatrixXd B = MatrixXd::Zero(6 * inertia_.body_count(), row_count());
    std::vector<Matrix3d> root;  // of inv_I: its Cholesky factor, L L^T = inv_I
    for (int body_i = 0; body_i < inertia_.body_count(); ++body_i) {
        const bool moves = inertia_.inv_M(body_i) > 0;
        root.push_back(moves ? Matrix3d(inertia_.inv_I(body_i).llt().matrixL()) : Matrix3d(Matrix3d::Zero()));
    }
    for (int row_i = 0; row_i < row_count(); ++row_i) {
        const FigureRow& row = rows_[static_cast<std::size_t>(row_i)];
        for (int part_i = 0; part_i < row.part_count; ++part_i) {
            const FigureRow::Part& part = row.parts[part_i];
            B.block<3, 1>(6 * part.body, row_i) = std::sqrt(inertia_.inv_M(part.body)) * part.on_v;
            B.block<3, 1>(6 * part.body + 3, row_i) = root[static_cast<std::size_t>(part.body)].transpose() * part.on_omega;
        }
    }
    return B;
}

std::vector<int> RowSystem::independent() const { return Equations(in_energy_metric()).independent(); }

VectorXd RowSystem::J_times(const VectorXd& x) const {
    VectorXd result = VectorXd::Zero(row_count());
    for (int row_i = 0; row_i < row_count(); ++row_i) {
        const FigureRow& row = rows_[static_cast<std::size_t>(row_i)];
        for (int part_i = 0; part_i < row.part_count; ++part_i) {
            const FigureRow::Part& part = row.parts[part_i];
            result(row_i) += part.on_v.dot(x.segment<3>(6 * part.body)) + part.on_omega.dot(x.segment<3>(6 * part.body + 3));
        }
    }
    return result;
}

VectorXd RowSystem::response(const VectorXd& lambda) const {
    VectorXd x = VectorXd::Zero(6 * inertia_.body_count());
    for (int row_i = 0; row_i < row_count(); ++row_i) {
        const FigureRow& row = rows_[static_cast<std::size_t>(row_i)];
        for (int part_i = 0; part_i < row.part_count; ++part_i) {
            const FigureRow::Part& part = row.parts[part_i];
            x.segment<3>(6 * part.body) += lambda(row_i) * part.on_v;
            x.segment<3>(6 * part.body + 3) += lambda(row_i) * part.on_omega;
        }
    }
    for (int body_i = 0; body_i < inertia_.body_count(); ++body_i) {
        x.segment<3>(6 * body_i) *= inertia_.inv_M(body_i);
        x.segment<3>(6 * body_i + 3) = inertia_.inv_I(body_i) * x.segment<3>(6 * body_i + 3);
    }
    return x;
}

VectorXd RowSystem::solve(const std::vector<int>& chosen, const VectorXd& rhs) const {
    struct Touch {
        int place;  // in `chosen`
        Vector3d on_v, on_omega;
    };
    std::vector<std::vector<Touch>> of_body(static_cast<std::size_t>(inertia_.body_count()));
    const int n = static_cast<int>(chosen.size());
    VectorXd lambda = VectorXd::Zero(row_count());
    if (n == 0) return lambda;
    for (int place = 0; place < n; ++place) {
        const FigureRow& row = rows_[static_cast<std::size_t>(chosen[static_cast<std::size_t>(place)])];
        for (int part_i = 0; part_i < row.part_count; ++part_i)
            of_body[static_cast<std::size_t>(row.parts[part_i].body)].push_back({place, row.parts[part_i].on_v, row.parts[part_i].on_omega});
    }
    MatrixXd W = MatrixXd::Zero(n, n);  // lower half
    for (int body_i = 0; body_i < inertia_.body_count(); ++body_i) {
        const std::vector<Touch>& touches = of_body[static_cast<std::size_t>(body_i)];
        for (const Touch& a : touches) {
            const Vector3d v = inertia_.inv_M(body_i) * a.on_v, omega = inertia_.inv_I(body_i) * a.on_omega;
            for (const Touch& b : touches)
                if (b.place >= a.place) W(b.place, a.place) += v.dot(b.on_v) + omega.dot(b.on_omega);
        }
    }
    const VectorXd scale = W.diagonal().cwiseSqrt().cwiseInverse();
    W = scale.asDiagonal() * W * scale.asDiagonal();
    const Eigen::LLT<MatrixXd> factors(W);
    VectorXd missing(n);
    for (int round = 0; round < 2; ++round) {
        const VectorXd met = round == 0 ? VectorXd(VectorXd::Zero(row_count())) : J_times(response(lambda));
        for (int place = 0; place < n; ++place) {
            const int row_i = chosen[static_cast<std::size_t>(place)];
            missing(place) = scale(place) * (rhs(row_i) - met(row_i));
        }
        const VectorXd change = factors.solve(missing);
        for (int place = 0; place < n; ++place) lambda(chosen[static_cast<std::size_t>(place)]) += scale(place) * change(place);
    }
    return lambda;
}

Multipliers RowSystem::solve_all(const VectorXd& rhs) const {
    const Equations equations(in_energy_metric());
    Multipliers found;
    found.rank = equations.rank();
    found.lambda = equations.multipliers(equations.answer(rhs));
    for (int row_i = 0; row_i < row_count(); ++row_i) found.determined.push_back(equations.is_determined(row_i));
    if (row_count() > 0) found.unmet = (J_times(response(found.lambda)) - rhs).cwiseAbs().maxCoeff();
    return found;
}

}  // namespace ingot_figures
