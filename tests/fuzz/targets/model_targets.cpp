// Models and textures, as the import helper reads them.

#include <array>
#include <cstring>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "scene/import/gltf/draco_mesh.h"
#include "scene/import/gltf/meshopt.h"
#include "scene/import/import_model.h"
#include "scene/import/source/decode_image.h"
#include "tests/fuzz/targets/targets.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::fuzz {

namespace {

using Json = nlohmann::json;

/// Takes a little-endian number from the front; 0 where there are no bytes left.
template <typename Number>
Number take(Bytes& bytes) {
    Number number = 0;
    const std::size_t size = std::min(sizeof number, bytes.size());
    std::memcpy(&number, bytes.data(), size);
    bytes = bytes.subspan(size);
    return number;
}

std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void import(const std::string& name, std::string_view bytes) {
    static const support::TemporaryFolder folder;
    folder.write(name, bytes);
    scene::SceneFile file;
    file.file = name;
    file.path = folder.path() / name;
    try {
        scene::import_model(file, scene::EmptyModel::accept);
    } catch (const scene::InputError&) {
    }
}

std::string chunk(const char* kind, std::string_view data, char padding) {
    const std::string padded = std::string(data) + std::string((4 - data.size() % 4) % 4, padding);
    const auto size = static_cast<std::uint32_t>(padded.size());
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
    return bytes.append(kind, 4).append(padded);
}

/// A GLB with correct lengths, so that all bytes are used for its contents: two bytes with the length of the
/// JSON, the JSON, the binary chunk.
void read_gltf(Bytes bytes) {
    const std::size_t length = take<std::uint16_t>(bytes);
    const Bytes json = bytes.first(std::min(length, bytes.size()));
    const std::string chunks =
        chunk("JSON", as_text(json), ' ') + chunk("BIN\0", as_text(bytes.subspan(json.size())), '\0');
    const std::array<std::uint32_t, 2> header = {2, static_cast<std::uint32_t>(12 + chunks.size())};
    import("a.glb",
           "glTF" + std::string(reinterpret_cast<const char*>(header.data()), sizeof header) + chunks);
}

/// The file as it is.
void read_glb(Bytes bytes) {
    import("b.glb", as_text(bytes));
}

/// A byte each for mode and filter, two each for stride and count, the packed bytes.
void read_meshopt(Bytes bytes) {
    constexpr std::array kModes = {"ATTRIBUTES", "TRIANGLES", "INDICES", "?"};
    constexpr std::array kFilters = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "?"};
    Json compression;
    compression["mode"] = kModes.at(take<std::uint8_t>(bytes) % kModes.size());
    compression["filter"] = kFilters.at(take<std::uint8_t>(bytes) % kFilters.size());
    compression["byteStride"] = take<std::uint16_t>(bytes);
    compression["count"] = take<std::uint16_t>(bytes);
    try {
        scene::gltf::decode_meshopt({compression, "bufferViews/0"}, bytes);
    } catch (const scene::gltf::GltfError&) {
    }
}

/// A byte each with the ids of position, normal, texture coordinates and colour, the packed bytes.
void read_draco(Bytes bytes) {
    const Json compression = Json::object();
    scene::gltf::DracoAttributes attributes;
    attributes.position = take<std::uint8_t>(bytes);
    attributes.normal = take<std::uint8_t>(bytes);
    attributes.uv = take<std::uint8_t>(bytes);
    attributes.color = take<std::uint8_t>(bytes);
    scene::RawMesh mesh;
    try {
        scene::gltf::decode_draco({compression, "meshes/0"}, bytes, attributes, mesh);
    } catch (const scene::gltf::GltfError&) {
    }
}

void read_texture(Bytes bytes) {
    std::string reason;
    scene::decode_image(bytes, reason);
}

constexpr std::array kTargets = {Target{"gltf", read_gltf}, Target{"glb", read_glb},
                                 Target{"meshopt", read_meshopt}, Target{"draco", read_draco},
                                 Target{"texture", read_texture}};

}  // namespace

std::span<const Target> model_targets() {
    return kTargets;
}

}  // namespace campuswalk::fuzz
