#include "tools/campuswalk_bench/files/write_glb.h"

#include <fstream>
#include <span>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace campuswalk::tools::bench {

namespace {

using nlohmann::json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

class GlbText {
public:
    GlbText(const scene::Model& model, const ImageEncoder& encode) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "campuswalk-bench"}};
        json_["scene"] = 0;
        json_["samplers"] = json::array({json::object()});
        for (const scene::Texture& texture : model.textures) {
            add_image(texture.name, encode(texture));
        }
        for (const scene::Material& material : model.materials) {
            add_material(material);
        }
        for (const scene::Mesh& mesh : model.meshes) {
            add_mesh(mesh, model.materials.size());
        }
        json roots = json::array();
        for (const scene::Node& node : model.nodes) {
            roots.push_back(json_["nodes"].size());
            json_["nodes"].push_back({{"name", node.name}, {"mesh", scene::index_of(node.meshes.at(0))}});
        }
        json_["scenes"] = json::array({{{"nodes", roots}}});
        json_["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
    }

    std::string text() const { return json_.dump(); }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
    template <typename Value>
    std::size_t add_view(std::span<const Value> values, int target) {
        json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size_bytes()}};
        if (target != 0) {
            view["target"] = target;
        }
        const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
        bytes_.insert(bytes_.end(), first, first + values.size_bytes());
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        json_["bufferViews"].push_back(view);
        return json_["bufferViews"].size() - 1;
    }

    std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type) {
        json_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return json_["accessors"].size() - 1;
    }

    void add_image(const std::string& name, const std::vector<std::uint8_t>& png) {
        const std::size_t view = add_view(std::span<const std::uint8_t>(png), 0);
        json_["textures"].push_back({{"source", json_["images"].size()}, {"sampler", 0}});
        json_["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}, {"name", name}});
    }

    void add_material(const scene::Material& material) {
        json surface = {
            {"baseColorFactor", material.base_color}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
        if (material.base_color_texture) {
            surface["baseColorTexture"] = {{"index", scene::index_of(*material.base_color_texture)}};
        }
        json_["materials"].push_back({{"name", material.name},
                                      {"pbrMetallicRoughness", surface},
                                      {"doubleSided", material.double_sided}});
    }

    void add_mesh(const scene::Mesh& mesh, std::size_t materials) {
        const std::size_t count = mesh.positions.size();
        const std::size_t positions =
            add_accessor(add_view(std::span(mesh.positions), kVertices), kFloat, count, "VEC3");
        scene::Bounds box;
        for (const Eigen::Vector3f& position : mesh.positions) {
            box.extend(position.cast<double>());
        }
        for (const auto& [key, limit] : {std::pair("min", box.min), std::pair("max", box.max)}) {
            json_["accessors"][positions][key] = {limit.x(), limit.y(), limit.z()};
        }
        json attributes = {{"POSITION", positions}};
        if (!mesh.normals.empty()) {
            attributes["NORMAL"] =
                add_accessor(add_view(std::span(mesh.normals), kVertices), kFloat, count, "VEC3");
        }
        if (!mesh.uvs.empty()) {
            attributes["TEXCOORD_0"] =
                add_accessor(add_view(std::span(mesh.uvs), kVertices), kFloat, count, "VEC2");
        }
        const std::size_t indices = add_accessor(add_view(std::span(mesh.triangles), kIndices), kUnsignedInt,
                                                 3 * mesh.triangles.size(), "SCALAR");
        json primitive = {{"attributes", attributes}, {"indices", indices}};
        if (scene::index_of(mesh.material) < materials) {
            primitive["material"] = scene::index_of(mesh.material);
        }
        json_["meshes"].push_back({{"name", mesh.name}, {"primitives", json::array({primitive})}});
    }

    json json_;
    std::vector<std::uint8_t> bytes_;
};

void put_number(std::ofstream& out, std::size_t number) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        out.put(static_cast<char>((number >> shift) & 255U));
    }
}

}  // namespace

void write_glb(const scene::Model& model, const std::filesystem::path& file, const ImageEncoder& encode) {
    const GlbText glb(model, encode);
    std::string text = glb.text();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::ofstream out(file, std::ios::binary);
    put_number(out, 0x46546C67);  // glTF
    put_number(out, 2);
    put_number(out, 12 + 8 + text.size() + 8 + glb.bytes().size());
    put_number(out, text.size());
    put_number(out, 0x4E4F534A);  // JSON
    out << text;
    put_number(out, glb.bytes().size());
    put_number(out, 0x004E4942);  // BIN
    out.write(reinterpret_cast<const char*>(glb.bytes().data()),
              static_cast<std::streamsize>(glb.bytes().size()));
    out.close();
    if (!out) {
        throw std::runtime_error("'" + file.string() + "' couldn't be written");
    }
}

}  // namespace campuswalk::tools::bench
