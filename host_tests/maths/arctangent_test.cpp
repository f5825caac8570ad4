// SPDX-License-Identifier: MIT
// Arc tangent in lanes: against the library, in all directions and of all sizes.
#include <gtest/gtest.h>
#include <ingot/math/arctangent.h>

#include <cmath>

#include "reference/random_input.h"

namespace {

using ingot::lane;
using ingot::lanes;
using ingot::scalar;

/// 2 ulp of the result; epsilon is that of 1, and a number has up to twice of it relative to itself.
void expect_near(const scalar (&y)[lanes], const scalar (&x)[lanes]) {
    scalar found[lanes];
    ingot::store(found, ingot::arctangent(ingot::load(y), ingot::load(x)));
    for (int i = 0; i < lanes; ++i) {
        const long double exact = std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i]));
        const double allowed = 2 * static_cast<double>(ingot::epsilon) * static_cast<double>(std::abs(exact));
        EXPECT_NEAR(static_cast<double>(found[i]), static_cast<double>(exact), allowed) << static_cast<double>(y[i] / x[i]);
        EXPECT_EQ(ingot::arctangent(y[i], x[i]), found[i]);
    }
}

TEST(Arctangent, is_the_angle_of_a_point) {
    ingot_reference::RandomInput random(342);
    for (int i = 0; i < 20000; ++i) {
        scalar y[lanes], x[lanes];
        for (int k = 0; k < lanes; ++k) {
            y[k] = static_cast<scalar>(random.real(-1, 1) * std::pow(10.0, random.integer(-6, 6)));
            x[k] = static_cast<scalar>(random.real(-1, 1) * (i % 3 == 0 ? 1 : std::pow(10.0, random.integer(-6, 6))));
        }
        expect_near(y, x);
    }
}

TEST(Arctangent, is_exact_on_the_axes) {
    EXPECT_EQ(ingot::arctangent(scalar(0), scalar(0)), 0);
    EXPECT_EQ(ingot::arctangent(scalar(0), scalar(3)), 0);
    EXPECT_EQ(ingot::arctangent(scalar(2), scalar(0)), scalar(1.57079632679489661923));
    EXPECT_EQ(ingot::arctangent(scalar(-2), scalar(0)), scalar(-1.57079632679489661923));
    EXPECT_EQ(ingot::arctangent(scalar(0), scalar(-3)), scalar(3.14159265358979323846));
}

}  // namespace
