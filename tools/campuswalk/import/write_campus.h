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

/// The walk that was written.
struct WrittenWalk {
    std::size_t visits = 0;  ///< doors that it goes to
    /// Without a visit: why the nearest of the doors can't be reached; empty if there is none.
    std::string obstacle;
};

/// Writes the campus, and a walk from its start to doors nearby that passes: it has been played, in a folder
/// of its own, from which all files are moved at the end. If something fails, nothing has changed. Throws
/// scene::InputError about `map` if it makes more than a campus file may have.
WrittenWalk write_campus_files(const scene::osm::MapFiles& contents, const CampusFiles& files,
                               const std::filesystem::path& map);

}  // namespace campuswalk::tools
