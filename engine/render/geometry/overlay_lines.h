#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// A thin line in the world frame.
struct OverlayLine {
    Eigen::Vector3d a = Eigen::Vector3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    std::array<float, 3> color = {1, 1, 1};  ///< linear
};

/// Adds the outline of a shape: the edges of a box, circles and lines of round shapes, and of a mesh its
/// border edges and creases of more than 20 degrees, of its triangles those that overlap `within`.
void add_outline(const collision::Shape& shape, const collision::Pose& X_world_shape,
                 const std::array<float, 3>& color, std::vector<OverlayLine>& lines,
                 const std::optional<collision::Aabb>& within = {});

/// Adds the boxes at a level of the hybrid tree of each mesh collider, or of leaves above that level.
void add_tree_boxes(const scene::Campus& campus, int level, std::vector<OverlayLine>& lines);

/// All lines that `overlays` selects. `path` and `contacts` are positions of the foot point. `within`: of
/// colliders and triggers, and of their meshes, only what overlaps this box; solid boxes there that no node
/// shows are hatched.
std::vector<OverlayLine> overlay_lines(const scene::Campus& campus, const ImageOverlays& overlays,
                                       std::span<const Eigen::Vector3d> path,
                                       std::span<const Eigen::Vector3d> contacts,
                                       const std::optional<collision::Aabb>& within = {});

}  // namespace campuswalk::engine::render
