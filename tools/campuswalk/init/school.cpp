#include "tools/campuswalk/init/school.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <vector>

#include "scene/model/mesh_parts.h"

namespace campuswalk::tools::init {

using collision::Pose;
using collision::Vec3;
using scene::MeshParts;

namespace {

const Eigen::Vector3f kGrass(0.42F, 0.55F, 0.33F);
const Eigen::Vector3f kBrick(0.64F, 0.34F, 0.26F);
const Eigen::Vector3f kPlaster(0.87F, 0.78F, 0.56F);
const Eigen::Vector3f kSlate(0.42F, 0.52F, 0.66F);
const Eigen::Vector3f kConcrete(0.72F, 0.71F, 0.68F);
const Eigen::Vector3f kWood(0.55F, 0.38F, 0.22F);

struct NamedMesh {
    std::string name;
    collision::TriangleMesh mesh;
    Eigen::Vector3f color;  ///< red, green, blue in [0, 1]
};

/// Adds boxes, given by opposite vertices, to one mesh.
class Masonry {
public:
    Masonry& box(const Vec3& low, const Vec3& high) {
        MeshParts(mesh_).add_box(Pose{}, 0.5 * (low + high), 0.5 * (high - low));
        return *this;
    }
    NamedMesh named(const std::string& name, const Eigen::Vector3f& color) const {
        return {name, mesh_, color};
    }

private:
    collision::TriangleMesh mesh_;
};

/// Walls around 10 m by 8 m; the doorway is in the middle of the wall at `z`, the rest to the north of it.
NamedMesh hall(const std::string& name, const Eigen::Vector3f& color, double x, double z) {
    constexpr double kThickness = 0.3;
    constexpr double kHeight = 3.0;
    const double west = x - 5.0;
    const double east = x + 5.0;
    const double north = z - 8.0;
    return Masonry()
        .box({west, 0, z - kThickness}, {x - 1.0, kHeight, z})
        .box({x + 1.0, 0, z - kThickness}, {east, kHeight, z})
        .box({west, 0, north}, {west + kThickness, kHeight, z - kThickness})
        .box({east - kThickness, 0, north}, {east, kHeight, z - kThickness})
        .box({west + kThickness, 0, north}, {east - kThickness, kHeight, north + kThickness})
        .named(name, color);
}

/// Ten treads of 0.3 m to the north, each 0.17 m higher, from z = 4 to the landing at z = 1.
NamedMesh flight() {
    Masonry masonry;
    for (int tread = 0; tread < 10; ++tread) {
        masonry.box({10, 0, 4 - 0.3 * (tread + 1)}, {12, 0.17 * (tread + 1), 4 - 0.3 * tread});
    }
    return masonry.named("stairs", kConcrete);
}

NamedMesh bench(const std::string& name, double x, double z) {
    return Masonry().box({x - 0.9, 0, z - 0.25}, {x + 0.9, 0.45, z + 0.25}).named(name, kWood);
}

std::vector<NamedMesh> meshes_of(Template which) {
    std::vector<NamedMesh> meshes;
    meshes.push_back(Masonry().box({-25, -1, -20}, {25, 0, 20}).named("terrain", kGrass));
    meshes.push_back(hall("library_walls", kBrick, 0, -6));
    meshes.push_back(Masonry().box({-1, 0, -12}, {1, 0.75, -11.2}).named("library_desk", kWood));
    if (which != Template::minimal) {
        meshes.push_back(flight());
        meshes.push_back(Masonry().box({10, 0, -3}, {12, 1.7, 1}).named("gallery", kConcrete));
    }
    if (which == Template::campus) {
        meshes.push_back(hall("cafeteria_walls", kPlaster, -16, -4));
        meshes.push_back(hall("gym_walls", kSlate, 18, -8));
        meshes.push_back(bench("bench_west", -3, 6));
        meshes.push_back(bench("bench_east", 3, 6));
    }
    return meshes;
}

/// The shortest digits that are read as the same number.
std::string digits(float value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string digits(const Eigen::Vector3f& v) {
    return digits(v.x()) + " " + digits(v.y()) + " " + digits(v.z());
}

std::string wavefront(const std::vector<NamedMesh>& meshes) {
    std::string text = "mtllib school.mtl\n";
    std::uint32_t first = 1;  // vertices count from 1, through all objects
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

std::string wavefront_materials(const std::vector<NamedMesh>& meshes) {
    std::string text;
    for (const NamedMesh& named : meshes) {
        text += "newmtl " + named.name + "\nKd " + digits(named.color) + "\n";
    }
    return text;
}

}  // namespace

SchoolModel school(Template which) {
    const std::vector<NamedMesh> meshes = meshes_of(which);
    return {wavefront(meshes), wavefront_materials(meshes)};
}

}  // namespace campuswalk::tools::init
