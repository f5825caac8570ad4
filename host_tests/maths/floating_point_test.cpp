// SPDX-License-Identifier: MIT
// check_floating_point() where the unit can be set from here; firmware/floating_point_main.cpp does it on every target.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <cfenv>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

using ingot::Status;

/// In a function of its own, so that nothing of it is computed in another mode.
__attribute__((noinline)) Status answer() { return ingot::check_floating_point(); }

TEST(FloatingPoint, rounds_to_nearest_and_keeps_denormals) { EXPECT_EQ(answer(), Status::ok); }

TEST(FloatingPoint, that_rounds_another_way_is_told) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ASSERT_EQ(std::fesetround(mode), 0);
        const Status status = answer();
        ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
        EXPECT_EQ(status, Status::wrong_rounding) << mode;
    }
    EXPECT_EQ(answer(), Status::ok);
}

#ifdef __SSE2__
TEST(FloatingPoint, that_flushes_what_comes_out_or_what_is_taken_in_is_told) {
    constexpr unsigned results_flushed = 1u << 15, operands_flushed = 1u << 6;  // FTZ, DAZ
    const unsigned good = _mm_getcsr();
    for (const unsigned bits : {results_flushed, operands_flushed, results_flushed | operands_flushed}) {
        _mm_setcsr(good | bits);
        const Status status = answer();
        _mm_setcsr(good);
        EXPECT_EQ(status, Status::flushes_denormals) << bits;
    }
}
#endif

}  // namespace
