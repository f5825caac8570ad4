// SPDX-License-Identifier: MIT
// The exact motion of a figure, in maximal coordinates, to about 1e-10 where it is smooth.
//
// Accelerations come from the dense system M a = F + J^T lambda, J a = -(what the rows do by themselves). Redundant rows are found by a
// rank-revealing decomposition at the begin of each step. The motion is integrated by Gragg's midpoint rule and extrapolation (Gragg, SIAM J. Numer.
// Anal. 2, 1965; Bulirsch and Stoer, Numer. Math. 8, 1966), order 16, with the step chosen by the last two columns. After each step positions and
// velocities are brought back onto the joints, which takes off what the step has erred, 1e-13 or less.
//
// Limits, ropes, motors with a largest torque and joints that break are events. Each is found in time to rounding, velocities jump by the exact
// impact (Newton's restitution, all limits that touch at once), and the motion goes on. Between events it is smooth. Bodies do not touch each other.
#pragma once

#include "joints/figure_measures.h"
#include "joints/joint_rows.h"
#include "joints/row_system.h"

namespace ingot_figures {

/// What a joint does to its body B, at the anchor of B; the opposite acts on A at the same place.
struct JointLoad {
    Vector3d force = Vector3d::Zero();   ///< N, world axes: locked directions and limits
    Vector3d torque = Vector3d::Zero();  ///< N m, the same; without servo, suspension and motor
    double motor = 0;                    ///< N m or N along the driven direction
    bool determined = true;              ///< false: redundant joints share the load, here as the shortest multipliers do
};

class ConstrainedReference {
public:
    /// tolerance: of the local error, times 1 + |coordinate|. longest_step, s: a limit that is met and left again within one is missed.
    explicit ConstrainedReference(const FigureScene& scene, double tolerance = 1e-13, double longest_step = 0.05);

    ConstrainedReference(const ConstrainedReference&) = delete;
    ConstrainedReference& operator=(const ConstrainedReference&) = delete;

    const FigureScene& scene() const { return scene_; }  ///< joints that broke are not enabled
    const JointRows& rows() const { return rows_; }
    const FigureState& state() const { return state_; }

    /// Starts from a state, which is brought onto the joints first.
    void restart(const FigureState& state);

    /// To time t, s, not before now. Throws std::runtime_error where no step is small enough.
    void advance_to(double t);

    std::vector<JointLoad> loads() const;
    double energy() const { return ingot_figures::energy(rows_, state_); }

    /// Accelerations of all bodies, v_CM' and omega' in turn.
    VectorXd accelerations() const;

    int step_count() const { return steps_; }
    int event_count() const { return events_; }

private:
    enum class MotorMode { forward, back, holding };

    /// A row that acts now, and what of the scene it belongs to.
    struct Source {
        enum Kind { locked, limit, motor } kind;
        int index;  ///< joint; of limits_
    };
    struct Active {
        std::vector<FigureRow> rows;
        std::vector<Source> sources;
    };
    /// How far each event is, and which.
    struct Event {
        double room;
        Source source;
    };

    Active active_rows(const FigureState& state) const;
    VectorXd free_acceleration(const FigureState& state) const;
    Multipliers multipliers(const FigureState& state, const Active& active) const;
    std::vector<JointLoad> loads_of(const FigureState& state, const Active& active, const Multipliers& found) const;

    FigureState unpacked(const VectorXd& y, double t) const;
    VectorXd derivative(const VectorXd& y, double t, const std::vector<int>& chosen) const;
    FigureState extrapolated(double h, double& error) const;
    void bring_onto_joints(FigureState& state) const;

    std::vector<Event> events_of(const FigureState& state) const;
    double least_room(const FigureState& state) const;
    FigureState at_first_event(double h) const;
    void handle_events();
    void break_joints(const std::vector<Event>& events);
    void meet_limits();
    void choose_modes();

    FigureScene scene_;
    JointRows rows_;
    std::vector<FigureLimit> limits_;
    std::vector<bool> held_;
    std::vector<MotorMode> motor_modes_;
    FigureState state_;
    double tolerance_, longest_step_, next_step_ = 1e-3;
    int steps_ = 0, events_ = 0;
};

}  // namespace ingot_figures
