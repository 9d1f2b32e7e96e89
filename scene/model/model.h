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

/// Plain data of an imported model: nodes place meshes, meshes have a material, materials name textures.
/// Everything is in the house frame (metres, +Y up, right-handed) once `import_model` returns it.

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

/// 8-bit sRGB colour with linear alpha, rows from top to bottom.
struct Texture {
    std::string name;
    int width = 0;
    int height = 0;
    Storage<std::uint8_t> rgba;  ///< 4 * width * height bytes
    bool repeat = true;          ///< wrap mode; false clamps to the edge
};

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0's metallic-roughness material (its section 3.9), reduced to what the renderer draws. All of its
/// textures lie by the same texture coordinates.
struct Material {
    std::string name;
    std::array<float, 4> base_color = {1, 1, 1, 1};  ///< linear factor, multiplies the texture
    std::optional<TextureIndex> base_color_texture;
    float metallic = 0.0F;   ///< 0 paint or stone, 1 bare metal; multiplies the texture's blue
    float roughness = 1.0F;  ///< 0 a mirror, 1 matt; multiplies the texture's green
    std::optional<TextureIndex> metallic_roughness_texture;  ///< of numbers, not of colours
    std::optional<TextureIndex> normal_texture;              ///< tangent space, +Y up the image
    float normal_scale = 1.0F;                               ///< how strongly it bends the surface
    std::array<float, 3> emissive = {0, 0, 0};               ///< linear, multiplies the texture; may exceed 1
    std::optional<TextureIndex> emissive_texture;
    bool unlit = false;  ///< its colour as it is, without light and shadow (KHR_materials_unlit)
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5F;  ///< for AlphaMode::mask
    bool double_sided = false;
};

/// Indexed triangles, counter-clockwise seen from outside once a node has placed them: the mesh of a node
/// that mirrors is wound the other way round.
struct Mesh {
    std::string name;
    Storage<Eigen::Vector3f> positions;
    Storage<Eigen::Vector3f> normals;                 ///< one a position, unit length
    Storage<Eigen::Vector2f> uvs;                     ///< empty or one a position; v runs down (glTF)
    Storage<std::array<std::uint8_t, 4>> colors;      ///< empty or one a position; linear RGBA
    Storage<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions
    MaterialIndex material{};
};

/// A named place in the hierarchy. Parents come before their children.
struct Node {
    std::string name;
    int parent = -1;                                             ///< index into Model::nodes, -1 at the root
    Eigen::Matrix4d X_world_node = Eigen::Matrix4d::Identity();  ///< affine, maps mesh positions to the world
    std::vector<MeshIndex> meshes;
};

struct Model {
    std::string file;  ///< as the user named it
    std::vector<Node> nodes;
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::optional<GeographicPlace> geographic;  ///< where the file says it is on the Earth
};

/// World-space bounds, empty (min > max) for a model without a vertex.
struct Bounds {
    Eigen::Vector3d min = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d max = Eigen::Vector3d::Constant(-1e300);

    bool empty() const { return min.x() > max.x(); }
    void extend(const Eigen::Vector3d& point) {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
};

/// Triangles as drawn: a mesh placed by three nodes counts three times.
std::size_t count_triangles(const Model& model);
Bounds world_bounds(const Model& model);

/// What to take off the coordinates of a map to come near 0: along each axis the whole kilometres next to
/// the middle where that is over 10 km away, else 0. Small changes of a model don't change it.
Eigen::Vector3d origin_near(const Bounds& bounds);

/// Takes `origin` off all coordinates of the world.
void move_origin(Model& model, const Eigen::Vector3d& origin);

/// Indices of the nodes whose name matches the glob (`*`, `?`, `[a-z]`), each with its whole subtree,
/// ascending and without repeats.
std::vector<std::size_t> match_nodes(const Model& model, const std::string& glob);

}  // namespace campuswalk::scene
