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

/// What is to be seen of it: "avenue", "square" or "lobby", from a walker's eyes.
Viewpoint demo_view(const std::string& name);

/// 1280 x 720, as users get it.
Image draw_demo(const std::vector<scene::Model>& models, const Viewpoint& view,
                const RenderSettings& settings = {});

}  // namespace campuswalk::engine::render::test
