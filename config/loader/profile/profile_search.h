#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

/// A kind of profile, which walks refer to by NAME.
struct ProfileKind {
    const char* suffix = "";  ///< of the file's name, such as ".avatar.yaml"
    const char* folder = "";  ///< that such files are in, such as "avatars"
};

constexpr ProfileKind kAvatars{".avatar.yaml", "avatars"};
constexpr ProfileKind kLights{".light.yaml", "lights"};

/// The folders to search for a walk's profile, in order: `avatars/` and `config/avatars/` beside the walk and
/// in its parent folders, then `more`.
std::vector<std::filesystem::path> profile_folders(const ProfileKind& kind,
                                                   const std::filesystem::path& walk_folder,
                                                   const std::vector<std::filesystem::path>& more);

/// NAME.avatar.yaml in the first folder that has it; if none does, reports unknown-name at `node`.
std::optional<std::filesystem::path> find_profile(const ProfileKind& kind, const CheckedNode& node,
                                                  const std::string& name,
                                                  const std::vector<std::filesystem::path>& folders);

}  // namespace campuswalk::config
