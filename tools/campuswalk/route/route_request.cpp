#include "tools/campuswalk/route/route_request.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools::route {

namespace {

constexpr double kFarthest = 1e7;  // metres

std::optional<double> coordinate(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && end == text.data() + text.size() && std::isfinite(value) &&
                      std::abs(value) <= kFarthest;
    return good ? std::optional(value) : std::nullopt;
}

}  // namespace

engine::Target parse_target(const scene::CampusDescription& campus, const std::string& text,
                            const std::string& option) {
    std::vector<std::string> names;
    for (const scene::Place& place : campus.places) {
        if (place.name == text) {
            return {text, place.position, place.has_height};
        }
        names.push_back(place.name);
    }
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == text) {
            return {text, spawn.position, true};
        }
        names.push_back(spawn.name);
    }
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() == 1) {
        throw scene::InputError(
            {option, 1, 1}, "unknown-name",
            "the campus has no place or spawn '" + text + "'" + scene::did_you_mean(text, names));
    }
    std::vector<double> numbers;
    for (const std::string_view part : parts) {
        if (const auto number = coordinate(part)) {
            numbers.push_back(*number);
        }
    }
    if (numbers.size() != parts.size() || numbers.size() > 3) {
        throw scene::InputError({option, 1, 1}, "bad-value",
                                "'" + text + "' is neither a name nor x,z nor x,y,z in metres");
    }
    const bool has_height = numbers.size() == 3;
    return {text, {numbers.front(), has_height ? numbers[1] : 0.0, numbers.back()}, has_height};
}

}  // namespace campuswalk::tools::route
