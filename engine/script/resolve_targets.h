#pragma once

#include <vector>

#include "engine/script/walk.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Sets the points of a walk that only its built campus tells: the middle of a building that a step looks at,
/// and the ground at a place without a height that a step teleports to. Returns errors about steps and
/// cameras that are aimed at a building of which nothing tells where it is (no-extent). A simulation takes no
/// other walks.
std::vector<scene::Diagnostic> resolve_targets(const scene::Campus& campus, Walk& walk);

/// Whether its steps know all points.
bool is_resolved(const Walk& walk);

/// The same error about one camera.
std::vector<scene::Diagnostic> check_aim(const scene::Campus& campus, const View& view);

}  // namespace campuswalk::engine
