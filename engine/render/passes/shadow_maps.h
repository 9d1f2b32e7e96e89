#pragma once

#include <Eigen/Core>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/gpu_campus.h"
#include "engine/render/passes/render_settings.h"
#include "engine/render/passes/shader_constants.h"

namespace campuswalk::engine::render {

/// A depth map seen from the sun: a square region of the texture that both maps share.
struct ShadowMap {
    int left = 0;  ///< texels, offset in the texture
    int size = 0;  ///< texels per side
    Eigen::Matrix4d clip_campus = Eigen::Matrix4d::Identity();
    double metres_per_texel = 0.0;  ///< along the longer axis
};

/// Two shadow cascades: a far map of the whole campus, drawn once, and a finer near map around the camera.
class ShadowMaps {
public:
    /// Draws the far map. All arguments must outlive this.
    ShadowMaps(const GlFunctions& gl, const RenderSettings& settings, const CampusGeometry& geometry,
               const GpuCampus& campus, const ShaderProgram& opaque, const ShaderProgram& masked);

    /// Redraws the near map for a camera at `eye` (campus frame) looking along `forwards`. `figure` (campus
    /// frame), if not null, casts a shadow too.
    void draw_near(const Eigen::Vector3d& eye, const Eigen::Vector3d& forwards, const GpuMesh* figure,
                   std::size_t figure_indices);

    /// The constants of the shadow chunk; empty without shadows.
    ShaderConstants constants() const;

    /// Sets the surface program's `near_origin` and binds the maps to texture unit 1.
    void bind(const ShaderProgram& surface, bool with_near) const;

private:
    void make_texture();
    void fit_near(const Eigen::Vector3d& centre);
    Eigen::Vector2d share(const ShadowMap& map) const;
    Eigen::Vector2d near_scale() const;
    void draw(const ShadowMap& map, const GpuMesh* figure, std::size_t figure_indices) const;

    const GlFunctions& gl_;
    const RenderSettings& settings_;
    const GpuCampus& campus_;
    const ShaderProgram& opaque_;
    const ShaderProgram& masked_;
    Eigen::Matrix3d R_sun_campus_;  // rows: right, up, towards the sun
    Eigen::Vector3d lowest_;        // bounds of the campus in the sun frame
    Eigen::Vector3d highest_;
    ShadowMap far_;
    ShadowMap near_;
    int width_ = 0;  // texels, of the shared texture
    int height_ = 0;
    GLuint texture_ = 0;
    GLuint framebuffer_ = 0;
};

}  // namespace campuswalk::engine::render
