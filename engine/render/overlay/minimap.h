#pragma once

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/camera.h"
#include "engine/render/image/image.h"
#include "engine/render/overlay/canvas.h"

namespace campuswalk::engine::render {

/// A round north-up map around the avatar in the lower left corner, cut from a plan of the campus that is
/// drawn once.
struct Minimap {
    Image plan;
    Viewpoint view;        ///< orthographic view of `plan`
    double radius = 70.0;  ///< metres around the avatar
};

/// The minimum canvas height with room for a minimap, pixels.
constexpr int kSmallestMinimapImage = 240;

void draw_minimap(const Canvas& canvas, const Minimap& minimap, const AvatarState& avatar);

}  // namespace campuswalk::engine::render
