#pragma once

#include "engine/render/snapshot/snapshot_renderer.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/images/rendering_backend.h"

namespace campuswalk::tools {

/// How this program draws a campus: cameras stay out of its walls. `campus` must outlive what uses them.
engine::render::SnapshotSettings settings_for(const scene::Campus& campus, Backend backend);

}  // namespace campuswalk::tools
