#pragma once

#include <vector>

#include "engine/script/image_tolerance.h"
#include "engine/script/walk.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// What --strict refuses in a walk, as errors with the code "strict": that it is skipped, that it may fail in
/// any way, that it expects nothing, and that its images may differ by more than the defaults allow.
/// `tolerance` is the run's own.
std::vector<scene::Diagnostic> strict_errors(const engine::Walk& walk,
                                             const engine::ImageTolerance& tolerance);

/// The same of a walk on its campus: expectations that can't fail, a fall at the spawn that the walk doesn't
/// announce, and an announcement that isn't true.
std::vector<scene::Diagnostic> strict_errors(const scene::Campus& campus, const engine::Walk& walk);

}  // namespace campuswalk::tools
