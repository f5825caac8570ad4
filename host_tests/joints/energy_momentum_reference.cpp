// SPDX-License-Identifier: MIT
#include "joints/energy_momentum_reference.h"

#include <cmath>
#include <stdexcept>

#include "joints/constrained_step_reference.h"
#include "joints/figure_measures.h"
#include "joints/row_system.h"

namespace ingot_figures {

namespace {

enum class Form { along_world, along_A, product, length };

/// A locked row by its vectors at the start of the step, world axes.
struct MeanRow {
    Form form;
    int joint, body_A, body_B;
    Vector3d s_A, s_B;  // arms to the anchors
    Vector3d a, b;      // axis of the world or of A, axis of B
    double wanted = 0;  // value that the row keeps
};

std::vector<MeanRow> mean_rows(const JointRows& rows, const FigureState& state) {
    std::vector<MeanRow> all;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) {
        const FigureJoint& joint = rows.scene().joint(joint_i);
        if (!joint.enabled) continue;
        const auto centre = [&](int body_i) { return body_i == the_world ? Vector3d(Vector3d::Zero()) : state.body(body_i).r_CM; };
        const Vector3d s_A = rows.anchor_A(state, joint_i) - centre(joint.body_A), s_B = rows.anchor_B(state, joint_i) - centre(joint.body_B);
        const Matrix3d A = rows.triad_A(state, joint_i), B = rows.triad_B(state, joint_i);
        const auto add = [&](Form form, const Vector3d& a, const Vector3d& b, double wanted) {
            all.push_back({form, joint_i, joint.body_A, joint.body_B, s_A, s_B, a, b, wanted});
        };
        const auto point = [&] {
            for (int i = 0; i < 3; ++i) add(Form::along_world, Vector3d::Unit(i), Vector3d::Zero(), 0);
        };
        const auto no_turn = [&] {
            for (int i = 0; i < 3; ++i) add(Form::product, A.col((i + 2) % 3), B.col(i), 0);  // n u, u w, w n
        };
        switch (joint.kind) {
            case FigureJointKind::ball: point(); break;
            case FigureJointKind::hinge: point(); [[fallthrough]];
            case FigureJointKind::parallel:
                for (int i = 0; i < 2; ++i) add(Form::product, A.col(i), B.col(2), 0);
                break;
            case FigureJointKind::slider:
                for (int i = 0; i < 2; ++i) add(Form::along_A, A.col(i), Vector3d::Zero(), 0);
                no_turn();
                break;
            case FigureJointKind::universal:
                point();
                add(Form::product, rows.axis_A(state, joint_i), rows.axis_B(state, joint_i), 0);
                break;
            case FigureJointKind::fixed:
                point();
                no_turn();
                break;
            case FigureJointKind::distance:
                if (!joint.is_rod()) throw std::invalid_argument("the energy-momentum reference has no ropes");
                add(Form::length, Vector3d::Zero(), Vector3d::Zero(), joint.most);
                break;
            default: throw std::invalid_argument("the energy-momentum reference has no such joint");
        }
    }
    return all;
}

Vector3d turned(const Vector3d& theta, const Vector3d& s) {
    const Vector3d across = theta.cross(s);
    return s + (across + theta.cross(across) / 2) / (1 + theta.squaredNorm() / 4);
}

class EnergyMomentum {
public:
    EnergyMomentum(const JointRows& joints, const FigureState& state, double h)
        : scene_(joints.scene()), state_(state), h_(h), rows_(mean_rows(joints, state)), inertia_(scene_, state) {}

    int body_count() const { return scene_.body_count(); }
    int unknowns() const { return 6 * body_count() + static_cast<int>(rows_.size()); }
    const std::vector<MeanRow>& rows() const { return rows_; }

    VectorXd guess() const {
        VectorXd x = VectorXd::Zero(unknowns());
        for (int body_i = 0; body_i < body_count(); ++body_i)
            if (moves(body_i)) x.segment<6>(6 * body_i) << h_ * state_.body(body_i).v_CM + h_ * h_ / 2 * scene_.g, h_ * state_.body(body_i).omega;
        return x;
    }

    VectorXd residual(const VectorXd& x) const {
        VectorXd F = VectorXd::Zero(unknowns());
        std::vector<Vector3d> p(static_cast<std::size_t>(body_count()), Vector3d::Zero()), tau = p;
        for (std::size_t row_i = 0; row_i < rows_.size(); ++row_i) {
            const Eigen::Index at = 6 * body_count() + static_cast<Eigen::Index>(row_i);
            F(at) = act(rows_[row_i], x, x(at), p, tau);
        }
        for (int body_i = 0; body_i < body_count(); ++body_i) {
            const std::size_t i = static_cast<std::size_t>(body_i);
            const Vector3d dr = x.segment<3>(6 * body_i), theta = x.segment<3>(6 * body_i + 3);
            if (!moves(body_i)) {
                F.segment<6>(6 * body_i) = x.segment<6>(6 * body_i);
                continue;
            }
            const double M = scene_.body(body_i).M;
            const Vector3d turn = inertia_.I(body_i) * theta, L = inertia_.I(body_i) * state_.body(body_i).omega;
            F.segment<3>(6 * body_i) = 2 * M / h_ * dr - 2 * M * state_.body(body_i).v_CM - h_ * M * scene_.g - p[i];
            F.segment<3>(6 * body_i + 3) = 2 / h_ * turn + theta.cross(turn) / h_ - 2 * L - tau[i] + theta.cross(tau[i]) / 2;
        }
        return F;
    }

    FigureState after(const VectorXd& x) const {
        FigureState state = state_;
        state.t += h_;
        for (int body_i = 0; body_i < body_count(); ++body_i) {
            if (!moves(body_i)) continue;
            const Vector3d dr = x.segment<3>(6 * body_i), theta = x.segment<3>(6 * body_i + 3);
            const Vector3d L_0 = inertia_.I(body_i) * state_.body(body_i).omega;
            const Vector3d L = turned(theta, 2 / h_ * inertia_.I(body_i) * theta - L_0);
            BodyMotion& body = state.body(body_i);
            body.r_CM += dr;
            body.v_CM = 2 / h_ * dr - body.v_CM;
            body.q = (Quaterniond(1, theta.x() / 2, theta.y() / 2, theta.z() / 2).normalized() * body.q).normalized();
            body.omega = body.q * (body.q.conjugate() * L).cwiseQuotient(scene_.body(body_i).I_body);
        }
        return state;
    }

    std::vector<Vector3d> forces(const VectorXd& x) const {
        std::vector<Vector3d> force(scene_.joints.size(), Vector3d::Zero());
        for (std::size_t row_i = 0; row_i < rows_.size(); ++row_i) {
            std::vector<Vector3d> p(static_cast<std::size_t>(body_count()), Vector3d::Zero()), tau = p;
            act(rows_[row_i], x, x(6 * body_count() + static_cast<Eigen::Index>(row_i)), p, tau);
            force[static_cast<std::size_t>(rows_[row_i].joint)] += p[static_cast<std::size_t>(rows_[row_i].body_B)] / h_;
        }
        return force;
    }

private:
    bool moves(int body_i) const { return body_i != the_world && scene_.body(body_i).M > 0; }
    Vector3d shift(int body_i, const VectorXd& x) const {
        return body_i == the_world ? Vector3d(Vector3d::Zero()) : Vector3d(x.segment<3>(6 * body_i));
    }
    Vector3d end_of(int body_i, const VectorXd& x, const Vector3d& s) const {
        return body_i == the_world ? s : turned(x.segment<3>(6 * body_i + 3), s);
    }
    Vector3d centre(int body_i) const { return body_i == the_world ? Vector3d(Vector3d::Zero()) : state_.body(body_i).r_CM; }

    /// Puts the impulse j of a row onto its bodies, and returns by how much the row is off at the end.
    double act(const MeanRow& row, const VectorXd& x, double j, std::vector<Vector3d>& p, std::vector<Vector3d>& tau) const {
        const int A = row.body_A, B = row.body_B;
        const Vector3d s_A = end_of(A, x, row.s_A), s_B = end_of(B, x, row.s_B), a = row.form == Form::along_world ? row.a : end_of(A, x, row.a);
        const Vector3d b = end_of(B, x, row.b), d_0 = centre(B) + row.s_B - centre(A) - row.s_A;
        const Vector3d d = centre(B) + shift(B, x) + s_B - centre(A) - shift(A, x) - s_A;
        const Vector3d mean_A = (row.s_A + s_A) / 2, mean_B = (row.s_B + s_B) / 2, mean_a = (row.a + a) / 2, mean_b = (row.b + b) / 2,
                       mean_d = (d_0 + d) / 2;
        const auto push = [&](const Vector3d& f, const Vector3d& arm_A) {
            p[static_cast<std::size_t>(B)] += f;
            tau[static_cast<std::size_t>(B)] += mean_B.cross(f);
            if (A == the_world) return;
            p[static_cast<std::size_t>(A)] -= f;
            tau[static_cast<std::size_t>(A)] -= arm_A.cross(f);
        };
        switch (row.form) {
            case Form::along_world: push(j * row.a, mean_A); return d.dot(row.a);
            case Form::along_A: push(j * mean_a, mean_A + mean_d); return d.dot(a) - row.wanted;
            case Form::product: {
                const Vector3d twist = j * mean_a.cross(mean_b);
                tau[static_cast<std::size_t>(B)] -= twist;
                if (A != the_world) tau[static_cast<std::size_t>(A)] += twist;
                return a.dot(b) - row.wanted;
            }
            case Form::length: push(j * mean_d.normalized(), mean_A); return d.norm() - row.wanted;
        }
        return 0;
    }

    const FigureScene& scene_;
    const FigureState& state_;
    double h_;
    std::vector<MeanRow> rows_;
    FigureInertia inertia_;
};

}  // namespace

EnergyMomentumStep energy_momentum_step(const JointRows& rows, const FigureState& state, double h) {
    constexpr int most_passes = 40;
    const EnergyMomentum step(rows, state, h);
    const int n = step.unknowns(), bodies = 6 * step.body_count();
    VectorXd x = step.guess();
    EnergyMomentumStep result;
    double last = infinity;
    for (result.passes = 0; result.passes < most_passes; ++result.passes) {
        const VectorXd F = step.residual(x);
        MatrixXd J(n, n);
        for (int i = 0; i < n; ++i) {
            const double size = 1e-6 * (1 + std::abs(x(i)));
            VectorXd more = x, less = x;
            more(i) += size;
            less(i) -= size;
            J.col(i) = (step.residual(more) - step.residual(less)) / (2 * size);
        }
        // Redundant rows: a compliance of the increment, far below that of bodies of a tonne, h / 2 M, and nothing once nothing changes.
        for (int i = bodies; i < n; ++i) J(i, i) -= 1e-8 * h;
        const VectorXd change = J.partialPivLu().solve(-F);
        x += change;
        const double size = change.head(bodies).cwiseAbs().maxCoeff();
        if (!std::isfinite(size)) break;
        if (size < 1e-15 || (size < 1e-12 && size >= last / 2)) {  // down to rounding
            result.converged = true;
            break;
        }
        last = size;
    }
    result.state = step.after(x);
    result.force = step.forces(x);
    return result;
}

EnergyMomentumStep energy_momentum_suzuki_step(const JointRows& rows, const FigureState& state, double h) {
    const double p = 1 / (4 - std::cbrt(4.0));
    EnergyMomentumStep result;
    result.state = state;
    result.converged = true;
    for (const double part : {p, p, 1 - 4 * p, p, p}) {
        const EnergyMomentumStep step = energy_momentum_step(rows, result.state, part * h);
        result.state = step.state;
        result.force = step.force;
        result.converged = result.converged && step.converged;
        result.passes += step.passes;
    }
    result.state.t = state.t + h;
    return result;
}

namespace {

/// The motion of one rigid body with the momentum of all; none for a figure that is tied to the world.
FigureState rigid_part(const JointRows& rows, const FigureState& state) {
    const FigureScene& scene = rows.scene();
    FigureState rigid = state;
    bool tied = false;
    for (const FigureJoint& joint : scene.joints)
        tied = tied || (joint.enabled && (joint.body_A == the_world || scene.body(joint.body_A).M <= 0 || scene.body(joint.body_B).M <= 0));
    const double M = mass(scene);
    const Vector3d centre = centre_of_mass(scene, state), v = momentum(scene, state) / M;
    const Vector3d L = angular_momentum(scene, state) - centre.cross(M * v);
    const FigureInertia inertia(scene, state);
    Matrix3d I = Matrix3d::Zero();
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const Vector3d d = state.body(body_i).r_CM - centre;
        I += inertia.I(body_i) + scene.body(body_i).M * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    const Vector3d omega = tied ? Vector3d(Vector3d::Zero()) : Vector3d(I.inverse() * L);
    for (BodyMotion& body : rigid.bodies) {
        body.omega = omega;
        body.v_CM = tied ? Vector3d(Vector3d::Zero()) : Vector3d(v + omega.cross(body.r_CM - centre));
    }
    return rigid;
}

}  // namespace

FigureState conditionally_projected(const JointRows& rows, const FigureState& state, double share) {
    const FigureScene& scene = rows.scene();
    std::vector<FigureRow> locked;
    for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) rows.add_locked(state, joint_i, locked);
    std::vector<StepRow> all;
    for (const FigureRow& row : locked) all.push_back({row, -row.own_rate, 0, -infinity, infinity});
    FigureState projected = with_velocities(state, solve_step(step_bodies(scene, state), all));
    const double k_0 = kinetic_energy(scene, state), k_1 = kinetic_energy(scene, projected);
    if (k_0 - k_1 <= share * k_0) return state;
    const FigureState rigid = rigid_part(rows, state);
    const double k_rigid = kinetic_energy(scene, rigid), s = std::sqrt((k_0 - k_rigid) / (k_1 - k_rigid));
    for (std::size_t body_i = 0; body_i < projected.bodies.size(); ++body_i) {
        BodyMotion& body = projected.bodies[body_i];
        const BodyMotion& base = rigid.bodies[body_i];
        body.v_CM = base.v_CM + s * (body.v_CM - base.v_CM);
        body.omega = base.omega + s * (body.omega - base.omega);
    }
    return projected;
}

}  // namespace ingot_figures
