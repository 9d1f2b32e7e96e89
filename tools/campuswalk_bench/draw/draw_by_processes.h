#pragma once

#include <cstddef>
#include <vector>

#include "scene/model/model.h"
#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {

/// Draws the views in each look in drawing_processes() at the same time, as the video frames of a walk are
/// drawn. Each process draws all views `rounds` times after once to warm up. An image's time is divided by
/// the number of processes: that is what the image adds to a walk. Must be called before this process draws
/// anything. Throws std::runtime_error when the machine can't draw.
std::vector<DrawTimes> draw_by_processes(const scene::Model& model, const std::vector<DrawnView>& views,
                                         int rounds);

/// As many as there are processors, at most eight.
std::size_t drawing_processes();

}  // namespace campuswalk::tools::bench
