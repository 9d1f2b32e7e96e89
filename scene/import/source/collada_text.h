#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/model/origin.h"

namespace campuswalk::scene {

/// Removes white space after tags: assimp 5.2.5 rejects numbers with leading white space, which XML allows
/// and some exporters write.
void trim_element_starts(std::vector<std::uint8_t>& xml);

/// The geographic location of a file's origin.
struct ColladaGeography {
    std::optional<GeographicPlace> place;  ///< without its `at`
    std::string error;                     ///< why the location is invalid; empty if it is valid or absent
};

struct ColladaFacts {
    std::string fault;  ///< what collada_fault() finds
    ColladaGeography geography;
};

/// Reads <geographic_location> of the document's <asset>, which assimp ignores. It is part of COLLADA 1.5;
/// some exporters write it in 1.4. <altitude> is taken as the height, whatever its mode.
ColladaFacts read_collada_facts(std::span<const std::uint8_t> xml);

}  // namespace campuswalk::scene
