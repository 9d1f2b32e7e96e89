#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace campuswalk::engine::render {

/// The visible pixels of each building in a snapshot.
struct VisibleBuildings {
    std::size_t pixels = 0;                       ///< of the whole image
    std::vector<std::size_t> pixels_of_building;  ///< pixels, by index into CampusDescription::buildings
};

/// By snapshot name.
using VisibleBuildingsBySnapshot = std::map<std::string, VisibleBuildings>;

}  // namespace campuswalk::engine::render
