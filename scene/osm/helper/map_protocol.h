#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/base/binary_archive.h"
#include "scene/import/helper/import_limits.h"
#include "scene/import/helper/sandbox.h"
#include "scene/osm/helper/map_files.h"

namespace campuswalk::scene::osm {

inline constexpr FileKind kMapResponse = {{'c', 'w', ' ', 'm', 'a', 'p', 'r', 's'}, 2};

struct MapHelperRequest {
    MapRequest map;
    ImportLimits limits;
    SandboxMode sandbox = SandboxMode::automatic;
};

std::vector<std::byte> write_request(const MapHelperRequest& request);
/// Throws DamagedFile.
MapHelperRequest read_map_request(std::span<const std::byte> bytes);

/// `files` must outlive the writer. With errors among its warnings it stands for an InputError.
ArchiveWriter archive_files(const MapFiles& files);
/// Accepts untrusted bytes. Throws DamagedFile for invalid ones, InputError for a response that stands for
/// one.
MapFiles read_map_response(std::span<const std::byte> bytes);

}  // namespace campuswalk::scene::osm
