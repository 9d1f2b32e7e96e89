#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/import/source/decode_image.h"
#include "scene/import/source/sanitize_mesh.h"
#include "scene/model/model.h"
#include "scene/model/model_file.h"

namespace campuswalk::scene {

/// A material's reference to an image: a path, or `*N` for the N-th image embedded in the file.
struct TextureReference {
    std::string uri;
    TextureWrap wrap = {};
};

/// An image of a material and the member that it belongs to, such as `&Material::normal_texture`.
struct SourceImage {
    std::optional<TextureIndex> Material::*use = nullptr;
    TextureReference reference;
};

/// A colour or factor limited to 0..1; 1 if it is not finite.
inline float unit_factor(float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
}

struct SourceMaterial {
    Material material;                ///< without textures, which are loaded later
    std::vector<SourceImage> images;  ///< at most one per use
    unsigned int uv_channel = 0;      ///< the set of texture coordinates of all images
    bool cut_out_by_texture = false;  ///< the format has no alpha mode: `mask` if the texture has holes
};

/// The hierarchy in document order, parents first. Node i draws the source's meshes `mesh_numbers[i]`.
struct NodeTree {
    std::vector<Node> nodes;  ///< in the world frame, without meshes
    std::vector<std::vector<std::size_t>> mesh_numbers;
};

/// An open model file: the interface of the readers, from which import_model makes a Model. Every member may
/// throw InputError (bad-model).
class ModelSource {
public:
    ModelSource() = default;
    ModelSource(const ModelSource&) = delete;
    ModelSource& operator=(const ModelSource&) = delete;
    virtual ~ModelSource() = default;

    virtual NodeTree nodes() = 0;
    virtual const std::vector<SourceMaterial>& materials() = 0;  ///< at least one
    virtual RawMesh mesh(std::size_t number) = 0;
    /// The location that the file states. Call after nodes().
    virtual std::optional<GeographicPlace> geographic() const = 0;
    /// nullopt if it is missing or can't be decoded; `reason` then completes "texture X …".
    virtual std::optional<DecodedImage> load_image(const TextureReference& reference,
                                                   std::string& reason) = 0;
    /// Whether meshes without normals get flat ones, as glTF requires; else smooth ones with creases.
    virtual bool flat_normals() const = 0;
    /// What was ignored or repaired. Call last.
    virtual void add_warnings(DiagnosticList& warnings) = 0;
    /// The lookups of other files so far.
    virtual std::vector<FileRequest> requests() const = 0;
};

}  // namespace campuswalk::scene
