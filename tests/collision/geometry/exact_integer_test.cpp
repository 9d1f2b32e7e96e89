#include "collision/geometry/exact_integer.h"

#include <CGAL/Exact_integer.h>
#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::collision {
namespace {

using CGAL::Exact_integer;
using support::Dice;

Exact_integer power_of_two(std::size_t exponent) {
    Exact_integer power = 1;
    return power <<= exponent;
}

template <std::size_t kDigits>
Exact_integer value(const ExactInteger<kDigits>& x) {
    Exact_integer sum = x.negative() ? Exact_integer(-power_of_two(32 * kDigits)) : Exact_integer(0);
    for (std::size_t i = 0; i < kDigits; ++i) {
        sum += power_of_two(32 * i) * x.digits[i];
    }
    return sum;
}

/// Many digits are all zeros or all ones, so that carries propagate far.
template <std::size_t kDigits>
ExactInteger<kDigits> random_number(Dice& dice) {
    ExactInteger<kDigits> x;
    for (std::uint32_t& digit : x.digits) {
        const auto any = static_cast<std::uint32_t>(dice.between(0.0, 4294967296.0));
        digit = dice.chance(0.3) ? 0U : dice.chance(0.4) ? ~0U : dice.chance(0.2) ? 1U << (any % 32) : any;
    }
    return x;
}

template <std::size_t kX, std::size_t kY>
void expect_exact_products(Dice& dice) {
    for (int i = 0; i < support::repeats(2000); ++i) {
        const auto x = random_number<kX>(dice);
        const auto y = random_number<kY>(dice);
        ASSERT_EQ(value(x * y), Exact_integer(value(x) * value(y))) << kX << ' ' << kY << ' ' << i;
    }
}

TEST(ExactInteger, ProductsAreExact) {
    Dice dice(1);
    expect_exact_products<1, 1>(dice);
    expect_exact_products<2, 2>(dice);
    expect_exact_products<2, 4>(dice);
    expect_exact_products<4, 2>(dice);
    expect_exact_products<5, 7>(dice);
}

TEST(ExactInteger, DifferencesThatFitAreExact) {
    Dice dice(2);
    const Exact_integer limit = power_of_two(127);
    int fitting = 0;
    for (int i = 0; i < support::repeats(4000); ++i) {
        const auto x = random_number<4>(dice);
        const auto y = random_number<4>(dice);
        const Exact_integer difference = value(x) - value(y);
        if (difference >= -limit && difference < limit) {
            ASSERT_EQ(value(x - y), difference) << i;
            ++fitting;
        }
    }
    EXPECT_GT(fitting, support::repeats(2000));
}

TEST(ExactInteger, SignMatchesTheValue) {
    Dice dice(3);
    for (int i = 0; i < support::repeats(2000); ++i) {
        const auto x = random_number<3>(dice);
        const Exact_integer exact = value(x);
        ASSERT_EQ(sign(x), exact < 0 ? -1 : exact > 0 ? 1 : 0) << i;
    }
    EXPECT_EQ(sign(ExactInteger<3>()), 0);
}

TEST(ExactInteger, ShiftsByUpTo200BitsAreExact) {
    for (int shift = 0; shift <= 200; ++shift) {
        for (const std::uint64_t magnitude : {std::uint64_t{1}, (std::uint64_t{1} << 53) - 1}) {
            const Exact_integer exact = power_of_two(static_cast<std::size_t>(shift)) * magnitude;
            EXPECT_EQ(value(shifted<8>(magnitude, shift, false)), exact) << shift;
            EXPECT_EQ(value(shifted<8>(magnitude, shift, true)), Exact_integer(-exact)) << shift;
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision
