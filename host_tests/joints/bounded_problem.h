// SPDX-License-Identifier: MIT
// Multipliers within bounds (a boxed linear complementarity problem): limits, contacts, motors with a largest torque.
//
//     w = W lambda + q,     lower <= lambda <= upper,     w = 0 between the bounds, w >= 0 at lower, w <= 0 at upper
//
// W is symmetric and has no negative eigenvalue. Two ways that share nothing but these laws.
#pragma once

#include <Eigen/Dense>

namespace ingot_figures {

struct BoundedProblem {
    Eigen::MatrixXd W;
    Eigen::VectorXd q, lower, upper;

    /// By how much lambda misses the laws, in the unit of w: the change that one projection onto the law of a row makes there, times W_ii.
    double miss(const Eigen::VectorXd& lambda) const;
};

/// Tries every set of rows at their bounds: 2 or 3 to the power of the rows, so for a dozen. The first set that obeys the laws is taken; redundant
/// rows have several.
Eigen::VectorXd solve_by_enumeration(const BoundedProblem& problem);

/// Block principal pivoting (Judice and Pires, Comput. Oper. Res. 21, 1994), one row at a time where blocks cycle. A proximal term makes it finite
/// where W is singular, and rounds of it take it off again. For hundreds of rows.
Eigen::VectorXd solve_by_pivoting(const BoundedProblem& problem);

}  // namespace ingot_figures
