#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <vector>

#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

inline constexpr std::uintmax_t kMaxReferenceBytes = std::uintmax_t{1} << 28U;

/// What is in a folder of golden files, in an order that doesn't depend on the file system.
std::set<std::filesystem::path> reference_files(const std::filesystem::path& folder);

/// What keeps the files in `NAME.walk.yaml-snapshots` from being golden ones: they must be regular, lie in
/// the project (see config::ReadRoots) and have at most kMaxReferenceBytes.
std::vector<scene::Diagnostic> reference_errors(const std::filesystem::path& walk_file);

}  // namespace campuswalk::tools
