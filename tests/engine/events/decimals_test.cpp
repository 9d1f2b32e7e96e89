#include "engine/events/decimals.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/effort.h"

namespace campuswalk::engine {
namespace {

/// The C library's output, without the sign of a value that rounds to zero.
std::string printed(double value, int digits) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), "%.*f", digits, value);
    std::string all = text.data();
    if (all.front() == '-' && all.find_first_of("123456789") == std::string::npos) {
        all.erase(0, 1);
    }
    return all;
}

void expect_same(double value) {
    for (const int digits : {0, 1, 3, 6, 17}) {
        ASSERT_EQ(fixed(value, digits), printed(value, digits)) << std::hexfloat << value << " " << digits;
    }
}

TEST(Decimals, AreRoundedToNearest) {
    EXPECT_EQ(fixed(1.0 / 3.0, 3), "0.333");
    EXPECT_EQ(fixed(-2.0 / 3.0, 3), "-0.667");
    EXPECT_EQ(fixed(51.8333333, 6), "51.833333");
    EXPECT_EQ(fixed(999.9996, 3), "1000.000");
    EXPECT_EQ(fixed(7.0, 0), "7");
}

TEST(Decimals, RoundExactTiesToEven) {
    EXPECT_EQ(fixed(0.5, 0), "0");
    EXPECT_EQ(fixed(1.5, 0), "2");
    EXPECT_EQ(fixed(2.5, 0), "2");
    EXPECT_EQ(fixed(-2.5, 0), "-2");
    EXPECT_EQ(fixed(0.125, 2), "0.12");
    EXPECT_EQ(fixed(0.375, 2), "0.38");
    EXPECT_EQ(fixed(0.0625, 3), "0.062");
    // Written as a tie, but the nearest double lies below or above it.
    EXPECT_EQ(fixed(1.005, 2), "1.00");
    EXPECT_EQ(fixed(1.015, 2), "1.01");
    EXPECT_EQ(fixed(1.025, 2), "1.02");
    EXPECT_EQ(fixed(0.0005, 3), "0.001");
}

TEST(Decimals, PrintZeroWithoutASign) {
    EXPECT_EQ(fixed(-0.0, 3), "0.000");
    EXPECT_EQ(fixed(-0.0, 0), "0");
    EXPECT_EQ(fixed(-0.0004999, 3), "0.000");
    EXPECT_EQ(fixed(-5e-324, 6), "0.000000");
    EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
    EXPECT_EQ(fixed(Eigen::Vector3d(-0.0, -1e-9, -1.0)), "0.000,0.000,-1.000");
}

TEST(Decimals, PrintPointsToTheMillimetre) {
    EXPECT_EQ(fixed(Eigen::Vector3d(11.0024, 0.0, -7.3099)), "11.002,0.000,-7.310");
}

TEST(Decimals, PrintExtremeValuesInFull) {
    using Limits = std::numeric_limits<double>;
    for (const double value :
         {Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min(), 1e22, 1e23,
          9007199254740993.0, 4503599627370496.5, 0.1, 1e-7, 123456789.123456789}) {
        expect_same(value);
        expect_same(-value);
    }
}

TEST(Decimals, AgreeWithTheCLibraryOnRandomDoubles) {
    std::mt19937_64 bits(20240501);
    for (int i = 0; i < support::repeats(20000); ++i) {
        if (const double value = std::bit_cast<double>(bits()); std::isfinite(value)) {
            expect_same(value);
        }
    }
}

TEST(Decimals, AgreeWithTheCLibraryAroundTies) {
    std::mt19937_64 bits(7);
    for (int i = 0; i < support::repeats(20000); ++i) {
        // Odd multiples of 1/16 are ties at three digits; their neighbours are not.
        const auto odd = static_cast<double>(bits() % 2000000) * 2.0 + 1.0;
        const double tie = (i % 2 == 0 ? odd : -odd) / 16.0;
        expect_same(tie);
        expect_same(std::nextafter(tie, 1e9));
        expect_same(std::nextafter(tie, -1e9));
        const double thousandths = (odd / 2.0) / 1000.0;
        expect_same(thousandths);
    }
}

TEST(Decimals, IgnoreTheLocale) {
    struct Comma final : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string text = fixed(1234567.25, 3);
    std::locale::global(before);
    EXPECT_EQ(text, "1234567.250");
}

}  // namespace
}  // namespace campuswalk::engine
