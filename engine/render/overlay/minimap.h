#pragma once

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/geometry/camera.h"
#include "engine/render/image/image.h"
#include "engine/render/overlay/canvas.h"

namespace campuswalk::engine::render {

/// A round map, north up, in the lower left corner: the surroundings of the avatar and where it looks. The
/// map is cut from one image of the campus that is drawn once.
struct Minimap {
    Image plan;
    Viewpoint view;        ///< that `plan` was drawn with; orthographic
    double radius = 70.0;  ///< metres that the circle shows around the avatar
};

/// The smallest canvas height that still has room for it, pixels.
constexpr int kSmallestMinimapImage = 240;

void draw_minimap(const Canvas& canvas, const Minimap& minimap, const AvatarState& avatar);

}  // namespace campuswalk::engine::render
