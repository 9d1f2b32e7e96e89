#pragma once

#include <vector>

#include "engine/render/campus_geometry.h"
#include "engine/render/drawn_depth.h"
#include "engine/render/frustum.h"
#include "engine/render/gl_functions.h"
#include "engine/render/gpu_mesh.h"
#include "engine/render/shader_program.h"

namespace campuswalk::engine::render {

/// The campus in the driver's memory and the ways to draw it. Lives as long as its context.
class GpuCampus {
public:
    /// `geometry` must outlive this.
    GpuCampus(const GlFunctions& gl, const CampusGeometry& geometry);

    /// Depth of everything that is not see-through: `opaque` for whole surfaces, `masked` for cut-outs. Sets
    /// `clip_campus` in both.
    void draw_depth(const ShaderProgram& opaque, const ShaderProgram& masked,
                    const Eigen::Matrix4d& clip_campus) const;

    /// Surfaces of one alpha mode, opaque or mask, those nearest to `eye` (campus frame) first. `surface`
    /// must be in use. `depth`, null for none, leaves out what is hidden.
    void draw_solid(const ShaderProgram& surface, scene::AlphaMode mode, const Frustum& frustum,
                    const Eigen::Vector3d& eye, DrawnDepth* depth = nullptr) const;

    /// See-through triangles, the farthest from `eye` first. `surface` must be in use.
    void draw_blend(const ShaderProgram& surface, const Frustum& frustum, const Eigen::Vector3d& eye) const;

    /// For drawing a mesh without a texture of its own.
    void set_plain_material(const ShaderProgram& surface) const;

private:
    void set_material(const ShaderProgram& surface, std::size_t material) const;

    const GlFunctions& gl_;
    const CampusGeometry& geometry_;
    GpuMesh mesh_;
    GpuMesh blend_mesh_;
    GLuint white_ = 0;
    std::vector<GLuint> textures_;  // one a material
};

}  // namespace campuswalk::engine::render
