#include "scene/lint/wording.h"

#include <array>
#include <cstdio>

namespace campuswalk::scene {

std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string in_metres(double length) {
    return short_number(length) + " m";
}

std::string plural(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace campuswalk::scene
