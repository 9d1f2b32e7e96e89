#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "config/loader/load_campus.h"

namespace campuswalk::tools {

/// The positions of the places of a file that the user named, wherever it is, for a model that lies there on
/// the Earth. Prints warnings. Throws scene::InputError as config::read_place_file, and no-origin for one
/// that needs --origin.
std::vector<Eigen::Vector3d> read_places(const config::PlaceFile& file,
                                         const std::optional<scene::GeographicPlace>& on_earth);

}  // namespace campuswalk::tools
