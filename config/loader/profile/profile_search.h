#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"

namespace campuswalk::config {

/// A kind of profile, which walks refer to by NAME.
struct ProfileKind {
    const char* key = "";      ///< of walks, in quotes
    const char* what = "";     ///< in messages about a file
    const char* suffix = "";   ///< of the file's name, such as ".avatar.yaml"
    const char* folder = "";   ///< that such files are in, such as "avatars"
    bool has_default = false;  ///< a walk may override keys without naming a profile
};

constexpr ProfileKind kAvatars{"'avatar'", "an avatar", ".avatar.yaml", "avatars"};
constexpr ProfileKind kLights{"'light'", "a light", ".light.yaml", "lights", true};

/// Where the profiles that a walk names are looked for, and which were read.
struct ProfileFiles {
    /// Its own `avatars/` and `config/avatars/` come first, then those of its parent folders, then `more`.
    std::filesystem::path walk_folder;
    std::vector<std::filesystem::path> more;
    const ReadRoots& roots;
    std::vector<std::filesystem::path>& read;  ///< those that are read are added
};

/// NAME.avatar.yaml in the first folder that has it; if none does, reports unknown-name at `node`.
std::optional<std::filesystem::path> find_profile(const ProfileKind& kind, const CheckedNode& node,
                                                  const std::string& name, const ProfileFiles& files);

}  // namespace campuswalk::config
