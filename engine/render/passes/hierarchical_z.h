#pragma once

#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/render_target.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/depth_tiles.h"

namespace campuswalk::engine::render {

/// Looks at the depth of an image between what is near and what is far, so that the far things that can't be
/// seen any more are left out. The image's pixels are the same with and without: what is left out would
/// fail every depth test.
class HierarchicalZ {
public:
    /// `samples` a pixel, those of the targets.
    HierarchicalZ(const GlFunctions& gl, int samples);
    HierarchicalZ(const HierarchicalZ&) = delete;
    HierarchicalZ& operator=(const HierarchicalZ&) = delete;
    ~HierarchicalZ();

    /// A new image, a perspective that `clip_campus` makes: nothing is hidden yet. `target` must live as
    /// long as it is drawn.
    void begin(const RenderTarget& target, const Eigen::Matrix4d& clip_campus);

    /// Whether all of the box is behind what had been drawn when it was looked last.
    bool hides(const Eigen::AlignedBox3d& box) const;

    /// So many more indices have been drawn. When it is time to look again it does, and says so: then another
    /// program and other vertices are bound than before, and texture unit 0 has another texture.
    bool drawn(std::size_t indices);

private:
    void look();
    void fit(int width, int height);
    void free_tiles();

    const GlFunctions& gl_;
    ShaderProgram farthest_;
    const RenderTarget* target_ = nullptr;
    Eigen::Matrix4d clip_campus_ = Eigen::Matrix4d::Identity();
    DepthTiles tiles_;
    std::size_t drawn_ = 0;      ///< indices since the last look
    std::size_t next_look_ = 0;  ///< after so many
    int image_width_ = 0;        ///< that the tiles fit
    int image_height_ = 0;
    int columns_ = 0;
    int rows_ = 0;
    GLuint texture_ = 0;
    GLuint framebuffer_ = 0;
    GLuint no_vertices_ = 0;
};

}  // namespace campuswalk::engine::render
