#pragma once

#include <filesystem>
#include <optional>

#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// Of all that a campus was read from, and of the program that read it; none if some of that isn't known.
std::optional<scene::ContentHash> hash_of_campus(const scene::Campus& campus,
                                                 const std::filesystem::path& campus_file,
                                                 const scene::CacheFolder& cache);

}  // namespace campuswalk::tools
