#pragma once

#include <Eigen/Core>

#include "engine/render/geometry/camera.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/gpu_campus.h"

namespace campuswalk::engine::render {

/// Contact shading: a map, half as wide and high as the image, of how much ambient light reaches each place
/// (1 all of it). Only for perspective cameras.
class AmbientOcclusionPass {
public:
    /// The arguments must outlive this.
    AmbientOcclusionPass(const GlFunctions& gl, const ShaderProgram& opaque, const ShaderProgram& masked);
    AmbientOcclusionPass(const AmbientOcclusionPass&) = delete;
    AmbientOcclusionPass& operator=(const AmbientOcclusionPass&) = delete;
    ~AmbientOcclusionPass();

    /// Makes the map fit images of `width` x `height` pixels; before `draw` or `clear_to_unoccluded`.
    void fit(int width, int height);

    /// Draws the map for what `view` sees; `radius` in metres. `figure` (null for none) counts too.
    void draw(const GpuCampus& campus, const GpuMesh* figure, std::size_t figure_indices,
              const Viewpoint& view, const Eigen::Matrix4d& clip_campus, double radius) const;

    /// Makes the map say that all light reaches everything. A plain white texture would do, but of another
    /// format: the driver compiles every shader again for that, which takes longer than drawing an image.
    void clear_to_unoccluded() const;

    /// Sets the surface shader's uniforms; binds the map to texture unit 3.
    void bind(const ShaderProgram& surface) const;

private:
    struct Layer {
        GLuint texture = 0;
        GLuint framebuffer = 0;
    };
    void free_layers() const;
    Layer make_layer(GLenum format, GLenum attachment) const;
    void blur(const Layer& from, const Layer& to, const Eigen::Vector2i& axis) const;
    void fill(const Layer& layer) const;

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
    Layer half_smooth_;
    Layer smooth_;
    GLuint no_vertices_ = 0;
};

}  // namespace campuswalk::engine::render
