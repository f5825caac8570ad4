// SPDX-License-Identifier: MIT
#include "joints/constrained_reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ingot_figures {

namespace {

constexpr int columns = 8;           // of the extrapolation: midpoint rules of 2, 4, .. 16 substeps
constexpr int numbers_of_body = 13;  // r, q, v, omega

bool has_motor(const FigureJoint& joint) { return joint.enabled && joint.motor.max_torque > 0; }

VectorXd packed(const FigureState& state) {
    VectorXd y(numbers_of_body * static_cast<Eigen::Index>(state.bodies.size()));
    Eigen::Index at = 0;
    for (const BodyMotion& body : state.bodies) {
        y.segment<numbers_of_body>(at) << body.r_CM, body.q.coeffs(), body.v_CM, body.omega;
        at += numbers_of_body;
    }
    return y;
}

}  // namespace

ConstrainedReference::ConstrainedReference(const FigureScene& scene, double tolerance, double longest_step)
    : scene_(scene),
      rows_(scene_),
      limits_(rows_.limits()),
      held_(limits_.size(), false),
      motor_modes_(scene.joints.size(), MotorMode::forward),
      tolerance_(tolerance),
      longest_step_(longest_step) {
    restart(start_of(scene));
}

void ConstrainedReference::restart(const FigureState& state) {
    state_ = state;
    held_.assign(limits_.size(), false);
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene_.joint(joint_i);
        if (!has_motor(joint)) continue;
        const bool slow = measured_rate(rows_, state_, joint_i, rows_.driven(joint_i)) < joint.motor.speed;
        motor_modes_[static_cast<std::size_t>(joint_i)] = slow ? MotorMode::forward : MotorMode::back;
    }
    bring_onto_joints(state_);
    meet_limits();
    choose_modes();
    bring_onto_joints(state_);
}

ConstrainedReference::Active ConstrainedReference::active_rows(const FigureState& state) const {
    Active active;
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        rows_.add_locked(state, joint_i, active.rows);
        active.sources.resize(active.rows.size(), {Source::locked, joint_i});
    }
    for (std::size_t limit_i = 0; limit_i < limits_.size(); ++limit_i) {
        const FigureLimit& limit = limits_[limit_i];
        if (!held_[limit_i] || !scene_.joint(limit.joint).enabled) continue;
        FigureRow row = rows_.measure(state, limit.joint, limit.measure);
        row.value -= limit.bound;
        active.rows.push_back(row.scaled(limit.sign));
        active.sources.push_back({Source::limit, static_cast<int>(limit_i)});
    }
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene_.joint(joint_i);
        if (!has_motor(joint) || motor_modes_[static_cast<std::size_t>(joint_i)] != MotorMode::holding) continue;
        FigureRow row = rows_.measure(state, joint_i, rows_.driven(joint_i));
        row.has_value = false;
        row.own_rate -= joint.motor.speed;
        active.rows.push_back(row);
        active.sources.push_back({Source::motor, joint_i});
    }
    return active;
}

VectorXd ConstrainedReference::free_acceleration(const FigureState& state) const {
    AppliedLoads loads = applied_loads(rows_, state);
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene_.joint(joint_i);
        const MotorMode mode = motor_modes_[static_cast<std::size_t>(joint_i)];
        if (!has_motor(joint) || mode == MotorMode::holding) continue;
        loads.add(rows_.measure(state, joint_i, rows_.driven(joint_i)),
                  mode == MotorMode::forward ? joint.motor.max_torque : -joint.motor.max_torque);
    }
    const FigureInertia inertia(scene_, state);
    VectorXd a(6 * scene_.body_count());
    for (int body_i = 0; body_i < scene_.body_count(); ++body_i) {
        const std::size_t i = static_cast<std::size_t>(body_i);
        const Vector3d& omega = state.body(body_i).omega;
        a.segment<3>(6 * body_i) = inertia.inv_M(body_i) * loads.force[i];
        a.segment<3>(6 * body_i + 3) = inertia.inv_I(body_i) * (loads.torque[i] - omega.cross(inertia.I(body_i) * omega));
    }
    return a;
}

namespace {

/// What the multipliers have to bring: J a = -bias, of which the free accelerations already do a part.
VectorXd missing_acceleration(const RowSystem& system, const std::vector<FigureRow>& rows, const VectorXd& free) {
    VectorXd missing = -system.J_times(free);
    for (Eigen::Index row_i = 0; row_i < missing.size(); ++row_i) missing(row_i) -= rows[static_cast<std::size_t>(row_i)].bias;
    return missing;
}

}  // namespace

Multipliers ConstrainedReference::multipliers(const FigureState& state, const Active& active) const {
    const FigureInertia inertia(scene_, state);
    const RowSystem system(inertia, active.rows);
    return system.solve_all(missing_acceleration(system, active.rows, free_acceleration(state)));
}

VectorXd ConstrainedReference::accelerations() const {
    const Active active = active_rows(state_);
    const FigureInertia inertia(scene_, state_);
    return free_acceleration(state_) + RowSystem(inertia, active.rows).response(multipliers(state_, active).lambda);
}

FigureState ConstrainedReference::unpacked(const VectorXd& y, double t) const {
    FigureState state;
    state.t = t;
    for (Eigen::Index at = 0; at < y.size(); at += numbers_of_body) {
        const Quaterniond q(Eigen::Vector4d(y.segment<4>(at + 3)));
        state.bodies.push_back({y.segment<3>(at), q.normalized(), y.segment<3>(at + 7), y.segment<3>(at + 10)});
    }
    return state;
}

VectorXd ConstrainedReference::derivative(const VectorXd& y, double t, const std::vector<int>& chosen) const {
    const FigureState state = unpacked(y, t);
    const Active active = active_rows(state);
    const FigureInertia inertia(scene_, state);
    const RowSystem system(inertia, active.rows);
    VectorXd a = free_acceleration(state);
    a += system.response(system.solve(chosen, missing_acceleration(system, active.rows, a)));
    VectorXd dy(y.size());
    for (int body_i = 0; body_i < scene_.body_count(); ++body_i) {
        const BodyMotion& body = state.body(body_i);
        const Eigen::Index at = numbers_of_body * body_i;
        const Quaterniond q(Eigen::Vector4d(y.segment<4>(at + 3)));  // as it is, so that its length stays
        const Quaterniond spin(0, body.omega.x() / 2, body.omega.y() / 2, body.omega.z() / 2);
        dy.segment<numbers_of_body>(at) << body.v_CM, (spin * q).coeffs(), a.segment<6>(6 * body_i);
        if (scene_.body(body_i).M <= 0) dy.segment<numbers_of_body>(at).setZero();
    }
    return dy;
}

FigureState ConstrainedReference::extrapolated(double h, double& error) const {
    std::vector<int> chosen;
    {
        const Active active = active_rows(state_);
        const FigureInertia inertia(scene_, state_);
        chosen = RowSystem(inertia, active.rows).independent();
    }
    const VectorXd y_0 = packed(state_), dy_0 = derivative(y_0, state_.t, chosen);
    std::vector<VectorXd> last, row;
    for (int column = 0; column < columns; ++column) {
        const int n = 2 * (column + 1);
        const double step = h / n;
        VectorXd before = y_0, y = y_0 + step * dy_0;
        for (int i = 1; i < n; ++i) {
            const VectorXd after = before + 2 * step * derivative(y, state_.t + i * step, chosen);
            before = y;
            y = after;
        }
        row.assign(1, y);
        for (int k = 1; k <= column; ++k) {
            const double ratio = static_cast<double>(n) / (n - 2 * k);
            const std::size_t i = static_cast<std::size_t>(k - 1);
            row.push_back(row[i] + (row[i] - last[i]) / (ratio * ratio - 1));
        }
        last = row;
    }
    const VectorXd& y = row[columns - 1];
    error = ((y - row[columns - 2]).array().abs() / (1 + y_0.array().abs().max(y.array().abs()))).maxCoeff();
    FigureState state = unpacked(y, state_.t + h);
    if (y.allFinite() && error < 1) bring_onto_joints(state);
    return state;
}

void ConstrainedReference::bring_onto_joints(FigureState& state) const {
    constexpr int most_rounds = 4;
    double size = 1;
    for (const BodyMotion& body : state.bodies) size = std::max(size, body.r_CM.norm());
    for (int round = 0; round <= most_rounds; ++round) {
        const Active active = active_rows(state);
        if (active.rows.empty()) return;
        const FigureInertia inertia(scene_, state);
        const RowSystem system(inertia, active.rows);
        const std::vector<int> chosen = system.independent();
        VectorXd missing(system.row_count());
        double worst = 0;
        for (Eigen::Index row_i = 0; row_i < missing.size(); ++row_i) {
            const FigureRow& row = active.rows[static_cast<std::size_t>(row_i)];
            missing(row_i) = row.has_value ? -row.value : 0;
            worst = std::max(worst, std::abs(missing(row_i)));
        }
        if (worst < 1e-15 * size || round == most_rounds) {  // poses are there: velocities
            for (Eigen::Index row_i = 0; row_i < missing.size(); ++row_i) missing(row_i) = -active.rows[static_cast<std::size_t>(row_i)].rate(state);
            const VectorXd change = system.response(system.solve(chosen, missing));
            for (int body_i = 0; body_i < scene_.body_count(); ++body_i) {
                state.body(body_i).v_CM += change.segment<3>(6 * body_i);
                state.body(body_i).omega += change.segment<3>(6 * body_i + 3);
            }
            return;
        }
        const VectorXd change = system.response(system.solve(chosen, missing));
        for (int body_i = 0; body_i < scene_.body_count(); ++body_i) {
            BodyMotion& body = state.body(body_i);
            body.r_CM += change.segment<3>(6 * body_i);
            body.q = (rotation_by(change.segment<3>(6 * body_i + 3)) * body.q).normalized();
        }
    }
}

void ConstrainedReference::advance_to(double t) {
    constexpr double least_step = 1e-9, order = 2 * columns - 1;
    const bool has_events = !limits_.empty() || std::any_of(scene_.joints.begin(), scene_.joints.end(), [](const FigureJoint& joint) {
        return has_motor(joint) || joint.break_force < infinity || joint.break_torque < infinity;
    });
    while (state_.t < t) {
        const double left = t - state_.t, wanted = has_events ? std::min(next_step_, longest_step_) : next_step_;
        const bool is_last = wanted >= left * (1 - 1e-9);
        const double h = is_last ? left : wanted;
        double error = 0;
        FigureState after = extrapolated(h, error);
        const double factor = std::isfinite(error) ? std::min(4.0, std::max(0.1, 0.8 * std::pow(tolerance_ / (error + 1e-300), 1 / order))) : 0.1;
        if (!(error <= tolerance_)) {
            next_step_ = std::min(0.9, factor) * h;
            if (next_step_ < least_step) throw std::runtime_error(scene_.name + ": no step is small enough at " + std::to_string(state_.t) + " s");
            continue;
        }
        next_step_ = is_last ? std::max(next_step_, factor * h) : factor * h;
        ++steps_;
        const bool event = has_events && least_room(after) < 0;
        if (event)
            after = at_first_event(h);
        else if (is_last)
            after.t = t;
        state_ = after;
        if (event) handle_events();
    }
}

std::vector<JointLoad> ConstrainedReference::loads_of(const FigureState& state, const Active& active, const Multipliers& found) const {
    std::vector<JointLoad> loads(scene_.joints.size());
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const MotorMode mode = motor_modes_[static_cast<std::size_t>(joint_i)];
        const double most = has_motor(scene_.joint(joint_i)) ? scene_.joint(joint_i).motor.max_torque : 0;
        loads[static_cast<std::size_t>(joint_i)].motor = mode == MotorMode::forward ? most : mode == MotorMode::back ? -most : 0;
    }
    for (std::size_t row_i = 0; row_i < active.rows.size(); ++row_i) {
        const Source& source = active.sources[row_i];
        const int joint_i = source.kind == Source::limit ? limits_[static_cast<std::size_t>(source.index)].joint : source.index;
        const double lambda = found.lambda(static_cast<Eigen::Index>(row_i));
        JointLoad& load = loads[static_cast<std::size_t>(joint_i)];
        if (!found.determined[row_i]) load.determined = false;
        if (source.kind == Source::motor) {
            load.motor = lambda;
            continue;
        }
        const int body_B = scene_.joint(joint_i).body_B;
        const Vector3d arm = rows_.anchor_B(state, joint_i) - state.body(body_B).r_CM;
        for (int part_i = 0; part_i < active.rows[row_i].part_count; ++part_i) {
            const FigureRow::Part& part = active.rows[row_i].parts[part_i];
            if (part.body != body_B) continue;
            load.force += lambda * part.on_v;
            load.torque += lambda * (part.on_omega - arm.cross(part.on_v));
        }
    }
    return loads;
}

std::vector<JointLoad> ConstrainedReference::loads() const {
    const Active active = active_rows(state_);
    return loads_of(state_, active, multipliers(state_, active));
}

}  // namespace ingot_figures
