// SPDX-License-Identifier: MIT
#include "contact_reference.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "random_input.h"

namespace ingot_reference {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two unit vectors that span the plane across n.
void tangents_of(const Vector3d& n, Vector3d& t_1, Vector3d& t_2) {
    t_1 = n.unitOrthogonal();
    t_2 = n.cross(t_1);
}

/// What velocities are counted in: y = M^(1/2) (v - v_free), so that an impulse adds g p to y and a row reads g.y with the
/// same g = M^(-1/2) J, and |y|^2 / 2 is the kinetic energy of the change. Bodies that nothing moves have g = 0.
struct Scaling {
    double root_inv_M;
    Matrix3d root_inv_I;

    explicit Scaling(const ContactBody& body) : root_inv_M(std::sqrt(body.inv_M)) {
        const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(body.inv_I_world);
        const Vector3d roots = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
        root_inv_I = eigen.eigenvectors() * roots.asDiagonal() * eigen.eigenvectors().transpose();
    }

    Vector6 row(const Vector3d& linear, const Vector3d& angular) const {
        Vector6 g;
        g << root_inv_M * linear, root_inv_I * angular;
        return g;
    }
};

/// One number of u and of p: a normal, one of two tangents, or a twist.
struct Row {
    int body_A, body_B;
    Vector6 g_A, g_B;
    double u_free;  ///< m/s (rad/s for a twist), less bound or drive
    double w;       ///< g.g: inverse mass at the point

    double change_of_u(const VectorXd& y) const { return g_A.dot(y.segment<6>(6 * body_A)) + g_B.dot(y.segment<6>(6 * body_B)); }
    double u(const VectorXd& y) const { return u_free + change_of_u(y); }
    void push(VectorXd& y, double p) const {
        y.segment<6>(6 * body_A) += p * g_A;
        y.segment<6>(6 * body_B) += p * g_B;
    }
};

/// Rows whose laws hang together: normals, and the friction they carry.
struct Group {
    std::vector<int> normals;
    int tangent = -1;  ///< first of two rows; -1: no friction
    int twist = -1;
    double mu = 0, mu_twist = 0;
};

class Assembly {
public:
    explicit Assembly(const ContactProblem& problem) : problem_(problem) {
        for (const ContactBody& body : problem.bodies) scaling_.emplace_back(body);
        for (const ContactPoint& point : problem.points) {
            add_row(point.body_A, point.body_B, point.r_P, point.n, problem.bound(point));
        }
        std::vector<bool> in_patch(problem.points.size(), false);
        for (const FrictionPatch& patch : problem.patches) {
            Group group;
            group.normals = patch.points;
            for (const int point_i : patch.points) in_patch[static_cast<std::size_t>(point_i)] = true;
            add_friction(group, patch, patch.mu, patch.mu_twist);
            groups.push_back(group);
        }
        for (std::size_t point_i = 0; point_i < problem.points.size(); ++point_i) {
            if (in_patch[point_i]) continue;
            const ContactPoint& point = problem.points[point_i];
            Group group;
            group.normals = {static_cast<int>(point_i)};
            add_friction(group, point, point.mu, 0);
            groups.push_back(group);
            group_of_point_.push_back({static_cast<int>(point_i), static_cast<int>(groups.size()) - 1});
        }
    }

    int body_count() const { return static_cast<int>(scaling_.size()); }
    int row_count() const { return static_cast<int>(rows.size()); }
    const Row& row(int row_i) const { return rows[static_cast<std::size_t>(row_i)]; }

    VectorXd pushed(const VectorXd& p) const {
        VectorXd y = VectorXd::Zero(6 * body_count());
        for (int row_i = 0; row_i < row_count(); ++row_i) row(row_i).push(y, p(row_i));
        return y;
    }

    VectorXd u(const VectorXd& y) const {
        VectorXd all(row_count());
        for (int row_i = 0; row_i < row_count(); ++row_i) all(row_i) = row(row_i).u(y);
        return all;
    }

    /// The impulses of rows as world vectors, and the velocities they make.
    void write(const VectorXd& p, ContactSolution& solution) const {
        solution.impulse.assign(problem_.points.size(), Vector3d::Zero());
        solution.patch_impulse.assign(problem_.patches.size(), Vector3d::Zero());
        solution.patch_twist.assign(problem_.patches.size(), 0);
        for (std::size_t point_i = 0; point_i < problem_.points.size(); ++point_i)
            solution.impulse[point_i] = p(static_cast<int>(point_i)) * problem_.points[point_i].n;
        for (std::size_t patch_i = 0; patch_i < problem_.patches.size(); ++patch_i) {
            const Group& group = groups[patch_i];
            if (group.tangent >= 0) solution.patch_impulse[patch_i] = tangent_vector(p, group.tangent, problem_.patches[patch_i].n);
            if (group.twist >= 0) solution.patch_twist[patch_i] = p(group.twist);
        }
        for (const auto& [point_i, group_i] : group_of_point_) {
            const Group& group = groups[static_cast<std::size_t>(group_i)];
            const std::size_t i = static_cast<std::size_t>(point_i);
            if (group.tangent >= 0) solution.impulse[i] += tangent_vector(p, group.tangent, problem_.points[i].n);
        }
        apply_impulses(problem_, solution);
    }

    /// The impulses of a solution as rows.
    VectorXd read(const ContactSolution& solution) const {
        VectorXd p = VectorXd::Zero(row_count());
        for (std::size_t point_i = 0; point_i < problem_.points.size(); ++point_i)
            p(static_cast<int>(point_i)) = solution.impulse[point_i].dot(problem_.points[point_i].n);
        const auto read_tangents = [&](int row_i, const Vector3d& n, const Vector3d& impulse) {
            Vector3d t_1, t_2;
            tangents_of(n, t_1, t_2);
            p(row_i) = impulse.dot(t_1);
            p(row_i + 1) = impulse.dot(t_2);
        };
        for (std::size_t patch_i = 0; patch_i < problem_.patches.size(); ++patch_i) {
            const Group& group = groups[patch_i];
            if (group.tangent >= 0) read_tangents(group.tangent, problem_.patches[patch_i].n, solution.patch_impulse[patch_i]);
            if (group.twist >= 0) p(group.twist) = solution.patch_twist[patch_i];
        }
        for (const auto& [point_i, group_i] : group_of_point_) {
            const Group& group = groups[static_cast<std::size_t>(group_i)];
            const std::size_t i = static_cast<std::size_t>(point_i);
            if (group.tangent >= 0) read_tangents(group.tangent, problem_.points[i].n, solution.impulse[i]);
        }
        return p;
    }

    std::vector<Row> rows;  ///< normals of all points first, in their order
    std::vector<Group> groups;

private:
    struct PointInGroup {
        int point, group;
    };

    static Vector3d tangent_vector(const VectorXd& p, int row_i, const Vector3d& n) {
        Vector3d t_1, t_2;
        tangents_of(n, t_1, t_2);
        return p(row_i) * t_1 + p(row_i + 1) * t_2;
    }

    /// A row along `direction` through r_P.
    int add_row(int body_A, int body_B, const Vector3d& r_P, const Vector3d& direction, double target) {
        const ContactBody& A = problem_.bodies[static_cast<std::size_t>(body_A)];
        const ContactBody& B = problem_.bodies[static_cast<std::size_t>(body_B)];
        const Vector3d r_AP = r_P - A.r_CM, r_BP = r_P - B.r_CM;
        const Vector3d v = A.v_CM + A.omega.cross(r_AP) - B.v_CM - B.omega.cross(r_BP);
        return add(body_A, body_B, direction, r_AP.cross(direction), r_BP.cross(direction), v.dot(direction) - target);
    }

    int add(int body_A, int body_B, const Vector3d& linear, const Vector3d& turn_A, const Vector3d& turn_B, double u_free) {
        Row row;
        row.body_A = body_A;
        row.body_B = body_B;
        row.g_A = scaling_[static_cast<std::size_t>(body_A)].row(linear, turn_A);
        row.g_B = -scaling_[static_cast<std::size_t>(body_B)].row(linear, turn_B);
        row.u_free = u_free;
        row.w = row.g_A.squaredNorm() + row.g_B.squaredNorm();
        rows.push_back(row);
        return row_count() - 1;
    }

    template <class Place>
    void add_friction(Group& group, const Place& place, double mu, double mu_twist) {
        Vector3d t_1, t_2;
        tangents_of(place.n, t_1, t_2);
        group.mu = mu;
        group.mu_twist = mu_twist;
        if (mu > 0) {
            group.tangent = add_row(place.body_A, place.body_B, place.r_P, t_1, place.v_t_drive.dot(t_1));
            add_row(place.body_A, place.body_B, place.r_P, t_2, place.v_t_drive.dot(t_2));
        }
        if (mu_twist > 0) {
            const Vector3d omega = problem_.bodies[static_cast<std::size_t>(place.body_A)].omega -
                                   problem_.bodies[static_cast<std::size_t>(place.body_B)].omega;
            group.twist = add(place.body_A, place.body_B, Vector3d::Zero(), place.n, place.n, omega.dot(place.n));
        }
    }

    const ContactProblem& problem_;
    std::vector<Scaling> scaling_;
    std::vector<PointInGroup> group_of_point_;
};

/// The laws of Alart and Curnier: q = p - rho u; p_n = max(0, q_n); p_t = q_t cut back to the disc of radius mu sum(p_n). A p
/// that this map leaves alone obeys the laws, whatever rho > 0.
class Law {
public:
    /// stiffness: rho in units of 1 / w of each row.
    Law(const Assembly& assembly, double stiffness) : assembly_(assembly), rho_(assembly.row_count()) {
        for (int row_i = 0; row_i < assembly.row_count(); ++row_i) rho_(row_i) = over(stiffness, assembly.row(row_i).w);
        for (const Group& group : assembly.groups) {
            if (group.tangent < 0) continue;  // one rho for both tangents keeps the disc round
            const double w = std::max(assembly.row(group.tangent).w, assembly.row(group.tangent + 1).w);
            rho_(group.tangent) = rho_(group.tangent + 1) = over(stiffness, w);
        }
    }

    double rho(int row_i) const { return rho_(row_i); }

    /// p after the map. With `bounds_of` the friction bounds are those of these impulses instead of the new ones (Tresca):
    /// then the map is the gradient of a convex function.
    VectorXd mapped(const VectorXd& p, const VectorXd& u, const VectorXd* bounds_of = nullptr) const {
        VectorXd q = p - rho_.cwiseProduct(u), result = q;
        for (const Group& group : assembly_.groups) {
            for (const int row_i : group.normals) result(row_i) = rho_(row_i) > 0 ? std::max(0.0, q(row_i)) : 0;
            const double N = normal_sum(group, bounds_of != nullptr ? *bounds_of : result);
            if (group.tangent >= 0) cut(result, group.tangent, 2, group.mu * N);
            if (group.twist >= 0) cut(result, group.twist, 1, group.mu_twist * N);
        }
        return result;
    }

    /// -dp/du of `mapped` for one group, in the order of rows_of(group).
    MatrixXd derivative(const Group& group, const VectorXd& p, const VectorXd& u, const VectorXd* bounds_of) const {
        const int count = static_cast<int>(group.normals.size());
        const std::vector<int> rows = rows_of(group);
        MatrixXd D = MatrixXd::Zero(static_cast<int>(rows.size()), static_cast<int>(rows.size()));
        VectorXd pushing = VectorXd::Zero(count);  // rho of normals that push
        double N = 0;
        for (int i = 0; i < count; ++i) {
            const int row_i = group.normals[static_cast<std::size_t>(i)];
            const double q = p(row_i) - rho_(row_i) * u(row_i);
            if (q <= 0 || rho_(row_i) == 0) continue;
            D(i, i) = pushing(i) = rho_(row_i);
            N += q;
        }
        if (bounds_of != nullptr) {
            N = normal_sum(group, *bounds_of);
            pushing.setZero();
        }
        int at = count;
        if (group.tangent >= 0) {
            cut_derivative(D, at, 2, group.tangent, group.mu, N, pushing, p, u);
            at += 2;
        }
        if (group.twist >= 0) cut_derivative(D, at, 1, group.twist, group.mu_twist, N, pushing, p, u);
        return D;
    }

    static std::vector<int> rows_of(const Group& group) {
        std::vector<int> rows = group.normals;
        if (group.tangent >= 0) rows.insert(rows.end(), {group.tangent, group.tangent + 1});
        if (group.twist >= 0) rows.push_back(group.twist);
        return rows;
    }

private:
    static double over(double stiffness, double w) { return w > 0 ? stiffness / w : 0; }

    static double normal_sum(const Group& group, const VectorXd& p) {
        double sum = 0;
        for (const int row_i : group.normals) sum += std::max(0.0, p(row_i));
        return sum;
    }

    void cut(VectorXd& p, int first, int size, double radius) const {
        const double length = p.segment(first, size).norm();
        if (rho_(first) == 0) p.segment(first, size).setZero();
        else if (length > radius) p.segment(first, size) *= radius / length;
    }

    void cut_derivative(MatrixXd& D, int at, int size, int first, double mu, double N, const VectorXd& pushing, const VectorXd& p,
                        const VectorXd& u) const {
        const double rho = rho_(first), radius = mu * N;
        const VectorXd q = p.segment(first, size) - rho * u.segment(first, size);
        const double length = q.norm();
        const MatrixXd one = MatrixXd::Identity(size, size);
        if (length <= radius) {
            D.block(at, at, size, size) = rho * one;
            return;
        }
        const VectorXd d = q / length;
        D.block(at, at, size, size) = (radius / length) * rho * (one - d * d.transpose());
        D.block(at, 0, size, pushing.size()) = mu * d * pushing.transpose();
    }

    const Assembly& assembly_;
    VectorXd rho_;
};

double residual_of(const Assembly& assembly, const VectorXd& p, const VectorXd& u) {
    const Law law(assembly, 1);
    const VectorXd change = p - law.mapped(p, u);
    double worst = 0;
    for (int row_i = 0; row_i < assembly.row_count(); ++row_i) {
        const double error = std::abs(change(row_i)) * assembly.row(row_i).w;
        if (!(error <= worst)) worst = error;  // a NaN stays
    }
    return worst;
}

/// Rounding of the impulses, as the velocity it makes, m/s: 1e6 kg on 1 kg leave the light one 3e-11.
double grain_of(const Assembly& assembly, const VectorXd& p) {
    double most = 0;
    for (int row_i = 0; row_i < assembly.row_count(); ++row_i) most = std::max(most, std::abs(p(row_i)) * assembly.row(row_i).w);
    return std::numeric_limits<double>::epsilon() * most;
}

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
        for (std::size_t i = 0; i < rows.size(); ++i) g.col(static_cast<int>(i)) << assembly_.row(rows[i]).g_A, assembly_.row(rows[i]).g_B;
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

/// Newton with a line search on the defect. True when the defect is down to rounding, which stiff points amplify, or down by 1e-6
/// and at a standstill; the caller judges by the laws themselves.
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

}  // namespace

namespace {

/// Where the augmented Lagrangian goes round in circles (friction that nearly jams): Newton on p - mapped(p, u(p)) = 0 itself, in
/// m/s, with steps of least length, from p and from places around it. For hundreds of rows at most. True: p is down to `tolerance`.
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
                if (attempt > 0) p(row_i) += random_.real(-1, 1) * 0.5 * start.cwiseAbs().maxCoeff() * (attempt % 2 == 0 ? 1 : 0.1);
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
                    if (law_.rho(rows[c]) > 0) kept(rows[r], rows[c]) = D(static_cast<int>(r), static_cast<int>(c)) / law_.rho(rows[c]);
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

double ContactProblem::bound(const ContactPoint& point) const {
    if (point.separation <= 0) return point.v_n_target;
    return h > 0 ? point.v_n_target - point.separation / h : -infinity;
}

double ContactDefects::worst() const { return std::max({penetration, pull, complementarity, cone, slip, momentum}); }

void apply_impulses(const ContactProblem& problem, ContactSolution& solution) {
    solution.v_CM.clear();
    solution.omega.clear();
    for (const ContactBody& body : problem.bodies) {
        solution.v_CM.push_back(body.v_CM);
        solution.omega.push_back(body.omega);
    }
    const auto push = [&](int body_i, const Vector3d& r_P, const Vector3d& J, const Vector3d& twist) {
        const std::size_t i = static_cast<std::size_t>(body_i);
        const ContactBody& body = problem.bodies[i];
        solution.v_CM[i] += body.inv_M * J;
        solution.omega[i] += body.inv_I_world * ((r_P - body.r_CM).cross(J) + twist);
    };
    const auto push_both = [&](const auto& place, const Vector3d& J, const Vector3d& twist) {
        push(place.body_A, place.r_P, J, twist);
        push(place.body_B, place.r_P, -J, -twist);
    };
    for (std::size_t i = 0; i < problem.points.size(); ++i) push_both(problem.points[i], solution.impulse[i], Vector3d::Zero());
    for (std::size_t i = 0; i < problem.patches.size(); ++i)
        push_both(problem.patches[i], solution.patch_impulse[i], solution.patch_twist[i] * problem.patches[i].n);
}

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
        if (slow) stiffness = rising ? std::min(ceiling, 10 * stiffness) : std::max(std::min(softest, ceiling), stiffness / 100);
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

ContactSolution solve_contacts_without_friction(const ContactProblem& problem) {
    ContactProblem smooth = problem;
    smooth.patches.clear();
    for (ContactPoint& point : smooth.points) point.mu = 0;
    const Assembly assembly(smooth);
    const int count = assembly.row_count();

    // The quadratic program: least p.W p / 2 + u_free.p over p >= 0.
    MatrixXd G = MatrixXd::Zero(6 * assembly.body_count(), count);
    VectorXd u_free(count);
    double speed = 0;
    for (int row_i = 0; row_i < count; ++row_i) {
        const Row& row = assembly.row(row_i);
        G.col(row_i).segment<6>(6 * row.body_A) += row.g_A;
        G.col(row_i).segment<6>(6 * row.body_B) += row.g_B;
        u_free(row_i) = row.u_free;
        if (std::isfinite(row.u_free)) speed = std::max(speed, std::abs(row.u_free));
    }
    const MatrixXd W = G.transpose() * G;

    ContactSolution solution;
    VectorXd p = VectorXd::Zero(count);
    std::vector<int> pushing;
    std::vector<bool> refused(static_cast<std::size_t>(count), false);  // dependent points whose gradient is rounding
    bool bounded = true;
    const auto solve_for = [&](const VectorXd& right) {  // W x = right over the pushing points
        const int size = static_cast<int>(pushing.size());
        MatrixXd part(size, size);
        for (int r = 0; r < size; ++r)
            for (int c = 0; c < size; ++c) part(r, c) = W(pushing[static_cast<std::size_t>(r)], pushing[static_cast<std::size_t>(c)]);
        ++solution.iterations;
        return VectorXd(part.ldlt().solve(right));
    };
    const auto picked = [&](const VectorXd& all) {
        VectorXd part(static_cast<int>(pushing.size()));
        for (int i = 0; i < part.size(); ++i) part(i) = all(pushing[static_cast<std::size_t>(i)]);
        return part;
    };
    // Moves p along d until the first pushing point lets go, at most by `reach`; says whether one did.
    const auto move = [&](const VectorXd& d, int entering, double reach) {
        int blocking = -1;
        for (int i = 0; i < d.size(); ++i) {
            const double room = p(pushing[static_cast<std::size_t>(i)]);
            if (d(i) < 0 && room + reach * d(i) < 0) {
                reach = room / -d(i);
                blocking = i;
            }
        }
        if (!std::isfinite(reach)) return -2;
        for (int i = 0; i < d.size(); ++i) p(pushing[static_cast<std::size_t>(i)]) += reach * d(i);
        if (entering >= 0) p(entering) += reach;
        if (blocking >= 0) {
            p(pushing[static_cast<std::size_t>(blocking)]) = 0;
            pushing.erase(pushing.begin() + blocking);
        }
        return blocking;
    };

    for (int pivot = 0; pivot < 100 * (count + 1) && bounded; ++pivot) {
        const VectorXd u = u_free + W * p;
        int entering = -1;
        double worst = -1e-13 * speed;
        for (int row_i = 0; row_i < count; ++row_i) {
            const bool is_in = std::find(pushing.begin(), pushing.end(), row_i) != pushing.end();
            if (is_in || refused[static_cast<std::size_t>(row_i)] || assembly.row(row_i).w == 0) continue;
            if (u(row_i) < worst) {
                worst = u(row_i);
                entering = row_i;
            }
        }
        if (entering < 0) break;
        // The entering point rises, the pushing ones follow so that they stay at rest, until it is at rest too or one lets go.
        for (;;) {
            const VectorXd c = -solve_for(picked(W.col(entering)));
            double w = W(entering, entering);
            for (int i = 0; i < c.size(); ++i) w += W(entering, pushing[static_cast<std::size_t>(i)]) * c(i);
            const bool dependent = w <= 1e-11 * W(entering, entering);
            const double u_now = u_free(entering) + W.row(entering).dot(p);
            if (dependent && u_now > -1e-9 * speed) {
                refused[static_cast<std::size_t>(entering)] = true;
                if (p(entering) > 0) pushing.push_back(entering);
                break;
            }
            const int blocking = move(c, entering, dependent ? infinity : std::max(0.0, -u_now / w));
            if (blocking == -2) {
                bounded = false;
                break;
            }
            if (blocking == -1) {
                pushing.push_back(entering);
                break;
            }
            std::fill(refused.begin(), refused.end(), false);
        }
    }
    if (!pushing.empty() && bounded) {  // once from the bounds themselves: what pivots left is taken off
        for (int refinement = 0; refinement < 2; ++refinement) {
            const VectorXd correction = -solve_for(picked(u_free + W * p));
            for (int i = 0; i < correction.size(); ++i) {
                double& p_i = p(pushing[static_cast<std::size_t>(i)]);
                p_i = std::max(0.0, p_i + correction(i));
            }
        }
    }
    assembly.write(p, solution);
    solution.residual = contact_residual(smooth, solution);
    solution.converged = bounded && solution.residual <= 1e-10;
    return solution;
}

double contact_residual(const ContactProblem& problem, const ContactSolution& solution) {
    const Assembly assembly(problem);
    // u from the velocities themselves: the same problem with these as the free ones, and nothing pushed.
    ContactProblem after = problem;
    for (std::size_t body_i = 0; body_i < after.bodies.size(); ++body_i) {
        after.bodies[body_i].v_CM = solution.v_CM[body_i];
        after.bodies[body_i].omega = solution.omega[body_i];
    }
    const Assembly moved(after);
    return residual_of(assembly, assembly.read(solution), moved.u(VectorXd::Zero(6 * assembly.body_count())));
}

namespace {

/// v_A - v_B at a place with the velocities of a solution.
template <class Place>
Vector3d velocity_across(const ContactProblem& problem, const ContactSolution& solution, const Place& place) {
    const auto at = [&](int body_i) -> Vector3d {
        const std::size_t i = static_cast<std::size_t>(body_i);
        return solution.v_CM[i] + solution.omega[i].cross(place.r_P - problem.bodies[i].r_CM);
    };
    return at(place.body_A) - at(place.body_B);
}

/// Inverse mass that an impulse along d meets at a place.
template <class Place>
double inverse_mass(const ContactProblem& problem, const Place& place, const Vector3d& d) {
    double sum = 0;
    for (const int body_i : {place.body_A, place.body_B}) {
        const ContactBody& body = problem.bodies[static_cast<std::size_t>(body_i)];
        const Vector3d turn = (place.r_P - body.r_CM).cross(d);
        sum += body.inv_M + turn.dot(body.inv_I_world * turn);
    }
    return sum;
}

/// Friction p of radius at most `bound` against a slip u, where 1 N s makes w m/s.
void add_friction_defects(const Vector3d& p, const Vector3d& u, double bound, double w, ContactDefects& defects) {
    defects.cone = std::max(defects.cone, w * (p.norm() - bound));
    if (!(bound > 0)) return;
    const double misfit = (u + u.norm() * p / bound).norm();
    // Friction that is as good as none cannot be told from none: it counts by the velocity it makes.
    defects.slip = std::max(defects.slip, std::min(misfit, 2 * w * bound));
}

}  // namespace

ContactDefects contact_defects(const ContactProblem& problem, const ContactSolution& solution) {
    ContactDefects defects;
    for (std::size_t point_i = 0; point_i < problem.points.size(); ++point_i) {
        const ContactPoint& point = problem.points[point_i];
        const Vector3d u = velocity_across(problem, solution, point), p = solution.impulse[point_i];
        const double u_n = u.dot(point.n) - problem.bound(point), p_n = p.dot(point.n);
        const double w_n = inverse_mass(problem, point, point.n);
        if (w_n == 0) continue;  // nothing here moves
        const Vector3d u_t = u - u.dot(point.n) * point.n - point.v_t_drive, p_t = p - p_n * point.n;
        defects.penetration = std::max(defects.penetration, -u_n);
        defects.pull = std::max(defects.pull, -w_n * p_n);
        defects.complementarity = std::max(defects.complementarity, std::min(u_n, w_n * p_n));
        const Vector3d along = u_t.norm() > 0 ? Vector3d(u_t.normalized()) : point.n.unitOrthogonal();
        add_friction_defects(p_t, u_t, point.mu * std::max(0.0, p_n), inverse_mass(problem, point, along), defects);
    }
    for (std::size_t patch_i = 0; patch_i < problem.patches.size(); ++patch_i) {
        const FrictionPatch& patch = problem.patches[patch_i];
        double N = 0;
        for (const int i : patch.points) {
            const std::size_t point_i = static_cast<std::size_t>(i);
            N += std::max(0.0, solution.impulse[point_i].dot(problem.points[point_i].n));
        }
        const Vector3d u = velocity_across(problem, solution, patch);
        const Vector3d u_t = u - u.dot(patch.n) * patch.n - patch.v_t_drive;
        const Vector3d along = u_t.norm() > 0 ? Vector3d(u_t.normalized()) : patch.n.unitOrthogonal();
        add_friction_defects(solution.patch_impulse[patch_i], u_t, patch.mu * N, inverse_mass(problem, patch, along), defects);
        const std::size_t A = static_cast<std::size_t>(patch.body_A), B = static_cast<std::size_t>(patch.body_B);
        const double spin = (solution.omega[A] - solution.omega[B]).dot(patch.n);
        const double w = patch.n.dot((problem.bodies[A].inv_I_world + problem.bodies[B].inv_I_world) * patch.n);
        add_friction_defects(Vector3d::UnitZ() * solution.patch_twist[patch_i], Vector3d::UnitZ() * spin, patch.mu_twist * N, w,
                             defects);
    }
    ContactSolution pushed = solution;
    apply_impulses(problem, pushed);
    for (std::size_t body_i = 0; body_i < problem.bodies.size(); ++body_i) {
        const double miss = (pushed.v_CM[body_i] - solution.v_CM[body_i]).norm();
        defects.momentum = std::max({defects.momentum, miss, (pushed.omega[body_i] - solution.omega[body_i]).norm()});
    }
    return defects;
}

double velocity_distance(const ContactProblem& problem, const ContactSolution& a, const ContactSolution& b) {
    double twice_T = 0, M = 0;
    for (std::size_t body_i = 0; body_i < problem.bodies.size(); ++body_i) {
        const ContactBody& body = problem.bodies[body_i];
        if (body.inv_M == 0) continue;
        const Vector3d v = a.v_CM[body_i] - b.v_CM[body_i], omega = a.omega[body_i] - b.omega[body_i];
        M += 1 / body.inv_M;
        twice_T += v.squaredNorm() / body.inv_M;
        // A body that may move but not turn has no inverse inertia to invert; omega is then 0 as well.
        if (omega.squaredNorm() > 0) twice_T += omega.dot(body.inv_I_world.completeOrthogonalDecomposition().solve(omega));
    }
    return M > 0 ? std::sqrt(twice_T / M) : 0;
}

}  // namespace ingot_reference
