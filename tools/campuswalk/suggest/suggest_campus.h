#pragma once

#include <filesystem>

#include "scene/campus/campus_description.h"

namespace campuswalk::tools {

/// Writes a first campus for a model and a walk on it (NAME.walk.yaml beside NAME.campus.yaml), which has
/// been played and passes. Returns the exit code. Throws scene::InputError as the import does, and with the
/// codes
///   file-name     the file is not called NAME.campus.yaml
///   file-exists   one of the two exists and must not be overwritten
///   no-ground     there is no place to stand
int suggest_campus(const scene::SceneFile& model, const std::filesystem::path& campus_file, bool overwrite);

}  // namespace campuswalk::tools
