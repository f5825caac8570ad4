// SPDX-License-Identifier: MIT
// A figure drawn at random in a world of its own, and what the kernel reads of it.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "control/drawn_figure.h"
#include "reference/draws.h"

namespace ingot_control {

using ingot::scalar;
using ingot::Status;
using ingot_reference::draws;

inline constexpr double tolerance = sizeof(scalar) == 8 ? 1e-12 : 1e-5;  // of the sum of what is summed
inline constexpr double eps = static_cast<double>(ingot::epsilon);
inline constexpr int most_bodies = 12;

inline VectorXd in_order(const scalar* numbers, const std::vector<int>& order) {
    VectorXd all(static_cast<Eigen::Index>(order.size()));
    for (std::size_t k = 0; k < order.size(); ++k) all(static_cast<Eigen::Index>(k)) = static_cast<double>(numbers[order[k]]);
    return all;
}

/// A figure in a world of its own, read, and what belongs to it.
template <class Scene>
struct Read {
    DrawnFigure drawn;
    BuiltFigure built;
    std::unique_ptr<ingot::World<Scene>> world = std::make_unique<ingot::World<Scene>>();
    ingot::FigureDynamics<most_bodies> figure;
    std::vector<int> order;
    scalar numbers[3 * most_bodies + 6] = {}, torques[3 * most_bodies + 6] = {}, matrix[(3 * most_bodies + 6) * (3 * most_bodies + 6)] = {};

    int count() const { return figure.direction_count(); }
    std::size_t size() const { return drawn.figure.size(); }
    void read() {
        ASSERT_TRUE(built.sound);
        ASSERT_EQ(world->read_dynamics(built.bodies[0], figure), Status::ok);
        ASSERT_EQ(count(), drawn.figure.count);
        ASSERT_EQ(figure.body_count(), static_cast<int>(size()));
        ASSERT_EQ(figure.floats(), drawn.figure.floats);
        order = numbers_of(figure, drawn, built);
        for (std::size_t k = 0; k < order.size(); ++k) numbers[order[k]] = static_cast<scalar>(drawn.q[k].second);
    }
    VectorXd given() const { return in_order(torques, order); }
    MatrixXd mass() {
        EXPECT_EQ(figure.mass_matrix(matrix, count() * count()), Status::ok);
        MatrixXd M(count(), count());
        for (int i = 0; i < count(); ++i)
            for (int k = 0; k < count(); ++k)
                M(i, k) = static_cast<double>(matrix[order[static_cast<std::size_t>(i)] * count() + order[static_cast<std::size_t>(k)]]);
        return M;
    }
};

}  // namespace ingot_control
