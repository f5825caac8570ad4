// SPDX-License-Identifier: MIT
// An oracle for what joints bear that needs no solver: what all joints of a body give it over a step is what its momentum and angular momentum
// change by, without gravity and contacts. In a tree that is one value for each joint; where loops leave the shares open, it still holds of the sum.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <vector>

#include "scene_in_world.h"

namespace ingot_figures {

using ingot::scalar;

/// A body between two steps.
struct BodyNow {
    Vector3d r, v, L;
    Matrix3d A;
};
template <class World>
std::vector<BodyNow> bodies_now(const World& world, const std::vector<ingot::BodyId>& ids) {
    using ingot_reference::to_eigen;
    std::vector<BodyNow> bodies;
    for (const ingot::BodyId id : ids) {
        const ingot::BodyState state = world.state(id).value;
        bodies.push_back({to_eigen(state.r_CM), to_eigen(state.v_CM), to_eigen(state.L), to_eigen(state.A)});
    }
    return bodies;
}

/// What is out of balance, as a share of what roundings and the length of the step allow.
struct Balance {
    double force = 0, torque = 0;  ///< of the worst body
    double along = 0;              ///< of the worst joint: what its reaction has along free directions, where there should be nothing

    void add(const Balance& other) {
        force = std::max(force, other.force);
        torque = std::max(torque, other.torque);
        along = std::max(along, other.along);
    }
};

/// Of a scene of figures in a world. Anchors and axes are kept as they are in their bodies at the start.
class JointBalance {
public:
    JointBalance(const FigureScene& scene, const Built& built, bool is_implicit)
        : scene_(scene), built_(built), gap_(is_implicit ? 64 * figures::eps : figures::held) {
        for (const FigureJoint& joint : scene.joints) {
            const FigureBody& body = scene.body(joint.body_B);
            anchors_.push_back(body.A.transpose() * (joint.anchor - body.r_CM));
        }
    }

    /// Free directions have loads of their own, of drives and limits, which may change much in a step. Those that fit best are taken.
    bool has_free_loads = false;
    /// Of all loads: what may be wrong of one in a loop. Rows share what they say alike as they like, another way in each substep.
    double share_of_loops = 0;
    /// N s, that each body got from contacts in the step: torques are not looked at then.
    std::vector<Vector3d> contacts;

    /// Of the next step, of h seconds. Arms and axes turn in it: a torque is only as sure as the forces times the way of their arms. Where loads
    /// jump, it is not known when they acted: torques and directions are then not looked at.
    template <class World>
    Balance of_step(const World& world, const std::vector<BodyNow>& before, const std::vector<BodyNow>& after, double h) {
        const Step step = {before, after, h};
        const bool is_smooth = note_loads(world);
        Sums sums = sums_of_bodies(step);
        Balance balance;
        Eigen::MatrixXd loads(6 * body_count(), 0);
        for (std::size_t joint_i = 0; joint_i < scene_.joints.size(); ++joint_i) {
            const ingot::JointReaction reaction = world.joint_reaction(built_.joints[joint_i]).value;
            const Wrench of_joint = {ingot_reference::to_eigen(reaction.force), ingot_reference::to_eigen(reaction.torque)};
            give(step, sums, joint_i, of_joint);
            const std::vector<Wrench> free = free_directions(step, joint_i);
            for (const Wrench& direction : free) {
                loads.conservativeResize(Eigen::NoChange, loads.cols() + 1);
                loads.col(loads.cols() - 1) = column_of(step, joint_i, direction);
                const double along = std::abs(direction.F.dot(of_joint.F) + direction.T.dot(of_joint.T)), all = of_joint.F.norm() + of_joint.T.norm();
                if (!is_smooth || has_free_loads || share_of_loops > 0 || !contacts.empty()) continue;
                const double may = all * (turn_of(step, joint_i) + 64 * figures::eps) + 1e-9;
                balance.along = std::max(balance.along, along / may);
            }
        }
        const auto for_bodies = [&](const auto& each) {
            for (int body_i = 0; body_i < body_count(); ++body_i)
                if (scene_.body(body_i).M > 0) each(body_i, sums.rounding(body_i) + (64 * figures::eps + share_of_loops) * sums.all);
        };
        for_bodies([&](int body_i, double roundings) {
            if (has_free_loads && slides(body_i)) return;  // drives push along what slides
            balance.force = std::max(balance.force, sums.lack.segment<3>(6 * body_i).norm() / roundings);
        });
        if (!is_smooth || !contacts.empty()) return balance;
        if (has_free_loads) fit_free_loads(loads, step, sums);
        for_bodies([&](int body_i, double roundings) {
            const double may = roundings + (has_free_loads ? sums.may.norm() : sums.may(body_i));
            balance.torque = std::max(balance.torque, sums.lack.segment<3>(6 * body_i + 3).norm() / may);
        });
        return balance;
    }

private:
    struct Step {
        const std::vector<BodyNow>&before, &after;
        double h;
    };
    struct Wrench {
        Vector3d F, T;  ///< on B, about its anchor
    };
    struct Sums {
        Eigen::VectorXd lack;      ///< force and torque of each body
        Eigen::VectorXd rounding;  ///< N, N m
        Eigen::VectorXd may;       ///< N m, by how much a torque may be off as arms turn
        double all;                ///< N, N m, of all joints
    };

    const FigureScene& scene_;
    const Built& built_;
    std::vector<Vector3d> anchors_;
    std::vector<Vector3d> last_forces_, last_torques_;
    double gap_;  ///< m, by which sides may be apart, and so arms in substeps be off, until a push takes it back

    /// Whether loads are about what they were in the step before.
    template <class World>
    bool note_loads(const World& world) {
        double change = 0, all = 0;
        std::vector<Vector3d> forces, torques;
        for (const ingot::JointId id : built_.joints) {
            const ingot::JointReaction reaction = world.joint_reaction(id).value;
            forces.push_back(ingot_reference::to_eigen(reaction.force));
            torques.push_back(ingot_reference::to_eigen(reaction.torque));
            all += forces.back().norm() + torques.back().norm();
        }
        for (std::size_t i = 0; i < last_forces_.size(); ++i) change += (forces[i] - last_forces_[i]).norm() + (torques[i] - last_torques_[i]).norm();
        const bool is_smooth = !last_forces_.empty() && change <= all / 2;
        last_forces_ = forces;
        last_torques_ = torques;
        return is_smooth;
    }
    bool slides(int body_i) const {
        bool some = false;
        for (const FigureJoint& joint : scene_.joints)
            some = some || (joint.kind == FigureJointKind::slider && (joint.body_A == body_i || joint.body_B == body_i));
        return some;
    }
    int body_count() const { return scene_.body_count(); }
    static const BodyNow& at(const std::vector<BodyNow>& bodies, int body_i) { return bodies[static_cast<std::size_t>(body_i)]; }

    Sums sums_of_bodies(const Step& step) const {
        Sums sums = {Eigen::VectorXd::Zero(6 * body_count()), Eigen::VectorXd::Zero(body_count()), Eigen::VectorXd::Zero(body_count()), 0};
        for (int body_i = 0; body_i < body_count(); ++body_i) {
            const double M = scene_.body(body_i).M;
            if (M == 0) continue;
            const BodyNow &from = at(step.before, body_i), &to = at(step.after, body_i);
            Vector3d force = M * ((to.v - from.v) / step.h - scene_.g);
            if (!contacts.empty()) force -= contacts[static_cast<std::size_t>(body_i)] / step.h;
            sums.lack.segment<3>(6 * body_i) = force;
            sums.lack.segment<3>(6 * body_i + 3) = (to.L - from.L) / step.h;
            double momenta = M * (from.v.norm() + to.v.norm() + step.h * scene_.g.norm()) + from.L.norm() + to.L.norm();
            if (!contacts.empty()) momenta += contacts[static_cast<std::size_t>(body_i)].norm();
            sums.rounding(body_i) = 64 * figures::eps * momenta / step.h;
        }
        return sums;
    }
    Vector3d place_of(const std::vector<BodyNow>& bodies, std::size_t joint_i) const {
        const BodyNow& B = at(bodies, scene_.joints[joint_i].body_B);
        return B.r + B.A * anchors_[joint_i];
    }
    /// Calls each(body_i, sign, arm half-way, by how much it changes).
    template <class Each>
    void for_sides(const Step& step, std::size_t joint_i, const Each& each) const {
        const FigureJoint& joint = scene_.joints[joint_i];
        for (const int body_i : {joint.body_A, joint.body_B}) {
            if (body_i == the_world) continue;
            const Vector3d arm_before = place_of(step.before, joint_i) - at(step.before, body_i).r;
            const Vector3d arm_after = place_of(step.after, joint_i) - at(step.after, body_i).r;
            each(body_i, body_i == joint.body_B ? 1.0 : -1.0, Vector3d((arm_before + arm_after) / 2), (arm_after - arm_before).norm());
        }
    }
    void give(const Step& step, Sums& sums, std::size_t joint_i, const Wrench& on_B) const {
        for_sides(step, joint_i, [&](int body_i, double sign, const Vector3d& arm, double change) {
            sums.lack.segment<3>(6 * body_i) -= sign * on_B.F;
            sums.lack.segment<3>(6 * body_i + 3) -= sign * (on_B.T + arm.cross(on_B.F));
            // All of it may have come in one of four substeps, with an arm that is half of the change off the middle.
            sums.may(body_i) += on_B.F.norm() * (2 * change + gap_);
        });
        sums.all += on_B.F.norm() + on_B.T.norm();
    }
    Eigen::VectorXd column_of(const Step& step, std::size_t joint_i, const Wrench& direction) const {
        Eigen::VectorXd column = Eigen::VectorXd::Zero(6 * body_count());
        for_sides(step, joint_i, [&](int body_i, double sign, const Vector3d& arm, double) {
            column.segment<3>(6 * body_i) = sign * direction.F;
            column.segment<3>(6 * body_i + 3) = sign * (direction.T + arm.cross(direction.F));
        });
        return column;
    }
    Vector3d axis_at(const std::vector<BodyNow>& bodies, int body_i, const Vector3d& axis) const {
        return body_i == the_world ? axis : Vector3d(at(bodies, body_i).A * (scene_.body(body_i).A.transpose() * axis));
    }
    /// By how much the axes of a joint turn.
    double turn_of(const Step& step, std::size_t joint_i) const {
        const FigureJoint& joint = scene_.joints[joint_i];
        double turn = 0;
        for (const int body_i : {joint.body_A, joint.body_B})
            if (body_i != the_world) turn += (at(step.after, body_i).A - at(step.before, body_i).A).norm();
        return turn;
    }
    std::vector<Wrench> free_directions(const Step& step, std::size_t joint_i) const {
        const FigureJoint& joint = scene_.joints[joint_i];
        const auto half_way = [&](int body_i, const Vector3d& axis) -> Vector3d {
            return (axis_at(step.before, body_i, axis) + axis_at(step.after, body_i, axis)) / 2;
        };
        const Vector3d none = Vector3d::Zero(), n = half_way(joint.body_A, joint.axis_A);
        switch (joint.kind) {
            case FigureJointKind::ball: return {{none, Vector3d::UnitX()}, {none, Vector3d::UnitY()}, {none, Vector3d::UnitZ()}};
            case FigureJointKind::hinge: return {{none, n}};
            case FigureJointKind::slider: return {{n, none}};
            case FigureJointKind::universal: return {{none, n}, {none, half_way(joint.body_B, joint.axis_B)}};
            default: return {};
        }
    }
    /// The nearest that loads along free directions come to the balance: what is left is no more than it is with the true ones.
    void fit_free_loads(const Eigen::MatrixXd& loads, const Step& step, Sums& sums) const {
        const Eigen::VectorXd fit = loads.colPivHouseholderQr().solve(sums.lack);
        sums.lack -= loads * fit;
        double most = 0;
        for (std::size_t joint_i = 0; joint_i < scene_.joints.size(); ++joint_i) most = std::max(most, turn_of(step, joint_i));
        sums.all += fit.lpNorm<1>();
        sums.may.array() += most * fit.lpNorm<1>();
    }
};

}  // namespace ingot_figures
