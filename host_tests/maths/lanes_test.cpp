// SPDX-License-Identifier: MIT
// Every lane function does in each lane what it says it does to one number.
#include <gtest/gtest.h>
#include <ingot/math/rotation.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "reference/random_input.h"

namespace {

using ingot::both;
using ingot::lane;
using ingot::lanes;
using ingot::mask;
using ingot::scalar;
using ingot_reference::RandomInput;
using Numbers = std::array<scalar, lanes>;

/// Lanes full of numbers of all kinds: of any size, denormal, zero of both signs, infinite, NaN.
Numbers random_numbers(RandomInput& random) {
    using limit = std::numeric_limits<scalar>;
    const scalar special[] = {0,
                              scalar(-0.0),
                              limit::infinity(),
                              -limit::infinity(),
                              limit::max(),
                              limit::denorm_min(),
                              limit::min(),
                              limit::quiet_NaN()};
    Numbers numbers;
    for (scalar& x : numbers)
        x = random.integer(0, 3) == 0 ? special[random.integer(0, 7)] : static_cast<scalar>(random.of_any_size(-30, 30));
    return numbers;
}

lane lanes_of(const Numbers& numbers) { return ingot::load(numbers.data()); }

Numbers numbers_of(lane value) {
    Numbers numbers;
    ingot::store(numbers.data(), value);
    return numbers;
}

/// What bits() of a mask has to be: `meaning` of each lane, lane 0 lowest.
template <class Meaning>
unsigned expected_bits(Meaning meaning) {
    unsigned b = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) b |= meaning(static_cast<size_t>(lane_i)) ? 1u << lane_i : 0u;
    return b;
}

/// Bitwise, except that one NaN is as good as another.
::testing::AssertionResult same(scalar a, scalar b) {
    if (std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b))) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << a << " is not " << b;
}

template <class Meaning>
void expect_lanes(lane value, Meaning meaning) {
    const Numbers computed = numbers_of(value);
    for (size_t lane_i = 0; lane_i < computed.size(); ++lane_i)
        ASSERT_TRUE(same(computed[lane_i], meaning(lane_i))) << "lane " << lane_i;
}

TEST(Lanes, load_and_store_keep_every_bit) {
    RandomInput random(51);
    for (int i = 0; i < 1000; ++i) {
        const Numbers numbers = random_numbers(random);
        const Numbers back = numbers_of(lanes_of(numbers));
        ASSERT_EQ(std::memcmp(back.data(), numbers.data(), sizeof numbers), 0);
    }
}

TEST(Lanes, splat_is_one_value_in_every_lane) {
    for (const scalar x : {scalar(3), scalar(-0.125), std::numeric_limits<scalar>::infinity()})
        expect_lanes(ingot::splat<lane>(x), [&](size_t) { return x; });
}

TEST(Lanes, arithmetic_is_that_of_the_scalar) {
    RandomInput random(52);
    for (int i = 0; i < 1000; ++i) {
        const Numbers a = random_numbers(random), b = random_numbers(random);
        expect_lanes(lanes_of(a) + lanes_of(b), [&](size_t k) { return a[k] + b[k]; });
        expect_lanes(lanes_of(a) - lanes_of(b), [&](size_t k) { return a[k] - b[k]; });
        expect_lanes(lanes_of(a) * lanes_of(b), [&](size_t k) { return a[k] * b[k]; });
        expect_lanes(lanes_of(a) / lanes_of(b), [&](size_t k) { return a[k] / b[k]; });
    }
}

TEST(Lanes, abs_and_sqrt_are_those_of_the_scalar) {
    RandomInput random(53);
    for (int i = 0; i < 1000; ++i) {
        const Numbers a = random_numbers(random);
        expect_lanes(ingot::abs(lanes_of(a)), [&](size_t k) { return std::abs(a[k]); });
        expect_lanes(ingot::sqrt(lanes_of(a)), [&](size_t k) { return std::sqrt(a[k]); });
    }
}

TEST(Lanes, bits_name_the_lanes_of_a_mask) {
    RandomInput random(54);
    for (int i = 0; i < 1000; ++i) {
        const Numbers a = random_numbers(random), b = random_numbers(random);
        const mask less = lanes_of(a) < lanes_of(b);
        ASSERT_EQ(ingot::bits(less), expected_bits([&](size_t k) { return a[k] < b[k]; }));
        ASSERT_EQ(ingot::any(less), ingot::bits(less) != 0);
        ASSERT_EQ(ingot::bits(both(less, lanes_of(b) < lane{})),
                  expected_bits([&](size_t k) { return a[k] < b[k] && b[k] < 0; }));
        ASSERT_EQ(ingot::bits(ingot::is_finite(lanes_of(a))), expected_bits([&](size_t k) { return std::isfinite(a[k]); }));
    }
}

TEST(Lanes, any_sees_a_single_lane) {
    EXPECT_FALSE(ingot::any(lane{} < lane{}));
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        Numbers one = {};
        one[static_cast<size_t>(lane_i)] = 1;
        EXPECT_TRUE(ingot::any(lanes_of(one) > lane{})) << lane_i;
        EXPECT_EQ(ingot::bits(lanes_of(one) > lane{}), 1u << lane_i);
    }
}

TEST(Lanes, mask_from_bits_is_the_inverse_of_bits) {
    for (unsigned b = 0; b < 1u << lanes; ++b) {
        const mask m = ingot::mask_from_bits(static_cast<std::uint16_t>(b));
        ASSERT_EQ(ingot::bits(m), b);
        ASSERT_EQ(ingot::any(m), b != 0);
        expect_lanes(ingot::select(m, ingot::splat<lane>(1), ingot::splat<lane>(2)),
                     [&](size_t k) { return (b >> k & 1u) != 0 ? scalar(1) : scalar(2); });
    }
    EXPECT_EQ(ingot::bits(ingot::mask_from_bits(0xFFFF)), (1u << lanes) - 1) << "bits beyond the last lane are nobody's";
}

TEST(Lanes, select_takes_each_lane_from_its_side) {
    RandomInput random(55);
    for (int i = 0; i < 1000; ++i) {
        const Numbers a = random_numbers(random), b = random_numbers(random), c = random_numbers(random);
        expect_lanes(ingot::select(lanes_of(a) < lanes_of(b), lanes_of(b), lanes_of(c)),
                     [&](size_t k) { return a[k] < b[k] ? b[k] : c[k]; });
    }
}

#if INGOT_LANES > 1

/// The nine numbers of a matrix, for `lanes` bodies, all finite.
struct Bodies {
    scalar rows[9][lanes];
    explicit Bodies(RandomInput& random) {
        for (auto& row : rows)
            for (scalar& x : row) x = static_cast<scalar>(random.real(-2, 2));
    }
    ingot::Mat3<lane> wide() const { return ingot::load(rows); }
    ingot::Matrix of_lane(int lane_i) const {
        return {{rows[0][lane_i], rows[1][lane_i], rows[2][lane_i]},
                {rows[3][lane_i], rows[4][lane_i], rows[5][lane_i]},
                {rows[6][lane_i], rows[7][lane_i], rows[8][lane_i]}};
    }
};

/// Writes the numbers of a Vec3, Sym3 or Mat3 of scalars, or of one lane of lanes, one after the other.
class Flat {
public:
    explicit Flat(int lane_i) : lane_i_(lane_i) {}
    void put(scalar x) { text_ += std::to_string(x) + " ", numbers_.push_back(x); }
    void put(lane x) { put(numbers_of(x)[static_cast<size_t>(lane_i_)]); }
    template <class T>
    void put(const ingot::Vec3<T>& v) {
        put(v.x), put(v.y), put(v.z);
    }
    template <class T>
    void put(const ingot::Mat3<T>& m) {
        put(m.c0), put(m.c1), put(m.c2);
    }
    template <class T>
    void put(const ingot::Sym3<T>& s) {
        put(s.xx), put(s.yy), put(s.zz), put(s.xy), put(s.xz), put(s.yz);
    }
    bool operator==(const Flat& other) const {
        return numbers_.size() == other.numbers_.size() &&
               std::memcmp(numbers_.data(), other.numbers_.data(), numbers_.size() * sizeof(scalar)) == 0;
    }
    friend std::ostream& operator<<(std::ostream& out, const Flat& flat) { return out << flat.text_; }

private:
    int lane_i_;
    std::vector<scalar> numbers_;
    std::string text_;
};

/// The maths written over T, for the lane and for the scalar: the same operations give the same bits.
template <class T>
void all_maths(const ingot::Mat3<T>& a, const ingot::Mat3<T>& b, Flat& out) {
    out.put(a + b);
    out.put(a - b);
    out.put(a * b);
    out.put(a * b.c0);
    out.put(a * b.c0.x);
    out.put(transpose_times(a, b.c0));
    out.put(transposed(a));
    out.put(determinant(a));
    out.put(dot(a.c0, b.c0));
    out.put(cross(a.c0, b.c0));
    out.put(scaled(a.c0, b.c0));
    out.put(ingot::tilde(a.c0));
    out.put(gram(a));
    out.put(rotated_diagonal(a, b.c0));
    out.put(rotated(a, gram(b)));
    out.put(a * gram(b));
    out.put(gram(a) * b.c0);
    out.put(gram(a) + gram(b) - gram(a) * b.c0.x);
    out.put(ingot::polar_correction(a));
    out.put(ingot::reorthogonalized(a));
    out.put(ingot::identity_matrix<T>());
    out.put(select(a.c0.x < b.c0.x, a, b));
}

TEST(Lanes, maths_over_lanes_has_the_bits_of_the_scalar) {
    RandomInput random(56);
    for (int i = 0; i < 200; ++i) {
        const Bodies a(random), b(random);
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            Flat wide(lane_i), alone(lane_i);
            all_maths(a.wide(), b.wide(), wide);
            all_maths(a.of_lane(lane_i), b.of_lane(lane_i), alone);
            ASSERT_EQ(wide, alone) << "lane " << lane_i;
        }
    }
}

#endif

}  // namespace
