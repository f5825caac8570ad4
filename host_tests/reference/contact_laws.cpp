// SPDX-License-Identifier: MIT
// What a solution is judged by.
#include "contact_assembly.h"

namespace ingot_reference {

using namespace contact;

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
