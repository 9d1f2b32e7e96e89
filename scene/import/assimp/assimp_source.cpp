#include "scene/import/assimp/assimp_source.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <unordered_map>
#include <utility>

#include <assimp/material.h>
#include <assimp/scene.h>

#include "scene/import/assimp/convert_nodes.h"
#include "scene/import/source/file_frame.h"
#include "scene/import/source/obj_text.h"
#include "scene/import/source/stl_text.h"

struct aiMaterial;

namespace campuswalk::scene {

namespace {

// Below this, an exporter confused opacity with transparency: nobody models invisible surfaces.
constexpr float kMinOpacity = 0.02F;
constexpr float kBlack = 0.01F;

float linear_from_srgb(float value) {
    const float v = unit_factor(value);
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

Wrap wrap_of(aiTextureMapMode mode) {
    return mode == aiTextureMapMode_Mirror                                    ? Wrap::mirror
           : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? Wrap::clamp
                                                                              : Wrap::repeat;
}

/// Adds the image of the first of `types` that the material has. The texture coordinates of a material's
/// first image apply to all: in practice these formats have one set.
void add_image(const aiMaterial& source, std::initializer_list<aiTextureType> types,
               std::optional<TextureIndex> Material::*use, SourceMaterial& out) {
    for (const aiTextureType type : types) {
        aiString path;
        unsigned int channel = 0;
        aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
        if (source.GetTexture(type, 0, &path, nullptr, &channel, nullptr, nullptr, modes) ==
                aiReturn_SUCCESS &&
            path.length > 0) {
            if (out.images.empty()) {
                out.uv_channel = channel;
            }
            out.images.push_back({use, {path.C_Str(), {wrap_of(modes[0]), wrap_of(modes[1])}}});
            return;
        }
    }
}

/// Diffuse colours of older formats are sRGB, and often black if there is a texture.
void convert_color(const aiMaterial& source, const aiColor4D& diffuse, SourceMaterial& out) {
    const bool textured = !out.images.empty();
    const bool black = std::max({diffuse.r, diffuse.g, diffuse.b}) < kBlack;
    auto& color = out.material.base_color;
    if (!(textured && black)) {
        color = {linear_from_srgb(diffuse.r), linear_from_srgb(diffuse.g), linear_from_srgb(diffuse.b), 1.0F};
    }
    float opacity = 1.0F;
    source.Get(AI_MATKEY_OPACITY, opacity);
    if (std::isfinite(opacity) && opacity >= kMinOpacity && opacity < 1.0F) {
        color[3] = opacity;
        out.material.alpha_mode = AlphaMode::blend;
    }
}

/// The diffuse colour becomes the base colour. Formats older than glTF have neither culling nor alpha modes:
/// their materials are double-sided, and blended if their opacity is below 1.
SourceMaterial convert_material(const aiMaterial& source) {
    SourceMaterial out;
    Material& material = out.material;
    aiString name;
    if (source.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) {
        material.name = name.C_Str();
    }
    add_image(source, {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}, &Material::base_color_texture, out);

    aiColor4D diffuse(1, 1, 1, 1);
    source.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse);
    aiColor3D emissive(0, 0, 0);
    source.Get(AI_MATKEY_COLOR_EMISSIVE, emissive);
    convert_color(source, diffuse, out);
    material.emissive = {linear_from_srgb(emissive.r), linear_from_srgb(emissive.g),
                         linear_from_srgb(emissive.b)};
    material.double_sided = true;
    out.cut_out_by_texture = material.alpha_mode == AlphaMode::opaque;
    const std::size_t images = out.images.size();
    add_image(source, {aiTextureType_EMISSIVE}, &Material::emissive_texture, out);
    if (out.images.size() > images && std::ranges::max(material.emissive) < kBlack) {
        material.emissive = {1, 1, 1};  // black beside a texture means no factor
    }
    add_image(source, {aiTextureType_NORMALS}, &Material::normal_texture, out);
    return out;
}

/// Pixels that assimp has already decoded.
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

std::vector<Eigen::Vector3f> to_vectors(const aiVector3D* source, unsigned int count) {
    std::vector<Eigen::Vector3f> result;
    result.reserve(count);
    for (unsigned int i = 0; i < count; ++i) {
        result.emplace_back(source[i].x, source[i].y, source[i].z);
    }
    return result;
}

void convert_faces(const aiMesh& source, RawMesh& out) {
    out.triangles.reserve(source.mNumFaces);
    for (unsigned int i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices == 3) {
            out.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
        }
    }
    out.points_and_lines = source.mNumFaces - out.triangles.size();
}

/// `uv_channel`: of the mesh's material.
RawMesh convert_mesh(const aiMesh& source, unsigned int uv_channel) {
    RawMesh out;
    const unsigned int count = source.mNumVertices;
    out.name = source.mName.C_Str();
    out.material = source.mMaterialIndex;
    convert_faces(source, out);
    out.positions = to_vectors(source.mVertices, count);
    if (source.HasNormals()) {
        out.normals = to_vectors(source.mNormals, count);
    }
    if (uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && source.HasTextureCoords(uv_channel)) {
        for (unsigned int i = 0; i < count; ++i) {
            const aiVector3D& uv = source.mTextureCoords[uv_channel][i];
            out.uvs.emplace_back(uv.x, 1.0F - uv.y);  // assimp's v points up, ours down
        }
    }
    if (source.HasVertexColors(0)) {
        for (unsigned int i = 0; i < count; ++i) {
            const aiColor4D& c = source.mColors[0][i];
            out.colors.push_back(to_rgba8(c.r, c.g, c.b, c.a));
        }
    }
    return out;
}

/// The name that the file has for an object of normalize_obj.
std::string without_number(const std::string& name) {
    return name.substr(0, name.rfind(kObjectNumber));
}

/// Gives the objects of OBJ text their names back, and makes one node of those with the same name.
void join_objects(NodeTree& tree) {
    NodeTree joined;
    std::unordered_map<std::string, std::size_t> by_name;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        Node& node = tree.nodes[i];
        const bool is_numbered = node.name.find(kObjectNumber) != std::string::npos;
        node.name = without_number(node.name);
        const auto known =
            is_numbered ? by_name.emplace(node.name, joined.nodes.size()) : std::pair(by_name.end(), true);
        if (known.second) {
            joined.nodes.push_back(std::move(node));
            joined.mesh_numbers.push_back(std::move(tree.mesh_numbers[i]));
        } else {
            std::vector<std::size_t>& meshes = joined.mesh_numbers[known.first->second];
            meshes.insert(meshes.end(), tree.mesh_numbers[i].begin(), tree.mesh_numbers[i].end());
        }
    }
    tree = std::move(joined);
}

}  // namespace

AssimpSource::AssimpSource(const SceneFile& file) : file_(file), folder_(file) {
    read_scene(file, folder_, read_);
    for (unsigned int i = 0; i < read_.scene->mNumMaterials; ++i) {
        materials_.push_back(convert_material(*read_.scene->mMaterials[i]));
    }
    if (materials_.empty()) {
        materials_.emplace_back();
    }
}

bool AssimpSource::is_obj() const {
    return lower_case(file_.path.extension().string()) == ".obj";
}

NodeTree AssimpSource::nodes() {
    const aiScene& scene = *read_.scene;
    Eigen::Matrix4d X_file_moved = Eigen::Matrix4d::Identity();
    X_file_moved.topRightCorner<3, 1>() = read_.files->origin();
    NodeTree tree = convert_nodes(scene, world_from_file(file_, scene) * X_file_moved);
    replace_generated_names(tree);
    if (is_obj()) {
        join_objects(tree);
    }
    for (Node& node : tree.nodes) {
        node.name = name_of_solid(std::move(node.name));
    }
    return tree;
}

std::optional<GeographicPlace> AssimpSource::geographic() const {
    std::optional<GeographicPlace> place = read_.files->geographic().place;
    if (place) {
        place->at = file_.position;  // the location is that of the file's origin
    }
    return place;
}

/// COLLADA nodes without a name get their id as name.
void AssimpSource::replace_generated_names(NodeTree& tree) const {
    const auto is_generated = [](const Node& node) { return node.name.starts_with(kGeneratedColladaName); };
    if (!std::ranges::any_of(tree.nodes, is_generated)) {
        return;
    }
    ReadScene with_ids;
    read_scene(file_, folder_, with_ids, ColladaNames::ids);
    const NodeTree ids = convert_nodes(*with_ids.scene, Eigen::Matrix4d::Identity());
    for (std::size_t i = 0; i < tree.nodes.size() && ids.nodes.size() == tree.nodes.size(); ++i) {
        if (is_generated(tree.nodes[i])) {
            tree.nodes[i].name = ids.nodes[i].name;
        }
    }
}

RawMesh AssimpSource::mesh(std::size_t number) {
    const aiMesh& source = *read_.scene->mMeshes[number];
    const SourceMaterial& material =
        materials_[source.mMaterialIndex < materials_.size() ? source.mMaterialIndex : 0];
    RawMesh mesh = convert_mesh(source, material.uv_channel);
    mesh.name = is_obj() ? without_number(mesh.name) : name_of_solid(std::move(mesh.name));
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
    return decode_image({reinterpret_cast<const std::uint8_t*>(embedded->pcData), embedded->mWidth}, reason);
}

void AssimpSource::add_warnings(DiagnosticList& warnings) {
    if (read_.files->dropped_uvs()) {
        warnings.warning(
            file_.mark, "repaired-uvs",
            file_.file + ": faces refer to texture coordinates, but the file has none; they are ignored");
    }
    if (read_.files->moves_images()) {
        warnings.warning(
            file_.mark, "unsupported-feature",
            file_.file +
                ": its material file scales or moves images (-s, -o or -t), which is ignored; put "
                "that into the texture coordinates, and export again");
    }
    if (has_left_handed_axes(*read_.scene)) {
        warnings.warning(file_.mark, "unsupported-feature",
                         file_.file +
                             ": its axes are left-handed (CoordAxis, UpAxis, FrontAxis), read as +X, +Y "
                             "and +Z; export it with right-handed axes");
    }
    if (const auto others = nodes_of_other_inheritance(*read_.scene); !others.empty()) {
        warnings.warning(file_.mark, "unsupported-feature",
                         file_.file +
                             ": nodes that don't take the scale of their parents as others do (FBX "
                             "InheritType), read as if they did: " +
                             std::to_string(others.size()) + ", the first '" + others.front() +
                             "'; apply the scale of what is above them, and export again");
    }
    if (!read_.files->geographic().error.empty()) {
        warnings.warning(file_.mark, "bad-geography",
                         file_.file + ": its geographic_location " + read_.files->geographic().error +
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
