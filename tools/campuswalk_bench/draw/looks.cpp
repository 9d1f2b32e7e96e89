#include "tools/campuswalk_bench/draw/looks.h"

namespace campuswalk::tools::bench {

using engine::render::RenderSettings;
using engine::render::Viewpoint;

namespace {

Look look(const char* name, int samples, bool fxaa, bool shadows) {
    RenderSettings settings;
    settings.samples = samples;
    settings.fxaa = fxaa;
    settings.shadows = shadows;
    settings.ambient_occlusion_radius = 0.0;
    return {name, settings};
}

}  // namespace

std::vector<Look> looks() {
    return {look("no-aa", 1, false, false),        look("fxaa", 1, true, false),
            look("msaa4", 4, false, false),        look("shadows+fxaa", 1, true, true),
            look("shadows+msaa4", 4, false, true), {"default", RenderSettings()}};
}

std::vector<Viewpoint> viewpoints(const std::vector<DrawnView>& views) {
    std::vector<Viewpoint> points;
    points.reserve(views.size());
    for (const DrawnView& view : views) {
        points.push_back(engine::render::looking_at(view.eye, view.target, kDrawnFov));
    }
    return points;
}

}  // namespace campuswalk::tools::bench
