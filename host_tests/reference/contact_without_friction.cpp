// SPDX-License-Identifier: MIT
#include "contact_assembly.h"

namespace ingot_reference {

using namespace contact;

namespace {

/// The quadratic program: least p.W p / 2 + u_free.p over p >= 0, whose gradient u_free + W p are the normal velocities. Points
/// enter the set of those that push one at a time, and leave it when their impulse falls to zero; the set's part of W stays
/// regular, since a point that depends on the others either is at rest with them already or drives one of them out.
class ActiveSet {
public:
    explicit ActiveSet(const Assembly& assembly) : p_(VectorXd::Zero(assembly.row_count())), u_free_(assembly.row_count()) {
        const int count = assembly.row_count();
        MatrixXd G = MatrixXd::Zero(6 * assembly.body_count(), count);
        for (int row_i = 0; row_i < count; ++row_i) {
            const Row& row = assembly.row(row_i);
            G.col(row_i).segment<6>(6 * row.body_A) += row.g_A;
            G.col(row_i).segment<6>(6 * row.body_B) += row.g_B;
            u_free_(row_i) = row.u_free;
            if (std::isfinite(row.u_free)) speed_ = std::max(speed_, std::abs(row.u_free));
        }
        W_ = G.transpose() * G;
        refused_.assign(static_cast<std::size_t>(count), false);
    }

    /// False: the bounds contradict each other.
    bool solve() {
        for (std::size_t pivot = 0; pivot < 100 * (refused_.size() + 1); ++pivot) {
            const int entering = fastest_closing();
            if (entering < 0) break;
            if (!enter(entering)) return false;
        }
        refine();
        return true;
    }

    const VectorXd& p() const { return p_; }
    int systems() const { return systems_; }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    /// The point outside the set that closes fastest, beyond rounding; -1: none.
    int fastest_closing() const {
        const VectorXd u = u_free_ + W_ * p_;
        int entering = -1;
        double worst = -1e-13 * speed_;
        for (int row_i = 0; row_i < p_.size(); ++row_i) {
            const bool pushes = std::find(pushing_.begin(), pushing_.end(), row_i) != pushing_.end();
            if (pushes || refused_[at(row_i)] || W_(row_i, row_i) == 0 || u(row_i) >= worst) continue;
            worst = u(row_i);
            entering = row_i;
        }
        return entering;
    }

    /// The entering point's impulse rises, the pushing ones follow so that they stay at rest, until it is at rest too. On the
    /// way others let go. False: nothing ever stops it.
    bool enter(int entering) {
        for (;;) {
            const VectorXd follow = -solution_of(picked(W_.col(entering)));
            double w = W_(entering, entering);
            for (int i = 0; i < follow.size(); ++i) w += W_(entering, pushing_[at(i)]) * follow(i);
            const bool depends = w <= 1e-11 * W_(entering, entering);
            const double u = u_free_(entering) + W_.row(entering).dot(p_);
            if (depends && u > -1e-9 * speed_) {  // at rest with the others: what is left is rounding
                refused_[at(entering)] = true;
                if (p_(entering) > 0) pushing_.push_back(entering);
                return true;
            }
            double reach = depends ? infinity : std::max(0.0, -u / w);
            const int letting_go = first_to_let_go(follow, reach);
            if (!std::isfinite(reach)) return false;
            for (int i = 0; i < follow.size(); ++i) p_(pushing_[at(i)]) += reach * follow(i);
            p_(entering) += reach;
            if (letting_go < 0) {
                pushing_.push_back(entering);
                return true;
            }
            p_(pushing_[at(letting_go)]) = 0;
            pushing_.erase(pushing_.begin() + letting_go);
            std::fill(refused_.begin(), refused_.end(), false);
        }
    }

    /// Shortens reach to where the first pushing point has no impulse left; which one, or -1.
    int first_to_let_go(const VectorXd& follow, double& reach) const {
        int first = -1;
        for (int i = 0; i < follow.size(); ++i) {
            const double room = p_(pushing_[at(i)]);
            if (follow(i) >= 0 || room + reach * follow(i) >= 0) continue;
            reach = room / -follow(i);
            first = i;
        }
        return first;
    }

    /// Takes off what rounding the pivots left.
    void refine() {
        for (int refinement = 0; refinement < 2 && !pushing_.empty(); ++refinement) {
            const VectorXd correction = -solution_of(picked(u_free_ + W_ * p_));
            for (int i = 0; i < correction.size(); ++i) {
                double& p_i = p_(pushing_[at(i)]);
                p_i = std::max(0.0, p_i + correction(i));
            }
        }
    }

    /// x with W x = right over the pushing points.
    VectorXd solution_of(const VectorXd& right) {
        const int size = static_cast<int>(pushing_.size());
        MatrixXd part(size, size);
        for (int r = 0; r < size; ++r)
            for (int c = 0; c < size; ++c) part(r, c) = W_(pushing_[at(r)], pushing_[at(c)]);
        ++systems_;
        return part.ldlt().solve(right);
    }

    VectorXd picked(const VectorXd& all) const {
        VectorXd part(static_cast<int>(pushing_.size()));
        for (int i = 0; i < part.size(); ++i) part(i) = all(pushing_[at(i)]);
        return part;
    }

    VectorXd p_, u_free_;
    MatrixXd W_;
    double speed_ = 0;  ///< m/s, the fastest of u_free: what rounding is measured by
    std::vector<int> pushing_;
    std::vector<bool> refused_;  ///< dependent points that are at rest but for rounding
    int systems_ = 0;
};

}  // namespace

ContactSolution solve_contacts_without_friction(const ContactProblem& problem) {
    ContactProblem smooth = problem;
    smooth.patches.clear();
    for (ContactPoint& point : smooth.points) point.mu = 0;
    const Assembly assembly(smooth);
    ActiveSet active(assembly);
    const bool bounded = active.solve();
    ContactSolution solution;
    assembly.write(active.p(), solution);
    solution.iterations = active.systems();
    solution.residual = contact_residual(smooth, solution);
    solution.converged = bounded && solution.residual <= 1e-10;
    return solution;
}

}  // namespace ingot_reference
