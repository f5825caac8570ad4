// SPDX-License-Identifier: MIT
#include <ingot/platform/fault.h>

#include <gtest/gtest.h>

namespace {

TEST(FaultDeathTest, says_what_and_where) {
    EXPECT_DEATH(ingot_fault("count <= capacity", "rows.cpp", 12), "rows.cpp:12: ingot fault: count <= capacity");
}

TEST(FaultDeathTest, survives_null_pointers) { EXPECT_DEATH(ingot_fault(nullptr, nullptr, 0), "\\?:0: ingot fault: \\?"); }

}  // namespace
