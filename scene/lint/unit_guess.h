#pragma once

#include <optional>

namespace campuswalk::scene {

/// A unit that the author may have meant, where metres were assumed.
struct UnitGuess {
    const char* yaml = "";  ///< `unit: cm` or `scale: 100`
    double factor = 1.0;    ///< metres per unit
};

/// The first common unit or power of ten that brings `length` into [min, max].
std::optional<UnitGuess> guess_unit(double length, double min, double max);

}  // namespace campuswalk::scene
