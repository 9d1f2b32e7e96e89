#include "scene/export/named_glb.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/export/glb_container.h"

namespace campuswalk::scene {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;

template <typename Values>
std::string_view bytes_of(const Values& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data())};
}

/// What a buffer view holds: an attribute or the indices of all meshes, or one image.
enum class Content { positions, normals, uvs, indices, image };

Json view_json(Content content, std::size_t offset, std::size_t length) {
    constexpr int kStrides[] = {12, 12, 8, 0, 0};
    Json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
    if (const int stride = kStrides[static_cast<std::size_t>(content)]; stride > 0) {
        view["byteStride"] = stride;
    }
    if (content != Content::image) {
        view["target"] = content == Content::indices ? kIndexData : kVertexData;
    }
    return view;
}

class NamedGlb {
public:
    explicit NamedGlb(const Model& model) : model_(model) {}

    std::string file(std::span<const std::string> images) {
        Json nodes = Json::array();
        Json roots = Json::array();
        for (const Node& node : model_.nodes) {
            roots.push_back(nodes.size());
            nodes.push_back(node_json(node));
        }
        Json materials = Json::array();
        for (const Material& material : model_.materials) {
            materials.push_back(material_json(material));
        }
        Json document = {{"asset", {{"version", "2.0"}, {"generator", "campuswalk"}}},
                         {"scene", 0},
                         {"scenes", {{{"nodes", roots}}}},
                         {"nodes", nodes},
                         {"meshes", meshes_},
                         {"materials", materials},
                         {"accessors", accessors_}};
        for (std::size_t i = 0; i < images.size(); ++i) {
            document["textures"].push_back({{"source", i}, {"sampler", 0}});
            document["samplers"] = {Json::object()};
            document["images"].push_back({{"bufferView", contents_.size()},
                                          {"mimeType", "image/png"},
                                          {"name", model_.textures[i].name}});
            append(contents_.size(), Content::image, images[i]);
        }
        std::size_t length = 0;
        for (std::size_t i = 0; i < contents_.size(); ++i) {
            document["bufferViews"].push_back(view_json(contents_[i], length, bytes_[i].size()));
            length += bytes_[i].size();
        }
        document["buffers"] = {{{"byteLength", length}}};
        return glb_container(document.dump(-1, ' ', false, Json::error_handler_t::replace), bytes_);
    }

private:
    Json node_json(const Node& node) {
        Json json = {{"name", node.name}};
        if (!node.meshes.empty()) {
            Json primitives = Json::array();
            for (const MeshIndex mesh : node.meshes) {
                primitives.push_back(primitive_json(model_.meshes[index_of(mesh)]));
            }
            json["mesh"] = meshes_.size();
            meshes_.push_back({{"name", node.name}, {"primitives", primitives}});
        }
        return json;
    }

    Json primitive_json(const Mesh& mesh) {
        const auto numbers = [](const Eigen::Vector3f& v) { return Json{v.x(), v.y(), v.z()}; };
        Eigen::Vector3f low = mesh.positions.front();
        Eigen::Vector3f high = low;
        for (const Eigen::Vector3f& p : mesh.positions) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const std::size_t count = mesh.positions.size();
        const std::size_t position =
            add_array(Content::positions, bytes_of(mesh.positions), count, kFloat, "VEC3");
        accessors_[position]["min"] = numbers(low);
        accessors_[position]["max"] = numbers(high);
        Json attributes = {{"POSITION", position}};
        if (!mesh.normals.empty()) {
            attributes["NORMAL"] = add_array(Content::normals, bytes_of(mesh.normals), count, kFloat, "VEC3");
        }
        if (!mesh.uvs.empty()) {
            attributes["TEXCOORD_0"] = add_array(Content::uvs, bytes_of(mesh.uvs), count, kFloat, "VEC2");
        }
        return {{"attributes", attributes},
                {"indices", add_indices(mesh)},
                {"material", index_of(mesh.material)}};
    }

    std::size_t add_indices(const Mesh& mesh) {
        const std::size_t count = 3 * mesh.triangles.size();
        if (mesh.positions.size() >= 0xFFFF) {
            return add_array(Content::indices, bytes_of(mesh.triangles), count, kUnsignedInt, "SCALAR");
        }
        std::vector<std::uint16_t> values;
        values.reserve(count);
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t index : triangle) {
                values.push_back(static_cast<std::uint16_t>(index));
            }
        }
        return add_array(Content::indices, bytes_of(values), count, kUnsignedShort, "SCALAR");
    }

    /// Returns the number of its accessor.
    std::size_t add_array(Content content, std::string_view bytes, std::size_t count, int component,
                          const char* type) {
        const auto view = static_cast<std::size_t>(std::ranges::find(contents_, content) - contents_.begin());
        accessors_.push_back({{"bufferView", view},
                              {"byteOffset", append(view, content, bytes)},
                              {"componentType", component},
                              {"count", count},
                              {"type", type}});
        return accessors_.size() - 1;
    }

    /// To a view that may be new; returns the offset in it.
    std::size_t append(std::size_t view, Content content, std::string_view values) {
        if (view == contents_.size()) {
            contents_.push_back(content);
            bytes_.emplace_back();
        }
        std::string& bytes = bytes_[view];
        const std::size_t offset = bytes.size();
        bytes += values;
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        return offset;
    }

    static Json material_json(const Material& material) {
        Json json = {{"name", material.name},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", material.base_color},
                       {"metallicFactor", material.metallic},
                       {"roughnessFactor", material.roughness}}}};
        if (material.base_color_texture) {
            json["pbrMetallicRoughness"]["baseColorTexture"] = {
                {"index", index_of(*material.base_color_texture)}};
        }
        if (material.alpha_mode == AlphaMode::blend) {
            json["alphaMode"] = "BLEND";
        }
        if (material.double_sided) {
            json["doubleSided"] = true;
        }
        return json;
    }

    const Model& model_;
    std::vector<Content> contents_;   ///< by view
    std::vector<std::string> bytes_;  ///< likewise
    Json meshes_ = Json::array();
    Json accessors_ = Json::array();
};

}  // namespace

std::string write_named_glb(const Model& model, std::span<const std::string> images) {
    return NamedGlb(model).file(images);
}

}  // namespace campuswalk::scene
