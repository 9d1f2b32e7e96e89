#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/model/origin.h"

namespace campuswalk::scene {

/// Takes the white space out that follows an element's opening tag: assimp 5.2.5 refuses a COLLADA number
/// with a space before it, which XML allows and some exporters write.
void trim_element_starts(std::vector<std::uint8_t>& xml);

/// What a file says of the place of its origin on the Earth.
struct ColladaGeography {
    std::optional<GeographicPlace> place;  ///< its `at` is yet unknown
    std::string refused;                   ///< why what it says is no place; empty else
};

/// Reads COLLADA 1.5's <geographic_location> of the document's <asset>, which assimp passes over; some
/// exporters write it in 1.4, too. An <altitude> is the height, above the ground where it says so.
ColladaGeography read_geography(std::span<const std::uint8_t> xml);

}  // namespace campuswalk::scene
