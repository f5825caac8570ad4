// SPDX-License-Identifier: MIT
#include <cmath>

#include "joints/constrained_step_reference.h"
#include "joints/figure_scenes.h"
#include "reference/random_input.h"

namespace ingot_figures {

namespace {

FigureBody pendulum_body(double M, const Vector3d& I, const Vector3d& r_CM, const Matrix3d& A) {
    FigureBody body;
    body.M = M;
    body.I_body = I;
    body.r_CM = r_CM;
    body.A = A;
    return body;
}

}  // namespace

FigureScene planar_pendulum(double k, double theta_0) {
    FigureScene scene;
    scene.name = "planar_pendulum";
    scene.g = {0, 0, -k};
    const Matrix3d A = turn_about(Vector3d::UnitY(), theta_0);
    const int body = scene.add(pendulum_body(1, Vector3d(0.25, 0.25, 0.125), A * Vector3d(0, 0, -0.5), A));
    scene.join(hinge(the_world, body, Vector3d::Zero(), Vector3d::UnitY()));
    return scene;
}

FigureScene spherical_pendulum(double g, double l, const Vector3d& r, const Vector3d& v) {
    FigureScene scene;
    scene.name = "spherical_pendulum";
    scene.g = {0, 0, -g};
    FigureBody body = pendulum_body(1, 3.0 / 16 * l * l * Vector3d::Ones(), 0.75 * r, Matrix3d::Identity());
    body.omega = r.cross(v) / r.squaredNorm();
    body.v_CM = body.omega.cross(body.r_CM);
    scene.join(ball(the_world, scene.add(body), Vector3d::Zero()));
    return scene;
}

FigureScene double_parallel_pendulum(const DoublePendulum& p) {
    FigureScene scene;
    scene.name = "double_parallel_pendulum";
    scene.g = {0, 0, -p.g};
    const Vector3d y = Vector3d::UnitY();
    const Matrix3d A_1 = turn_about(y, p.q1), A_2 = turn_about(y, p.q2);
    const Vector3d knee = A_1 * Vector3d(0, 0, -p.l1), omega_1 = p.q1_rate * y, omega_2 = p.q2_rate * y;
    FigureBody first = pendulum_body(p.m1, p.I1, A_1 * Vector3d(0, 0, -p.c1), A_1);
    first.omega = omega_1;
    first.v_CM = omega_1.cross(first.r_CM);
    FigureBody second = pendulum_body(p.m2, p.I2, knee + A_2 * Vector3d(0, 0, -p.c2), A_2);
    second.omega = omega_2;
    second.v_CM = omega_1.cross(knee) + omega_2.cross(second.r_CM - knee);
    const int body_1 = scene.add(first), body_2 = scene.add(second);
    scene.join(hinge(the_world, body_1, Vector3d::Zero(), y));
    scene.join(hinge(body_1, body_2, knee, y));
    return scene;
}

FigureScene double_perpendicular_pendulum(const DoublePendulum& p) {
    FigureScene scene;
    scene.name = "double_perpendicular_pendulum";
    scene.g = {0, 0, -p.g};
    const Vector3d y = Vector3d::UnitY();
    const Matrix3d A_1 = turn_about(y, p.q1), A_2 = A_1 * turn_about(Vector3d::UnitX(), p.q2);
    const Vector3d knee = A_1 * Vector3d(0, 0, -p.l1), axis = A_1.col(0), omega_1 = p.q1_rate * y, omega_2 = omega_1 + p.q2_rate * axis;
    FigureBody first = pendulum_body(p.m1, p.I1, A_1 * Vector3d(0, 0, -p.c1), A_1);
    first.omega = omega_1;
    first.v_CM = omega_1.cross(first.r_CM);
    FigureBody second = pendulum_body(p.m2, p.I2, knee + A_2 * Vector3d(0, 0, -p.c2), A_2);
    second.omega = omega_2;
    second.v_CM = omega_1.cross(knee) + omega_2.cross(second.r_CM - knee);
    const int body_1 = scene.add(first), body_2 = scene.add(second);
    scene.join(hinge(the_world, body_1, Vector3d::Zero(), y));
    scene.join(hinge(body_1, body_2, knee, axis));
    return scene;
}

FigureScene pendulum_with_stop(double theta_0, double stop, double restitution) {
    FigureScene scene;
    scene.name = "pendulum_with_stop";
    const Matrix3d A = turn_about(Vector3d::UnitY(), theta_0);
    const int body = scene.add(pendulum_body(1, Vector3d(1.0 / 12, 1.0 / 12, 1.0 / 96), A * Vector3d(0, 0, -0.5), A));
    FigureJoint joint = hinge(the_world, body, Vector3d::Zero(), Vector3d::UnitY());
    (stop < theta_0 ? joint.lower : joint.upper) = stop - theta_0;
    joint.restitution = restitution;
    scene.join(joint);
    return scene;
}

FigureScene spring_rotor(double J, double stiffness, double damping, double angle, double max_torque) {
    FigureScene scene;
    scene.name = "spring_rotor";
    const int body = scene.add(pendulum_body(1, Vector3d(0.75 * J, 0.75 * J, J), Vector3d::Zero(), Matrix3d::Identity()));
    FigureJoint joint = hinge(the_world, body, Vector3d::Zero(), Vector3d::UnitZ());
    joint.servo.stiffness = stiffness;
    joint.servo.damping = damping;
    joint.servo.target = -angle;
    joint.servo.max_torque = max_torque;
    scene.join(joint);
    return scene;
}

FigureScene chain(const ChainOptions& options) {
    FigureScene scene;
    scene.name = "chain";
    const Vector3d e = options.direction.normalized(), half(0.05, 0.05, options.link_length / 2);
    const auto join = [&](int body_A, int body_B, const Vector3d& anchor) {
        FigureJoint joint = options.kind == FigureJointKind::hinge ? hinge(body_A, body_B, anchor, Vector3d::UnitY()) : ball(body_A, body_B, anchor);
        joint.break_force = options.break_force;
        scene.join(joint);
    };
    int last = the_world;
    for (int link_i = 0; link_i < options.links; ++link_i) {
        const Vector3d from = link_i * options.link_length * e;
        const int link = scene.add(box(options.link_mass, half, from + options.link_length / 2 * e, along(e)));
        join(last, link, from);
        last = link;
    }
    if (options.end_radius <= 0) return scene;
    const Vector3d end = options.links * options.link_length * e;
    join(last, scene.add(sphere(options.end_mass, options.end_radius, end + options.end_radius * e)), end);
    return scene;
}

FigureScene floating_chain(int links, double spin, std::uint64_t seed) {
    ChainOptions options;
    options.links = links;
    options.end_radius = 0;
    FigureScene scene = chain(options);
    scene.name = "floating_chain";
    scene.g.setZero();
    scene.joints.erase(scene.joints.begin());
    ingot_reference::RandomInput random(seed);
    for (FigureBody& link : scene.bodies) link.omega = random.real(0, spin) * random.direction();
    for (const FigureJoint& joint : scene.joints) {
        const FigureBody& A = scene.body(joint.body_A);
        FigureBody& B = scene.body(joint.body_B);
        B.v_CM = A.v_CM + A.omega.cross(joint.anchor - A.r_CM) + B.omega.cross(B.r_CM - joint.anchor);
    }
    return scene;
}

FigureScene breaking_chain(int links, double end_mass) {
    ChainOptions options;
    options.links = links;
    options.link_length = 0.2;
    options.link_mass = 0.2;
    options.end_mass = end_mass;
    options.end_radius = 0.1;
    options.break_force = 1.5 * 9.81 * (links * options.link_mass + end_mass);
    FigureScene scene = chain(options);
    scene.name = "breaking_chain";
    return scene;
}

namespace {

const Vector3d plate_half(0.2, 0.2, 0.02);
constexpr double top_arm = 0.3;

}  // namespace

double top_precession(double spin, double tilt) {
    const Vector3d I = box_moments(1, plate_half);
    const double I_1 = I.x() + top_arm * top_arm, I_3 = I.z(), mgr = 9.81 * top_arm;
    const double a = I_1 * std::cos(tilt), b = I_3 * spin;
    return 2 * mgr / (b + std::sqrt(b * b - 4 * a * mgr));  // the slow root of a p^2 - b p + m g r = 0
}

FigureScene heavy_top(double spin, double tilt) {
    FigureScene scene;
    scene.name = "heavy_top";
    const Matrix3d A = turn_about(Vector3d::UnitY(), tilt);
    const Vector3d axis = A.col(2);
    FigureBody plate = box(1, plate_half, top_arm * axis, A);
    plate.shape = FigureShape::none;
    // Precession about the vertical; about its own axis all in all `spin`.
    const double precession = top_precession(spin, tilt);
    const Vector3d p = precession * Vector3d::UnitZ();
    plate.omega = p + (spin - p.dot(axis)) * axis;
    plate.v_CM = plate.omega.cross(plate.r_CM);
    scene.join(ball(the_world, scene.add(plate), Vector3d::Zero()));
    return scene;
}

FigureScene binary_tree(int levels, double end_mass) {
    FigureScene scene;
    scene.name = "binary_tree";
    struct End {
        int body;
        Vector3d place, direction;
    };
    std::vector<End> ends{{the_world, Vector3d::Zero(), Vector3d::UnitX()}};
    const double length = 0.5;
    for (int level = 0; level < levels; ++level) {
        std::vector<End> next;
        for (const End& end : ends) {
            const bool is_last = level + 1 == levels;
            const int link = scene.add(
                box(is_last ? end_mass : 1, Vector3d(0.04, 0.04, length / 2), end.place + length / 2 * end.direction, along(end.direction)));
            scene.join(ball(end.body, link, end.place));
            const Vector3d tip = end.place + length * end.direction, across = level % 2 == 0 ? Vector3d::UnitY() : Vector3d::UnitZ();
            for (const double side : {-0.7, 0.7}) next.push_back({link, tip, (end.direction + side * across).normalized()});
        }
        ends = next;
    }
    return scene;
}

FigureScene mixed_tree(bool with_rod, std::uint64_t seed) {
    FigureScene scene;
    scene.name = "mixed_tree";
    ingot_reference::RandomInput random(seed);
    const FigureJointKind kinds[] = {FigureJointKind::hinge, FigureJointKind::universal, FigureJointKind::slider, FigureJointKind::ball,
                                     FigureJointKind::fixed, FigureJointKind::wheel,     FigureJointKind::hinge};
    Vector3d place(0, 0, 0);
    int last = the_world;
    for (const FigureJointKind kind : kinds) {
        const Vector3d e = (random.direction() + Vector3d(1, 0, -0.5)).normalized();
        FigureBody link = box(random.real(0.5, 2), Vector3d(0.05, 0.08, 0.2), place + 0.2 * e, along(e));
        link.shape = FigureShape::none;
        const int body = scene.add(link);
        const Vector3d a = random.direction(), b = square_to(a);
        FigureJoint joint = joint_of(kind, last, body, place, a, kind == FigureJointKind::ball ? random.direction() : b);
        scene.join(joint);
        place += 0.4 * e;
        last = body;
    }
    if (with_rod) {  // from the second body to the last
        FigureJoint rod =
            joint_of(FigureJointKind::distance, 1, last, scene.body(1).r_CM + Vector3d(0.05, 0, 0), Vector3d::UnitZ(), Vector3d::UnitZ());
        rod.anchor_B = scene.body(last).r_CM;
        rod.least = rod.most = (rod.anchor_B - rod.anchor).norm();
        scene.join(rod);
    }
    for (FigureBody& body : scene.bodies) {
        body.omega = random.vector(2);
        body.v_CM = random.vector(1);
    }
    set_rate(scene, 0, 1);
    return scene;
}

}  // namespace ingot_figures
