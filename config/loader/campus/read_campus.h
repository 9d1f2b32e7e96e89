#pragma once

#include <filesystem>
#include <optional>

#include "config/loader/values/read_roots.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads a campus file and reports all its errors; null if there is no YAML in it. Scene files are resolved
/// against its folder. An object with errors still counts as declared, so that other keys may name it and one
/// mistake yields one diagnostic. `named_at` is where the file is named: in another file, or the file itself.
std::optional<scene::CampusDescription> open_campus(const std::filesystem::path& path, const ReadRoots& roots,
                                                    const scene::SourceMark& named_at,
                                                    scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
