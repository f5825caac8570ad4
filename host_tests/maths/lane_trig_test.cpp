// SPDX-License-Identifier: MIT
// Sine and cosine in lanes: against the library, over the range that they promise, and at the quarter turns.
#include <gtest/gtest.h>
#include <ingot/math/lane_trig.h>

#include <cmath>

#include "reference/random_input.h"

namespace {

using ingot::lane;
using ingot::lanes;
using ingot::scalar;

void expect_near(const scalar (&angles)[lanes]) {
    scalar sines[lanes], cosines[lanes];
    const auto found = ingot::lane_sin_cos(ingot::load(angles));
    ingot::store(sines, found.sin);
    ingot::store(cosines, found.cos);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const auto angle = static_cast<long double>(angles[lane_i]);
        // As sin_cos: a rounding or two, and what is left of the angle's reduction.
        const double allowed = 4 * static_cast<double>(ingot::epsilon);
        EXPECT_NEAR(static_cast<double>(sines[lane_i]), static_cast<double>(std::sin(angle)), allowed) << static_cast<double>(angle);
        EXPECT_NEAR(static_cast<double>(cosines[lane_i]), static_cast<double>(std::cos(angle)), allowed) << static_cast<double>(angle);
    }
}

TEST(LaneTrig, is_sine_and_cosine) {
    ingot_reference::RandomInput random(341);
    for (int i = 0; i < 20000; ++i) {
        scalar angles[lanes];
        for (scalar& angle : angles) angle = static_cast<scalar>(random.real(-1, 1) * (i % 3 == 0 ? 1000 : i % 3 == 1 ? 10 : 1e-3));
        expect_near(angles);
    }
    for (int quarter = -600; quarter <= 600; ++quarter) {
        scalar angles[lanes];
        for (scalar& angle : angles) angle = static_cast<scalar>(1.57079632679489661923L * quarter);
        expect_near(angles);
    }
}

TEST(LaneTrig, nearest_whole_number_is_the_nearest) {
    for (int whole = -1001; whole <= 1001; ++whole) {
        scalar x[lanes], rounded[lanes];
        for (const double aside : {-0.375, 0.0, 0.375}) {
            for (scalar& one : x) one = static_cast<scalar>(whole + aside);
            ingot::store(rounded, ingot::nearest_whole(ingot::load(x)));
            for (const scalar one : rounded) EXPECT_EQ(one, static_cast<scalar>(whole));
        }
    }
}

}  // namespace
