#pragma once

#include <filesystem>
#include <vector>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"
#include "scene/model/scene_file.h"

namespace campuswalk::config {

/// The list `scenes` of a campus: model files, and where each is put. `folder`: the campus file's; `roots`:
/// where models may be.
std::vector<scene::SceneFile> read_scenes(const CheckedNode& section, const std::filesystem::path& folder,
                                          const ReadRoots& roots);

}  // namespace campuswalk::config
