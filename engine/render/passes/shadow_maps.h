#pragma once

#include <Eigen/Core>

#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/gpu_campus.h"
#include "engine/render/passes/render_settings.h"
#include "engine/render/passes/shader_constants.h"

namespace campuswalk::engine::render {

/// One depth image seen from the sun, a square within the texture of both.
struct ShadowMap {
    int left = 0;  ///< texels, of its place in the texture
    int size = 0;  ///< texels a side
    Eigen::Matrix4d clip_campus = Eigen::Matrix4d::Identity();
    double metres_per_texel = 0.0;  ///< along the longer axis
};

/// The sun's shadows: a map of the whole campus, drawn once, and a finer one around the camera.
class ShadowMaps {
public:
    /// Draws the far map. All arguments must outlive this.
    ShadowMaps(const GlFunctions& gl, const RenderSettings& settings, const CampusGeometry& geometry,
               const GpuCampus& campus, const ShaderProgram& opaque, const ShaderProgram& masked);

    /// Redraws the near map for a camera at `eye` (campus frame) that looks along `forwards`. `figure`, null
    /// for none, casts a shadow too; its vertices are in the campus frame.
    void draw_near(const Eigen::Vector3d& eye, const Eigen::Vector3d& forwards, const GpuMesh* figure,
                   std::size_t figure_indices);

    /// What the shadow chunk wants to know; none without shadows.
    ShaderConstants constants() const;

    /// Sets the surface programs' `near_offset`; binds the maps to texture unit 1.
    void bind(const ShaderProgram& surface, bool with_near) const;

private:
    void make_texture();
    void aim_near(const Eigen::Vector3d& centre);
    Eigen::Vector2d share(const ShadowMap& map) const;
    Eigen::Vector2d near_step() const;
    void draw(const ShadowMap& map, const GpuMesh* figure, std::size_t figure_indices) const;

    const GlFunctions& gl_;
    const RenderSettings& settings_;
    const GpuCampus& campus_;
    const ShaderProgram& opaque_;
    const ShaderProgram& masked_;
    Eigen::Matrix3d R_sun_campus_;  // rows: right, up, towards the sun
    Eigen::Vector3d lowest_;        // of the campus' box in the sun's frame
    Eigen::Vector3d highest_;
    ShadowMap far_;
    ShadowMap near_;
    int width_ = 0;  // texels, of the texture of both
    int height_ = 0;
    GLuint texture_ = 0;
    GLuint framebuffer_ = 0;
};

}  // namespace campuswalk::engine::render
