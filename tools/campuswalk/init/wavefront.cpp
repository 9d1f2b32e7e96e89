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

}  // namespace

std::string wavefront(std::span<const NamedMesh> meshes) {
    std::string text;
    std::uint32_t first = 1;  // corners count from 1, through all objects
    for (const NamedMesh& named : meshes) {
        text += "o " + named.name + "\n";
        for (const Eigen::Vector3f& p : named.mesh.positions) {
            text += "v " + digits(p.x()) + " " + digits(p.y()) + " " + digits(p.z()) + "\n";
        }
        for (const auto& [a, b, c] : named.mesh.triangles) {
            text += "f " + std::to_string(first + a) + " " + std::to_string(first + b) + " " +
                    std::to_string(first + c) + "\n";
        }
        first += static_cast<std::uint32_t>(named.mesh.positions.size());
    }
    return text;
}

}  // namespace campuswalk::tools::init
