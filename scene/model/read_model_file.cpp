#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/mesh/mesh_extent.h"
#include "scene/base/diagnostic_archive.h"
#include "scene/model/model_file.h"
#include "scene/model/model_limits.h"

namespace campuswalk::scene {
namespace {

[[noreturn]] void refuse(const char* reason) {
    throw DamagedFile(reason);
}

template <typename Element>
Storage<Element> take_counted(ArchiveReader& in) {
    const std::size_t count = in.take_count(sizeof(Element));
    return in.take_aligned<Element>(count);
}

float take_finite(ArchiveReader& in) {
    const auto number = in.take<float>();
    if (!std::isfinite(number)) {
        refuse("a colour in it is not a number");
    }
    return number;
}

template <std::size_t Count>
void take_finite(ArchiveReader& in, std::array<float, Count>& numbers) {
    for (float& number : numbers) {
        number = take_finite(in);
    }
}

// The size of an entry with empty strings and arrays, bytes.
constexpr std::size_t kMinRequestBytes = 12;
constexpr std::size_t kMinTextureBytes = 28;
constexpr std::size_t kMinMaterialBytes = 88;
constexpr std::size_t kMinMeshBytes = 52;
constexpr std::size_t kMinNodeBytes = 116;

FileRequest take_request(ArchiveReader& in) {
    FileRequest request;
    request.uri = in.take_text();
    request.image = in.take_flag();
    return request;
}

Wrap take_wrap(ArchiveReader& in) {
    const auto wrap = in.take<std::uint32_t>();
    if (wrap > static_cast<std::uint32_t>(Wrap::mirror)) {
        throw DamagedFile("a texture's wrap mode is unknown");
    }
    return static_cast<Wrap>(wrap);
}

Texture take_texture(ArchiveReader& in) {
    constexpr std::int32_t kMaxSide = 1 << 24U;
    Texture texture;
    texture.name = in.take_text();
    texture.width = in.take<std::int32_t>();
    texture.height = in.take<std::int32_t>();
    texture.wrap.u = take_wrap(in);
    texture.wrap.v = take_wrap(in);
    texture.rgba = take_counted<std::uint8_t>(in);
    const bool sized =
        texture.width > 0 && texture.height > 0 && texture.width <= kMaxSide && texture.height <= kMaxSide;
    if (!sized ||
        static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height) * 4 !=
            texture.rgba.size()) {
        refuse("an image in it has the wrong number of pixels");
    }
    return texture;
}

std::optional<TextureIndex> take_texture_index(ArchiveReader& in, std::size_t textures) {
    const bool textured = in.take_flag();
    const std::uint32_t texture = in.take_below(textured ? textures : 1, "texture's number");
    return textured ? std::optional(static_cast<TextureIndex>(texture)) : std::nullopt;
}

Material take_material(ArchiveReader& in, std::size_t textures) {
    Material material;
    material.name = in.take_text();
    take_finite(in, material.base_color);
    take_finite(in, material.emissive);
    material.base_color_texture = take_texture_index(in, textures);
    material.emissive_texture = take_texture_index(in, textures);
    material.normal_texture = take_texture_index(in, textures);
    material.metallic_roughness_texture = take_texture_index(in, textures);
    material.normal_scale = take_finite(in);
    material.metallic = take_finite(in);
    material.roughness = take_finite(in);
    material.alpha_mode = static_cast<AlphaMode>(in.take_below(3, "transparency"));
    material.alpha_cutoff = take_finite(in);
    material.double_sided = in.take_flag();
    material.unlit = in.take_flag();
    return material;
}

void check_mesh(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto fits = [&](std::size_t count) { return count == 0 || count == vertices; };
    if (mesh.normals.size() != vertices || !fits(mesh.uvs.size()) || !fits(mesh.colors.size())) {
        refuse("a mesh in it does not have one normal, texture coordinate or colour per vertex");
    }
    if (!std::isfinite(collision::largest_coordinate(mesh.positions))) {
        refuse("a vertex in it is not a number");
    }
    if (!mesh.triangles.empty() && collision::highest_vertex(mesh.triangles) >= vertices) {
        refuse("a triangle in it refers to a vertex that does not exist");
    }
}

Mesh take_mesh(ArchiveReader& in, std::size_t materials) {
    Mesh mesh;
    mesh.name = in.take_text();
    mesh.material = static_cast<MaterialIndex>(in.take_below(materials, "material's number"));
    mesh.positions = take_counted<Eigen::Vector3f>(in);
    mesh.normals = take_counted<Eigen::Vector3f>(in);
    mesh.uvs = take_counted<Eigen::Vector2f>(in);
    mesh.colors = take_counted<std::array<std::uint8_t, 4>>(in);
    mesh.triangles = take_counted<std::array<std::uint32_t, 3>>(in);
    check_mesh(mesh);
    return mesh;
}

Node take_node(ArchiveReader& in, std::size_t nodes_before, std::size_t meshes) {
    Node node;
    node.name = in.take_text();
    node.parent = in.take<std::int32_t>();
    if (node.parent < -1 || node.parent >= static_cast<std::int64_t>(nodes_before)) {
        refuse("a node in it comes before its parent");
    }
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = 0; column < 4; ++column) {
            node.X_world_node(row, column) = in.take<double>();
        }
    }
    if (!node.X_world_node.allFinite()) {
        refuse("a transform in it is not finite");
    }
    node.meshes = in.take_all<MeshIndex>(in.take_count(sizeof(MeshIndex)));
    if (std::ranges::any_of(node.meshes, [&](MeshIndex mesh) { return index_of(mesh) >= meshes; })) {
        refuse("a node in it refers to a mesh that does not exist");
    }
    return node;
}

std::optional<GeographicPlace> take_geographic(ArchiveReader& in) {
    if (!in.take_flag()) {
        return std::nullopt;
    }
    GeographicPlace place;
    place.latitude_deg = in.take<double>();
    place.longitude_deg = in.take<double>();
    place.height = in.take<double>();
    for (double& along : place.at) {
        along = in.take<double>();
    }
    const bool on_earth = std::abs(place.latitude_deg) <= kMaxLatitude &&
                          std::abs(place.longitude_deg) <= kMaxLongitude && std::isfinite(place.height);
    if (!on_earth || !place.at.allFinite()) {
        refuse("a geographic place in it is out of range");
    }
    return place;
}

template <typename Item, typename Take>
std::vector<Item> take_each(ArchiveReader& in, std::size_t min_bytes, const Take& take) {
    std::vector<Item> items;
    const std::size_t count = in.take_count(min_bytes);
    items.reserve(count);
    while (items.size() < count) {
        items.push_back(take(items.size()));
    }
    return items;
}

}  // namespace

ImportedModel read_model_file(std::span<const std::byte> bytes, std::shared_ptr<const void> owner) {
    ArchiveReader in(bytes, kModelFile, std::move(owner));
    ImportedModel read;
    Model& model = read.model;
    read.warnings = take_each<Diagnostic>(in, kMinDiagnosticBytes, [&](auto) { return take_diagnostic(in); });
    read.requests = take_each<FileRequest>(in, kMinRequestBytes, [&](auto) { return take_request(in); });
    model.file = in.take_text();
    model.geographic = take_geographic(in);
    model.textures = take_each<Texture>(in, kMinTextureBytes, [&](auto) { return take_texture(in); });
    model.materials = take_each<Material>(in, kMinMaterialBytes,
                                          [&](auto) { return take_material(in, model.textures.size()); });
    model.meshes =
        take_each<Mesh>(in, kMinMeshBytes, [&](auto) { return take_mesh(in, model.materials.size()); });
    model.nodes = take_each<Node>(
        in, kMinNodeBytes, [&](std::size_t before) { return take_node(in, before, model.meshes.size()); });
    in.finish();
    if (find_node_beyond(model, kMaxReach)) {
        refuse("a node in it reaches too far");
    }
    return read;
}

}  // namespace campuswalk::scene
