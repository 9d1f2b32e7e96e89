#pragma once

#include <cstddef>
#include <vector>

#include "scene/model/model.h"
#include "tools/campuswalk_bench/draw/draw_times.h"
#include "tools/campuswalk_bench/draw/drawn_campus.h"

namespace campuswalk::tools::bench {

/// Draws the views in each look by drawing_processes() at the same time, as a walk's frames are drawn: as
/// many as there are processors, at most eight. Each draws all views `rounds` times after one for warming up.
/// A frame's time is what it took divided by the number of processes: what it adds to a walk. To be called
/// before this process draws anything. Throws std::runtime_error when the machine can't draw.
std::vector<DrawTimes> draw_by_processes(const scene::Model& model, const std::vector<DrawnView>& views,
                                         int rounds);

std::size_t drawing_processes();

}  // namespace campuswalk::tools::bench
