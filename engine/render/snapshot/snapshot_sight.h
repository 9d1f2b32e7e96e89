#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace campuswalk::engine::render {

/// Of which buildings something is to be seen in a snapshot.
struct VisibleBuildings {
    std::size_t pixels = 0;                       ///< of the whole image
    std::vector<std::size_t> pixels_of_building;  ///< pixels, by index into CampusDescription::buildings
};

/// By the snapshot's name.
using VisibleBuildingsBySnapshot = std::map<std::string, VisibleBuildings>;

}  // namespace campuswalk::engine::render
