#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/values/checked_node.h"

namespace campuswalk::config {

/// A kind of file that a walk names by NAME alone.
struct ProfileKind {
    const char* suffix = "";  ///< of NAME.avatar.yaml: ".avatar.yaml"
    const char* folder = "";  ///< where such files are: "avatars"
};

constexpr ProfileKind kAvatars{".avatar.yaml", "avatars"};
constexpr ProfileKind kLights{".light.yaml", "lights"};

/// The folders in which a walk's profile is looked for, in order: `avatars/` and `config/avatars/` beside the
/// walk and in its parent folders, then `more`.
std::vector<std::filesystem::path> profile_folders(const ProfileKind& kind,
                                                   const std::filesystem::path& walk_folder,
                                                   const std::vector<std::filesystem::path>& more);

/// NAME.avatar.yaml in the first folder that has it; complains (unknown-name, with what there is) when none
/// has.
std::optional<std::filesystem::path> find_profile(const ProfileKind& kind, const CheckedNode& node,
                                                  const std::string& name,
                                                  const std::vector<std::filesystem::path>& folders);

}  // namespace campuswalk::config
