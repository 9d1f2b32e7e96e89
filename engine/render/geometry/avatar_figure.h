#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/campus_geometry.h"
#include "engine/script/avatar.h"

namespace campuswalk::engine::render {

/// Triangles of the visitor as others see them.
struct FigureMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A simple walker with a rucksack, standing on the avatar's foot point and facing its yaw, `profile.height`
/// tall. `stride` is the phase of the step in radians: 0 stands still, pi / 2 is the widest step. Vertices
/// count from `origin` (world).
FigureMesh make_figure(const AvatarState& avatar, const AvatarProfile& profile, double stride,
                       const Eigen::Vector3d& origin);

}  // namespace campuswalk::engine::render
