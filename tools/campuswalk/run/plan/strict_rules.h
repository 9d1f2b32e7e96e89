#pragma once

#include <vector>

#include "engine/script/image_tolerance.h"
#include "engine/script/walk.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

/// What --strict refuses in a walk, as errors with the code "strict": that it is skipped, that it may fail in
/// any way, that it expects nothing, and that its images may differ by more than the defaults allow.
/// `tolerance` is the run's own.
std::vector<scene::Diagnostic> strict_errors(const engine::Walk& walk,
                                             const engine::ImageTolerance& tolerance);

}  // namespace campuswalk::tools
