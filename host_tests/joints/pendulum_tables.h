// SPDX-License-Identifier: MIT
// The tables of pendulums, 32 digits in minimal coordinates, as scenes of joints.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "joints/figure_scenes.h"
#include "reference/csv_table.h"
#include "reference/driven_body_table.h"

namespace ingot_figures {

struct PendulumSample {
    double t = 0;
    std::vector<double> coordinates;
};

/// One case of a table: the scene, what its coordinates are in a state, and their values.
struct PendulumCase {
    FigureScene scene;
    std::vector<PendulumSample> samples;
    std::vector<double> (*coordinates_of)(const FigureState& state) = nullptr;
    double energy = 0;  ///< J
    bool has_angles = true;

    /// Largest error of a position (angles: the shorter way round), and of a rate.
    struct Error {
        double position = 0, rate = 0;
    };
    Error error(const PendulumSample& sample, const FigureState& state) const {
        const std::vector<double> found = coordinates_of(state);
        Error worst;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double difference = found[i] - sample.coordinates[i];
            if (i < found.size() / 2)
                worst.position = std::max(worst.position, std::abs(has_angles ? std::remainder(difference, 2 * pi) : difference));
            else
                worst.rate = std::max(worst.rate, std::abs(difference));
        }
        return worst;
    }
};

inline std::vector<PendulumSample> pendulum_samples(const std::string& table_name, const std::string& name) {
    const ingot_reference::CsvTable table(table_name + ".csv");
    std::vector<std::string> columns(table.columns().begin() + 2, table.columns().end());
    std::vector<PendulumSample> samples;
    for (const std::size_t row : table.rows_with("case", name)) samples.push_back({table.number(row, "t"), table.numbers(row, columns)});
    return samples;
}

/// theta, theta_dot. Cases: small, large, near_top.
inline PendulumCase planar_pendulum_case(const std::string& name) {
    const ingot_reference::CsvTable parameters("planar_pendulum_params.csv");
    const std::size_t row = parameters.row_with("case", name);
    const double k = parameters.number(row, "k"), theta_0 = parameters.number(row, "theta0");
    PendulumCase pendulum{planar_pendulum(k, theta_0), pendulum_samples("planar_pendulum", name),
                          [](const FigureState& state) {
                              return std::vector<double>{turned_about_y(state.body(0).A()), state.body(0).omega.y()};
                          },
                          -k * 0.5 * std::cos(theta_0), true};
    return pendulum;
}

/// x, y, z, vx, vy, vz of the point. Cases: conical_perturbed, near_planar, over_the_top.
inline PendulumCase spherical_pendulum_case(const std::string& name) {
    const ingot_reference::CsvTable parameters("spherical_pendulum_params.csv");
    const std::size_t row = parameters.row_with("case", name);
    const auto vector = [&](const char* x, const char* y, const char* z) {
        return Vector3d(parameters.number(row, x), parameters.number(row, y), parameters.number(row, z));
    };
    const double g = parameters.number(row, "g"), l = parameters.number(row, "l");
    PendulumCase pendulum;
    pendulum.scene = spherical_pendulum(g, l, vector("x0", "y0", "z0"), vector("vx0", "vy0", "vz0"));
    pendulum.samples = pendulum_samples("spherical_pendulum", name);
    pendulum.coordinates_of = [](const FigureState& state) {  // the point is 4/3 of the way to the centre of mass
        const Vector3d r = state.body(0).r_CM * 4 / 3, v = state.body(0).v_CM * 4 / 3;
        return std::vector<double>{r.x(), r.y(), r.z(), v.x(), v.y(), v.z()};
    };
    pendulum.energy = 0.75 * parameters.number(row, "E_per_mass");  // T = 3/8 v^2 and V = 3/4 g z in those of the point
    pendulum.has_angles = false;
    return pendulum;
}

/// q1, q2 and their rates. Cases: swing, chaotic_short, heavy_tip. Moments that the table has no use for are those of round rods.
inline PendulumCase double_parallel_pendulum_case(const std::string& name) {
    const ingot_reference::CsvTable parameters("double_parallel_pendulum_params.csv");
    const std::size_t row = parameters.row_with("case", name);
    const auto number = [&](const char* column) { return parameters.number(row, column); };
    DoublePendulum p;
    p.m1 = number("m1");
    p.m2 = number("m2");
    p.l1 = number("l1");
    p.c1 = number("c1");
    p.c2 = number("c2");
    p.I1 = number("I1") * Vector3d(1, 1, 0.25);
    p.I2 = number("I2") * Vector3d(1, 1, 0.25);
    p.g = number("g");
    p.q1 = number("q1_0");
    p.q2 = number("q2_0");
    p.q1_rate = number("q1dot_0");
    p.q2_rate = number("q2dot_0");
    PendulumCase pendulum{double_parallel_pendulum(p), pendulum_samples("double_parallel_pendulum", name),
                          [](const FigureState& state) {
                              return std::vector<double>{turned_about_y(state.body(0).A()), turned_about_y(state.body(1).A()),
                                                         state.body(0).omega.y(), state.body(1).omega.y()};
                          },
                          number("E"), true};
    return pendulum;
}

/// q1, q2 and their rates. Cases: swing, energetic.
inline PendulumCase double_perpendicular_pendulum_case(const std::string& name) {
    const ingot_reference::CsvTable parameters("double_perpendicular_pendulum_params.csv");
    const std::size_t row = parameters.row_with("case", name);
    const auto number = [&](const char* column) { return parameters.number(row, column); };
    DoublePendulum p;
    p.m1 = number("m1");
    p.m2 = number("m2");
    p.l1 = number("l1");
    p.c1 = number("c1");
    p.c2 = number("c2");
    p.I1 = number("I1y") * Vector3d(1, 1, 0.25);
    p.I2 = Vector3d(number("I2x"), number("I2y"), number("I2z"));
    p.g = number("g");
    p.q1 = number("q1_0");
    p.q2 = number("q2_0");
    p.q1_rate = number("q1dot_0");
    p.q2_rate = number("q2dot_0");
    PendulumCase pendulum{
        double_perpendicular_pendulum(p), pendulum_samples("double_perpendicular_pendulum", name),
        [](const FigureState& state) {
            const Matrix3d A_1 = state.body(0).A(), R = A_1.transpose() * state.body(1).A();
            const Vector3d W = state.body(1).omega - state.body(0).omega;
            return std::vector<double>{turned_about_y(A_1), std::atan2(R(2, 1), R(1, 1)), state.body(0).omega.y(), W.dot(A_1.col(0))};
        },
        number("E"), true};
    return pendulum;
}

/// A top of the table `top` as a body on a ball joint at the origin: 1 kg, so g is its weight. Its centre of mass has to be on body z.
inline FigureScene top_of_table(const ingot_reference::TopCase& top) {
    FigureScene scene;
    scene.name = "top";
    scene.g = {0, 0, -static_cast<double>(top.weight)};
    const double arm = static_cast<double>(top.r_body.z());
    FigureBody body;
    body.I_body = top.I.cast<double>() - arm * arm * Vector3d(1, 1, 0);
    body.A = top.A_0.cast<double>();
    body.r_CM = arm * body.A.col(2);
    body.omega = body.A * top.w_body_0.cast<double>();
    body.v_CM = body.omega.cross(body.r_CM);
    FigureJoint joint;
    joint.body_B = scene.add(body);
    scene.join(joint);
    return scene;
}

}  // namespace ingot_figures
