#include "tools/campuswalk/bench/import/write_glb.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "collision/mesh_extent.h"
#include "scene/whole_file.h"

namespace campuswalk::tools::bench {

namespace {

using Json = nlohmann::ordered_json;

/// The binary chunk, and what the JSON says of it.
class Buffer {
public:
    std::size_t add(std::span<const std::byte> bytes, Json accessor) {
        const std::size_t index = accessors_.size();
        accessor["bufferView"] = index;
        views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
        accessors_.push_back(std::move(accessor));
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        return index;
    }

    const std::vector<std::byte>& bytes() const { return bytes_; }
    const Json& views() const { return views_; }
    const Json& accessors() const { return accessors_; }

private:
    std::vector<std::byte> bytes_;
    Json views_ = Json::array();
    Json accessors_ = Json::array();
};

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

Json vectors(std::span<const Eigen::Vector3f> of) {
    const collision::Aabb box = collision::box_of(of);
    return {{"componentType", kFloat},
            {"count", of.size()},
            {"type", "VEC3"},
            {"min", {box.min.x(), box.min.y(), box.min.z()}},
            {"max", {box.max.x(), box.max.y(), box.max.z()}}};
}

void append_chunk(std::vector<std::byte>& file, const char* type, std::span<const std::byte> bytes) {
    const auto length = static_cast<std::uint32_t>(bytes.size());
    const auto of_length = std::as_bytes(std::span(&length, 1));
    file.insert(file.end(), of_length.begin(), of_length.end());
    const auto of_type = std::as_bytes(std::span(type, 4));
    file.insert(file.end(), of_type.begin(), of_type.end());
    file.insert(file.end(), bytes.begin(), bytes.end());
}

}  // namespace

void write_glb(const std::filesystem::path& file, const collision::TriangleMesh& mesh,
               std::span<const Eigen::Vector3f> normals) {
    Buffer buffer;
    const std::span<const Eigen::Vector3f> positions = mesh.positions;
    Json attributes = {{"POSITION", buffer.add(std::as_bytes(positions), vectors(positions))}};
    if (!normals.empty()) {
        attributes["NORMAL"] = buffer.add(std::as_bytes(normals), vectors(normals));
    }
    const std::size_t indices = buffer.add(
        std::as_bytes(std::span(mesh.triangles)),
        {{"componentType", kUnsignedInt}, {"count", 3 * mesh.triangles.size()}, {"type", "SCALAR"}});
    const Json json = {{"asset", {{"version", "2.0"}}},
                       {"scene", 0},
                       {"scenes", {{{"nodes", {0}}}}},
                       {"nodes", {{{"name", "campus"}, {"mesh", 0}}}},
                       {"meshes", {{{"primitives", {{{"attributes", attributes}, {"indices", indices}}}}}}},
                       {"buffers", {{{"byteLength", buffer.bytes().size()}}}},
                       {"bufferViews", buffer.views()},
                       {"accessors", buffer.accessors()}};
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');

    constexpr std::size_t kFrame = 28;
    const std::array<std::uint32_t, 3> header = {
        0x46546C67, 2, static_cast<std::uint32_t>(kFrame + text.size() + buffer.bytes().size())};
    const auto start = std::as_bytes(std::span(header));
    std::vector<std::byte> whole(start.begin(), start.end());
    whole.reserve(header[2]);
    append_chunk(whole, "JSON", std::as_bytes(std::span(text)));
    append_chunk(whole, "BIN\0", buffer.bytes());
    scene::write_whole_file(file, whole);
}

std::vector<Eigen::Vector3f> smooth_normals(const collision::TriangleMesh& mesh) {
    std::vector<Eigen::Vector3f> normals(mesh.positions.size(), Eigen::Vector3f::Zero());
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3f& a = mesh.positions[t[0]];
        const Eigen::Vector3f n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
        for (const std::uint32_t v : t) {
            normals[v] += n;
        }
    }
    for (Eigen::Vector3f& n : normals) {
        n = n.squaredNorm() > 0.0F ? n.normalized() : Eigen::Vector3f(0, 1, 0);
    }
    return normals;
}

}  // namespace campuswalk::tools::bench
