#include "engine/events/decimals.h"

#include <array>
#include <cassert>
#include <charconv>
#include <string_view>
#include <system_error>

namespace campuswalk::engine {

std::string fixed(double value, int digits) {
    std::array<char, 400> text{};  // the longest double has a sign, 309 digits and a point
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
    assert(error == std::errc());
    static_cast<void>(error);
    const std::string_view all(text.data(), static_cast<std::size_t>(end - text.data()));
    const bool is_minus_zero = all.starts_with('-') && all.find_first_not_of("-0.") == std::string_view::npos;
    return std::string(is_minus_zero ? all.substr(1) : all);
}

std::string fixed(const Eigen::Vector3d& value) {
    return fixed(value.x(), 3) + "," + fixed(value.y(), 3) + "," + fixed(value.z(), 3);
}

std::string coordinates_text(const Eigen::Vector3d& place) {
    return fixed(place.x(), 2) + ", " + fixed(place.y(), 2) + ", " + fixed(place.z(), 2);
}

std::string hexadecimal(std::uint64_t value) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
    const std::string text(digits.data(), end);
    return std::string(digits.size() - text.size(), '0') + text;
}

}  // namespace campuswalk::engine
