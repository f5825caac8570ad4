// SPDX-License-Identifier: MIT
// What scenes are put together from.
#include "joints/constrained_step_reference.h"
#include "joints/figure_measures.h"
#include "joints/figure_scenes.h"

namespace ingot_figures {

Vector3d box_moments(double M, const Vector3d& half_extent) {
    const Vector3d sq = half_extent.cwiseAbs2();
    return M / 3 * Vector3d(sq.y() + sq.z(), sq.z() + sq.x(), sq.x() + sq.y());
}

Vector3d sphere_moments(double M, double radius) { return 0.4 * M * radius * radius * Vector3d::Ones(); }

Vector3d capsule_moments(double M, double radius, double half_length) {
    const double r = radius, l = half_length;
    const double cylinder = 2 * l, caps = 4.0 / 3 * r;  // volumes over pi r^2
    const double M_c = M * cylinder / (cylinder + caps), M_s = M - M_c;
    const double axial = M_c * r * r / 2 + M_s * 0.4 * r * r;
    const double across = M_c * (r * r / 4 + l * l / 3) + M_s * (0.4 * r * r + l * l + 0.75 * r * l);
    return {across, across, axial};
}

FigureBody box(double M, const Vector3d& half_extent, const Vector3d& r_CM, const Matrix3d& A) {
    FigureBody body;
    body.M = M;
    body.I_body = box_moments(M, half_extent);
    body.r_CM = r_CM;
    body.A = A;
    body.shape = FigureShape::box;
    body.half_extent = half_extent;
    body.friction = 0.6;
    return body;
}

FigureBody sphere(double M, double radius, const Vector3d& r_CM) {
    FigureBody body = box(M, Vector3d(radius, 0, 0), r_CM, Matrix3d::Identity());
    body.I_body = sphere_moments(M, radius);
    body.shape = FigureShape::sphere;
    return body;
}

FigureBody capsule(double M, double radius, double half_length, const Vector3d& r_CM, const Matrix3d& A) {
    FigureBody body = box(M, Vector3d(radius, 0, half_length), r_CM, A);
    body.I_body = capsule_moments(M, radius, half_length);
    body.shape = FigureShape::capsule;
    return body;
}

FigureBody ground(double friction) {
    FigureBody body = box(0, Vector3d(50, 50, 0.5), Vector3d(0, 0, -0.5));
    body.friction = friction;
    return body;
}

FigureJoint joint_of(FigureJointKind kind, int body_A, int body_B, const Vector3d& anchor, const Vector3d& axis_A, const Vector3d& axis_B) {
    FigureJoint joint;
    joint.kind = kind;
    joint.body_A = body_A;
    joint.body_B = body_B;
    joint.anchor = joint.anchor_B = anchor;
    joint.axis_A = axis_A.normalized();
    joint.axis_B = axis_B.normalized();
    return joint;
}

FigureJoint ball(int body_A, int body_B, const Vector3d& anchor) {
    return joint_of(FigureJointKind::ball, body_A, body_B, anchor, Vector3d::UnitZ(), Vector3d::UnitZ());
}

FigureJoint hinge(int body_A, int body_B, const Vector3d& anchor, const Vector3d& axis) {
    return joint_of(FigureJointKind::hinge, body_A, body_B, anchor, axis, axis);
}

Matrix3d along(const Vector3d& direction) {
    const Vector3d z = Vector3d::UnitZ();
    if (direction.z() >= 0) return least_turn(z, direction).toRotationMatrix();
    return least_turn(-z, direction).toRotationMatrix() * Eigen::DiagonalMatrix<double, 3>(1, -1, -1);  // upside down first
}

int insert(FigureScene& scene, const FigureScene& part, const Vector3d& r, const Matrix3d& R) {
    const int first_body = scene.body_count(), first_joint = scene.joint_count();
    for (FigureBody body : part.bodies) {
        body.r_CM = r + R * body.r_CM;
        body.A = R * body.A;
        body.v_CM = R * body.v_CM;
        body.omega = R * body.omega;
        scene.add(body);
    }
    for (FigureJoint joint : part.joints) {
        joint.anchor = r + R * joint.anchor;
        joint.anchor_B = r + R * joint.anchor_B;
        joint.axis_A = R * joint.axis_A;
        joint.axis_B = R * joint.axis_B;
        if (joint.body_A != the_world) joint.body_A += first_body;
        joint.body_B += first_body;
        joint.gear_1 += first_joint;
        joint.gear_2 += first_joint;
        scene.join(joint);
    }
    return first_body;
}

namespace {

void take_velocities(FigureScene& scene, const StepSolution& solution) {
    for (std::size_t body_i = 0; body_i < scene.bodies.size(); ++body_i) {
        scene.bodies[body_i].v_CM = solution.v_CM[body_i];
        scene.bodies[body_i].omega = solution.omega[body_i];
    }
}

std::vector<StepRow> rows_that_hold(const JointRows& rows, const FigureState& state) {
    std::vector<FigureRow> locked;
    for (int joint_i = 0; joint_i < rows.scene().joint_count(); ++joint_i) rows.add_locked(state, joint_i, locked);
    std::vector<StepRow> all;
    for (const FigureRow& row : locked) all.push_back({row, -row.own_rate, 0, -infinity, infinity});
    return all;
}

}  // namespace

void set_rate(FigureScene& scene, int joint_i, double rate) {
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    std::vector<StepRow> all = rows_that_hold(rows, state);
    const FigureRow driven = rows.measure(state, joint_i, rows.driven(joint_i));
    all.push_back({driven, rate - driven.own_rate, 0, -infinity, infinity});
    take_velocities(scene, solve_step(step_bodies(scene, state), all));
}

void hold_joints(FigureScene& scene) {
    const JointRows rows(scene);
    const FigureState state = start_of(scene);
    take_velocities(scene, solve_step(step_bodies(scene, state), rows_that_hold(rows, state)));
}

void add_motion(FigureScene& scene, const Vector3d& v, const Vector3d& omega) {
    const Vector3d centre = centre_of_mass(scene, start_of(scene));
    for (FigureBody& body : scene.bodies) {
        if (body.M <= 0) continue;
        body.v_CM += v + omega.cross(body.r_CM - centre);
        body.omega += omega;
    }
}

}  // namespace ingot_figures
