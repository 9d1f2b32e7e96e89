#pragma once

#include <filesystem>
#include <optional>

#include "scene/base/diagnostic.h"
#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

/// Where to cut a map out of a file: a box, or the square about a centre, or, without both, what the file
/// states as its bounds; without these, all of its nodes.
struct MapSection {
    std::optional<GeographicBox> box;
    std::optional<std::pair<double, double>> center;  ///< latitude and longitude, degrees
    double radius = 0.0;                              ///< of the square, metres
};

/// Reads OpenStreetMap XML (`.osm`) or PBF (`.pbf`). Elements far from the section are left out. Throws
/// InputError at `mark`: missing-file, bad-map (damaged, or no map), bad-size (the section is empty, larger
/// than kMaxMapSize, or holds nothing). What is left out becomes a warning.
Map read_map(const std::filesystem::path& file, const SourceMark& mark, const MapSection& section,
             DiagnosticList& warnings);

/// Metres, an edge of the largest section. Beyond it, a plane is too far from the Earth's surface.
inline constexpr double kMaxMapSize = 20'000.0;

}  // namespace campuswalk::scene::osm
