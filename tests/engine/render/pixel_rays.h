#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render::test {

/// What a ray through a pixel's middle meets.
struct PixelHit {
    std::uint32_t node = 0;                            ///< counted as in Channels; 0 nothing
    double depth = 0.0;                                ///< metres along the camera's axis
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the triangle, towards the camera
};

/// The rays of an image, each tried on every triangle of the model in double precision: what channels are
/// held against. Shares nothing with the renderer but Viewpoint. Textures are read at the nearest texel.
class PixelRays {
public:
    PixelRays(const scene::Model& model, const Viewpoint& view, int width, int height);

    const PixelHit& at(int x, int y) const {
        return hits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
    }
    /// Whether the pixel isn't on the image's rim and the eight around it show the same node.
    bool is_interior(int x, int y) const;
    /// The largest difference of depth to the four pixels beside.
    double depth_change(int x, int y) const;

private:
    int width_;
    int height_;
    std::vector<PixelHit> hits_;
};

}  // namespace campuswalk::engine::render::test
