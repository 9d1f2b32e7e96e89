#pragma once

#include <optional>

namespace campuswalk::scene {

/// How lengths that were read as metres may be meant.
struct UnitGuess {
    const char* yaml = "";  ///< `unit: cm` or `scale: 100`
    double factor = 1.0;    ///< metres per unit
};

/// The first of centimetres, millimetres, inches, feet and their inverses that brings the length into the
/// range.
std::optional<UnitGuess> guess_unit(double length, double least, double most);

}  // namespace campuswalk::scene
