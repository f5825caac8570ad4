// SPDX-License-Identifier: MIT
#include "joints/constrained_step_reference.h"

#include <algorithm>
#include <cmath>

#include "joints/equations.h"
#include "joints/row_system.h"

namespace ingot_figures {

namespace {

FigureInertia inertia_of(const std::vector<StepBody>& bodies) {
    std::vector<double> inv_M;
    std::vector<Matrix3d> inv_I;
    for (const StepBody& body : bodies) {
        inv_M.push_back(body.inv_M);
        inv_I.push_back(body.inv_M > 0 ? body.inv_I_world : Matrix3d(Matrix3d::Zero()));
    }
    return {inv_M, inv_I};
}

MatrixXd columns_of(const MatrixXd& all, const std::vector<int>& which) {
    MatrixXd some(all.rows(), static_cast<Eigen::Index>(which.size()));
    for (std::size_t i = 0; i < which.size(); ++i) some.col(static_cast<Eigen::Index>(i)) = all.col(which[i]);
    return some;
}

VectorXd entries_of(const VectorXd& all, const std::vector<int>& which) {
    VectorXd some(static_cast<Eigen::Index>(which.size()));
    for (std::size_t i = 0; i < which.size(); ++i) some(static_cast<Eigen::Index>(i)) = all(which[i]);
    return some;
}

VectorXd bounded_multipliers(const BoundedProblem& problem, BoundedBy method) {
    const bool few = problem.q.size() < 13;
    const bool enumerate = method == BoundedBy::enumeration || (method == BoundedBy::fewer_than_13_by_enumeration && few);
    return enumerate ? solve_by_enumeration(problem) : solve_by_pivoting(problem);
}

/// Marks rows whose multiplier is not the only one, among equations and those bounded ones that are between their bounds.
std::vector<bool> determined_rows(const MatrixXd& B, const std::vector<StepRow>& rows, const VectorXd& lambda) {
    std::vector<int> carrying;
    for (int row_i = 0; row_i < lambda.size(); ++row_i) {
        const StepRow& row = rows[static_cast<std::size_t>(row_i)];
        if (lambda(row_i) > row.lower && lambda(row_i) < row.upper) carrying.push_back(row_i);
    }
    std::vector<bool> determined(rows.size(), true);
    const Equations equations(columns_of(B, carrying));
    for (std::size_t i = 0; i < carrying.size(); ++i)
        determined[static_cast<std::size_t>(carrying[i])] = equations.is_determined(static_cast<int>(i));
    return determined;
}

}  // namespace

FigureRow point_row(const std::vector<StepBody>& bodies, int body_A, const Vector3d& P_A, int body_B, const Vector3d& P_B,
                    const Vector3d& direction) {
    FigureRow row;
    row.has_value = false;
    if (body_B != the_world) row.add(body_B, direction, (P_B - bodies[static_cast<std::size_t>(body_B)].r_CM).cross(direction));
    if (body_A != the_world) row.add(body_A, -direction, -(P_A - bodies[static_cast<std::size_t>(body_A)].r_CM).cross(direction));
    return row;
}

FigureRow turn_row(int body_A, int body_B, const Vector3d& direction) {
    FigureRow row;
    row.has_value = false;
    row.add(body_B, Vector3d::Zero(), direction);
    row.add(body_A, Vector3d::Zero(), -direction);
    return row;
}

namespace {

/// Rows and bodies of one substep as vectors and matrices.
class Step {
public:
    Step(const std::vector<StepBody>& bodies, const std::vector<StepRow>& rows)
        : rows_(rows), inertia_(inertia_of(bodies)), jacobian_(jacobian_of(rows)), system_(inertia_, jacobian_), u_(6 * body_count()) {
        for (int row_i = 0; row_i < row_count(); ++row_i) (row(row_i).is_equation() ? equations_ : bounded_).push_back(row_i);
        for (int body_i = 0; body_i < body_count(); ++body_i) {
            const StepBody& body = bodies[static_cast<std::size_t>(body_i)];
            u_.segment<3>(6 * body_i) = body.v_CM + inertia_.inv_M(body_i) * body.impulse;
            u_.segment<3>(6 * body_i + 3) = body.omega + inertia_.inv_I(body_i) * body.angular_impulse;
        }
        // A compliance is a mass of its own that the row moves too.
        B_.resize(6 * body_count() + row_count(), row_count());
        B_ << system_.in_energy_metric(), MatrixXd::Zero(row_count(), row_count());
        for (int row_i = 0; row_i < row_count(); ++row_i) B_(6 * body_count() + row_i, row_i) = std::sqrt(row(row_i).compliance);
    }

    StepSolution solved(BoundedBy method) {
        const MatrixXd B_I = columns_of(B_, bounded_);
        const Equations locked(columns_of(B_, equations_));
        VectorXd lambda = VectorXd::Zero(row_count());
        const VectorXd free = missing(lambda), y_E = locked.answer(entries_of(free, equations_));
        const MatrixXd within = locked.without(B_I);  // what bounded rows do when the equations stay
        BoundedProblem problem;
        problem.W = within.transpose() * within;
        problem.q = B_I.transpose() * y_E - entries_of(free, bounded_);
        problem.lower = problem.upper = VectorXd(problem.q.size());
        for (std::size_t i = 0; i < bounded_.size(); ++i) {
            problem.lower(static_cast<Eigen::Index>(i)) = row(bounded_[i]).lower;
            problem.upper(static_cast<Eigen::Index>(i)) = row(bounded_[i]).upper;
        }
        const VectorXd lambda_I = bounded_multipliers(problem, method);
        put(lambda_I, bounded_, lambda);
        put(locked.multipliers(y_E - B_I * lambda_I), equations_, lambda);
        u_ += system_.response(lambda);

        // What rounding has left of the equations, once more.
        VectorXd change = VectorXd::Zero(row_count());
        put(locked.multipliers(locked.answer(entries_of(missing(lambda), equations_))), equations_, change);
        u_ += system_.response(change);
        return solution(lambda + change);
    }

private:
    static std::vector<FigureRow> jacobian_of(const std::vector<StepRow>& rows) {
        std::vector<FigureRow> jacobian;
        for (const StepRow& row : rows) jacobian.push_back(row.row);
        return jacobian;
    }

    static void put(const VectorXd& some, const std::vector<int>& which, VectorXd& all) {
        for (std::size_t i = 0; i < which.size(); ++i) all(which[i]) = some(static_cast<Eigen::Index>(i));
    }

    int body_count() const { return inertia_.body_count(); }
    int row_count() const { return static_cast<int>(rows_.size()); }
    const StepRow& row(int row_i) const { return rows_[static_cast<std::size_t>(row_i)]; }

    /// -w of every row, at the velocities as they are.
    VectorXd missing(const VectorXd& lambda) const {
        VectorXd missing = -system_.J_times(u_);
        for (int row_i = 0; row_i < row_count(); ++row_i) missing(row_i) += row(row_i).target - row(row_i).compliance * lambda(row_i);
        return missing;
    }

    StepSolution solution(const VectorXd& lambda) const {
        StepSolution solution;
        for (int body_i = 0; body_i < body_count(); ++body_i) {
            solution.v_CM.push_back(u_.segment<3>(6 * body_i));
            solution.omega.push_back(u_.segment<3>(6 * body_i + 3));
        }
        solution.impulse.assign(lambda.data(), lambda.data() + row_count());
        solution.determined = determined_rows(B_, rows_, lambda);
        const VectorXd w = -missing(lambda);
        for (const int row_i : equations_) solution.unmet = std::max(solution.unmet, std::abs(w(row_i)));
        for (const int row_i : bounded_) {
            const double W_ii = B_.col(row_i).squaredNorm();
            if (W_ii <= 0) continue;
            const double wanted = std::min(row(row_i).upper, std::max(row(row_i).lower, lambda(row_i) - w(row_i) / W_ii));
            solution.miss = std::max(solution.miss, std::abs(wanted - lambda(row_i)) * W_ii);
        }
        return solution;
    }

    const std::vector<StepRow>& rows_;
    FigureInertia inertia_;
    std::vector<FigureRow> jacobian_;
    RowSystem system_;
    std::vector<int> equations_, bounded_;
    VectorXd u_;  // velocities of all bodies
    MatrixXd B_;  // rows in the metric of the kinetic energy, one a column
};

}  // namespace

StepSolution solve_step(const std::vector<StepBody>& bodies, const std::vector<StepRow>& rows, BoundedBy method) {
    return Step(bodies, rows).solved(method);
}

std::vector<StepBody> step_bodies(const FigureScene& scene, const FigureState& state) {
    const FigureInertia inertia(scene, state);
    std::vector<StepBody> bodies;
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const BodyMotion& motion = state.body(body_i);
        bodies.push_back({inertia.inv_M(body_i), inertia.inv_I(body_i), motion.r_CM, motion.v_CM, motion.omega, Vector3d::Zero(), Vector3d::Zero()});
    }
    return bodies;
}

FigureState with_velocities(const FigureState& state, const StepSolution& solution) {
    FigureState after = state;
    for (std::size_t body_i = 0; body_i < after.bodies.size(); ++body_i) {
        after.bodies[body_i].v_CM = solution.v_CM[body_i];
        after.bodies[body_i].omega = solution.omega[body_i];
    }
    return after;
}

namespace {

/// A joint's arms and axes, of A and of B, at the begin of a substep.
struct JointPlace {
    Vector3d r_A = Vector3d::Zero(), r_B = Vector3d::Zero(), omega_A = Vector3d::Zero(), omega_B = Vector3d::Zero();
    Vector3d anchor_A, anchor_B;
    Matrix3d triad_A, triad_B;

    JointPlace(const JointRows& rows, const FigureState& state, int joint_i)
        : anchor_A(rows.anchor_A(state, joint_i)),
          anchor_B(rows.anchor_B(state, joint_i)),
          triad_A(rows.triad_A(state, joint_i)),
          triad_B(rows.triad_B(state, joint_i)) {
        const FigureJoint& joint = rows.scene().joint(joint_i);
        if (joint.body_A != the_world) {
            r_A = state.body(joint.body_A).r_CM;
            omega_A = state.body(joint.body_A).omega;
        }
        if (joint.body_B != the_world) {
            r_B = state.body(joint.body_B).r_CM;
            omega_B = state.body(joint.body_B).omega;
        }
    }
};

/// By how much a vector that turns by R in h ends off its tangent, per h.
struct Chord {
    Matrix3d R;
    Vector3d omega;
    double h;
    Vector3d operator()(const Vector3d& s) const { return (R * s - s) / h - omega.cross(s); }
};

/// The target with chords; `zero` chords make the plain one.
JointTarget target_with(const JointRows& rows, const FigureState& state, int joint_i, double h, const Chord& k_A, const Chord& k_B) {
    const FigureJoint& joint = rows.scene().joint(joint_i);
    const JointPlace at(rows, state, joint_i);
    JointTarget target;
    const Vector3d g = at.anchor_B - at.anchor_A, chords = k_A(at.anchor_A - at.r_A) - k_B(at.anchor_B - at.r_B);
    target.g_rate = -g / h + chords;
    if (joint.kind == FigureJointKind::distance) {
        target.g_rate = -(g.norm() - joint.most) / h * g.normalized() + chords;
        return target;
    }
    const auto turn = [&](const Vector3d& a, const Vector3d& b) { return b.cross(-(b - a) / h - k_B(b) + k_A(a)).eval(); };
    switch (joint.kind) {
        case FigureJointKind::hinge:
        case FigureJointKind::parallel: target.W = turn(at.triad_A.col(2), at.triad_B.col(2)); break;
        case FigureJointKind::fixed:
        case FigureJointKind::slider:
            for (int i = 0; i < 3; ++i) target.W += turn(at.triad_A.col(i), at.triad_B.col(i)) / 2;
            break;
        case FigureJointKind::wheel: {
            const Vector3d e = rows.axis_A(state, joint_i);
            target.W = turn(rotation_by((joint.steer + joint.steer_rate * (state.t + h)) * e) * Vector3d(at.triad_A.col(2)), at.triad_B.col(2));
            break;
        }
        case FigureJointKind::universal: {
            const Vector3d a = rows.axis_A(state, joint_i), b = rows.axis_B(state, joint_i), c = a.cross(b);
            const Vector3d a_turned = h * (k_A(a) + k_A.omega.cross(a)), b_turned = h * (k_B(b) + k_B.omega.cross(b));
            const bool plain = k_A.h == infinity;
            const double second = plain ? 0 : h * (k_A(a).dot(b) + a.dot(k_B(b))) + a_turned.dot(b_turned);
            target.W = c / c.squaredNorm() * (a.dot(b) + second) / h;
            break;
        }
        default: break;
    }
    return target;
}

}  // namespace

JointTarget plain_target(const JointRows& rows, const FigureState& state, int joint_i, double h) {
    const Chord none{Matrix3d::Identity(), Vector3d::Zero(), infinity};
    return target_with(rows, state, joint_i, h, none, none);
}

JointTarget second_order_target(const JointRows& rows, const FigureState& state, int joint_i, double h, const Matrix3d& R_A, const Matrix3d& R_B) {
    const JointPlace at(rows, state, joint_i);
    return target_with(rows, state, joint_i, h, Chord{R_A, at.omega_A, h}, Chord{R_B, at.omega_B, h});
}

Matrix3d rotation_ahead(const FigureScene& scene, const FigureState& state, int body_i, double h) {
    if (body_i == the_world || scene.body(body_i).M <= 0) return Matrix3d::Identity();
    const BodyMotion& motion = state.body(body_i);
    const Matrix3d A = motion.A();
    const Vector3d I = scene.body(body_i).I_body, w = A.transpose() * motion.omega;
    const Vector3d change = A * I.cwiseProduct(w).cross(w).cwiseQuotient(I);
    return rotation_by(h * motion.omega + h * h / 2 * change).toRotationMatrix();
}

std::vector<StepRow> locked_rows(const JointRows& rows, const FigureState& state, int joint_i, const JointTarget& target, bool point_of_A_itself) {
    const FigureScene& scene = rows.scene();
    const FigureJoint& joint = scene.joint(joint_i);
    const std::vector<StepBody> bodies = step_bodies(scene, state);
    const Vector3d P_B = rows.anchor_B(state, joint_i), P_A = point_of_A_itself ? rows.anchor_A(state, joint_i) : P_B;
    const Vector3d n_B = rows.axis_B(state, joint_i), a = rows.axis_A(state, joint_i);
    std::vector<StepRow> all;
    const auto move = [&](const Vector3d& e) {
        all.push_back({point_row(bodies, joint.body_A, P_A, joint.body_B, P_B, e), target.g_rate.dot(e), 0, -infinity, infinity});
    };
    const auto turn = [&](const Vector3d& e) { all.push_back({turn_row(joint.body_A, joint.body_B, e), target.W.dot(e), 0, -infinity, infinity}); };
    const auto all_axes = [](const auto& add) {
        for (int i = 0; i < 3; ++i) add(Vector3d::Unit(i));
    };
    const auto across = [](const auto& add, const Vector3d& axis) {
        const Vector3d u = square_to(axis);
        add(u);
        add(axis.cross(u));
    };
    switch (joint.kind) {
        case FigureJointKind::ball: all_axes(move); break;
        case FigureJointKind::hinge:
            all_axes(move);
            across(turn, n_B);
            break;
        case FigureJointKind::universal:
            all_axes(move);
            turn(a.cross(n_B).normalized());
            break;
        case FigureJointKind::fixed:
            all_axes(move);
            all_axes(turn);
            break;
        case FigureJointKind::slider:
            across(move, a);
            all_axes(turn);
            break;
        case FigureJointKind::wheel:
            across(move, a);
            across(turn, n_B);
            break;
        case FigureJointKind::parallel: across(turn, n_B); break;
        case FigureJointKind::distance: {
            const Vector3d n = (P_B - rows.anchor_A(state, joint_i)).normalized();
            const double upper = joint.is_rod() ? infinity : 0;  // a rope pulls
            all.push_back(
                {point_row(bodies, joint.body_A, rows.anchor_A(state, joint_i), joint.body_B, P_B, n), target.g_rate.dot(n), 0, -infinity, upper});
            break;
        }
        case FigureJointKind::gear: {
            std::vector<FigureRow> gear;
            rows.add_locked(state, joint_i, gear);
            all.push_back({gear[0], -gear[0].own_rate, 0, -infinity, infinity});
            break;
        }
    }
    return all;
}

}  // namespace ingot_figures
