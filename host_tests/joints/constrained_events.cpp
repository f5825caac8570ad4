// SPDX-License-Identifier: MIT
// Where the motion of a figure is not smooth: limits that are met and left, motors that reach their speed or slip, joints that break.
#include <algorithm>
#include <cmath>

#include "joints/constrained_reference.h"
#include "joints/constrained_step_reference.h"

namespace ingot_figures {

namespace {

constexpr double touching = 1e-9;  // rad or m: a limit that is so near is met
constexpr double standing = 1e-8;  // rad/s or m/s: a limit that is left slower is not left

}  // namespace

/// Rooms are positive before an event.
std::vector<ConstrainedReference::Event> ConstrainedReference::events_of(const FigureState& state) const {
    std::vector<Event> events;
    const Active active = active_rows(state);
    const Multipliers found = multipliers(state, active);
    const std::vector<JointLoad> loads = loads_of(state, active, found);
    for (std::size_t row_i = 0; row_i < active.rows.size(); ++row_i) {
        const Source& source = active.sources[row_i];
        const double lambda = found.lambda(static_cast<Eigen::Index>(row_i));
        if (source.kind == Source::limit) events.push_back({lambda, source});
        if (source.kind == Source::motor) events.push_back({scene_.joint(source.index).motor.max_torque - std::abs(lambda), source});
    }
    for (std::size_t limit_i = 0; limit_i < limits_.size(); ++limit_i) {
        const FigureLimit& limit = limits_[limit_i];
        if (held_[limit_i] || !scene_.joint(limit.joint).enabled) continue;
        events.push_back(
            {limit.sign * (measured(rows_, state, limit.joint, limit.measure) - limit.bound), {Source::limit, static_cast<int>(limit_i)}});
    }
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene_.joint(joint_i);
        if (!joint.enabled) continue;
        const JointLoad& load = loads[static_cast<std::size_t>(joint_i)];
        if (joint.break_force < infinity) events.push_back({1 - load.force.norm() / joint.break_force, {Source::locked, joint_i}});
        if (joint.break_torque < infinity) events.push_back({1 - load.torque.norm() / joint.break_torque, {Source::locked, joint_i}});
        const MotorMode mode = motor_modes_[static_cast<std::size_t>(joint_i)];
        if (joint.motor.max_torque <= 0 || mode == MotorMode::holding) continue;
        const double behind = joint.motor.speed - measured_rate(rows_, state, joint_i, rows_.driven(joint_i));
        events.push_back({mode == MotorMode::forward ? behind : -behind, {Source::motor, joint_i}});
    }
    return events;
}

/// A limit that was met and left at this moment has room 0 and some rounding.
double ConstrainedReference::least_room(const FigureState& state) const {
    double least = infinity;
    for (const Event& event : events_of(state)) least = std::min(least, event.room);
    return least + 1e-13;
}

/// The state of the first event within h, found by halving and false position (Illinois) on the least room.
FigureState ConstrainedReference::at_first_event(double h) const {
    double error = 0, late = h, early = 0;
    FigureState at_late = extrapolated(h, error);
    double room_late = least_room(at_late), room_early = least_room(state_);
    // Right after an event its own room is about zero: the bracket begins where it has opened.
    for (double trial = h / 2; room_early < 1e-12 && trial > 1e-12; trial /= 2) {
        const FigureState state = extrapolated(trial, error);
        const double room = least_room(state);
        if (room > 1e-12) {
            early = trial;
            room_early = room;
        } else {
            late = trial;
            at_late = state;
            room_late = room;
        }
    }
    int side = 0;
    for (int round = 0; round < 100 && late - early > 1e-15 * (1 + std::abs(state_.t)) && room_early > 0; ++round) {
        double middle = (early * room_late - late * room_early) / (room_late - room_early);
        if (!(middle > early && middle < late) || round > 40) middle = (early + late) / 2;
        const FigureState state = extrapolated(middle, error);
        const double room = least_room(state);
        if (room < 0) {
            late = middle;
            at_late = state;
            room_late = room;
            if (side == -1) room_early /= 2;
            side = -1;
            if (room > -1e-13) break;
        } else {
            early = middle;
            room_early = room;
            if (side == 1) room_late /= 2;
            side = 1;
        }
    }
    return at_late;
}

void ConstrainedReference::handle_events() {
    ++events_;
    break_joints(events_of(state_));
    meet_limits();
    choose_modes();
    bring_onto_joints(state_);
}

void ConstrainedReference::break_joints(const std::vector<Event>& events) {
    for (const Event& event : events)
        if (event.source.kind == Source::locked && event.room < 1e-11) scene_.joint(event.source.index).enabled = false;
}

/// The impact: limits that touch and close get their restitution, those that touch do not close.
void ConstrainedReference::meet_limits() {
    std::vector<StepRow> rows;
    std::vector<FigureRow> locked;
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) rows_.add_locked(state_, joint_i, locked);
    for (const FigureRow& row : locked) rows.push_back({row, -row.own_rate, 0, -infinity, infinity});
    bool closes = false;
    for (const FigureLimit& limit : limits_) {
        if (!scene_.joint(limit.joint).enabled) continue;
        FigureRow row = rows_.measure(state_, limit.joint, limit.measure);
        if (limit.sign * (row.value - limit.bound) > touching) continue;
        row = row.scaled(limit.sign);
        const double rate = row.rate(state_);
        const double after = rate < -standing ? -limit.restitution * rate : 0;
        closes = closes || rate < -standing;
        rows.push_back({row, (after > standing ? after : 0) - row.own_rate, 0, 0, infinity});
    }
    if (closes) state_ = with_velocities(state_, solve_step(step_bodies(scene_, state_), rows));
}

/// Which limits carry and which motors hold from here on: the accelerations of limits at rest are a problem like that of impacts.
void ConstrainedReference::choose_modes() {
    held_.assign(limits_.size(), false);
    std::vector<std::size_t> resting;
    for (std::size_t limit_i = 0; limit_i < limits_.size(); ++limit_i) {
        const FigureLimit& limit = limits_[limit_i];
        if (!scene_.joint(limit.joint).enabled) continue;
        const FigureRow row = rows_.measure(state_, limit.joint, limit.measure).scaled(limit.sign);
        if (row.value - limit.sign * limit.bound <= touching && row.rate(state_) <= standing) resting.push_back(limit_i);
    }
    std::vector<int> at_speed;
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) {
        const FigureJoint& joint = scene_.joint(joint_i);
        if (!joint.enabled || joint.motor.max_torque <= 0) continue;
        const double ahead = measured_rate(rows_, state_, joint_i, rows_.driven(joint_i)) - joint.motor.speed;
        if (std::abs(ahead) <= standing)
            at_speed.push_back(joint_i);
        else
            motor_modes_[static_cast<std::size_t>(joint_i)] = ahead < 0 ? MotorMode::forward : MotorMode::back;
    }
    if (resting.empty() && at_speed.empty()) return;

    // The same problem one derivative up: accelerations for velocities, loads for impulses.
    for (const int joint_i : at_speed) motor_modes_[static_cast<std::size_t>(joint_i)] = MotorMode::holding;
    const VectorXd free = free_acceleration(state_);
    std::vector<StepBody> bodies = step_bodies(scene_, state_);
    for (int body_i = 0; body_i < scene_.body_count(); ++body_i) {
        bodies[static_cast<std::size_t>(body_i)].v_CM = free.segment<3>(6 * body_i);
        bodies[static_cast<std::size_t>(body_i)].omega = free.segment<3>(6 * body_i + 3);
    }
    std::vector<StepRow> rows;
    std::vector<FigureRow> locked;
    for (int joint_i = 0; joint_i < scene_.joint_count(); ++joint_i) rows_.add_locked(state_, joint_i, locked);
    for (const FigureRow& row : locked) rows.push_back({row, -row.bias, 0, -infinity, infinity});
    for (const std::size_t limit_i : resting) {
        const FigureRow row = rows_.measure(state_, limits_[limit_i].joint, limits_[limit_i].measure).scaled(limits_[limit_i].sign);
        rows.push_back({row, -row.bias, 0, 0, infinity});
    }
    for (const int joint_i : at_speed) {
        const FigureRow row = rows_.measure(state_, joint_i, rows_.driven(joint_i));
        const double most = scene_.joint(joint_i).motor.max_torque;
        rows.push_back({row, -row.bias, 0, -most, most});
    }
    const StepSolution solution = solve_step(bodies, rows);
    std::size_t row_i = locked.size();
    for (const std::size_t limit_i : resting) held_[limit_i] = solution.impulse[row_i++] > 0;
    for (const int joint_i : at_speed) {
        const double torque = solution.impulse[row_i++], most = scene_.joint(joint_i).motor.max_torque;
        if (std::abs(torque) >= most * (1 - 1e-12))
            motor_modes_[static_cast<std::size_t>(joint_i)] = torque > 0 ? MotorMode::forward : MotorMode::back;
    }
}

}  // namespace ingot_figures
