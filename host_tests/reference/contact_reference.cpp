// SPDX-License-Identifier: MIT
#include "contact_reference.h"

#include <Eigen/SparseLU>

#include "contact_assembly.h"
#include "random_input.h"

namespace ingot_reference {

using namespace contact;

namespace {

/// One inner problem of the augmented Lagrangian: y = sum of g p'(y), where p' is the map of p and of u(y).
class BodyEquation {
public:
    BodyEquation(const Assembly& assembly, const Law& law, const VectorXd& p, const VectorXd* bounds_of)
        : assembly_(assembly), law_(law), p_(p), bounds_of_(bounds_of) {}

    VectorXd impulses(const VectorXd& y) const { return law_.mapped(p_, assembly_.u(y), bounds_of_); }
    VectorXd defect(const VectorXd& y) const { return y - assembly_.pushed(impulses(y)); }

    /// The Newton step from y; false where the matrix is singular.
    bool newton_step(const VectorXd& y, const VectorXd& defect, VectorXd& step) const {
        const VectorXd u = assembly_.u(y);
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < y.size(); ++i) entries.emplace_back(i, i, 1.0);
        for (const Group& group : assembly_.groups) add_group(group, u, entries);
        Eigen::SparseMatrix<double> matrix(y.size(), y.size());
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
        factors.compute(matrix);
        if (factors.info() != Eigen::Success) return false;
        step = factors.solve(-defect);
        return step.allFinite();
    }

private:
    void add_group(const Group& group, const VectorXd& u, std::vector<Eigen::Triplet<double>>& entries) const {
        const std::vector<int> rows = Law::rows_of(group);
        const MatrixXd D = law_.derivative(group, p_, u, bounds_of_);
        const int bodies[2] = {assembly_.row(rows[0]).body_A, assembly_.row(rows[0]).body_B};
        MatrixXd g(12, static_cast<int>(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            g.col(static_cast<int>(i)) << assembly_.row(rows[i]).g_A, assembly_.row(rows[i]).g_B;
        const MatrixXd block = g * D * g.transpose();
        for (int r = 0; r < 12; ++r)
            for (int c = 0; c < 12; ++c)
                if (block(r, c) != 0) entries.emplace_back(6 * bodies[r / 6] + r % 6, 6 * bodies[c / 6] + c % 6, block(r, c));
    }

    const Assembly& assembly_;
    const Law& law_;
    const VectorXd& p_;
    const VectorXd* bounds_of_;
};

/// Newton with a line search on the defect. True when the defect is down to rounding, which stiff points amplify, or down by
/// 1e-6 and at a standstill; the caller judges by the laws themselves.
bool solve_inner(const BodyEquation& equation, double stiffness, VectorXd& y, int& systems) {
    VectorXd defect = equation.defect(y), step;
    const double at_start = defect.norm();
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double size = defect.norm();
        if (size <= 1e-15 * (1e-3 + y.norm())) return true;
        if (!equation.newton_step(y, defect, step)) return false;
        ++systems;
        double t = 1;
        VectorXd trial, trial_defect;
        for (; t > 1e-4; t /= 2) {
            trial = y + t * step;
            trial_defect = equation.defect(trial);
            if (trial_defect.norm() <= (1 - 1e-4 * t) * size) break;
        }
        const bool small = size <= 1e-6 * at_start || size <= 1e-15 * std::max(1e3, stiffness) * (1e-3 + y.norm());
        if (t <= 1e-4 || (small && trial_defect.norm() > 0.5 * size)) return small;
        y = trial;
        defect = trial_defect;
    }
    return false;
}

/// Where the augmented Lagrangian goes round in circles (friction that nearly jams): Newton on p - mapped(p, u(p)) = 0 itself,
/// in m/s, with steps of least length, from p and from places around it. For hundreds of rows at most. True: p is down to
/// `tolerance`.
class NewtonOnImpulses {
public:
    explicit NewtonOnImpulses(const Assembly& assembly) : assembly_(assembly), law_(assembly, 1), w_(assembly.row_count()) {
        const int count = assembly.row_count();
        W_.resize(count, count);
        u_free_ = assembly.u(VectorXd::Zero(6 * assembly.body_count()));
        for (int row_i = 0; row_i < count; ++row_i) {
            w_(row_i) = assembly.row(row_i).w;
            const VectorXd y = assembly.pushed(VectorXd::Unit(count, row_i));
            for (int other_i = 0; other_i < count; ++other_i) W_(other_i, row_i) = assembly.row(other_i).change_of_u(y);
        }
    }

    bool solve(VectorXd& p, double tolerance, int& systems) {
        const VectorXd start = p;
        for (int attempt = 0; attempt < 60; ++attempt) {
            p = start;
            for (int row_i = 0; row_i < p.size(); ++row_i)
                if (attempt > 0)
                    p(row_i) += random_.real(-1, 1) * 0.5 * start.cwiseAbs().maxCoeff() * (attempt % 2 == 0 ? 1 : 0.1);
            descend(p, tolerance, systems);
            if (defect(p).cwiseAbs().maxCoeff() <= tolerance) return true;
        }
        p = start;
        return false;
    }

private:
    VectorXd defect(const VectorXd& p) const { return w_.cwiseProduct(p - law_.mapped(p, u_free_ + W_ * p)); }

    MatrixXd slope(const VectorXd& p) const {
        const VectorXd u = u_free_ + W_ * p;
        const int count = assembly_.row_count();
        MatrixXd kept = MatrixXd::Zero(count, count);  // d mapped / d q
        for (const Group& group : assembly_.groups) {
            const std::vector<int> rows = Law::rows_of(group);
            const MatrixXd D = law_.derivative(group, p, u, nullptr);
            for (std::size_t r = 0; r < rows.size(); ++r)
                for (std::size_t c = 0; c < rows.size(); ++c)
                    if (law_.rho(rows[c]) > 0)
                        kept(rows[r], rows[c]) = D(static_cast<int>(r), static_cast<int>(c)) / law_.rho(rows[c]);
        }
        MatrixXd one_less = -W_;
        for (int row_i = 0; row_i < count; ++row_i) one_less.row(row_i) *= law_.rho(row_i);
        one_less.diagonal().array() += 1;
        return w_.asDiagonal() * (MatrixXd::Identity(count, count) - kept * one_less);
    }

    void descend(VectorXd& p, double tolerance, int& systems) const {
        VectorXd d = defect(p);
        for (int iteration = 0; iteration < 60 && d.cwiseAbs().maxCoeff() > 0.1 * tolerance; ++iteration) {
            const VectorXd step = slope(p).completeOrthogonalDecomposition().solve(-d);
            ++systems;
            double t = 1;
            VectorXd trial, trial_d;
            for (; t > 1e-3; t /= 2) {
                trial = p + t * step;
                trial_d = defect(trial);
                if (trial_d.norm() <= (1 - 1e-4 * t) * d.norm()) break;
            }
            if (t <= 1e-3) return;
            p = trial;
            d = trial_d;
        }
    }

    const Assembly& assembly_;
    Law law_;
    VectorXd w_, u_free_;
    MatrixXd W_;
    RandomInput random_{1};
};

}  // namespace

ContactSolution solve_contacts(const ContactProblem& problem, double tolerance, const ContactSolution* guess) {
    const Assembly assembly(problem);
    VectorXd p = VectorXd::Zero(assembly.row_count()), y = VectorXd::Zero(6 * assembly.body_count()), best_p = p;
    ContactSolution solution;
    if (guess != nullptr) {
        p = assembly.read(*guess);
        y = assembly.pushed(p);
        best_p = p;
    }
    double best = residual_of(assembly, p, assembly.u(y)), last = best;
    // Soft points converge everywhere and remove rounding, stiff ones reach the heavy body on the light one (a mode of inverse
    // mass w_mode shrinks by 1 / (1 + stiffness w_mode / w)): stiffness rises while progress is slow, falls where rounding ends
    // it, and so on. Where Newton fails it stays below for a while.
    constexpr double softest = 1e1, stiffest = 1e8, last_resort = 1e-2;
    constexpr int polish = 2;  // rungs after the bar is met: where friction is slight, its direction lags behind the residual
    double stiffness = softest, ceiling = stiffest;
    bool rising = true;
    for (int rungs_left = 300; rungs_left > 0; --rungs_left) {
        if (best <= std::max(tolerance, grain_of(assembly, p))) rungs_left = std::min(rungs_left, polish);
        const Law law(assembly, stiffness);
        VectorXd trial = y;
        const VectorXd* bounds_of = nullptr;
        bool solved = solve_inner(BodyEquation(assembly, law, p, nullptr), stiffness, trial, solution.iterations);
        if (!solved && stiffness <= last_resort) {  // with the friction bounds of the impulses at hand it is a convex problem
            bounds_of = &p;
            trial = y;
            solved = solve_inner(BodyEquation(assembly, law, p, bounds_of), stiffness, trial, solution.iterations);
        }
        if (!solved) {
            stiffness = ceiling = std::max(last_resort, stiffness / 4);
            continue;
        }
        p = law.mapped(p, assembly.u(trial), bounds_of);
        y = assembly.pushed(p);
        const double residual = residual_of(assembly, p, assembly.u(y));
        if (residual < best) {
            best = residual;
            best_p = p;
        }
        const bool slow = residual > 0.1 * last, at_rounding = residual > 0.9 * last && residual < 1e-6;
        if (stiffness >= stiffest || at_rounding) rising = false;
        if (stiffness <= softest) rising = true;
        ceiling = std::min(stiffest, 2 * ceiling);
        if (slow)
            stiffness = rising ? std::min(ceiling, 10 * stiffness) : std::max(std::min(softest, ceiling), stiffness / 100);
        last = residual;
    }
    if (best > std::max(tolerance, grain_of(assembly, best_p)) && assembly.row_count() <= 300)
        NewtonOnImpulses(assembly).solve(best_p, std::max(tolerance, grain_of(assembly, best_p)), solution.iterations);
    assembly.write(best_p, solution);
    solution.residual = contact_residual(problem, solution);
    // Ten: the velocities written are summed in another order.
    solution.converged = solution.residual <= 10 * std::max(tolerance, grain_of(assembly, best_p));
    return solution;
}

}  // namespace ingot_reference
