// SPDX-License-Identifier: MIT
#include "joints/figure_measures.h"

#include <algorithm>
#include <cmath>

#include "joints/row_system.h"

namespace ingot_figures {

namespace {

Vector3d spin_of(const FigureBody& body, const BodyMotion& motion) {
    return motion.q * body.I_body.cwiseProduct(motion.q.conjugate() * motion.omega);  // I omega
}

/// Springs whose energy comes back.
double spring_energy(const FigureDrive& drive, double x) {
    return drive.max_torque < infinity ? 0 : drive.stiffness * (x - drive.target) * (x - drive.target) / 2;
}

}  // namespace

double kinetic_energy(const FigureScene& scene, const FigureState& state) {
    double sum = 0;
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const FigureBody& body = scene.body(body_i);
        const BodyMotion& motion = state.body(body_i);
        if (body.M > 0) sum += (body.M * motion.v_CM.squaredNorm() + motion.omega.dot(spin_of(body, motion))) / 2;
    }
    return sum;
}

double potential_energy(const JointRows& rows, const FigureState& state) {
    const FigureScene& scene = rows.scene();
    double sum = 0;
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) sum -= scene.body(body_i).M * scene.g.dot(state.body(body_i).r_CM);
    for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene.joint(joint_i);
        if (!joint.enabled) continue;
        if (joint.servo.exists()) {
            if (rows.has_driven(joint_i))
                sum += spring_energy(joint.servo, measured(rows, state, joint_i, rows.driven(joint_i)));
            else
                sum += joint.servo.max_torque < infinity ? 0 : joint.servo.stiffness * rows.rotation(state, joint_i).squaredNorm() / 2;
        }
        if (joint.suspension.exists()) sum += spring_energy(joint.suspension, measured(rows, state, joint_i, FigureMeasure::travel));
    }
    return sum;
}

double energy(const JointRows& rows, const FigureState& state) { return kinetic_energy(rows.scene(), state) + potential_energy(rows, state); }

double mass(const FigureScene& scene) {
    double sum = 0;
    for (const FigureBody& body : scene.bodies) sum += body.M;
    return sum;
}

Vector3d centre_of_mass(const FigureScene& scene, const FigureState& state) {
    Vector3d sum = Vector3d::Zero();
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) sum += scene.body(body_i).M * state.body(body_i).r_CM;
    return sum / mass(scene);
}

Vector3d momentum(const FigureScene& scene, const FigureState& state) {
    Vector3d sum = Vector3d::Zero();
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) sum += scene.body(body_i).M * state.body(body_i).v_CM;
    return sum;
}

Vector3d angular_momentum(const FigureScene& scene, const FigureState& state) {
    Vector3d sum = Vector3d::Zero();
    for (int body_i = 0; body_i < scene.body_count(); ++body_i) {
        const FigureBody& body = scene.body(body_i);
        const BodyMotion& motion = state.body(body_i);
        if (body.M > 0) sum += body.M * motion.r_CM.cross(motion.v_CM) + spin_of(body, motion);
    }
    return sum;
}

double gap(const JointRows& rows, const FigureState& state, int joint_i) {
    const FigureJoint& joint = rows.scene().joint(joint_i);
    if (!joint.enabled) return 0;
    const Vector3d d = rows.anchor_B(state, joint_i) - rows.anchor_A(state, joint_i);
    switch (joint.kind) {
        case FigureJointKind::slider:
        case FigureJointKind::wheel: return d.cross(rows.axis_A(state, joint_i)).norm();
        case FigureJointKind::distance: return std::max({0.0, d.norm() - joint.most, joint.least - d.norm()});
        case FigureJointKind::parallel:
        case FigureJointKind::gear: return 0;
        default: return d.norm();
    }
}

double worst_gap(const JointRows& rows, const FigureState& state) {
    double worst = 0;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) worst = std::max(worst, gap(rows, state, joint_i));
    return worst;
}

double misalignment(const JointRows& rows, const FigureState& state, int joint_i) {
    const auto between = [](const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); };
    if (!rows.scene().joint(joint_i).enabled) return 0;
    switch (rows.scene().joint(joint_i).kind) {
        case FigureJointKind::hinge:
        case FigureJointKind::parallel: return between(rows.triad_A(state, joint_i).col(2), rows.triad_B(state, joint_i).col(2));
        case FigureJointKind::universal: return std::abs(std::asin(rows.axis_A(state, joint_i).dot(rows.axis_B(state, joint_i))));
        case FigureJointKind::fixed:
        case FigureJointKind::slider: return rows.rotation(state, joint_i).norm();
        case FigureJointKind::wheel: {
            std::vector<FigureRow> locked;
            rows.add_locked(state, joint_i, locked);
            return std::hypot(locked[2].value, locked[3].value);
        }
        default: return 0;
    }
}

double worst_misalignment(const JointRows& rows, const FigureState& state) {
    double worst = 0;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) worst = std::max(worst, misalignment(rows, state, joint_i));
    return worst;
}

double worst_excess(const JointRows& rows, const FigureState& state) {
    double worst = -infinity;
    for (const FigureLimit& limit : rows.limits())
        worst = std::max(worst, limit.sign * (limit.bound - measured(rows, state, limit.joint, limit.measure)));
    return worst;
}

double measured(const JointRows& rows, const FigureState& state, int joint_i, FigureMeasure which) {
    return rows.measure(state, joint_i, which).value;
}

double measured_rate(const JointRows& rows, const FigureState& state, int joint_i, FigureMeasure which) {
    return rows.measure(state, joint_i, which).rate(state);
}

double inadmissible_share(const JointRows& rows, const FigureState& state) {
    std::vector<FigureRow> locked;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) rows.add_locked(state, joint_i, locked);
    if (locked.empty()) return 0;
    const FigureInertia inertia(rows.scene(), state);
    const RowSystem system(inertia, locked);
    VectorXd rates(static_cast<Eigen::Index>(locked.size()));
    for (Eigen::Index row_i = 0; row_i < rates.size(); ++row_i) rates(row_i) = locked[static_cast<std::size_t>(row_i)].rate(state);
    const double kinetic = kinetic_energy(rows.scene(), state);
    return kinetic > 0 ? system.solve_all(rates).lambda.dot(rates) / 2 / kinetic : 0;
}

double drive_torque(const FigureDrive& drive, double x, double rate) {
    const double torque = -drive.stiffness * (x - drive.target) - drive.damping * (rate - drive.target_rate);
    return std::min(drive.max_torque, std::max(-drive.max_torque, torque));
}

void AppliedLoads::add(const FigureRow& row, double lambda) {
    for (int part_i = 0; part_i < row.part_count; ++part_i) {
        const FigureRow::Part& part = row.parts[part_i];
        force[static_cast<std::size_t>(part.body)] += lambda * part.on_v;
        torque[static_cast<std::size_t>(part.body)] += lambda * part.on_omega;
    }
}

AppliedLoads applied_loads(const JointRows& rows, const FigureState& state) {
    const FigureScene& scene = rows.scene();
    AppliedLoads loads;
    for (const FigureBody& body : scene.bodies) {
        loads.force.push_back(body.M * scene.g);
        loads.torque.push_back(Vector3d::Zero());
    }
    for (int joint_i = 0; joint_i < scene.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene.joint(joint_i);
        if (!joint.enabled) continue;
        const auto drive = [&](const FigureDrive& law, FigureMeasure which) {
            const FigureRow row = rows.measure(state, joint_i, which);
            loads.add(row, drive_torque(law, row.value, row.rate(state)));
        };
        if (joint.suspension.exists()) drive(joint.suspension, FigureMeasure::travel);
        if (!joint.servo.exists()) continue;
        if (rows.has_driven(joint_i)) {
            drive(joint.servo, rows.driven(joint_i));
            continue;
        }
        const auto omega = [&](int body_i) { return body_i == the_world ? Vector3d(Vector3d::Zero()) : state.body(body_i).omega; };
        Vector3d torque = -joint.servo.stiffness * rows.rotation(state, joint_i) - joint.servo.damping * (omega(joint.body_B) - omega(joint.body_A));
        if (torque.norm() > joint.servo.max_torque) torque *= joint.servo.max_torque / torque.norm();
        loads.torque[static_cast<std::size_t>(joint.body_B)] += torque;
        if (joint.body_A != the_world) loads.torque[static_cast<std::size_t>(joint.body_A)] -= torque;
    }
    return loads;
}

}  // namespace ingot_figures
