// SPDX-License-Identifier: MIT
#include "joints/joint_rows.h"

#include <cmath>
#include <stdexcept>

namespace ingot_figures {

namespace {

/// A vector or point that bodies carry: where it is, and its derivatives where no body accelerates.
struct Carried {
    Vector3d x, d, dd;
};

Carried operator-(const Carried& a, const Carried& b) { return {a.x - b.x, a.d - b.d, a.dd - b.dd}; }

struct Product {
    double value, d, dd;
};

Product dot(const Carried& a, const Carried& b) {
    return {a.x.dot(b.x), a.d.dot(b.x) + a.x.dot(b.d), a.dd.dot(b.x) + 2 * a.d.dot(b.d) + a.x.dot(b.dd)};
}

/// What a body does; the world does nothing.
BodyMotion motion_of(const FigureState& state, int body_i) { return body_i == the_world ? BodyMotion() : state.body(body_i); }

Carried carried_vector(const BodyMotion& body, const Vector3d& x) {
    const Vector3d d = body.omega.cross(x);
    return {x, d, body.omega.cross(d)};
}

Carried carried_point(const BodyMotion& body, const Vector3d& arm) {
    const Carried s = carried_vector(body, arm);
    return {body.r_CM + s.x, body.v_CM + s.d, s.dd};
}

/// A vector of a frame that turns against its body about `axis` of it, at `rate`.
Carried steered_vector(const BodyMotion& body, const Vector3d& axis, double rate, const Vector3d& x) {
    const Vector3d spin = body.omega + rate * axis, d = spin.cross(x);
    return {x, d, rate * body.omega.cross(axis).cross(x) + spin.cross(d)};
}

}  // namespace

void FigureRow::add(int body, const Vector3d& on_v, const Vector3d& on_omega) {
    if (body == the_world) return;
    int part_i = 0;
    while (part_i < part_count && parts[part_i].body != body) ++part_i;
    if (part_i == part_count) {
        if (part_count == most_parts) throw std::logic_error("a row of more than four bodies");
        parts[part_count++].body = body;
    }
    parts[part_i].on_v += on_v;
    parts[part_i].on_omega += on_omega;
}

double FigureRow::J_times_u(const FigureState& state) const {
    double sum = 0;
    for (int part_i = 0; part_i < part_count; ++part_i) {
        const BodyMotion& body = state.body(parts[part_i].body);
        sum += parts[part_i].on_v.dot(body.v_CM) + parts[part_i].on_omega.dot(body.omega);
    }
    return sum;
}

FigureRow FigureRow::scaled(double factor) const {
    FigureRow row = *this;
    row.value *= factor;
    row.own_rate *= factor;
    row.bias *= factor;
    for (int part_i = 0; part_i < part_count; ++part_i) {
        row.parts[part_i].on_v *= factor;
        row.parts[part_i].on_omega *= factor;
    }
    return row;
}

JointRows::JointRows(const FigureScene& scene) : scene_(scene) {
    const FigureState start = start_of(scene);
    for (const FigureJoint& joint : scene.joints) {
        const BodyMotion A = motion_of(start, joint.body_A), B = motion_of(start, joint.body_B);
        const Vector3d anchor_B = joint.kind == FigureJointKind::distance ? joint.anchor_B : joint.anchor;
        const bool is_wheel = joint.kind == FigureJointKind::wheel;
        const Vector3d n = is_wheel ? joint.axis_B : joint.axis_A;
        Vector3d u = square_to(n);
        if (joint.kind == FigureJointKind::universal) u = joint.axis_B;
        Matrix3d triad_A, triad_B;
        triad_A << u, n.cross(u), n;
        triad_B = triad_A;
        if (joint.kind == FigureJointKind::ball) triad_B = least_turn(joint.axis_A, joint.axis_B).toRotationMatrix() * triad_A;
        const Quaterniond to_A = A.q.conjugate(), to_B = B.q.conjugate();
        attached_.push_back({to_A * Vector3d(joint.anchor - A.r_CM), to_B * Vector3d(anchor_B - B.r_CM), to_A * joint.axis_A, to_B * joint.axis_B,
                             to_A.toRotationMatrix() * triad_A, to_B.toRotationMatrix() * triad_B, to_A * B.q});
    }
}

/// A joint where its bodies have carried it.
struct JointRows::Placed {
    const FigureJoint& joint;
    BodyMotion A, B;
    Vector3d s_A, s_B;  ///< anchors, from the centres of mass
    Carried d;          ///< from the anchor of A to the anchor of B
    Matrix3d triad_A, triad_B;
    Vector3d axis_A, axis_B;

    /// d along an axis of the world.
    FigureRow along_world(const Vector3d& e) const {
        FigureRow row;
        row.value = d.x.dot(e);
        row.bias = d.dd.dot(e);
        row.add(joint.body_B, e, s_B.cross(e));
        row.add(joint.body_A, -e, -s_A.cross(e));
        return row;
    }

    /// d along an axis of A.
    FigureRow along_A(const Vector3d& a) const {
        FigureRow row = along_world(a);
        row.bias = dot(d, carried_vector(A, a)).dd;
        row.add(joint.body_A, Vector3d::Zero(), a.cross(d.x));
        return row;
    }

    /// Product of two axes, `a` carried by A and `b` fixed in B.
    FigureRow product(const Carried& a, const Vector3d& b) const {
        const Product g = dot(a, carried_vector(B, b));
        FigureRow row;
        row.value = g.value;
        row.bias = g.dd;
        row.add(joint.body_A, Vector3d::Zero(), a.x.cross(b));
        row.add(joint.body_B, Vector3d::Zero(), b.cross(a.x));
        return row;
    }
    FigureRow product(const Vector3d& a, const Vector3d& b) const { return product(carried_vector(A, a), b); }

    /// An angle whose rate is x.(omega_B - omega_A); x turns at x_rate.
    FigureRow turn(double angle, const Vector3d& x, const Vector3d& x_rate) const {
        FigureRow row;
        row.value = angle;
        row.bias = x_rate.dot(B.omega - A.omega);
        row.add(joint.body_A, Vector3d::Zero(), -x);
        row.add(joint.body_B, Vector3d::Zero(), x);
        return row;
    }

    FigureRow length() const {
        const double l = d.x.norm();
        const Vector3d n = d.x / l;
        FigureRow row = along_world(n);
        row.value = l;
        const double closing = n.dot(d.d);
        row.bias = n.dot(d.dd) + (d.d.squaredNorm() - closing * closing) / l;
        return row;
    }

    /// Triad of A, turned about the suspension by the steering.
    Matrix3d steered(double t) const { return rotation_by((joint.steer + joint.steer_rate * t) * axis_A).toRotationMatrix() * triad_A; }
};

JointRows::Placed JointRows::place(const FigureState& state, int joint_i) const {
    const FigureJoint& joint = scene_.joint(joint_i);
    const Attached& at = attached(joint_i);
    const BodyMotion A = motion_of(state, joint.body_A), B = motion_of(state, joint.body_B);
    const Matrix3d A_A = A.A(), A_B = B.A();
    const Vector3d s_A = A_A * at.anchor_A, s_B = A_B * at.anchor_B;
    return {joint,          A, B, s_A, s_B, carried_point(B, s_B) - carried_point(A, s_A), A_A * at.triad_A, A_B * at.triad_B, A_A * at.axis_A,
            A_B * at.axis_B};
}

void JointRows::add_locked(const FigureState& state, int joint_i, std::vector<FigureRow>& rows) const {
    if (!scene_.joint(joint_i).enabled) return;
    const Placed p = place(state, joint_i);
    const FigureJoint& joint = p.joint;
    const Vector3d u_A = p.triad_A.col(0), w_A = p.triad_A.col(1), n_A = p.triad_A.col(2);
    const Vector3d u_B = p.triad_B.col(0), w_B = p.triad_B.col(1), n_B = p.triad_B.col(2);
    const auto point = [&] {
        for (int i = 0; i < 3; ++i) rows.push_back(p.along_world(Vector3d::Unit(i)));
    };
    const auto no_turn = [&] {
        rows.push_back(p.product(n_A, u_B));
        rows.push_back(p.product(u_A, w_B));
        rows.push_back(p.product(w_A, n_B));
    };
    switch (joint.kind) {
        case FigureJointKind::ball: point(); break;
        case FigureJointKind::hinge: point(); [[fallthrough]];
        case FigureJointKind::parallel:
            rows.push_back(p.product(u_A, n_B));
            rows.push_back(p.product(w_A, n_B));
            break;
        case FigureJointKind::slider:
            rows.push_back(p.along_A(u_A));
            rows.push_back(p.along_A(w_A));
            no_turn();
            break;
        case FigureJointKind::universal:
            point();
            rows.push_back(p.product(p.axis_A, p.axis_B));
            break;
        case FigureJointKind::fixed:
            point();
            no_turn();
            break;
        case FigureJointKind::wheel: {
            const Vector3d across = square_to(attached(joint_i).axis_A);  // fixed in A
            const Vector3d x = p.A.q * across;
            rows.push_back(p.along_A(x));
            rows.push_back(p.along_A(p.axis_A.cross(x)));
            const Matrix3d wanted = p.steered(state.t);
            for (int i = 0; i < 2; ++i) {
                FigureRow row = p.product(steered_vector(p.A, p.axis_A, joint.steer_rate, wanted.col(i)), n_B);
                row.own_rate = joint.steer_rate * p.axis_A.cross(wanted.col(i)).dot(n_B);
                rows.push_back(row);
            }
            break;
        }
        case FigureJointKind::distance:
            if (!joint.is_rod()) break;
            rows.push_back(p.length());
            rows.back().value -= joint.most;
            break;
        case FigureJointKind::gear: {
            FigureRow row = measure(state, joint.gear_1, driven(joint.gear_1));
            const FigureRow other = measure(state, joint.gear_2, driven(joint.gear_2)).scaled(joint.gear_ratio);
            row.has_value = false;
            row.own_rate += other.own_rate;
            row.bias += other.bias;
            for (int part_i = 0; part_i < other.part_count; ++part_i)
                row.add(other.parts[part_i].body, other.parts[part_i].on_v, other.parts[part_i].on_omega);
            rows.push_back(row);
            break;
        }
    }
}

FigureRow JointRows::measure(const FigureState& state, int joint_i, FigureMeasure which) const {
    const Placed p = place(state, joint_i);
    switch (which) {
        case FigureMeasure::angle: {
            if (p.joint.kind == FigureJointKind::wheel) {
                const Matrix3d frame = p.steered(state.t);
                const Carried n = steered_vector(p.A, p.axis_A, p.joint.steer_rate, frame.col(2));
                const Vector3d u = p.triad_B.col(0);
                FigureRow row = p.turn(std::atan2(u.dot(frame.col(1)), u.dot(frame.col(0))), n.x, n.d);
                const Vector3d steering = p.joint.steer_rate * p.axis_A;
                row.own_rate = -n.x.dot(steering);
                row.bias -= n.d.dot(steering) + n.x.dot(p.A.omega.cross(steering));
                return row;
            }
            const Vector3d u = p.triad_B.col(0), n = p.triad_A.col(2);
            return p.turn(std::atan2(u.dot(p.triad_A.col(1)), u.dot(p.triad_A.col(0))), n, p.A.omega.cross(n));
        }
        case FigureMeasure::travel: return p.along_A(p.axis_A);
        case FigureMeasure::first: {  // triad_A has axis_B of the start as u
            const Vector3d b = p.axis_B;
            return p.turn(std::atan2(b.dot(p.triad_A.col(1)), b.dot(p.triad_A.col(0))), p.axis_A, p.A.omega.cross(p.axis_A));
        }
        case FigureMeasure::second: {  // triad_B has axis_A of the start as n; A sees B turn the other way
            const Vector3d a = p.axis_A, b = p.axis_B, n = p.triad_B.col(2);
            return p.turn(std::atan2(-a.dot(b.cross(n)), a.dot(n)), b, p.B.omega.cross(b));
        }
        case FigureMeasure::cone: {
            const Carried a = carried_vector(p.A, p.axis_A), b = carried_vector(p.B, p.axis_B);
            const Vector3d c = a.x.cross(b.x), c_rate = a.d.cross(b.x) + a.x.cross(b.d);
            const double s = c.norm();
            const Vector3d x = c / s;
            return p.turn(std::atan2(s, a.x.dot(b.x)), x, (c_rate - x * x.dot(c_rate)) / s);
        }
        case FigureMeasure::twist: {
            const Quaterniond q(p.triad_A.transpose() * p.triad_B);  // z is the axis
            const Carried a = carried_vector(p.A, p.triad_A.col(2)), b = carried_vector(p.B, p.triad_B.col(2));
            const Product c = dot(a, b);
            const Vector3d x = (a.x + b.x) / (1 + c.value), x_rate = (a.d + b.d - x * c.d) / (1 + c.value);
            return p.turn(std::remainder(2 * std::atan2(q.z(), q.w()), 2 * pi), x, x_rate);
        }
        case FigureMeasure::length: return p.length();
    }
    throw std::logic_error("no such measure");
}

FigureMeasure JointRows::driven(int joint_i) const {
    return scene_.joint(joint_i).kind == FigureJointKind::slider ? FigureMeasure::travel : FigureMeasure::angle;
}

bool JointRows::has_driven(int joint_i) const {
    const FigureJointKind kind = scene_.joint(joint_i).kind;
    return kind == FigureJointKind::hinge || kind == FigureJointKind::slider || kind == FigureJointKind::wheel;
}

std::vector<FigureLimit> JointRows::limits(int joint_i) const {
    const FigureJoint& joint = scene_.joint(joint_i);
    std::vector<FigureLimit> all;
    if (!joint.enabled) return all;
    const auto add = [&](FigureMeasure measure, double lower, double upper) {
        if (lower > -infinity) all.push_back({joint_i, measure, lower, 1, joint.restitution});
        if (upper < infinity) all.push_back({joint_i, measure, upper, -1, joint.restitution});
    };
    switch (joint.kind) {
        case FigureJointKind::hinge: add(FigureMeasure::angle, joint.lower, joint.upper); break;
        case FigureJointKind::slider:
        case FigureJointKind::wheel: add(FigureMeasure::travel, joint.lower, joint.upper); break;
        case FigureJointKind::universal: add(FigureMeasure::first, joint.lower, joint.upper); break;
        case FigureJointKind::ball:
            add(FigureMeasure::cone, -infinity, joint.cone);
            add(FigureMeasure::twist, joint.twist_lower, joint.twist_upper);
            break;
        case FigureJointKind::distance:
            if (!joint.is_rod()) add(FigureMeasure::length, joint.least > 0 ? joint.least : -infinity, joint.most);
            break;
        default: break;
    }
    return all;
}

std::vector<FigureLimit> JointRows::limits() const {
    std::vector<FigureLimit> all;
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i)
        for (const FigureLimit& limit : limits(joint_i)) all.push_back(limit);
    return all;
}

Vector3d JointRows::anchor_A(const FigureState& state, int joint_i) const {
    const Placed p = place(state, joint_i);
    return p.A.r_CM + p.s_A;
}

Vector3d JointRows::anchor_B(const FigureState& state, int joint_i) const {
    const Placed p = place(state, joint_i);
    return p.B.r_CM + p.s_B;
}

Vector3d JointRows::axis_A(const FigureState& state, int joint_i) const { return place(state, joint_i).axis_A; }
Vector3d JointRows::axis_B(const FigureState& state, int joint_i) const {
    const Placed p = place(state, joint_i);
    const FigureJointKind kind = p.joint.kind;
    const bool apart = kind == FigureJointKind::ball || kind == FigureJointKind::universal || kind == FigureJointKind::wheel;
    return apart ? p.axis_B : Vector3d(p.triad_B.col(2));
}

Matrix3d JointRows::triad_A(const FigureState& state, int joint_i) const { return place(state, joint_i).triad_A; }
Matrix3d JointRows::triad_B(const FigureState& state, int joint_i) const { return place(state, joint_i).triad_B; }

Vector3d JointRows::rotation(const FigureState& state, int joint_i) const {
    const Placed p = place(state, joint_i);
    return p.A.q * rotation_vector(p.A.q.conjugate() * p.B.q * attached(joint_i).turn.conjugate());
}

}  // namespace ingot_figures
