#include "collision/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "collision/geometry/exact_integer.h"

namespace campuswalk::collision {

namespace {

// First a determinant in doubles, which decides unless it is near 0; then one in integers.
//
// The error bound of the first. Every operation below yields (x op y)(1 + e), |e| <= u = 2^-53: sums and
// differences always, products where they don't underflow. Multiplied out, the determinant is a sum of
// products of differences, each of which is computed times at most n factors (1 + e). In space n = 8: 3 from
// the differences, 2 from the minor, 1 from the third factor, 2 from the sum; in the plane n = 4: 2, 1 and 1.
// So the error is at most ((1 + u)^n - 1) S, where S is the sum of the true products' magnitudes. `size` sums
// the magnitudes of the rounded ones, with at most n + 1 factors, hence S <= size / (1 - u)^(n + 1).
// Together, the error is below n u (1 + 100 u) size, and (n + 1) u size, rounded, is more.
//
// Each product that underflows is off by at most 2^-1075. The 2 in a minor are magnified by the third factor:
// kTiny = 2^-1022 among the minor's magnitudes adds 9 u kTiny = 9 x 2^-1075, magnified alike, to the bound.
// The underflow of the other products, in the determinant and in its bound, amounts to a few 2^-1075, which
// kTiny added to the bound covers. An overflow makes the bound infinite or NaN, which no determinant exceeds.

constexpr double kUnit = 0x1p-53;
constexpr double kTiny = std::numeric_limits<double>::min();
constexpr int kUndecided = 2;

int sign_beyond(double determinant, double bound) {
    return determinant > bound ? 1 : determinant < -bound ? -1 : kUndecided;
}

int quick_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 p = a - d;
    const Vec3 q = b - d;
    const Vec3 r = c - d;
    const double pq = p.x() * q.y();
    const double qp = q.x() * p.y();
    const double qr = q.x() * r.y();
    const double rq = r.x() * q.y();
    const double rp = r.x() * p.y();
    const double pr = p.x() * r.y();
    const double determinant = p.z() * (qr - rq) + q.z() * (rp - pr) + r.z() * (pq - qp);
    const double size = std::abs(p.z()) * (std::abs(qr) + std::abs(rq) + kTiny) +
                        std::abs(q.z()) * (std::abs(rp) + std::abs(pr) + kTiny) +
                        std::abs(r.z()) * (std::abs(pq) + std::abs(qp) + kTiny);
    return sign_beyond(determinant, 9.0 * kUnit * size + kTiny);
}

int quick_orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    return sign_beyond(left - right, 5.0 * kUnit * (std::abs(left) + std::abs(right)) + kTiny);
}

// The rest is in integers. The sign doesn't depend on an axis' scale, so the unit of each axis is a power of
// two that all its coordinates are multiples of. Coordinates with magnitudes below 2^width have differences
// below 2^(width + 1), minors below 2^(2 width + 3) and a determinant below 2^(3 width + 6), each with one
// more bit for its sign.

/// The greatest width with 3 width + 7 <= 3 x 32 kDigits.
template <std::size_t kDigits>
constexpr int kRoom = 32 * static_cast<int>(kDigits) - 3;

template <std::size_t kDimension>
using Points = std::array<const double*, kDimension + 1>;

/// The first points relative to the last, one per row.
template <typename Integer, std::size_t kDimension>
using Differences = std::array<std::array<Integer, kDimension>, kDimension>;

template <typename Integer>
auto determinant(const Differences<Integer, 2>& m) {
    return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

template <typename Integer>
auto determinant(const Differences<Integer, 3>& m) {
    const auto minor = [&](std::size_t i, std::size_t j) { return m[i][0] * m[j][1] - m[i][1] * m[j][0]; };
    // With rows swapped where a sign would make it a sum.
    return m[0][2] * minor(1, 2) - m[1][2] * minor(0, 2) - m[2][2] * minor(1, 0);
}

int sign(std::int64_t x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

constexpr int kFractionBits = 52;

int exponent_field(double x) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> kFractionBits) & 0x7ff;
}

/// The differences along one axis, in the greatest possible unit, if the coordinates fit 64-bit words.
template <std::size_t kDimension>
bool differences_in_words(const Points<kDimension>& points, std::size_t axis,
                          Differences<std::int64_t, kDimension>& rows) {
    double largest = 0.0;
    for (const double* p : points) {
        largest = std::max(largest, std::abs(p[axis]));
    }
    if (largest == 0.0) {
        return true;
    }
    constexpr int kScaledField = 1023 + kRoom<2> - 1;  // of 2^60 to 2^61
    const int scale_field = kScaledField + 1023 - exponent_field(largest);
    if (scale_field >= 0x7ff) {
        return false;
    }
    const auto scale = std::bit_cast<double>(static_cast<std::uint64_t>(scale_field) << kFractionBits);
    std::array<std::int64_t, kDimension + 1> x{};
    for (std::size_t i = 0; i <= kDimension; ++i) {
        const double scaled = points[i][axis] * scale;
        x[i] = static_cast<std::int64_t>(scaled);
        const bool vanished = x[i] == 0 && points[i][axis] != 0.0;
        if (vanished || static_cast<double>(x[i]) != scaled) {
            return false;
        }
    }
    std::int64_t bits = 0;
    for (std::size_t i = 0; i < kDimension; ++i) {
        rows[i][axis] = x[i] - x[kDimension];
        bits |= rows[i][axis];
    }
    const int zeros = bits == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(bits));
    for (auto& row : rows) {
        row[axis] >>= zeros;
    }
    return true;
}

/// For coordinates of similar size with trailing zero bits, such as converted float32; on lattices, where
/// there are more, products fit words, too.
template <std::size_t kDimension>
int word_orientation(const Points<kDimension>& points) {
    Differences<std::int64_t, kDimension> rows{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
        if (!differences_in_words<kDimension>(points, axis, rows)) {
            return kUndecided;
        }
    }
    constexpr auto kShort = std::int64_t{1} << 60 / kDimension;  // 2 or 6 products stay below 2^63
    bool is_short = true;
    Differences<ExactInteger<2>, kDimension> integers{};
    for (std::size_t i = 0; i < kDimension; ++i) {
        for (std::size_t axis = 0; axis < kDimension; ++axis) {
            const std::int64_t x = rows[i][axis];
            is_short = is_short && -kShort < x && x < kShort;
            integers[i][axis].digits = {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(x >> 32)};
        }
    }
    return is_short ? sign(determinant(rows)) : sign(determinant(integers));
}

/// odd 2^exponent, or minus that; 0 if `odd` is.
struct Binary {
    std::uint64_t odd = 0;
    int exponent = 0;
    bool negative = false;
};

Binary binary(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << kFractionBits) - 1);
    const int field = exponent_field(x);
    const std::uint64_t mantissa = field == 0 ? fraction : fraction | std::uint64_t{1} << kFractionBits;
    if (mantissa == 0) {
        return {};
    }
    const int zeros = std::countr_zero(mantissa);
    return {mantissa >> zeros, std::max(field, 1) - 1075 + zeros, bits >> 63 != 0};
}

template <std::size_t kDimension>
struct ExactPoints {
    std::array<std::array<Binary, kDimension>, kDimension + 1> points{};
    std::array<int, kDimension> units{};  ///< exponents of two
    int width = 0;
};

template <std::size_t kDimension>
ExactPoints<kDimension> exact_points(const Points<kDimension>& points) {
    ExactPoints<kDimension> result;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
        int low = std::numeric_limits<int>::max();
        int high = std::numeric_limits<int>::min();
        for (std::size_t i = 0; i <= kDimension; ++i) {
            const Binary x = binary(points[i][axis]);
            result.points[i][axis] = x;
            if (x.odd != 0) {
                low = std::min(low, x.exponent);
                high = std::max(high, x.exponent + static_cast<int>(std::bit_width(x.odd)));
            }
        }
        if (low < high) {
            result.units[axis] = low;
            result.width = std::max(result.width, high - low);
        }
    }
    return result;
}

template <std::size_t kDigits, std::size_t kDimension>
int long_orientation(const ExactPoints<kDimension>& exact) {
    Differences<ExactInteger<kDigits>, kDimension> rows{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const auto counted = [&](std::size_t i) {
            const Binary& x = exact.points[i][axis];
            return x.odd == 0 ? ExactInteger<kDigits>()
                              : shifted<kDigits>(x.odd, x.exponent - exact.units[axis], x.negative);
        };
        const ExactInteger<kDigits> last = counted(kDimension);
        for (std::size_t i = 0; i < kDimension; ++i) {
            rows[i][axis] = counted(i) - last;
        }
    }
    return sign(determinant(rows));
}

template <std::size_t kDimension>
int exact_orientation(const Points<kDimension>& points) {
    if (const int decided = word_orientation<kDimension>(points); decided != kUndecided) {
        return decided;
    }
    constexpr std::size_t kFew = 4;
    constexpr std::size_t kSome = 8;
    constexpr std::size_t kMax = 66;
    static_assert(kRoom<kMax> >= 1024 + 1074, "from 2^-1074 to 2^1024");
    const ExactPoints<kDimension> exact = exact_points<kDimension>(points);
    if (exact.width <= kRoom<kFew>) {
        return long_orientation<kFew>(exact);
    }
    return exact.width <= kRoom<kSome> ? long_orientation<kSome>(exact) : long_orientation<kMax>(exact);
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int quick = quick_orientation(a, b, c, d);
    return quick != kUndecided ? quick : exact_orientation<3>({a.data(), b.data(), c.data(), d.data()});
}

int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const int quick = quick_orientation(a, b, c);
    return quick != kUndecided ? quick : exact_orientation<2>({a.data(), b.data(), c.data()});
}

}  // namespace campuswalk::collision
