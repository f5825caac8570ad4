// SPDX-License-Identifier: MIT
// Inside the contact reference: a problem as rows in scaled velocities, and the law each group of rows obeys.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact_reference.h"

namespace ingot_reference {
namespace contact {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two unit vectors that span the plane across n.
inline void tangents_of(const Vector3d& n, Vector3d& t_1, Vector3d& t_2) {
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

    double change_of_u(const VectorXd& y) const {
        return g_A.dot(y.segment<6>(6 * body_A)) + g_B.dot(y.segment<6>(6 * body_B));
    }
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
            if (group.tangent >= 0)
                solution.patch_impulse[patch_i] = tangent_vector(p, group.tangent, problem_.patches[patch_i].n);
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
        if (rho_(first) == 0)
            p.segment(first, size).setZero();
        else if (length > radius)
            p.segment(first, size) *= radius / length;
    }

    void cut_derivative(MatrixXd& D, int at, int size, int first, double mu, double N, const VectorXd& pushing,
                        const VectorXd& p, const VectorXd& u) const {
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

inline double residual_of(const Assembly& assembly, const VectorXd& p, const VectorXd& u) {
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
inline double grain_of(const Assembly& assembly, const VectorXd& p) {
    double most = 0;
    for (int row_i = 0; row_i < assembly.row_count(); ++row_i)
        most = std::max(most, std::abs(p(row_i)) * assembly.row(row_i).w);
    return std::numeric_limits<double>::epsilon() * most;
}

}  // namespace contact
}  // namespace ingot_reference
