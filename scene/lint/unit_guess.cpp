#include "scene/lint/unit_guess.h"

#include <array>

namespace campuswalk::scene {

std::optional<UnitGuess> guess_unit(double length, double min, double max) {
    constexpr std::array<UnitGuess, 7> kUnits = {{{"unit: cm", 0.01},
                                                  {"unit: mm", 0.001},
                                                  {"unit: in", 0.0254},
                                                  {"unit: ft", 0.3048},
                                                  {"scale: 100", 100.0},
                                                  {"scale: 1000", 1000.0},
                                                  {"scale: 10", 10.0}}};
    for (const UnitGuess& unit : kUnits) {
        if (length * unit.factor >= min && length * unit.factor <= max) {
            return unit;
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::scene
