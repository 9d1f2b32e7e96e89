#pragma once

#include <span>

#include <Eigen/Geometry>

#include "engine/render/image/image.h"
#include "engine/render/plan/storey_plan.h"

namespace campuswalk::engine::render {

/// Metres per pixel at which the longer side of `area` (metres) has 840 to 2100 pixels; their inverse is 1, 2
/// or 5 times a power of ten.
double round_resolution(const Eigen::AlignedBox2d& area);

/// Draws the plan on white, with title, labelled grid, legend and a list of the findings. Needs no OpenGL;
/// the same plan gives the same image.
Image draw_storey_plan(const StoreyPlan& plan);
/// Likewise, one below the other.
Image draw_storey_plans(std::span<const StoreyPlan> plans);

}  // namespace campuswalk::engine::render
