#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace campuswalk::config {

/// The folder and those above it, nearest first, as seen from here: up to the root of the repository (the
/// first with `.git`), and no farther than folders of the same owner, as others could put files there.
std::vector<std::filesystem::path> folders_upwards(const std::filesystem::path& folder);

/// nullopt if there is no such folder.
std::optional<unsigned> owner_of(const std::filesystem::path& folder);

}  // namespace campuswalk::config
