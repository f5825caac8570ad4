// SPDX-License-Identifier: MIT
#include "joints/bounded_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "joints/equations.h"

namespace ingot_figures {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

enum class At { lower, between, upper };

/// Multipliers where the rows that are between their bounds have w = 0.
VectorXd with_set(const BoundedProblem& problem, const std::vector<At>& at) {
    const int n = static_cast<int>(problem.q.size());
    VectorXd lambda(n);
    std::vector<int> free;
    for (int i = 0; i < n; ++i) {
        const At where = at[static_cast<std::size_t>(i)];
        if (where == At::between) free.push_back(i);
        lambda(i) = where == At::lower ? problem.lower(i) : where == At::upper ? problem.upper(i) : 0;
    }
    const int count = static_cast<int>(free.size());
    if (count == 0) return lambda;
    const VectorXd w = problem.W * lambda + problem.q;
    MatrixXd W(count, count);
    VectorXd rhs(count);
    for (int i = 0; i < count; ++i) {
        rhs(i) = -w(free[static_cast<std::size_t>(i)]);
        for (int j = 0; j < count; ++j) W(i, j) = problem.W(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
    }
    const Equations equations(W);  // W is symmetric
    VectorXd x = equations.answer(rhs);
    x += equations.answer(rhs - W * x);
    for (int i = 0; i < count; ++i) lambda(free[static_cast<std::size_t>(i)]) = x(i);
    return lambda;
}

/// What rounding leaves in w.
double grain(const BoundedProblem& problem, const VectorXd& lambda) {
    const VectorXd sizes = problem.W.cwiseAbs() * lambda.cwiseAbs() + problem.q.cwiseAbs();
    return 100 * std::numeric_limits<double>::epsilon() * (sizes.size() > 0 ? sizes.maxCoeff() : 0);
}

/// Rows whose multiplier is out of its bounds, or whose w has the wrong sign at a bound; `next` is where they belong.
int wrong_rows(const BoundedProblem& problem, const VectorXd& lambda, const std::vector<At>& at, std::vector<At>& next) {
    const VectorXd w = problem.W * lambda + problem.q;
    const double tolerance = grain(problem, lambda);
    next = at;
    int wrong = 0;
    for (int i = 0; i < static_cast<int>(at.size()); ++i) {
        At& where = next[static_cast<std::size_t>(i)];
        const double slack = tolerance / std::max(problem.W(i, i), std::numeric_limits<double>::min());
        if (where == At::between && lambda(i) < problem.lower(i) - slack)
            where = At::lower;
        else if (where == At::between && lambda(i) > problem.upper(i) + slack)
            where = At::upper;
        else if (where == At::lower && w(i) < -tolerance)
            where = At::between;
        else if (where == At::upper && w(i) > tolerance)
            where = At::between;
        else
            continue;
        ++wrong;
    }
    return wrong;
}

/// For a W without zero eigenvalues.
VectorXd pivoted(const BoundedProblem& problem, std::vector<At>& at) {
    constexpr int blocks_without_gain = 10, most_rounds = 100000;
    std::vector<At> next;
    int least = std::numeric_limits<int>::max(), patience = blocks_without_gain;
    VectorXd lambda = with_set(problem, at);
    for (int round = 0; round < most_rounds; ++round) {
        const int wrong = wrong_rows(problem, lambda, at, next);
        if (wrong == 0) break;
        if (wrong < least) {
            least = wrong;
            patience = blocks_without_gain;
        } else {
            --patience;
        }
        if (patience >= 0) {
            at = next;
        } else {  // the last wrong row alone: it ends (Murty)
            std::size_t last = at.size() - 1;
            while (at[last] == next[last]) --last;
            at[last] = next[last];
        }
        lambda = with_set(problem, at);
    }
    return lambda;
}

}  // namespace

double BoundedProblem::miss(const VectorXd& lambda) const {
    const VectorXd w = W * lambda + q;
    double worst = 0;
    for (int i = 0; i < q.size(); ++i) {
        if (W(i, i) <= 0) continue;
        const double wanted = std::min(upper(i), std::max(lower(i), lambda(i) - w(i) / W(i, i)));
        const double off = std::abs(wanted - lambda(i)) * W(i, i);
        if (!(off <= worst)) worst = off;  // a NaN stays
    }
    return worst;
}

VectorXd solve_by_enumeration(const BoundedProblem& problem) {
    const std::size_t n = static_cast<std::size_t>(problem.q.size());
    std::vector<std::vector<At>> choices(n);
    for (std::size_t i = 0; i < n; ++i) {
        choices[i].push_back(At::between);
        if (std::isfinite(problem.lower(static_cast<int>(i)))) choices[i].push_back(At::lower);
        if (std::isfinite(problem.upper(static_cast<int>(i)))) choices[i].push_back(At::upper);
    }
    std::vector<std::size_t> choice(n, 0);
    VectorXd best = VectorXd::Zero(problem.q.size());
    double least = std::numeric_limits<double>::infinity();
    for (;;) {
        std::vector<At> at(n);
        for (std::size_t i = 0; i < n; ++i) at[i] = choices[i][choice[i]];
        const VectorXd lambda = with_set(problem, at).cwiseMax(problem.lower).cwiseMin(problem.upper);
        const double miss = problem.miss(lambda);
        if (miss < least) {
            least = miss;
            best = lambda;
        }
        if (least <= grain(problem, best)) return best;
        std::size_t i = 0;
        while (i < n && ++choice[i] == choices[i].size()) choice[i++] = 0;
        if (i == n) return best;
    }
}

VectorXd solve_by_pivoting(const BoundedProblem& problem) {
    const int n = static_cast<int>(problem.q.size());
    if (n == 0) return {};
    constexpr double share = 1e-6;  // of the proximal term in W_ii: each round takes off all but so much of what independent rows still miss
    constexpr int rounds = 40;
    BoundedProblem near = problem;
    const double most = problem.W.diagonal().maxCoeff();
    const VectorXd weight = share * problem.W.diagonal().cwiseMax(1e-12 * most).cwiseMax(std::numeric_limits<double>::min());
    near.W.diagonal() += weight;
    VectorXd lambda = VectorXd::Zero(n).cwiseMax(problem.lower).cwiseMin(problem.upper), best = lambda;
    double least = problem.miss(lambda);
    std::vector<At> at(static_cast<std::size_t>(n), At::between);
    for (int round = 0; round < rounds && least > grain(problem, best); ++round) {
        near.q = problem.q - weight.cwiseProduct(lambda);
        for (int i = 0; i < n; ++i) {
            At& where = at[static_cast<std::size_t>(i)];
            if (where == At::lower && !std::isfinite(problem.lower(i))) where = At::between;
        }
        lambda = pivoted(near, at).cwiseMax(problem.lower).cwiseMin(problem.upper);
        const double miss = problem.miss(lambda);
        if (miss < least) {
            least = miss;
            best = lambda;
        }
    }
    return best;
}

}  // namespace ingot_figures
