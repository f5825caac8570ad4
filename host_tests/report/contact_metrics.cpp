// SPDX-License-Identifier: MIT
#include "contact_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace report {

namespace {

using Vector3d = Eigen::Vector3d;
using Matrix3d = Eigen::Matrix3d;

/// The larger; infinity once something was not a number.
double worse(double a, double b) { return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b); }

}  // namespace

ContactTally::ContactTally(const ContactCase& scene, const std::vector<BodyPose>& start, double seconds)
    : scene_(scene),
      start_(start),
      last_(start),
      seconds_(seconds),
      energy_begin_(0),
      energy_last_(0),
      overlaps_due_(seconds / 2) {
    energy_begin_ = energy_last_ = energy(start);
}

double kinetic_energy(const ContactCase& scene, const std::vector<BodyPose>& poses) {
    double sum = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const SceneBody& body = scene.bodies[i];
        if (body.immovable) continue;
        const Vector3d omega_body = matrix(poses[i].A).transpose() * vector(poses[i].omega);
        sum += body.M * vector(poses[i].v).squaredNorm() / 2 + omega_body.dot(omega_body.cwiseProduct(vector(body.I))) / 2;
    }
    return sum;
}

/// Kinetic and potential, J; heights are counted from the floor, those of a bouncing ball from where it rests.
double ContactTally::energy(const std::vector<BodyPose>& poses) const {
    double sum = kinetic_energy(scene_, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const SceneBody& body = scene_.bodies[i];
        const double height = is("bounce") ? poses[i].r[2] - body.size[0] : poses[i].r[2];
        if (!body.immovable) sum -= body.M * scene_.gravity[2] * height;
    }
    return sum;
}

void ContactTally::see_energy(const std::vector<BodyPose>& poses) {
    const double now = energy(poses);
    if (energy_last_ > 0) energy_gain_ = worse(energy_gain_, (now - energy_last_) / energy_last_);
    energy_error_ = worse(energy_error_, std::abs(now / energy_begin_ - 1));
    energy_last_ = now;
}

void ContactTally::see_displacements(const std::vector<BodyPose>& poses, double t) {
    bool moving = false;
    double furthest = 0;
    settled_ = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (scene_.bodies[i].immovable) continue;
        const Vector3d moved = vector(poses[i].r) - vector(start_[i].r);
        const double sideways = moved.head<2>().norm();
        shift_ = worse(shift_, sideways);
        settled_ = worse(settled_, -moved.z());
        settling_ = worse(settling_, settled_);
        furthest = worse(furthest, moved.norm());
        if (i + 1 == poses.size()) {
            top_shift_ = worse(top_shift_, sideways);
            top_sink_ = worse(top_sink_, -moved.z());
        }
        spin_ = worse(spin_, vector(poses[i].omega).norm());
        moving = moving || !(vector(poses[i].v).norm() < 0.02);
    }
    if (moving) last_moving_ = t;
    stands_ = stands_ && furthest < 0.5;
    if (stands_) stood_ = t;
    if (is("incline")) {
        const Vector3d up = vector(scene_.bodies[0].size), moved = vector(poses[1].r) - vector(start_[1].r);
        lift_ = worse(lift_, std::abs(up.dot(moved)));
        creep_ = worse(creep_, (moved - up * up.dot(moved)).norm());
    }
}

void ContactTally::see_overlaps(const std::vector<BodyPose>& poses, double t) {
    if (t + 1e-9 < overlaps_due_) return;
    overlaps_due_ = t + seconds_ / 2 / 20;
    const Overlaps now = overlaps_of(scene_, poses);
    overlaps_.sum += now.sum;
    overlaps_.count += now.count;
    overlaps_.deepest = worse(overlaps_.deepest, now.deepest);
}

void ContactTally::see(const std::vector<BodyPose>& poses, const StepFigures& figures, double t) {
    see_displacements(poses, t);
    see_energy(poses);
    see_overlaps(poses, t);
    lost_ += figures.lost;
    frozen_ += figures.frozen;
    if (t > seconds_ / 2) {
        residual_ = worse(residual_, figures.residual);
        sweeps_ += figures.sweeps;
        ++later_steps_;
    }
    last_ = poses;
    t_ = t;
}

void ContactTally::add_of_stack(std::vector<Metric>& list) const {
    list.push_back({"shift", shift_ * 1e3, "mm"});
    list.push_back({"settling", settling_ * 1e3, "mm"});
    list.push_back({"settled", settled_ * 1e3, "mm"});
    list.push_back({"drift", top_shift_ * 1e3, "mm"});
    list.push_back({"sink", top_sink_ * 1e3, "mm"});
    list.push_back({"stood", stood_, "s"});
}

void ContactTally::add_of_incline(std::vector<Metric>& list) const {
    const Vector3d up = vector(scene_.bodies[0].size);
    const double g = -scene_.gravity[2], tangent = up.head<2>().norm(), mu = scene_.bodies[1].mu;
    const double acceleration = g * (tangent - mu * up.z());
    list.push_back({"lift", lift_ * 1e3, "mm"});
    if (acceleration <= 0) {
        list.push_back({"creep", creep_ * 1e3, "mm"});
        return;
    }
    const double distance = acceleration * t_ * t_ / 2;
    list.push_back({"distance_error", std::abs((vector(last_[1].r) - vector(start_[1].r)).norm() / distance - 1) * 100, "%"});
}

void ContactTally::add_of_drop(std::vector<Metric>& list) const {
    double rest_speed = 0, escaped = 0;
    for (std::size_t i = 0; i < last_.size(); ++i) {
        if (scene_.bodies[i].immovable) continue;
        rest_speed = worse(rest_speed, vector(last_[i].v).norm());
        bool outside = false;
        for (const SceneBody& wall : scene_.bodies)
            if (wall.solid == Solid::half_space)
                outside = outside || !(vector(wall.size).dot(vector(last_[i].r)) > wall.offset);
        escaped += outside ? 1 : 0;
    }
    list.push_back({"escaped", escaped, "1"});
    list.push_back({"rest_speed", rest_speed * 1e3, "mm/s"});
}

std::vector<Metric> ContactTally::metrics() const {
    std::vector<Metric> list;
    if (is("pyramid") || is("tower") || is("mass_ratio")) add_of_stack(list);
    if (is("incline")) add_of_incline(list);
    if (is("pile") || is("pit") || is("box_dropped")) add_of_drop(list);
    if (is("bounce_e1")) list.push_back({"energy_error", energy_error_, "1"});
    if (is("bounce_e05")) list.push_back({"rest_time", last_moving_, "s"});
    if (is("box_dropped")) list.push_back({"spin", spin_, "rad/s"});
    if (!is("incline")) list.push_back({"energy_gain", energy_gain_, "1"});
    const double pairs = static_cast<double>(overlaps_.count);
    list.push_back({"mean_overlap", pairs > 0 ? overlaps_.sum / pairs * 1e3 : 0, "mm"});
    list.push_back({"max_overlap", overlaps_.deepest * 1e3, "mm"});
    list.push_back({"lost", static_cast<double>(lost_), "1"});
    list.push_back({"frozen", static_cast<double>(frozen_), "1"});
    list.push_back({"seconds", t_, "s"});
    if (later_steps_ > 0 && sweeps_ > 0) {
        list.push_back({"residual", residual_, "m/s"});
        list.push_back({"sweeps", sweeps_ / static_cast<double>(later_steps_), "1"});
    }
    return list;
}

}  // namespace report
