#include "tests/engine/render/campus_view.h"

#include <filesystem>
#include <map>

#include "engine/render/renderer.h"
#include "scene/import/import_model.h"

namespace campuswalk::engine::render::test {

std::vector<scene::Model> demo_models() {
    std::vector<scene::Model> models;
    for (const char* name : {"ground", "buildings", "vegetation", "furniture"}) {
        scene::SceneFile file;
        file.path = std::filesystem::path(CAMPUSWALK_SOURCE_DIR) / "campus_assets" / "demo" /
                    (std::string(name) + ".glb");
        models.push_back(scene::import_model(file).model);
    }
    return models;
}

Viewpoint demo_view(const std::string& name) {
    constexpr double kFov = 1.0471975511965976;
    const std::map<std::string, Viewpoint> views = {{"avenue", looking({0.0, 0.65, 58.0}, 0.0, 0.0, kFov)},
                                                    {"square", looking({12.8, 1.71, 17.0}, 0.5, 0.0, kFov)},
                                                    {"lobby", looking({0.0, 2.33, -21.5}, 0.0, 0.0, kFov)}};
    return views.at(name);
}

Image draw_demo(const std::vector<scene::Model>& models, const Viewpoint& view,
                const RenderSettings& settings) {
    return Renderer(models, settings).draw(view, 1280, 720);
}

}  // namespace campuswalk::engine::render::test
