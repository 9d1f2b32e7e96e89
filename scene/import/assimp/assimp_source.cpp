#include "scene/import/assimp/assimp_source.h"

#include <algorithm>

#include <assimp/scene.h>

#include "scene/import/assimp/convert_material.h"
#include "scene/import/assimp/convert_mesh.h"
#include "scene/import/assimp/convert_nodes.h"
#include "scene/import/source/file_frame.h"

namespace campuswalk::scene {
namespace {

/// Uncompressed pixels that an importer unpacked already.
DecodedImage from_texels(const aiTexture& source) {
    DecodedImage image;
    image.width = static_cast<int>(source.mWidth);
    image.height = static_cast<int>(source.mHeight);
    const std::size_t count = static_cast<std::size_t>(source.mWidth) * source.mHeight;
    image.rgba.reserve(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const aiTexel& texel = source.pcData[i];
        image.rgba.insert(image.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
    }
    return image;
}

}  // namespace

AssimpSource::AssimpSource(const SceneFile& file) : file_(file), folder_(file.path) {
    read_scene(file, folder_, read_);
    for (unsigned int i = 0; i < read_.scene->mNumMaterials; ++i) {
        materials_.push_back(convert_material(*read_.scene->mMaterials[i]));
    }
    if (materials_.empty()) {
        materials_.emplace_back();
    }
}

NodeTree AssimpSource::nodes() {
    const aiScene& scene = *read_.scene;
    Eigen::Matrix4d X_file_moved = Eigen::Matrix4d::Identity();
    X_file_moved.topRightCorner<3, 1>() = read_.files->origin();
    NodeTree tree = convert_nodes(*scene.mRootNode, world_from_file(file_, scene) * X_file_moved);
    for (std::vector<std::size_t>& numbers : tree.mesh_numbers) {
        std::erase_if(numbers, [&](std::size_t number) { return number >= scene.mNumMeshes; });
    }
    name_nodes(tree);
    return tree;
}

std::optional<GeographicPlace> AssimpSource::geographic() const {
    std::optional<GeographicPlace> place = read_.files->geographic().place;
    if (place) {
        place->at = file_.position;  // it is the place of the file's own origin
    }
    return place;
}

/// A COLLADA node may have an id and no name: its id is the author's word all the same.
void AssimpSource::name_nodes(NodeTree& tree) const {
    const auto is_made_up = [](const Node& node) { return node.name.starts_with(kGeneratedColladaName); };
    if (!std::ranges::any_of(tree.nodes, is_made_up)) {
        return;
    }
    ReadScene with_ids;
    read_scene(file_, folder_, with_ids, ColladaNames::ids);
    const NodeTree ids = convert_nodes(*with_ids.scene->mRootNode, Eigen::Matrix4d::Identity());
    for (std::size_t i = 0; i < tree.nodes.size() && ids.nodes.size() == tree.nodes.size(); ++i) {
        if (is_made_up(tree.nodes[i])) {
            tree.nodes[i].name = ids.nodes[i].name;
        }
    }
}

RawMesh AssimpSource::mesh(std::size_t number) {
    const aiMesh& source = *read_.scene->mMeshes[number];
    const SourceMaterial& material =
        materials_[source.mMaterialIndex < materials_.size() ? source.mMaterialIndex : 0];
    RawMesh mesh = convert_mesh(source, material.uv_channel);
    constexpr unsigned int kPointsAndLines = aiPrimitiveType_POINT | aiPrimitiveType_LINE;
    if (source.mPrimitiveTypes != 0 && (source.mPrimitiveTypes & ~kPointsAndLines) == 0) {
        mesh.points_and_lines = std::max<std::size_t>(mesh.points_and_lines, 1);
    }
    return mesh;
}

std::optional<DecodedImage> AssimpSource::load_image(const TextureReference& reference, std::string& reason) {
    const aiTexture* embedded = read_.scene->GetEmbeddedTexture(reference.uri.c_str());
    if (embedded == nullptr) {
        return read_image(folder_, reference.uri, reason);
    }
    if (embedded->mHeight > 0) {
        return from_texels(*embedded);
    }
    return decode_image_bytes({reinterpret_cast<const std::uint8_t*>(embedded->pcData), embedded->mWidth},
                              reason);
}

void AssimpSource::add_warnings(DiagnosticList& warnings) {
    if (read_.files->dropped_uvs()) {
        warnings.warning(
            file_.mark, "repaired-uvs",
            file_.file + ": faces refer to texture coordinates, but the file has none; they are ignored");
    }
    if (!read_.files->geographic().refused.empty()) {
        warnings.warning(file_.mark, "bad-geography",
                         file_.file + ": its geographic_location " + read_.files->geographic().refused +
                             "; the location is ignored");
    }
    for (const std::string& name : read_.files->refused()) {
        if (name.ends_with(".mtl")) {
            warnings.warning(file_.mark, "missing-materials",
                             file_.file + ": the material file '" + name +
                                 "' was not found; its materials are drawn in a plain colour");
            return;
        }
    }
}

}  // namespace campuswalk::scene
