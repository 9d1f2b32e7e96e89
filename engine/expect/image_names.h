#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Appends a diagnostic (unknown-name) about each snapshot that expectations name and no step takes, and
/// about each building that isn't there or has nothing to be seen.
void check_image_names(const scene::Campus& campus, const Walk& walk,
                       std::vector<scene::Diagnostic>& diagnostics);

}  // namespace campuswalk::engine
