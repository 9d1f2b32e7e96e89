#pragma once

#include <cstddef>
#include <string>

namespace campuswalk::scene {

/// Four significant digits: `0.05`, `1.234e+04`.
std::string short_number(double value);

/// `1.5 m`, with four significant digits.
std::string in_metres(double length);

/// `1 node`, `2 nodes`.
std::string plural(std::size_t count, const std::string& thing);

}  // namespace campuswalk::scene
