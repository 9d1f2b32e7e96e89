#pragma once

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/gpu_campus.h"

namespace campuswalk::engine::render {

/// Screen-space ambient occlusion: a half-resolution map of the share of ambient light that reaches each
/// pixel's surface. Perspective cameras only.
class AmbientOcclusionPass {
public:
    /// The arguments must outlive this.
    AmbientOcclusionPass(const GlFunctions& gl, const ShaderProgram& opaque, const ShaderProgram& masked);
    AmbientOcclusionPass(const AmbientOcclusionPass&) = delete;
    AmbientOcclusionPass& operator=(const AmbientOcclusionPass&) = delete;
    ~AmbientOcclusionPass();

    /// Allocates the map for images of `width` x `height` pixels; before `draw` or `clear_to_unoccluded`.
    void resize(int width, int height);

    /// Draws the map for `view`; `radius` in metres. `figure`, if not null, occludes too.
    void draw(const GpuCampus& campus, const GpuMesh* figure, std::size_t figure_indices,
              const Viewpoint& view, const Eigen::Matrix4d& clip_campus, double radius) const;

    /// Clears the map to 1. (A constant white texture has another format, for which the driver would
    /// recompile every shader: slower than drawing an image.)
    void clear_to_unoccluded() const;

    /// Sets the surface program's uniforms and binds the map to texture unit 3.
    void bind(const ShaderProgram& surface) const;

private:
    struct Layer {
        GLuint texture = 0;
        GLuint framebuffer = 0;
    };
    void delete_layers() const;
    Layer make_layer(GLenum format, GLenum attachment) const;
    void blur(const Layer& from, const Layer& to, const Eigen::Vector2i& axis) const;
    void draw_full_screen(const Layer& layer) const;

    const GlFunctions& gl_;
    const ShaderProgram& opaque_;
    const ShaderProgram& masked_;
    ShaderProgram occlusion_;
    ShaderProgram blur_;
    int image_width_ = 0;
    int image_height_ = 0;
    int width_ = 0;
    int height_ = 0;
    Layer depth_;
    Layer raw_;
    Layer half_blurred_;
    Layer blurred_;
    GLuint no_vertices_ = 0;
};

}  // namespace campuswalk::engine::render
