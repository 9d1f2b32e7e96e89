#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "collision/base/storage.h"
#include "scene/model/origin.h"

namespace campuswalk::scene {

using collision::Storage;

/// Plain data of an imported model: nodes place meshes, meshes refer to a material, materials to textures.
/// `import_model` returns it in the world frame: metres, +Y up, right-handed.

enum class MeshIndex : std::uint32_t {};
enum class MaterialIndex : std::uint32_t {};
enum class TextureIndex : std::uint32_t {};

constexpr std::size_t index_of(MeshIndex i) {
    return static_cast<std::size_t>(i);
}
constexpr std::size_t index_of(MaterialIndex i) {
    return static_cast<std::size_t>(i);
}
constexpr std::size_t index_of(TextureIndex i) {
    return static_cast<std::size_t>(i);
}

/// What an image shows beyond its edges.
enum class Wrap : std::uint8_t { repeat, clamp, mirror };

/// Along the image's width and height.
struct TextureWrap {
    Wrap u = Wrap::repeat;
    Wrap v = Wrap::repeat;

    friend auto operator<=>(const TextureWrap&, const TextureWrap&) = default;
};

/// 8-bit sRGB colour with linear alpha, top row first.
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    Storage<std::uint8_t> rgba;  ///< 4 * width * height bytes
    TextureWrap wrap = {};
};

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0's metallic-roughness material (its section 3.9), reduced to what the renderer draws. All
/// textures share one set of texture coordinates.
struct Material {
    std::string name;
    std::array<float, 4> base_color = {1, 1, 1, 1};  ///< linear factor on the texture
    std::optional<TextureIndex> base_color_texture;
    float metallic = 0.0F;                                   ///< factor on the texture's blue
    float roughness = 1.0F;                                  ///< factor on the texture's green
    std::optional<TextureIndex> metallic_roughness_texture;  ///< linear, not sRGB
    std::optional<TextureIndex> normal_texture;              ///< tangent space, +Y up the image
    float normal_scale = 1.0F;                               ///< glTF's normalTexture.scale
    std::array<float, 3> emissive = {0, 0, 0};               ///< linear factor on the texture; may exceed 1
    std::optional<TextureIndex> emissive_texture;
    bool unlit = false;  ///< KHR_materials_unlit
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5F;  ///< for AlphaMode::mask
    bool double_sided = false;
};

/// Indexed triangles, counter-clockwise seen from outside in the world frame: the mesh of a mirroring node is
/// wound clockwise in its own frame.
struct Mesh {
    std::string name;
    Storage<Eigen::Vector3f> positions;
    Storage<Eigen::Vector3f> normals;                 ///< one per position, unit length
    Storage<Eigen::Vector2f> uvs;                     ///< empty or one per position; v points down (glTF)
    Storage<std::array<std::uint8_t, 4>> colors;      ///< empty or one per position; linear RGBA
    Storage<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions
    MaterialIndex material{};
};

/// A node of the hierarchy. Parents precede their children.
struct Node {
    std::string name;
    int parent = -1;                                             ///< index into Model::nodes, -1 for a root
    Eigen::Matrix4d X_world_node = Eigen::Matrix4d::Identity();  ///< affine
    std::vector<MeshIndex> meshes;
};

struct Model {
    std::string file;  ///< as the user named it
    std::vector<Node> nodes;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::optional<GeographicPlace> geographic;  ///< the location that the file states
};

/// An axis-aligned box; empty (min > max) by default.
struct Bounds {
    Eigen::Vector3d min = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d max = Eigen::Vector3d::Constant(-1e300);

    bool empty() const { return min.x() > max.x(); }
    Eigen::Vector3d center() const { return 0.5 * (min + max); }
    void extend(const Eigen::Vector3d& point) {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
    void extend(const Bounds& other) {
        min = min.cwiseMin(other.min);
        max = max.cwiseMax(other.max);
    }
};

/// Triangles as drawn: a mesh with three instances counts three times.
std::size_t count_triangles(const Model& model);
Bounds world_bounds(const Model& model);
/// What its meshes and textures take in memory.
std::uint64_t count_bytes(const Model& model);

/// The first node with a mesh that reaches farther than `most` metres along an axis; none on any real campus.
std::optional<std::size_t> find_node_beyond(const Model& model, double most);

/// The origin to subtract from map coordinates: per axis the bounds' centre, rounded to whole kilometres, if
/// it is over kFarAway from 0, else 0. The rounding keeps it stable under small changes of the model.
Eigen::Vector3d origin_near(const Bounds& bounds);

/// Subtracts `origin` from all world coordinates.
void move_origin(Model& model, const Eigen::Vector3d& origin);

/// Indices of the nodes whose name matches the glob, and of all their descendants; ascending, unique.
std::vector<std::size_t> match_nodes(const Model& model, const std::string& glob);

}  // namespace campuswalk::scene
