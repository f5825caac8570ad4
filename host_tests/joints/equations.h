// SPDX-License-Identifier: MIT
// Columns b_i, of which some may follow from others: what they span, the vectors that answer b_i . y = rhs_i, and the multipliers that make a vector
// of them. By QR with column pivoting, columns scaled to length one first.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace ingot_figures {

class Equations {
public:
    /// Below this share of the largest pivot a column counts as redundant.
    static constexpr double rank_tolerance = 1e-9;

    explicit Equations(const Eigen::MatrixXd& B);

    int rank() const { return rank_; }

    /// Columns that all others follow from, in ascending order.
    std::vector<int> independent() const;

    /// The shortest y with b_i . y = rhs_i for the independent columns, and so for all where they do not contradict each other.
    Eigen::VectorXd answer(const Eigen::VectorXd& rhs) const;

    /// Less what lies in the span of the columns.
    Eigen::MatrixXd without(const Eigen::MatrixXd& X) const;

    /// The shortest lambda with B lambda = y, for a y of the span; of more than that the part outside is left out.
    Eigen::VectorXd multipliers(const Eigen::VectorXd& y) const;

    /// Orthonormal multipliers that make nothing, one a column.
    const Eigen::MatrixXd& idle_basis() const { return idle_; }

    /// False where another multiplier of this column does the same.
    bool is_determined(int column) const;

private:
    int count_, rank_ = 0;
    Eigen::VectorXd scale_;
    Eigen::VectorXi order_;  // of the columns, pivots first
    Eigen::MatrixXd basis_, R_, idle_;
};

}  // namespace ingot_figures
