#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// As reports spell them.
constexpr std::array<std::pair<Outcome, std::string_view>, 6> kOutcomeNames = {{
    {Outcome::passed, "passed"},
    {Outcome::failed, "failed"},
    {Outcome::skipped, "skipped"},
    {Outcome::bad_input, "bad_input"},
    {Outcome::broken, "broken"},
    {Outcome::interrupted, "interrupted"},
}};

constexpr std::string_view name_of(Outcome outcome) {
    for (const auto& [value, name] : kOutcomeNames) {
        if (value == outcome) {
            return name;
        }
    }
    return "";
}

}  // namespace campuswalk::engine
