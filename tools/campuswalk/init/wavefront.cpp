#include "tools/campuswalk/init/wavefront.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace campuswalk::tools::init {

namespace {

/// The shortest digits that give the same number back.
std::string digits(float value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string digits(const Eigen::Vector3f& v) {
    return digits(v.x()) + " " + digits(v.y()) + " " + digits(v.z());
}

}  // namespace

std::string wavefront(std::span<const NamedMesh> meshes, const std::string& material_file) {
    std::string text = "mtllib " + material_file + "\n";
    std::uint32_t first = 1;  // corners count from 1, through all objects
    for (const NamedMesh& named : meshes) {
        text += "o " + named.name + "\n";
        for (const Eigen::Vector3f& p : named.mesh.positions) {
            text += "v " + digits(p) + "\n";
        }
        text += "usemtl " + named.name + "\n";
        for (const auto& [a, b, c] : named.mesh.triangles) {
            text += "f " + std::to_string(first + a) + " " + std::to_string(first + b) + " " +
                    std::to_string(first + c) + "\n";
        }
        first += static_cast<std::uint32_t>(named.mesh.positions.size());
    }
    return text;
}

std::string wavefront_materials(std::span<const NamedMesh> meshes) {
    std::string text;
    for (const NamedMesh& named : meshes) {
        text += "newmtl " + named.name + "\nKd " + digits(named.color) + "\n";
    }
    return text;
}

}  // namespace campuswalk::tools::init
