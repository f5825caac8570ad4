// SPDX-License-Identifier: MIT
// What joints ask of the motion, as scalar functions g of the poses of bodies, each with its Jacobian and its second derivative.
//
//     g' = J u + own_rate,      g'' = J a + bias          u = (v_CM, omega) of each body, a = u'
//
// Locked directions are rows with g = 0. They come in few forms: a coordinate of the distance d between two anchors, along an axis of the world or of
// A; the product of an axis of A and one of B; the length of d. Free directions are rows whose g is an angle, a travel or a length.
#pragma once

#include "joints/figure.h"

namespace ingot_figures {

/// One function g of the poses.
struct FigureRow {
    static constexpr int most_parts = 4;
    struct Part {
        int body = 0;
        Vector3d on_v = Vector3d::Zero(), on_omega = Vector3d::Zero();
    };

    double value = 0;       ///< g
    bool has_value = true;  ///< false: a rate alone is asked for (motors, gears), and no pose misses it
    double own_rate = 0;    ///< dg/dt where no body moves (steering)
    double bias = 0;        ///< d2g/dt2 where no body accelerates
    int part_count = 0;
    Part parts[most_parts];  ///< J; the world has no part

    /// Adds to the Jacobian of a body; nothing for the_world.
    void add(int body, const Vector3d& on_v, const Vector3d& on_omega);
    double J_times_u(const FigureState& state) const;
    double rate(const FigureState& state) const { return J_times_u(state) + own_rate; }
    FigureRow scaled(double factor) const;
};

/// Free directions of joints that have limits, drives or readings.
enum class FigureMeasure {
    angle,   ///< hinge; wheel: its spin. rad, in (-pi, pi]
    travel,  ///< slider, wheel: m along axis_A
    first,   ///< universal: angle about axis_A, rad
    second,  ///< universal: angle about axis_B, rad
    cone,    ///< ball: angle between axis_A and axis_B, rad in [0, pi]; no Jacobian at 0 and pi
    twist,   ///< ball: rad in (-pi, pi]
    length,  ///< distance: m between the anchors
};

/// An end of a free direction: sign (measure - bound) >= 0 is allowed.
struct FigureLimit {
    int joint = 0;
    FigureMeasure measure = FigureMeasure::angle;
    double bound = 0;
    int sign = 1;  ///< 1: lower end, -1: upper end
    double restitution = 0;
};

/// The rows of all joints of a scene. Keeps what is fixed in bodies; the scene has to stay.
class JointRows {
public:
    explicit JointRows(const FigureScene& scene);

    const FigureScene& scene() const { return scene_; }

    /// Appends the locked rows of a joint: ball 3, hinge 5, slider 5, universal 4, fixed 6, wheel 4, rod 1, parallel 2, gear 1.
    void add_locked(const FigureState& state, int joint_i, std::vector<FigureRow>& rows) const;

    /// A free direction. The joint has to be of a kind that has it.
    FigureRow measure(const FigureState& state, int joint_i, FigureMeasure which) const;

    /// The direction that motor and servo act on: hinge and wheel angle, slider travel.
    FigureMeasure driven(int joint_i) const;
    bool has_driven(int joint_i) const;

    /// The ends of the free directions of a joint that are not infinite; of a rope too, but not of a rod.
    std::vector<FigureLimit> limits(int joint_i) const;
    std::vector<FigureLimit> limits() const;

    /// World positions of the anchors in A and in B.
    Vector3d anchor_A(const FigureState& state, int joint_i) const;
    Vector3d anchor_B(const FigureState& state, int joint_i) const;

    /// axis_A where A has carried it, and axis_B where B has. Of a hinge, slider and fixed joint both are the same axis.
    Vector3d axis_A(const FigureState& state, int joint_i) const;
    Vector3d axis_B(const FigureState& state, int joint_i) const;

    /// Triads of a joint, columns u, w, n, as A and as B carry them: equal where nothing has turned since the start, but for a ball, whose n is
    /// axis_A in A and axis_B in B. n of a wheel is its axle before it is steered; of all others axis_A.
    Matrix3d triad_A(const FigureState& state, int joint_i) const;
    Matrix3d triad_B(const FigureState& state, int joint_i) const;

    /// The rotation vector of B against A since the start, world axes.
    Vector3d rotation(const FigureState& state, int joint_i) const;

private:
    struct Attached {
        Vector3d anchor_A, anchor_B;  ///< from the centre of mass, body axes
        Vector3d axis_A, axis_B;      ///< body axes
        Matrix3d triad_A, triad_B;
        Quaterniond turn;  ///< B against A at the start, in body axes of A
    };
    struct Placed;

    const Attached& attached(int joint_i) const { return attached_[static_cast<std::size_t>(joint_i)]; }
    Placed place(const FigureState& state, int joint_i) const;

    const FigureScene& scene_;
    std::vector<Attached> attached_;
};

}  // namespace ingot_figures
