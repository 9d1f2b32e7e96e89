#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace campuswalk::collision {

/// An integer of `kDigits` 32-bit digits, lowest first, in two's complement: from -2^(n-1) to 2^(n-1) - 1,
/// where n = 32 kDigits. A difference is as wide as its terms, and the caller ensures that it fits; a product
/// is as wide as both factors together, which always fits.
template <std::size_t kDigits>
struct ExactInteger {
    std::array<std::uint32_t, kDigits> digits{};

    bool negative() const { return digits.back() >> 31 != 0; }
};

/// -1, 0 or 1.
template <std::size_t kDigits>
int sign(const ExactInteger<kDigits>& x) {
    if (x.negative()) {
        return -1;
    }
    return x.digits == ExactInteger<kDigits>().digits ? 0 : 1;
}

/// x -= y 2^(32 places), without the digits beyond x's.
template <std::size_t kDigits, std::size_t kOther>
void subtract(ExactInteger<kDigits>& x, const ExactInteger<kOther>& y, std::size_t places) {
    static_assert(kOther <= kDigits);
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < kOther && i + places < kDigits; ++i) {
        const std::uint64_t digit = std::uint64_t{x.digits[i + places]} - y.digits[i] - borrow;
        x.digits[i + places] = static_cast<std::uint32_t>(digit);
        borrow = digit >> 63;
    }
}

template <std::size_t kDigits>
ExactInteger<kDigits> operator-(ExactInteger<kDigits> x, const ExactInteger<kDigits>& y) {
    subtract(x, y, 0);
    return x;
}

template <std::size_t kX, std::size_t kY>
ExactInteger<kX + kY> operator*(const ExactInteger<kX>& x, const ExactInteger<kY>& y) {
    ExactInteger<kX + kY> product;
    for (std::size_t i = 0; i < kX; ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < kY; ++j) {
            carry += std::uint64_t{x.digits[i]} * y.digits[j] + product.digits[i + j];
            product.digits[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        product.digits[i + kY] = static_cast<std::uint32_t>(carry);
    }
    // The digits were multiplied as unsigned: a negative factor counted as 2^n more than its value.
    if (x.negative()) {
        subtract(product, y, kX);
    }
    if (y.negative()) {
        subtract(product, x, kY);
    }
    return product;
}

/// magnitude 2^shift, or minus that; the caller ensures that it fits.
template <std::size_t kDigits>
ExactInteger<kDigits> shifted(std::uint64_t magnitude, int shift, bool negative) {
    const auto first = static_cast<std::size_t>(shift / 32);
    const int rest = shift % 32;
    const std::uint64_t low = magnitude << rest;
    const std::uint64_t high = rest == 0 ? 0 : magnitude >> (64 - rest);
    const std::array<std::uint64_t, 3> digits{low, low >> 32, high};
    ExactInteger<kDigits> result;
    for (std::size_t i = 0; i < digits.size() && first + i < kDigits; ++i) {
        result.digits[first + i] = static_cast<std::uint32_t>(digits[i]);
    }
    return negative ? ExactInteger<kDigits>() - result : result;
}

}  // namespace campuswalk::collision
