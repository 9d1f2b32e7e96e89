#pragma once

#include <string>
#include <vector>

#include "engine/render/geometry/camera.h"
#include "engine/render/passes/render_settings.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {

constexpr int kDrawnWidth = 1280;
constexpr int kDrawnHeight = 720;
constexpr double kDrawnFov = 1.0471975511965976;  ///< vertical, radians

/// Render settings that are timed.
struct Look {
    std::string name;
    engine::render::RenderSettings settings;
};

/// The looks that peers also have, then our default settings.
std::vector<Look> looks();

std::vector<engine::render::Viewpoint> viewpoints(const std::vector<DrawnView>& views);

}  // namespace campuswalk::tools::bench
