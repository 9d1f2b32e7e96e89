#pragma once

#include <string>
#include <vector>

#include "engine/render/geometry/camera.h"
#include "engine/render/image/image.h"
#include "engine/render/passes/render_settings.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render::test {

/// The demo campus' models.
std::vector<scene::Model> demo_models();

/// A view at eye level: "avenue", "square" or "lobby".
Viewpoint demo_view(const std::string& name);

/// 1280 x 720.
Image draw_demo(const std::vector<scene::Model>& models, const Viewpoint& view,
                const RenderSettings& settings = {});

}  // namespace campuswalk::engine::render::test
