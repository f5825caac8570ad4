// SPDX-License-Identifier: MIT
// Formatting, against the C library's.
#include <ingot/platform/console.h>

#include <gtest/gtest.h>
#include <stdint.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace ingot::platform;

/// Numbers of every length, and the edges.
std::vector<uint64_t> numbers() {
    std::vector<uint64_t> list = {0, 1, 9, 10, 11, 99, 100, UINT32_MAX, INT64_MAX, uint64_t{1} << 63, UINT64_MAX - 1, UINT64_MAX};
    for (uint64_t power = 1; power < UINT64_MAX / 10; power *= 10) {
        list.push_back(power - 1);
        list.push_back(power);
        list.push_back(9 * power);
    }
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) list.push_back(random() >> (random() % 64));
    return list;
}

/// At least `digits` digits, with zeros in front.
std::string pad(std::string text, int digits) {
    const size_t wanted = static_cast<size_t>(digits);
    return text.size() < wanted ? std::string(wanted - text.size(), '0') + text : text;
}

TEST(ConsoleFormat, u64_equals_the_library) {
    for (const uint64_t value : numbers()) ASSERT_EQ(format_u64(value).text, std::to_string(value));
}

TEST(ConsoleFormat, whole_signed_numbers_equal_the_library) {
    for (const uint64_t bits : numbers()) {
        const int64_t value = static_cast<int64_t>(bits);
        ASSERT_EQ(format_decimal(value, 0).text, std::to_string(value));
    }
}

TEST(ConsoleFormat, hex_equals_the_library_at_every_width) {
    for (const uint64_t value : numbers()) {
        std::ostringstream hex;
        hex << std::hex << value;
        for (int digits = 1; digits <= 16; ++digits) ASSERT_EQ(format_hex(value, digits).text, "0x" + pad(hex.str(), digits));
    }
}

TEST(ConsoleFormat, the_decimal_point_only_splits_the_digits) {
    for (const uint64_t bits : numbers()) {
        const int64_t value = static_cast<int64_t>(bits);
        const std::string sign = value < 0 ? "-" : "";
        const std::string whole = std::to_string(value).substr(sign.size());
        for (int decimals = 1; decimals <= 18; ++decimals) {
            std::string digits = pad(whole, decimals + 1);
            digits.insert(digits.size() - static_cast<size_t>(decimals), ".");
            ASSERT_EQ(format_decimal(value, decimals).text, sign + digits);
        }
    }
}

TEST(ConsoleFormat, hex_clamps_the_width) {
    EXPECT_STREQ(format_hex(0, 0).text, "0x0");
    EXPECT_STREQ(format_hex(0, -5).text, "0x0");
    EXPECT_STREQ(format_hex(0xBEEF, 99).text, "0x000000000000beef");
}

TEST(ConsoleFormat, decimals_read_as_one_expects) {
    EXPECT_STREQ(format_decimal(5, 2).text, "0.05");
    EXPECT_STREQ(format_decimal(-1234, 3).text, "-1.234");
    EXPECT_STREQ(format_decimal(0, 3).text, "0.000");
    EXPECT_STREQ(format_decimal(INT64_MIN, 18).text, "-9.223372036854775808");
    EXPECT_STREQ(format_decimal(7, 99).text, "0.000000000000000007");
    EXPECT_STREQ(format_decimal(7, -1).text, "7");
}

TEST(Console, writes_to_standard_output) {
    testing::internal::CaptureStdout();
    console_write("ticks ");
    console_write_u64(42);
    console_write(" hash ");
    console_write_hex(0x30e74d42, 8);
    console_write(" ratio ");
    console_write_decimal(-1600, 3);
    console_write(" line ");
    console_write_i64(-7);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "ticks 42 hash 0x30e74d42 ratio -1.600 line -7");
}

TEST(ConsoleDeathTest, exit_code_is_the_status_of_the_process) {
    EXPECT_EXIT(console_exit(0), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(console_exit(3), testing::ExitedWithCode(3), "");
}

}  // namespace
