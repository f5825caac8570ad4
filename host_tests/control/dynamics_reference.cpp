// SPDX-License-Identifier: MIT
#include "control/dynamics_reference.h"

namespace ingot_control {

namespace {

RefPose pose_of_child(const RefBody& body, const RefPose& parent, const std::vector<RefCoordinate>& q) {
    const auto coordinate = [&](int i) { return q[static_cast<std::size_t>(body.first + i)]; };
    Turn B_in_A = still(body.start);
    Changing<double> travel = {0, 0, 0};
    switch (body.kind) {
        case RefKind::ball: {
            const RefCoordinate x = coordinate(0), y = coordinate(1), z = coordinate(2);
            B_in_A = turn_with(body.start, {x.rate, y.rate, z.rate}, {x.second, y.second, z.second});
            break;
        }
        case RefKind::hinge: B_in_A = turn_about(body.axis_A, coordinate(0)) * B_in_A; break;
        case RefKind::slider: travel = coordinate(0); break;
        case RefKind::universal: B_in_A = turn_about(body.axis_A, coordinate(0)) * turn_about(body.axis_B, coordinate(1)) * B_in_A; break;
        case RefKind::wheel:
            B_in_A = turn_about(body.axis_A, coordinate(2)) * turn_about(body.axis_B, coordinate(0)) * B_in_A;
            travel = coordinate(1);
            break;
        case RefKind::fixed: break;
    }
    const Way place = {body.anchor_A + body.axis_A * travel.at, body.axis_A * travel.rate, body.axis_A * travel.second};
    if (!body.is_A) {
        const Turn A = parent.A * B_in_A;
        return {parent.r + parent.A * place - A * still(body.anchor_B), A};
    }
    const Turn A = parent.A * transposed(B_in_A);
    return {parent.r + parent.A * still(body.anchor_B) - A * place, A};
}

}  // namespace

std::vector<RefPose> RefFigure::poses(const std::vector<RefCoordinate>& q) const {
    std::vector<RefPose> poses;
    for (std::size_t i = 0; i < size(); ++i) {
        const RefBody& body = bodies[i];
        if (body.parent < 0 && floats) {
            poses.push_back(pose_of_root(q));
            continue;
        }
        const RefPose& parent = body.parent < 0 ? root : poses[static_cast<std::size_t>(body.parent)];
        poses.push_back(pose_of_child(body, parent, q));
    }
    return poses;
}

RefFigure::Torques RefFigure::torques(const std::vector<RefCoordinate>& q) const {
    const std::vector<RefPose> now = poses(q);
    Torques torques = {VectorXd::Zero(count), VectorXd::Zero(count)};
    std::vector<Vector3d> F, T, gyro;
    for (std::size_t i = 0; i < size(); ++i) {
        const Matrix3d I = inertia(i, now);
        const Vector3d w = now[i].spin();
        F.push_back(bodies[i].M * now[i].r.second);
        T.push_back(I * now[i].change_of_spin());
        gyro.push_back(w.cross(I * w));
    }
    for (int k = 0; k < count; ++k) {
        const std::vector<RefPose> partial = partial_poses(q, k);
        for (std::size_t i = 0; i < size(); ++i) {
            const RefBody& body = bodies[i];
            const Vector3d v_k = partial[i].r.rate, w_k = partial[i].spin();
            torques.value(k) += (F[i] - body.weight - body.F).dot(v_k) + (T[i] + gyro[i] - body.T).dot(w_k);
            torques.size(k) += (F[i].norm() + body.weight.norm() + body.F.norm()) * v_k.norm();
            torques.size(k) += (T[i].norm() + gyro[i].norm() + body.T.norm()) * w_k.norm();
        }
    }
    return torques;
}

MatrixXd RefFigure::mass_matrix(const std::vector<RefCoordinate>& q) const {
    const std::vector<RefPose> now = poses(q);
    std::vector<std::vector<RefPose>> partial;
    for (int k = 0; k < count; ++k) partial.push_back(partial_poses(q, k));
    MatrixXd matrix = MatrixXd::Zero(count, count);
    for (std::size_t i = 0; i < size(); ++i) {
        const Matrix3d I = inertia(i, now);
        std::vector<Vector3d> v, w;
        for (const std::vector<RefPose>& of_k : partial) {
            v.push_back(of_k[i].r.rate);
            w.push_back(of_k[i].spin());
        }
        for (std::size_t k = 0; k < v.size(); ++k) {
            const Vector3d p = bodies[i].M * v[k], L = I * w[k];
            for (std::size_t l = 0; l < v.size(); ++l) matrix(static_cast<int>(k), static_cast<int>(l)) += p.dot(v[l]) + L.dot(w[l]);
        }
    }
    return matrix;
}

VectorXd RefFigure::transposed_jacobian(const std::vector<RefCoordinate>& q, std::size_t body_i, const Vector3d& P, const Vector3d& F,
                                        const Vector3d& T) const {
    const Vector3d arm = P - poses(q)[body_i].r.at;
    VectorXd torques(count);
    for (int k = 0; k < count; ++k) {
        const RefPose partial = partial_poses(q, k)[body_i];
        torques(k) = F.dot(partial.r.rate + partial.spin().cross(arm)) + T.dot(partial.spin());
    }
    return torques;
}

Matrix3d RefFigure::inertia(std::size_t i, const std::vector<RefPose>& now) const {
    return now[i].A.at * bodies[i].I_body.asDiagonal() * now[i].A.at.transpose();
}

/// The figure where it is, with a rate of 1 of one coordinate and no other motion.
std::vector<RefPose> RefFigure::partial_poses(std::vector<RefCoordinate> q, int k) const {
    for (RefCoordinate& one : q) one.rate = one.second = 0;
    q[static_cast<std::size_t>(k)].rate = 1;
    RefFigure resting = *this;
    resting.root = {still(root.r.at), still(root.A.at)};
    return resting.poses(q);
}

RefPose RefFigure::pose_of_root(const std::vector<RefCoordinate>& q) const {
    const Vector3d v(q[0].rate, q[1].rate, q[2].rate), a(q[0].second, q[1].second, q[2].second);
    const Vector3d w(q[3].rate, q[4].rate, q[5].rate), alpha(q[3].second, q[4].second, q[5].second);
    return {{root.r.at, v, a}, turn_with(root.A.at, w, alpha)};
}

MatrixXd inverse_of(MatrixXd M) {
    // Gauss and Jordan; no row is taken before another: none is 0 where all is positive.
    const Eigen::Index n = M.rows();
    for (Eigen::Index p = 0; p < n; ++p) {
        const double pivot = M(p, p);
        M(p, p) = 1;
        for (Eigen::Index k = 0; k < n; ++k) M(p, k) /= pivot;
        for (Eigen::Index i = 0; i < n; ++i) {
            if (i == p) continue;
            const double share = M(i, p);
            M(i, p) = 0;
            for (Eigen::Index k = 0; k < n; ++k) M(i, k) -= share * M(p, k);
        }
    }
    return M;
}

}  // namespace ingot_control
