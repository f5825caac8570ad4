// SPDX-License-Identifier: MIT
// The references themselves, against the 32-digit tables and against each other: nothing here is the kernel.
#include <gtest/gtest.h>

#include "reference/csv_table.h"
#include "reference/eigen_driven_body.h"
#include "reference/eigen_free_body.h"
#include "reference/eigen_impulse.h"
#include "reference/eigen_listing1.h"
#include "reference/free_body_table.h"
#include "reference/impulse_table.h"
#include "reference/measure.h"

namespace {

using namespace ingot_reference;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

double worst_against_table(const FreeBodyCase& body) {
    FreeBody reference(body.I, body.A_0, body.L);
    long double t = 0;
    double worst = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) {
        reference.advance(sample.t - t);
        t = sample.t;
        worst = std::max(worst, attitude_error(reference.A(), sample.A));
    }
    return worst;
}

/// Each radian turned adds a few roundings of long double to the modulus m, and the period of a tumbling body changes with m
/// like 1 / (1 - m).
double rounding_of_flight(const FreeBodyCase& body, long double one_minus_m) {
    const long double turned = body.samples.back().t * body.w_body_0.norm();
    return static_cast<double>(4 * turned * roundoff<long double> / one_minus_m);
}

TEST(FreeBodyReference, agrees_with_the_tables) {
    const CsvTable params("free_asymmetric_params.csv");
    for (const char* name : {"book", "dzhanibekov", "near_separatrix", "brick", "water", "near_symmetric", "fast", "slow"}) {
        const FreeBodyCase body("free_asymmetric", name);
        const long double m = params.number<long double>(params.row_with("case", name), "modulus_m");
        EXPECT_LE(worst_against_table(body), rounding_of_flight(body, 1 - m)) << name;
    }
    for (const char* name : {"oblate", "prolate", "disc", "sphere"}) {
        const FreeBodyCase body("free_symmetric", name);
        EXPECT_LE(worst_against_table(body), rounding_of_flight(body, 1)) << name;
    }
}

TEST(FreeBodyReference, runs_backwards) {
    const FreeBodyCase body("free_asymmetric", "book");
    FreeBody reference(body.I, body.A_0, body.L);
    reference.advance(20);
    EXPECT_GT(attitude_error(reference.A(), body.A_0), 0.1);
    reference.advance(-20);
    EXPECT_LE(attitude_error(reference.A(), body.A_0), 1e-17);  // 2 * 27 rad * 4 roundings / (1 - m): 2.2e-17, halved
}

/// Without torque it is the free body; its order is 4, so a step of 2^-10 s leaves |w|^5 h^4 t / 120 = 1e-13.
TEST(DrivenBodyReference, agrees_with_the_free_body) {
    const FreeBodyCase body("free_asymmetric", "book");
    FreeBody free(body.I, body.A_0, body.L);
    DrivenBody driven(body.I, body.A_0, body.L);
    free.advance(4);
    driven.advance(4, 4096, [](long double, const Square&) -> Column { return Column::Zero(); });
    EXPECT_LE(attitude_error(driven.A(), free.A()), 1e-12);
}

/// A body that turns about a principal axis under a torque tau about it: angle = tau t^2 / (2 I).
TEST(DrivenBodyReference, agrees_with_a_closed_form) {
    DrivenBody driven(Column(1, 2, 3), Square::Identity(), Column::Zero());
    driven.advance(2, 2048, [](long double, const Square&) { return Column(0, 0, 1.5L); });
    const Square expected = Eigen::AngleAxis<long double>(1.5L * 4 / (2 * 3), Column::UnitZ()).toRotationMatrix();
    EXPECT_LE(attitude_error(driven.A(), expected), 1e-14);  // (h^4 t w^5 / 120) = 2^-40 * 2 / 120
    EXPECT_LE(largest_difference(driven.L(), Column(0, 0, 3)), 1e-15);
}

/// Listing 1 is of first order: half the step, half the error, at 2 s with h = 2^-10 and 2^-11.
TEST(Listing1Reference, converges_to_the_free_body_with_order_1) {
    const FreeBodyCase body("free_asymmetric", "book");
    double error[2];
    for (int halving = 0; halving < 2; ++halving) {
        auto listing1 =
            Listing1Body<double>::initialised(1, body.I.cast<double>(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                              body.A_0.cast<double>(), body.L.cast<double>());
        const int steps = 2048 << halving;
        for (int step_i = 0; step_i < steps; ++step_i) listing1.step(2.0 / steps, {});
        FreeBody exact(body.I, body.A_0, body.L);
        exact.advance(2);
        error[halving] = attitude_error(listing1.A, exact.A());
        EXPECT_LE(orthogonality_defect(listing1.A), 1e-15);
        EXPECT_EQ(listing1.L, body.L.cast<double>());
    }
    EXPECT_NEAR(std::log2(error[0] / error[1]), 1, 0.05);
}

TEST(Listing1Reference, right_hand_sides_are_of_step_n) {
    using V = Eigen::Vector3d;
    auto body =
        Listing1Body<double>::initialised(2, V(1, 1, 1), V(1, 2, 3), V(4, 5, 6), Eigen::Matrix3d::Identity(), V(0, 0, 0));
    body.step(0.5, {{V(8, 0, 0), V(0, 0, 0)}, {V(0, 4, 0), V(1, 0, 0)}});
    EXPECT_EQ(body.r, V(3, 4.5, 6));                 // with v of step n
    EXPECT_EQ(body.v, V(6, 6, 6));                   // F = (8, 4, 0), M = 2
    EXPECT_EQ(body.L, V(0, 0, 2));                   // tau = (1,0,0) x (0,4,0)
    EXPECT_EQ(body.A, Eigen::Matrix3d::Identity());  // omega of step n was zero
    EXPECT_EQ(body.omega, V(0, 0, 2));
}

TEST(Figure4Reference, agrees_with_the_table) {
    const std::vector<ImpulseCase> rows = impulse_cases();
    ASSERT_EQ(rows.size(), 100u);
    for (const ImpulseCase& row : rows) {
        ImpulseBody<long double> A = row.A, B = row.B;
        const long double j = figure4_impulse(A, B, row.n, row.e);
        // 32 digits rounded to 64 bits: the speed of approach is a difference, up to 1e3 times smaller than its terms.
        ASSERT_NEAR(static_cast<double>(j / row.j), 1, 1e-15) << "row " << row.row;
        A.receive(j * row.n);
        B.receive(-j * row.n);
        ASSERT_LE(largest_difference(A.v, row.v_A_after), 1e-15 * (1 + length_of(row.A.v) + length_of(row.v_A_after)));
        ASSERT_LE(largest_difference(B.v, row.v_B_after), 1e-15 * (1 + length_of(row.B.v) + length_of(row.v_B_after)));
        ASSERT_LE(largest_difference(A.omega, row.omega_A_after),
                  1e-15 * (1 + length_of(row.A.omega) + length_of(row.omega_A_after)));
        ASSERT_LE(largest_difference(B.omega, row.omega_B_after),
                  1e-15 * (1 + length_of(row.B.omega) + length_of(row.omega_B_after)));
    }
}

}  // namespace
