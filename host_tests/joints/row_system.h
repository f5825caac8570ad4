// SPDX-License-Identifier: MIT
// Rows on bodies: W = J M^-1 J^T of the rows of a figure, which of them are independent, and the multipliers that answer a right-hand side.
#pragma once

#include <utility>

#include "joints/joint_rows.h"

namespace ingot_figures {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Mass and world inertia of each body at a state, and their inverses; zero inverses for what nothing moves.
class FigureInertia {
public:
    FigureInertia(const FigureScene& scene, const FigureState& state);

    /// Of inverses alone; I() is not there.
    FigureInertia(std::vector<double> inv_M, std::vector<Matrix3d> inv_I) : inv_M_(std::move(inv_M)), inv_I_(std::move(inv_I)) {}

    int body_count() const { return static_cast<int>(inv_M_.size()); }
    double inv_M(int body_i) const { return inv_M_[static_cast<std::size_t>(body_i)]; }
    const Matrix3d& inv_I(int body_i) const { return inv_I_[static_cast<std::size_t>(body_i)]; }
    const Matrix3d& I(int body_i) const { return I_[static_cast<std::size_t>(body_i)]; }

private:
    std::vector<double> inv_M_;
    std::vector<Matrix3d> inv_I_, I_;
};

/// Multipliers of rows. Where rows are redundant they are not unique.
struct Multipliers {
    VectorXd lambda;               ///< of each row; the shortest where they are not unique
    std::vector<bool> determined;  ///< false: other multipliers of this row do the same
    int rank = 0;
    double unmet = 0;  ///< largest miss of the right-hand side: rows that contradict each other
};

/// Velocities and accelerations of all bodies stand in one vector, v_CM and omega of each in turn.
class RowSystem {
public:
    RowSystem(const FigureInertia& inertia, const std::vector<FigureRow>& rows);

    int row_count() const { return static_cast<int>(rows_.size()); }

    /// Rows that all others follow from in the metric of the kinetic energy, in ascending order.
    std::vector<int> independent() const;

    /// J x.
    VectorXd J_times(const VectorXd& x) const;
    /// M^-1 J^T lambda.
    VectorXd response(const VectorXd& lambda) const;

    /// lambda with J M^-1 J^T lambda = rhs on the chosen rows, which are independent; 0 on the others. By Cholesky and one refinement whose residual
    /// goes through J and M^-1, so the error grows as the condition of J and not of W.
    VectorXd solve(const std::vector<int>& chosen, const VectorXd& rhs) const;

    /// All rows, with those that are redundant.
    Multipliers solve_all(const VectorXd& rhs) const;

    /// M^-1/2 J^T: what the rows are in the metric of the kinetic energy.
    MatrixXd in_energy_metric() const;

private:
    const FigureInertia& inertia_;
    const std::vector<FigureRow>& rows_;
};

}  // namespace ingot_figures
