#pragma once

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

/// An image as a material names it: a path, or `*N` for the N-th that is embedded in the file.
struct TextureReference {
    std::string uri;
    bool repeat = true;
};

/// An image that a material names, and what of it the image is: `&Material::normal_texture`.
struct SourceImage {
    std::optional<TextureIndex> Material::*use = nullptr;
    TextureReference reference;
};

struct SourceMaterial {
    Material material;                ///< without its textures, which are loaded apart
    std::vector<SourceImage> images;  ///< at most one for each use
    unsigned int uv_channel = 0;      ///< the texture coordinates that all of them lie by
    bool cut_out_by_texture = false;  ///< no alpha mode in the file: a texture with holes makes it `mask`
};

/// The hierarchy, parents first, in the order of the document: `mesh_numbers[i]` are the reader's numbers of
/// what node i draws.
struct NodeTree {
    std::vector<Node> nodes;  ///< in the house frame, not yet with meshes
    std::vector<std::vector<std::size_t>> mesh_numbers;
};

/// A model file, opened. What readers of different formats have in common; build_model makes a Model of it.
/// Every member may throw InputError (bad-model).
class ModelSource {
public:
    ModelSource() = default;
    ModelSource(const ModelSource&) = delete;
    ModelSource& operator=(const ModelSource&) = delete;
    virtual ~ModelSource() = default;

    virtual NodeTree nodes() = 0;
    virtual const std::vector<SourceMaterial>& materials() = 0;  ///< at least one
    virtual RawMesh mesh(std::size_t number) = 0;
    /// Where the file says it is on the Earth, asked for after the nodes.
    virtual std::optional<GeographicPlace> geographic() const = 0;
    /// nullopt when it is missing or can't be decoded, with the reason.
    virtual std::optional<DecodedImage> load_image(const TextureReference& reference,
                                                   std::string& reason) = 0;
    /// How surfaces without normals are shaded: flat as glTF demands, else creased.
    virtual bool flat_normals() const = 0;
    /// What was passed over or made up, asked for after all else.
    virtual void add_warnings(DiagnosticList& warnings) = 0;
    /// The other files that were asked for so far.
    virtual std::vector<FileRequest> requests() const = 0;
};

}  // namespace campuswalk::scene
