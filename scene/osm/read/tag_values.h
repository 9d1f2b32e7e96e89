#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string_view>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

// How the values of OpenStreetMap's tags are written (wiki.openstreetmap.org, "Map features/Units").

/// "3.5", "3,5 m", "12'6\"", "10 Feet", "0.2 km", "15 cm", "~12", of a list "12;14" the first, in metres;
/// nullopt for anything else, or beyond 100 km.
std::optional<double> length_of(std::string_view value);
std::optional<double> length_of(const Tags& tags, std::string_view key);

/// A number without a unit, such as of levels or steps; of a list "1;3" the first.
std::optional<double> number_of(const Tags& tags, std::string_view key);

/// A degree, radians.
inline constexpr double kDegree = std::numbers::pi / 180.0;

/// "30" or "30°".
std::optional<double> degrees_of(const Tags& tags, std::string_view key);

/// "30", "30°", "NNE" in degrees clockwise from north.
std::optional<double> direction_of(const Tags& tags, std::string_view key);

/// The value is "yes" or another that doesn't say no.
bool affirmed(const Tags& tags, std::string_view key);

/// sRGB, 0 to 255.
using Color = std::array<std::uint8_t, 3>;

/// "#d0a080", "#da8" or a name of CSS that is in use, such as "brown"; nullopt for another.
std::optional<Color> color_of(std::string_view value);
std::optional<Color> color_of(const Tags& tags, std::string_view key, std::string_view american_key);

/// A building material's usual colour, such as that of "brick" or "roof_tiles".
std::optional<Color> material_color(std::string_view material);

}  // namespace campuswalk::scene::osm
