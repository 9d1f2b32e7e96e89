#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/campus_geometry.h"
#include "engine/script/avatar.h"

namespace campuswalk::engine::render {

/// Triangles of the avatar.
struct FigureMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A simple figure with a rucksack at the avatar's foot point, facing its yaw, `profile.height` tall.
/// `stride` is the phase of the gait in radians: 0 stands still, pi / 2 is the widest step. Vertices are
/// relative to `origin` (world frame).
FigureMesh make_figure(const AvatarState& avatar, const AvatarProfile& profile, double stride,
                       const Eigen::Vector3d& origin);

}  // namespace campuswalk::engine::render
