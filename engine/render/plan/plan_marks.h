#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Geometry>

#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/map_grid.h"
#include "engine/render/plan/storey_plan.h"

namespace campuswalk::engine::render {

constexpr double kMarker = 11.0;  ///< half the height of a finding's marker, pixels

/// The number of a finding, centred on `at`, pixels; without a number if that is 0.
void draw_marker(const Canvas& canvas, const Eigen::Vector2d& at, PlanSeverity severity, int number);
/// Centred on `at`, pixels.
void draw_point_symbol(const Canvas& canvas, const Eigen::Vector2d& at, PlanPointKind kind);
/// For what lies beyond the plan, in `direction`, of length 1: an arrow with its tip there, pixels.
void draw_arrow_beyond(const Canvas& canvas, const Eigen::Vector2d& tip, const Eigen::Vector2d& direction);
/// A line through `points`, pixels, in the colour of the route with this index.
void draw_route(const Canvas& canvas, std::span<const Eigen::Vector2d> points, std::size_t index);

/// Draws the plan's routes, points with their names, names of buildings, and findings, in this order. What
/// would overlap moves aside; a marker is then joined to its place by a line, and a name without room is
/// omitted. What lies
/// beyond the map is at its border, as an arrow. `map` is in pixels.
void draw_plan_marks(const Canvas& canvas, const StoreyPlan& plan, const PlanFrame& frame,
                     const Eigen::AlignedBox2d& map);

}  // namespace campuswalk::engine::render
