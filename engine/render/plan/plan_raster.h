#pragma once

#include <Eigen/Geometry>

#include "engine/render/image/image.h"
#include "engine/render/overlay/map_grid.h"
#include "engine/render/plan/storey_plan.h"

namespace campuswalk::engine::render {

/// Draws what the raster has within `map`, in pixels of the image, which `frame` maps to the world. A pixel
/// that several cells share gets the kind of most of them. Walkable ground has a dark rim.
void draw_cells(const StoreyPlan& plan, const PlanFrame& frame, const Eigen::AlignedBox2i& map, Image& image);

}  // namespace campuswalk::engine::render
