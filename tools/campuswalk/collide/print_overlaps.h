#pragma once

#include <cstdint>

#include "tools/campuswalk/collide/overlaps.h"

namespace campuswalk::tools::collide {

/// What is told of the overlaps.
enum class Told : std::uint8_t {
    all,    ///< every pair or triangle, and how many there are
    one,    ///< one of them
    count,  ///< how many there are
};

// To standard output.

/// A line about the bodies, a line a pair or triangle (`a 12 b 907 "node of a" "node of b"`, `b 907 "node"`)
/// and one with the verdict; of Told::count the number alone.
void print_text(const Body& a, const Body& b, const Overlaps& overlaps, Told told);

void print_json(const Body& a, const Body& b, const Overlaps& overlaps, Told told);

}  // namespace campuswalk::tools::collide
