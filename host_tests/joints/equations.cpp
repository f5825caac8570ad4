// SPDX-License-Identifier: MIT
#include "joints/equations.h"

#include <algorithm>

namespace ingot_figures {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Equations::Equations(const MatrixXd& B)
    : count_(static_cast<int>(B.cols())), basis_(MatrixXd::Zero(B.rows(), 0)), idle_(MatrixXd::Zero(B.cols(), 0)) {
    if (count_ == 0) return;
    scale_ = VectorXd::Ones(count_);
    MatrixXd scaled = B;
    for (int i = 0; i < count_; ++i) {
        const double length = B.col(i).norm();
        if (length > 0) scale_(i) = 1 / length;
        scaled.col(i) *= scale_(i);
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(rank_tolerance);
    qr.compute(scaled);
    rank_ = static_cast<int>(qr.rank());
    order_ = qr.colsPermutation().indices();
    basis_ = qr.householderQ() * MatrixXd::Identity(B.rows(), rank_);
    R_ = qr.matrixR().topLeftCorner(rank_, count_).triangularView<Eigen::Upper>();
    const int rest = count_ - rank_;
    if (rest == 0) return;

    MatrixXd in_order(count_, rest), idle(count_, rest);
    in_order.topRows(rank_) = -R_.leftCols(rank_).triangularView<Eigen::Upper>().solve(R_.rightCols(rest));
    in_order.bottomRows(rest).setIdentity();
    for (int i = 0; i < count_; ++i) idle.row(order_(i)) = scale_(order_(i)) * in_order.row(i);
    for (int i = 0; i < rest; ++i) {  // Gram and Schmidt, twice
        for (int round = 0; round < 2; ++round)
            for (int j = 0; j < i; ++j) idle.col(i) -= idle.col(j).dot(idle.col(i)) * idle.col(j);
        idle.col(i).normalize();
    }
    idle_ = idle;
}

std::vector<int> Equations::independent() const {
    std::vector<int> chosen(order_.data(), order_.data() + rank_);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

VectorXd Equations::answer(const VectorXd& rhs) const {
    VectorXd z(rank_);
    for (int i = 0; i < rank_; ++i) {
        z(i) = scale_(order_(i)) * rhs(order_(i));
        for (int j = 0; j < i; ++j) z(i) -= R_(j, i) * z(j);
        z(i) /= R_(i, i);
    }
    return basis_ * z;
}

MatrixXd Equations::without(const MatrixXd& X) const { return X - basis_ * (basis_.transpose() * X); }

VectorXd Equations::multipliers(const VectorXd& y) const {
    VectorXd lambda = VectorXd::Zero(count_), x = basis_.transpose() * y;
    for (int i = rank_ - 1; i >= 0; --i) {
        for (int j = i + 1; j < rank_; ++j) x(i) -= R_(i, j) * x(j);
        x(i) /= R_(i, i);
        lambda(order_(i)) = scale_(order_(i)) * x(i);
    }
    return lambda - idle_ * (idle_.transpose() * lambda);
}

bool Equations::is_determined(int column) const { return idle_.cols() == 0 || idle_.row(column).norm() < 1e-6; }

}  // namespace ingot_figures
