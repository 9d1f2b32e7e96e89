#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// A line in the world, as thin as can be seen.
struct OverlayLine {
    Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< world
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    std::array<float, 3> color = {1, 1, 1};  ///< linear
};

/// What a shape is told by: a box's twelve edges, circles and lines of what is round, of a mesh the edges
/// that end it or at which its surface bends by more than 20 degrees.
void add_outline(const collision::Shape& shape, const collision::Pose& X_world_shape,
                 const std::array<float, 3>& color, std::vector<OverlayLine>& lines);

/// The boxes at a level of the paper's tree of each mesh collider, or its leaves' where it isn't as deep.
void add_tree_boxes(const scene::Campus& campus, int level, std::vector<OverlayLine>& lines);

/// All lines that `overlays` asks for. `path` and `contacts` are the foot point's places.
std::vector<OverlayLine> overlay_lines(const scene::Campus& campus, const ImageOverlays& overlays,
                                       std::span<const Eigen::Vector3d> path,
                                       std::span<const Eigen::Vector3d> contacts);

}  // namespace campuswalk::engine::render
