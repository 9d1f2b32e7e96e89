#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "config/loader/search_paths.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads `NAME.campus.yaml` alone.
scene::CampusDescription load_campus_description(const std::filesystem::path& campus_file,
                                                 const SearchPaths& search = {});

/// A file of places by itself, and the property of its features that names them.
struct PlaceFile {
    std::filesystem::path path;
    std::string name_property = "name";
};

/// The places of a file, and what was left out of it.
struct PlacesRead {
    std::vector<Eigen::Vector3d> positions;  ///< world frame, metres; without a height in the file at 0
    std::vector<scene::Diagnostic> warnings;
};

/// Reads a file of places as `places: {from: {file: FILE, name: PROPERTY}}` does, for a campus that lies
/// there on the Earth.
PlacesRead read_place_file(const PlaceFile& file, const std::optional<scene::GeographicPlace>& origin,
                           const SearchPaths& search);

}  // namespace campuswalk::config
