#pragma once

#include "engine/render/geometry/camera.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/image/channels.h"
#include "engine/render/passes/gpu_campus.h"

namespace campuswalk::engine::render {

/// What the channel pass draws.
struct ChannelScene {
    const GpuCampus& campus;
    const GpuMesh* figure = nullptr;  ///< null for none
    std::size_t figure_indices = 0;
};

/// Draws channels. Must not outlive its context.
class ChannelPass {
public:
    /// Throws RenderError if the campus has too many vertices for the driver's texture size.
    ChannelPass(const GlFunctions& gl, const CampusGeometry& geometry);
    ChannelPass(const ChannelPass&) = delete;
    ChannelPass& operator=(const ChannelPass&) = delete;
    ~ChannelPass();

    /// `clip_campus` and `eye` are those of `view` in the campus frame. The size must be valid for a
    /// RenderTarget.
    Channels draw(const ChannelScene& scene, const Viewpoint& view, const Eigen::Matrix4d& clip_campus,
                  const Eigen::Vector3d& eye, int width, int height, const ChannelChoice& choice) const;

private:
    ShaderProgram program(const char* name, std::string_view define) const;
    void upload_nodes(const CampusGeometry& geometry);
    void begin(const ShaderProgram& program, const Viewpoint& view, const Eigen::Matrix4d& clip_campus,
               const Eigen::Vector3d& eye) const;

    const GlFunctions& gl_;
    ShaderProgram opaque_;
    ShaderProgram cutout_;
    ShaderProgram see_through_;
    GLuint nodes_ = 0;  // texture: node number per vertex
};

}  // namespace campuswalk::engine::render
