#pragma once

#include <functional>
#include <vector>

#include "engine/render/geometry/campus_geometry.h"
#include "engine/render/geometry/frustum.h"
#include "engine/render/gl/gl_functions.h"
#include "engine/render/gl/gpu_mesh.h"
#include "engine/render/gl/shader_program.h"
#include "engine/render/passes/hierarchical_z.h"

namespace campuswalk::engine::render {

/// Which program draws a material.
using ProgramSelector = std::function<const ShaderProgram&(const scene::Material&)>;

/// The campus in the driver's memory and the ways to draw it. Lives as long as its context.
class GpuCampus {
public:
    /// `geometry` must outlive this.
    GpuCampus(const GlFunctions& gl, const CampusGeometry& geometry);

    /// Depth of everything that is not see-through: `opaque` for whole surfaces, `masked` for cut-outs. Sets
    /// `clip_campus` in both.
    void draw_depth(const ShaderProgram& opaque, const ShaderProgram& masked,
                    const Eigen::Matrix4d& clip_campus) const;

    /// Surfaces of one alpha mode, opaque or mask, those nearest to `eye` (campus frame) first. `program_of`
    /// is asked for each material that is drawn, and must have set what isn't the material's. `depth`, null
    /// for none, leaves out what is hidden.
    void draw_solid(const ProgramSelector& program_of, scene::AlphaMode mode, const Frustum& frustum,
                    const Eigen::Vector3d& eye, HierarchicalZ* depth = nullptr) const;

    /// See-through triangles, the farthest from `eye` first.
    void draw_blend(const ProgramSelector& program_of, const Frustum& frustum,
                    const Eigen::Vector3d& eye) const;

    /// For drawing a mesh without a texture of its own.
    void set_plain_material(const ShaderProgram& surface) const;

private:
    /// The textures of one material.
    struct Images {
        GLuint color = 0;
        GLuint glow = 0;
        GLuint normal = 0;
        GLuint metal = 0;
    };

    void set_material(const ShaderProgram& surface, std::size_t material, bool both_sides) const;

    const GlFunctions& gl_;
    const CampusGeometry& geometry_;
    GpuMesh mesh_;
    GpuMesh blend_mesh_;
    GLuint white_ = 0;
    std::vector<Images> images_;  // one a material
};

}  // namespace campuswalk::engine::render
