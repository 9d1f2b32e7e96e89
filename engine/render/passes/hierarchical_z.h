#pragma once

#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/render_target.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/depth_tiles.h"

namespace campuswalk::engine::render {

/// Occlusion culling: reads back the depth of the front-to-back drawn image at intervals, so that occluded
/// batches can be skipped. Pixels don't change: whatever is culled would fail every depth test.
class HierarchicalZ {
public:
    /// `samples` per pixel of the render targets.
    HierarchicalZ(const GlFunctions& gl, int samples);
    HierarchicalZ(const HierarchicalZ&) = delete;
    HierarchicalZ& operator=(const HierarchicalZ&) = delete;
    ~HierarchicalZ();

    /// Starts a new image, with nothing occluded yet. `clip_campus` must be a perspective projection;
    /// `target` must outlive the drawing of the image.
    void begin(const RenderTarget& target, const Eigen::Matrix4d& clip_campus);

    /// Whether the whole box was occluded at the latest readback.
    bool occludes(const Eigen::AlignedBox3d& box) const;

    /// To be called after each draw call. Returns true after a readback, which changes the bound program,
    /// vertex array and texture unit 0.
    bool count_drawn(std::size_t indices);

private:
    void read_back();
    void fit(int width, int height);
    void delete_tiles();

    const GlFunctions& gl_;
    ShaderProgram farthest_;
    const RenderTarget* target_ = nullptr;
    Eigen::Matrix4d clip_campus_ = Eigen::Matrix4d::Identity();
    DepthTiles tiles_;
    std::size_t drawn_ = 0;          ///< indices since the last readback
    std::size_t next_readback_ = 0;  ///< threshold for drawn_
    int image_width_ = 0;            ///< size that the tiles were allocated for
    int image_height_ = 0;
    int columns_ = 0;
    int rows_ = 0;
    GLuint texture_ = 0;
    GLuint framebuffer_ = 0;
    GLuint no_vertices_ = 0;
};

}  // namespace campuswalk::engine::render
