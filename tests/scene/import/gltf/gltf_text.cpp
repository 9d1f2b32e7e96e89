#include "tests/scene/import/gltf/gltf_text.h"

#include <cstring>

namespace campuswalk::scene::test {
namespace {

void append_word(std::string& out, std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    out.append(reinterpret_cast<const char*>(&word), sizeof word);
}

std::string padded(std::string text, char with) {
    text.resize((text.size() + 3) / 4 * 4, with);
    return text;
}

}  // namespace

GltfText::GltfText()
    : json({{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", Json::array()}}}},
            {"nodes", Json::array()},
            {"meshes", Json::array()},
            {"accessors", Json::array()},
            {"bufferViews", Json::array()}}) {}

std::size_t GltfText::add_view(std::span<const std::uint8_t> bytes) {
    buffer_ = padded(std::move(buffer_), '\0');
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return json["bufferViews"].size() - 1;
}

std::size_t GltfText::add_accessor(std::size_t view, int component, std::size_t count, const char* type) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return json["accessors"].size() - 1;
}

std::size_t GltfText::add_floats(const std::vector<float>& values, const char* type) {
    const std::size_t components =
        std::strcmp(type, "SCALAR") == 0 ? 1 : static_cast<std::size_t>(type[3] - '0');  // VEC2, VEC3, VEC4
    return add_accessor(add_view(values), 5126, values.size() / components, type);
}

std::size_t GltfText::add_mesh(Json primitive) {
    json["meshes"].push_back({{"primitives", {std::move(primitive)}}});
    return json["meshes"].size() - 1;
}

std::size_t GltfText::add_triangle_positions() {
    return add_floats({0, 0, 0, 0, 0, 1, 1, 0, 0}, "VEC3");
}

std::size_t GltfText::add_node(Json node) {
    json["nodes"].push_back(std::move(node));
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    return json["nodes"].size() - 1;
}

void GltfText::write_gltf(const support::TemporaryFolder& folder, const std::string& name) const {
    Json whole = json;
    whole["buffers"] = {{{"uri", name + ".bin"}, {"byteLength", buffer_.size()}}};
    folder.write(name + ".bin", buffer_);
    folder.write(name, whole.dump());
}

void GltfText::write_glb(const support::TemporaryFolder& folder, const std::string& name) const {
    Json whole = json;
    if (!whole.contains("buffers")) {
        whole["buffers"] = {{{"byteLength", buffer_.size()}}};
    }
    const std::string text = padded(whole.dump(), ' ');
    const std::string binary = padded(buffer_, '\0');
    std::string file = "glTF";
    append_word(file, 2);
    append_word(file, 12 + 8 + text.size() + 8 + binary.size());
    append_word(file, text.size());
    file += "JSON" + text;
    append_word(file, binary.size());
    file += std::string("BIN\0", 4) + binary;
    folder.write(name, file);
}

}  // namespace campuswalk::scene::test
