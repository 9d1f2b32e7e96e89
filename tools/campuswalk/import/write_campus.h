#pragma once

#include <filesystem>
#include <string>

#include "scene/osm/helper/map_files.h"

namespace campuswalk::tools {

/// The files of an imported campus in a folder.
struct CampusFiles {
    std::filesystem::path model;
    std::filesystem::path campus;
    std::filesystem::path walk;
    std::filesystem::path attribution;
};

CampusFiles campus_files_in(const std::filesystem::path& folder, const std::string& name);

/// Writes the campus, and a walk from its start to doors nearby that passes: it has been played. If something
/// fails, none of the files is left. Returns how many doors it visits.
std::size_t write_campus_files(const scene::osm::MapFiles& contents, const CampusFiles& files);

}  // namespace campuswalk::tools
