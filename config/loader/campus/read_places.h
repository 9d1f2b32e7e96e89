#pragma once

#include <filesystem>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads the section `places` into the campus, whose origin has been read: written places, then those of the
/// files that `from` names. A name in a file that is an id stays as it is, any other becomes one as in
/// `info --suggest` ("Room A 101" is room-a-101). Names that occur again, as written ones or earlier in the
/// files, get `-2`, `-3`, …: data may call ten doors "door".
void read_places(const CheckedNode& section, const std::filesystem::path& folder, const ReadRoots& roots,
                 scene::CampusDescription& campus);

}  // namespace campuswalk::config
