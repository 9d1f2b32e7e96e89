#pragma once

#include <vector>

#include "scene/import/gltf/accessors.h"
#include "scene/import/gltf/deformation.h"
#include "scene/import/gltf/document.h"
#include "scene/import/gltf/materials.h"
#include "scene/import/source/sanitize_mesh.h"

namespace campuswalk::scene::gltf {

/// Reads the primitives of all meshes, which are numbered consecutively, and after them those of deformed
/// meshes.
class Primitives {
public:
    Primitives(const Document& document, Buffers& buffers, const std::vector<GltfMaterial>& materials);

    /// A mesh has the primitives `[first(mesh), first(mesh + 1))`.
    std::size_t first(std::size_t mesh) const { return first_[mesh]; }
    std::size_t mesh_count() const { return first_.size() - 1; }
    /// The number of the first primitive of mesh `mesh` deformed so; the others follow.
    std::size_t add_deformed(std::size_t mesh, Deformation deformation);
    RawMesh read(std::size_t number);

    std::size_t without_data() const { return accessors_.without_data() + without_positions_; }

private:
    struct Deformed {
        std::size_t first;  // the number of its first primitive
        std::size_t mesh;
        Deformation deformation;
    };
    struct Numbered {
        std::size_t mesh;
        std::size_t primitive;  // of the mesh
        const Deformation* deformation;
    };
    Numbered find(std::size_t number) const;
    void read_attributes(const JsonObject& primitive, const JsonObject& attributes, RawMesh& out);
    std::vector<JointSet> read_draco(const JsonObject& compression, bool skinned, RawMesh& out);
    std::vector<MorphTarget> read_targets(const JsonObject& primitive, const std::vector<float>& weights,
                                          const RawMesh& mesh);
    void deform(const JsonObject& primitive, const Deformation& deformation,
                const std::vector<JointSet>& joints, RawMesh& out);
    void read_triangles(const JsonObject& primitive, RawMesh& out);
    /// The attribute with the texture coordinates that the mesh's material uses.
    std::string uv_name(const RawMesh& mesh) const;
    void transform_uvs(RawMesh& mesh) const;

    const Document& document_;
    Buffers& buffers_;
    const std::vector<GltfMaterial>& materials_;
    Accessors accessors_;
    std::vector<std::size_t> first_;  // by mesh, and one past the end
    std::vector<Deformed> deformed_;
    std::size_t past_end_ = 0;  // of all numbers
    std::size_t without_positions_ = 0;
};

}  // namespace campuswalk::scene::gltf
