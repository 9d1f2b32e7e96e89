#include "scene/export/named_glb.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

namespace campuswalk::scene {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// The binary chunk in three views: positions, normals, indices.
struct Buffers {
    std::string positions;
    std::string normals;
    std::string indices;
};

enum View { positions, normals, indices };

class NamedGlb {
public:
    explicit NamedGlb(const Model& model) : model_(model) {}

    std::string file() {
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
        const Json document = {
            {"asset", {{"version", "2.0"}, {"generator", "campuswalk"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", roots}}}},
            {"nodes", nodes},
            {"meshes", meshes_},
            {"materials", materials},
            {"accessors", accessors_},
            {"bufferViews",
             {view_json(0, buffers_.positions.size(), 12, kVertexData),
              view_json(buffers_.positions.size(), buffers_.normals.size(), 12, kVertexData),
              view_json(buffers_.positions.size() + buffers_.normals.size(), buffers_.indices.size(), 0,
                        kIndexData)}},
            {"buffers",
             {{{"byteLength",
                buffers_.positions.size() + buffers_.normals.size() + buffers_.indices.size()}}}}};
        return container(document.dump(-1, ' ', false, Json::error_handler_t::replace));
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
        Json position = accessor(positions, buffers_.positions.size(), mesh.positions.size(), kFloat, "VEC3");
        position["min"] = numbers(low);
        position["max"] = numbers(high);
        buffers_.positions +=
            bytes_of(std::span<const Eigen::Vector3f>(mesh.positions.data(), mesh.positions.size()));
        const Json normal = accessor(normals, buffers_.normals.size(), mesh.normals.size(), kFloat, "VEC3");
        buffers_.normals +=
            bytes_of(std::span<const Eigen::Vector3f>(mesh.normals.data(), mesh.normals.size()));
        const std::size_t position_at = keep(position);
        const std::size_t normal_at = keep(normal);
        return {{"attributes", {{"POSITION", position_at}, {"NORMAL", normal_at}}},
                {"indices", add_indices(mesh)},
                {"material", index_of(mesh.material)}};
    }

    std::size_t add_indices(const Mesh& mesh) {
        const std::size_t at = buffers_.indices.size();
        const std::size_t count = 3 * mesh.triangles.size();
        const bool narrow = mesh.positions.size() < 0xFFFF;
        if (narrow) {
            std::vector<std::uint16_t> values;
            values.reserve(count);
            for (const auto& triangle : mesh.triangles) {
                for (const std::uint32_t index : triangle) {
                    values.push_back(static_cast<std::uint16_t>(index));
                }
            }
            buffers_.indices += bytes_of(std::span<const std::uint16_t>(values));
            buffers_.indices.resize((buffers_.indices.size() + 3) / 4 * 4, '\0');
        } else {
            for (const auto& triangle : mesh.triangles) {
                buffers_.indices += bytes_of(std::span<const std::uint32_t>(triangle));
            }
        }
        return keep(accessor(indices, at, count, narrow ? kUnsignedShort : kUnsignedInt, "SCALAR"));
    }

    static Json accessor(View view, std::size_t offset, std::size_t count, int component, const char* type) {
        return {{"bufferView", static_cast<int>(view)},
                {"byteOffset", offset},
                {"componentType", component},
                {"count", count},
                {"type", type}};
    }

    std::size_t keep(Json accessor) {
        accessors_.push_back(std::move(accessor));
        return accessors_.size() - 1;
    }

    static Json view_json(std::size_t offset, std::size_t length, int stride, int target) {
        Json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
        if (stride > 0) {
            view["byteStride"] = stride;
        }
        view["target"] = target;
        return view;
    }

    static Json material_json(const Material& material) {
        Json json = {{"name", material.name},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", material.base_color},
                       {"metallicFactor", material.metallic},
                       {"roughnessFactor", material.roughness}}}};
        if (material.alpha_mode == AlphaMode::blend) {
            json["alphaMode"] = "BLEND";
        }
        if (material.double_sided) {
            json["doubleSided"] = true;
        }
        return json;
    }

    static void append_word(std::string& bytes, std::size_t word) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            bytes += static_cast<char>((word >> shift) & 0xFFU);
        }
    }

    std::string container(std::string json) const {
        constexpr std::size_t kHeader = 12;
        constexpr std::size_t kChunkHeader = 8;
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const std::size_t bin = buffers_.positions.size() + buffers_.normals.size() + buffers_.indices.size();
        const std::size_t total = kHeader + kChunkHeader + json.size() + kChunkHeader + bin;
        if (total > 0xFFFFFFFF) {
            throw std::runtime_error("the model is too large for one GLB file (4 GB)");
        }
        std::string bytes = "glTF";
        bytes.reserve(total);
        append_word(bytes, 2);
        append_word(bytes, total);
        append_word(bytes, json.size());
        bytes += "JSON" + json;
        append_word(bytes, bin);
        bytes.append("BIN\0", 4);
        for (const std::string* view : {&buffers_.positions, &buffers_.normals, &buffers_.indices}) {
            bytes += *view;
        }
        return bytes;
    }

    const Model& model_;
    Buffers buffers_;
    Json meshes_ = Json::array();
    Json accessors_ = Json::array();
};

}  // namespace

std::string write_named_glb(const Model& model) {
    return NamedGlb(model).file();
}

}  // namespace campuswalk::scene
