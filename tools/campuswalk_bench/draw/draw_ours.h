#pragma once

#include <filesystem>
#include <vector>

#include "scene/model/model.h"
#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {

struct OurDrawing {
    std::vector<DrawTimes> looks;
    double encode_ms = 0.0;      ///< to encode an image as PNG; in a walk, this runs in parallel with drawing
    std::size_t heap_bytes = 0;  ///< allocated besides the model: geometry, textures, maps, targets
};

/// Draws the views in each look: once to warm up, then `rounds` times. The first view is saved as
/// `folder`/campuswalk-LOOK.png. Throws RenderError when the machine can't draw.
OurDrawing draw_ours(const scene::Model& model, const std::vector<DrawnView>& views, int rounds,
                     const std::filesystem::path& folder);

}  // namespace campuswalk::tools::bench
