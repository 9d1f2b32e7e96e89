#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render::test {

/// The first hit of the ray through a pixel's centre.
struct PixelHit {
    std::uint32_t node = 0;                            ///< as in Channels; 0 = no hit
    double depth = 0.0;                                ///< metres along the camera axis
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the triangle, towards the camera
};

/// Reference for channels: intersects the ray of every pixel with every triangle of the model in double
/// precision. Shares only Viewpoint with the renderer. Textures are sampled at the nearest texel.
class PixelRays {
public:
    PixelRays(const scene::Model& model, const Viewpoint& view, int width, int height);

    const PixelHit& at(int x, int y) const {
        return hits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
    }
    /// Whether the pixel has eight neighbours that all show the same node.
    bool is_interior(int x, int y) const;
    /// The largest depth difference to the four direct neighbours.
    double depth_change(int x, int y) const;

private:
    int width_;
    int height_;
    std::vector<PixelHit> hits_;
};

}  // namespace campuswalk::engine::render::test
