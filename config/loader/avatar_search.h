#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/checked_node.h"

namespace campuswalk::config {

/// The folders in which a walk's avatar is looked for, in order: `avatars/` and `config/avatars/` beside the
/// walk and in its parent folders, then `more`.
std::vector<std::filesystem::path> avatar_folders(const std::filesystem::path& walk_folder,
                                                  const std::vector<std::filesystem::path>& more);

/// NAME.avatar.yaml in the first folder that has it; complains (unknown-name, with what there is) when none
/// has.
std::optional<std::filesystem::path> find_avatar(const CheckedNode& node, const std::string& name,
                                                 const std::vector<std::filesystem::path>& folders);

}  // namespace campuswalk::config
