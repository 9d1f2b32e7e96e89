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

/// Selects the program that draws a material.
using ProgramSelector = std::function<const ShaderProgram&(const scene::Material&)>;

/// The campus in GPU memory, and how to draw it. Must not outlive its context.
class GpuCampus {
public:
    /// `geometry` must outlive this.
    GpuCampus(const GlFunctions& gl, const CampusGeometry& geometry);

    /// Draws the depth of all opaque and masked surfaces, each with its program. Sets `clip_campus` in both.
    void draw_depth(const ShaderProgram& opaque, const ShaderProgram& masked,
                    const Eigen::Matrix4d& clip_campus) const;

    /// Draws the surfaces of one alpha mode (opaque or mask) front to back from `eye` (campus frame).
    /// `program_of` must return a program whose uniforms are set except for the material's. `depth`, if not
    /// null, culls occluded batches.
    void draw_solid(const ProgramSelector& program_of, scene::AlphaMode mode, const Frustum& frustum,
                    const Eigen::Vector3d& eye, HierarchicalZ* depth = nullptr) const;

    /// Draws blended triangles back to front from `eye`.
    void draw_blend(const ProgramSelector& program_of, const Frustum& frustum,
                    const Eigen::Vector3d& eye) const;

    /// For drawing a mesh without a material.
    void set_plain_material(const ShaderProgram& surface) const;

private:
    /// The textures of one material.
    struct MaterialTextures {
        GLuint color = 0;
        GLuint emissive = 0;
        GLuint normal = 0;
        GLuint metallic_roughness = 0;
    };

    void set_material(const ShaderProgram& surface, std::size_t material, bool double_sided) const;

    const GlFunctions& gl_;
    const CampusGeometry& geometry_;
    GpuMesh mesh_;
    GpuMesh blend_mesh_;
    GLuint white_ = 0;
    std::vector<MaterialTextures> textures_;  // one per material
};

}  // namespace campuswalk::engine::render
