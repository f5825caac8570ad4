// SPDX-License-Identifier: MIT
// Buildings and machines: loops, drives, things that carry things.
#include <cmath>

#include "joints/figure_scenes.h"

namespace ingot_figures {

namespace {

const Vector3d x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

/// A bar of square section between two points, body z along it.
FigureBody bar(double M, double thickness, const Vector3d& from, const Vector3d& to) {
    FigureBody body = box(M, Vector3d(thickness / 2, thickness / 2, (to - from).norm() / 2), (from + to) / 2, along((to - from).normalized()));
    body.shape = FigureShape::none;
    return body;
}

/// In the plane x z, at an angle from x towards z.
Vector3d at_angle(double angle) { return {std::cos(angle), 0, std::sin(angle)}; }

}  // namespace

FigureScene bridge(int planks, int boxes, double box_factor) {
    FigureScene scene;
    scene.name = "bridge";
    const double length = 0.5, bend = 0.6 / planks;  // the arc turns by 0.6 rad
    Vector3d place(0, 0, 3);
    std::vector<Vector3d> middles;
    int last = the_world;
    for (int plank_i = 0; plank_i < planks; ++plank_i) {
        const double slope = bend * (plank_i + 0.5 - planks / 2.0);
        const Vector3d e = at_angle(slope);
        const int plank = scene.add(box(10, Vector3d(length / 2, 0.5, 0.04), place + length / 2 * e, turn_about(y_axis, -slope)));
        scene.join(hinge(last, plank, place, y_axis));
        middles.push_back(scene.body(plank).r_CM);
        place += length * e;
        last = plank;
    }
    scene.join(hinge(the_world, last, place, y_axis));
    for (int box_i = 0; box_i < boxes; ++box_i) {
        const std::size_t over = static_cast<std::size_t>((box_i + 0.5) / boxes * planks);
        scene.add(box(10 * box_factor, Vector3d(0.2, 0.2, 0.2), middles[over] + Vector3d(0, 0, 0.5)));
    }
    return scene;
}

FigureScene rope_over_edge(int links, double left_mass, double right_mass) {
    FigureScene scene;
    scene.name = "rope_over_edge";
    const double length = 0.1, radius = 0.02, half_wall = 0.18, friction = 0.1, height = 4;
    FigureBody wall = box(0, Vector3d(half_wall, 1, 0.5), Vector3d(0, 0, height - 0.5));
    wall.friction = friction;
    scene.add(wall);
    const int across = 4, hanging = (links - across) / 2;
    std::vector<Vector3d> places;  // of the ends of links; corners stand off the edge by the radius
    for (int i = 0; i <= links; ++i) {
        const double top = height + radius, side = half_wall + radius;
        if (i <= hanging)
            places.emplace_back(-side, 0, top - (hanging - i) * length);
        else if (i <= hanging + across)
            places.emplace_back(-side + (i - hanging) * length, 0, top);
        else
            places.emplace_back(side, 0, top - (i - hanging - across) * length);
    }
    const auto weight = [&](double M, const Vector3d& end) {
        FigureBody body = sphere(M, 0.08, end + Vector3d(0, 0, -0.08));
        body.friction = friction;
        return body;
    };
    int last = scene.add(weight(left_mass, places.front()));
    for (int link_i = 0; link_i < links; ++link_i) {
        const Vector3d from = places[static_cast<std::size_t>(link_i)], to = places[static_cast<std::size_t>(link_i) + 1];
        FigureBody link = capsule(0.05, radius, length / 2, (from + to) / 2, along((to - from).normalized()));
        link.friction = friction;
        const int body = scene.add(link);
        scene.join(ball(last, body, from));
        last = body;
    }
    scene.join(ball(last, scene.add(weight(right_mass, places.back())), places.back()));
    return scene;
}

FigureScene door(int hinges, double lean) {
    FigureScene scene;
    scene.name = "door";
    const Matrix3d R = turn_about(x_axis, lean) * turn_about(z_axis, 1);  // opened about its own line, which leans
    FigureBody leaf = box(10, Vector3d(0.5, 0.02, 1), R * Vector3d(0.5, 0, 1), R);
    leaf.shape = FigureShape::none;
    const int body = scene.add(leaf);
    const Vector3d line = R * z_axis;
    for (int hinge_i = 0; hinge_i < hinges; ++hinge_i) {
        const double height = hinges == 1 ? 1 : 0.2 + 1.6 * hinge_i / (hinges - 1);
        scene.join(hinge(the_world, body, height * line, line));
    }
    return scene;
}

namespace {

constexpr double crank_bar = 0.4, coupler_bar = 0.9, rocker_bar = 0.8, ground_bar = 1.0;

}  // namespace

FourBarPose four_bar_pose(double crank_angle) {
    // Where the coupler's end is: on a circle about the crank's end and one about the rocker's foot.
    const Vector3d crank_end = crank_bar * at_angle(crank_angle), foot = ground_bar * x_axis, diagonal = foot - crank_end;
    const double d = diagonal.norm(), s = (d * d + coupler_bar * coupler_bar - rocker_bar * rocker_bar) / (2 * d);
    const double height = std::sqrt(coupler_bar * coupler_bar - s * s);
    const Vector3d e = diagonal / d, square = Vector3d(-e.z(), 0, e.x());
    const Vector3d end = crank_end + s * e + height * square, coupler = end - crank_end, rocker = end - foot;
    return {std::atan2(coupler.z(), coupler.x()), std::atan2(rocker.z(), rocker.x())};
}

FigureScene four_bar(bool doubled, double crank_angle, double speed, const Matrix3d& R) {
    FigureScene plane;
    const FourBarPose pose = four_bar_pose(crank_angle);
    const Vector3d o = Vector3d::Zero(), foot = ground_bar * x_axis, p = crank_bar * at_angle(crank_angle),
                   q = foot + rocker_bar * at_angle(pose.rocker);
    const int crank = plane.add(bar(crank_bar, 0.04, o, p)), coupler = plane.add(bar(coupler_bar, 0.04, p, q)),
              rocker = plane.add(bar(rocker_bar, 0.04, q, foot));
    const Vector3d axis = -y_axis;  // from x towards z
    plane.join(hinge(the_world, crank, o, axis));
    plane.join(hinge(crank, coupler, p, axis));
    plane.join(hinge(coupler, rocker, q, axis));
    plane.join(hinge(the_world, rocker, foot, axis));
    if (doubled) {
        plane.join(hinge(the_world, crank, 0.1 * y_axis, axis));
        plane.join(hinge(the_world, rocker, foot + 0.1 * y_axis, axis));
    }
    FigureScene scene;
    scene.name = "four_bar";
    insert(scene, plane, Vector3d::Zero(), R);
    if (speed != 0) set_rate(scene, 0, speed);
    return scene;
}

FigureScene bennett_loop(double angle, double speed) {
    FigureScene scene;
    scene.name = "bennett_loop";
    const double twist_a = 40 * pi / 180, twist_b = 70 * pi / 180, a = 0.6, b = a * std::sin(twist_b) / std::sin(twist_a);
    // Angles of hinges 1 and 3 sum to 2 pi, those of 2 and 4 too; tan(1/2) tan(2/2) is constant.
    const double half = std::sin((twist_b + twist_a) / 2) / std::sin((twist_b - twist_a) / 2) / std::tan(angle / 2);
    const double angles[] = {angle, 2 * std::atan(half), -angle, -2 * std::atan(half)};
    Matrix3d R = Matrix3d::Identity();
    Vector3d place(0, 0, 2);
    std::vector<Vector3d> places, axes;
    for (int hinge_i = 0; hinge_i < 4; ++hinge_i) {
        places.push_back(place);
        axes.push_back(R.col(2));
        R = R * turn_about(z_axis, angles[hinge_i]);
        place += (hinge_i % 2 == 0 ? a : b) * R.col(0);
        R = R * turn_about(x_axis, hinge_i % 2 == 0 ? twist_a : twist_b);
    }
    int last = the_world;  // the fourth link
    for (std::size_t hinge_i = 0; hinge_i < 4; ++hinge_i) {
        const int link =
            hinge_i < 3 ? scene.add(bar((places[hinge_i + 1] - places[hinge_i]).norm(), 0.05, places[hinge_i], places[hinge_i + 1])) : the_world;
        if (link != the_world)
            scene.join(hinge(last, link, places[hinge_i], axes[hinge_i]));
        else
            scene.join(hinge(the_world, last, places[hinge_i], axes[hinge_i]));
        last = link;
    }
    if (speed != 0) set_rate(scene, 0, speed);
    return scene;
}

namespace {

constexpr double crank_arm = 0.2, rod_length = 0.6;

}  // namespace

double piston_position(double crank_angle) {
    const double s = crank_arm * std::sin(crank_angle);
    return crank_arm * std::cos(crank_angle) + std::sqrt(rod_length * rod_length - s * s);
}

FigureScene slider_crank(double crank_angle, double speed) {
    FigureScene scene;
    scene.name = "slider_crank";
    const Vector3d o = Vector3d::Zero(), p = crank_arm * at_angle(crank_angle), q = piston_position(crank_angle) * x_axis, axis = -y_axis;
    const int crank = scene.add(bar(1, 0.04, o, p)), rod = scene.add(bar(1.5, 0.04, p, q));
    FigureBody block = box(2, Vector3d(0.05, 0.05, 0.05), q);
    block.shape = FigureShape::none;
    const int piston = scene.add(block);
    scene.join(hinge(the_world, crank, o, axis));
    scene.join(hinge(crank, rod, p, axis));
    scene.join(hinge(rod, piston, q, axis));
    scene.join(joint_of(FigureJointKind::slider, the_world, piston, q, x_axis, x_axis));
    if (speed != 0) set_rate(scene, 0, speed);
    return scene;
}

FigureScene car(double wheel_mass, double motor_torque, double steer_rate) {
    FigureScene scene;
    scene.name = "car";
    scene.add(ground(0.8));
    const double radius = 0.35, chassis_mass = 1000, quarter = chassis_mass / 4, w = 2 * pi * 1.5;
    const int chassis = scene.add(box(chassis_mass, Vector3d(2, 0.6, 0.25), Vector3d(0, 0, 0.75)));
    for (const double front : {1.0, -1.0}) {
        for (const double side : {1.0, -1.0}) {
            const Vector3d hub(1.3 * front, 0.8 * side, radius);
            FigureBody wheel = sphere(wheel_mass, radius, hub);
            // A disc 0.2 m wide: 1/2 M r^2 about the axle.
            const double across = wheel_mass * (radius * radius / 4 + 0.2 * 0.2 / 12);
            wheel.I_body = Vector3d(across, wheel_mass * radius * radius / 2, across);
            wheel.friction = 0.8;
            FigureJoint joint = joint_of(FigureJointKind::wheel, chassis, scene.add(wheel), hub, z_axis, y_axis);
            joint.suspension.stiffness = quarter * w * w;
            joint.suspension.damping = 0.4 * 2 * quarter * w;
            joint.suspension.target = -quarter * 9.81 / joint.suspension.stiffness;  // carries its quarter as the car stands
            joint.lower = -0.15;
            joint.upper = 0.15;
            joint.motor.speed = 30;
            joint.motor.max_torque = motor_torque;
            if (front > 0) joint.steer_rate = steer_rate;
            scene.join(joint);
        }
    }
    for (int bump_i = 0; bump_i < 3; ++bump_i) {
        FigureBody bump = capsule(0, 0.25, 2, Vector3d(6 + 3 * bump_i, 0, -0.15), along(y_axis));
        bump.friction = 0.8;
        scene.add(bump);
    }
    if (steer_rate != 0) hold_joints(scene);
    return scene;
}

FigureScene arm(double stiffness, double damping, double max_torque) {
    FigureScene scene;
    scene.name = "arm";
    const Vector3d axes[] = {z_axis, y_axis, y_axis, x_axis, y_axis, x_axis};
    int last = the_world;
    for (int link_i = 0; link_i < 6; ++link_i) {
        const Vector3d from = 0.1 * link_i * x_axis + 0.5 * z_axis;
        const int link = scene.add(bar(0.05, 0.02, from, from + 0.1 * x_axis));
        FigureJoint joint = hinge(last, link, from, axes[link_i]);
        joint.servo.stiffness = stiffness;
        joint.servo.damping = damping;
        joint.servo.max_torque = max_torque;
        scene.join(joint);
        last = link;
    }
    return scene;
}

FigureScene rotor_on_base(double rotor_moment, double base_moment, double speed, double max_torque) {
    FigureScene scene;
    scene.name = "rotor_on_base";
    scene.g.setZero();
    FigureBody base, rotor;
    base.M = 10;
    base.I_body = base_moment * Vector3d(1, 0.8, 0.9);
    rotor.M = 0.5;
    rotor.I_body = rotor_moment * Vector3d(0.6, 0.6, 1);
    rotor.r_CM = Vector3d(0.1, 0.2, 0.3);
    const int body_A = scene.add(base), body_B = scene.add(rotor);
    FigureJoint joint = hinge(body_A, body_B, rotor.r_CM, z_axis);
    joint.motor.speed = speed;
    joint.motor.max_torque = max_torque;
    scene.join(joint);
    return scene;
}

}  // namespace ingot_figures
