#pragma once

#include <filesystem>
#include <optional>

#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::scene {

/// The hash of a file's contents; nullopt if it isn't a regular file or can't be read.
///
/// With a cache (null: none), a large file is read once: its hash is remembered under its device, inode,
/// size, and times of modification and status change, as Git does in its index. Users can't set the latter,
/// so that whoever changes the contents changes the name. A file changed within the last two seconds is
/// hashed again each time: another change could still get the same times.
std::optional<ContentHash> hash_of_file(const std::filesystem::path& file, const CacheFolder* cache);

/// The hash of the running executable. It keeps builds from using each other's cache entries, even if a
/// version was not incremented. Zero if the system doesn't tell which file it is.
const ContentHash& program_hash(const CacheFolder* cache);

}  // namespace campuswalk::scene
