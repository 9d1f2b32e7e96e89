#pragma once

#include <filesystem>

#include "scene/campus/campus_description.h"

namespace campuswalk::tools {

/// Writes a first campus of a model and a walk on it (NAME.walk.yaml beside NAME.campus.yaml), which has been
/// walked and passes. Returns the exit code. Throws scene::InputError: those of the import, and
///   file-name     the file is not called NAME.campus.yaml
///   file-exists   one of the two is there, and may not be overwritten
///   no-ground     nobody can stand anywhere
int suggest_campus(const scene::SceneFile& model, const std::filesystem::path& campus_file, bool overwrite);

}  // namespace campuswalk::tools
