#include "tools/campuswalk_bench/draw/drawn_campus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "scene/model/weld.h"

namespace campuswalk::tools::bench {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

/// The metres that an image covers in each direction.
constexpr double kImageMetres = 3.0;

/// Images of a campus' surfaces, 512 x 512 pixels, that repeat without a seam. The same on every platform.
enum class SurfaceImage : std::uint8_t { grass, paving, bricks, leaves, planks };

constexpr int kSide = 512;  // a power of two: the noise's lattice wraps around by masking

struct Surface {
    const char* name = "";
    std::array<int, 3> color = {0, 0, 0};  ///< sRGB
    int coarse = 0;                        ///< amplitude of noise over 32 pixels, 0 to 255
    int fine = 0;                          ///< over 2 pixels
    int course_height = 0;                 ///< pixels of a row of bricks, stones or planks; 0: none
    int course_width = 0;                  ///< of one of them; every other row is shifted by half of it
};

constexpr std::array<Surface, 5> kSurfaces = {{{"grass", {96, 122, 62}, 26, 40, 0, 0},
                                               {"paving", {158, 152, 142}, 14, 14, 128, 128},
                                               {"bricks", {158, 92, 72}, 20, 16, 16, 64},
                                               {"leaves", {78, 112, 52}, 40, 56, 0, 0},
                                               {"planks", {146, 108, 70}, 18, 12, 32, 512}}};

/// -128 to 127, a hash of the lattice point.
int hash_at(unsigned x, unsigned y, unsigned seed) {
    unsigned h = x * 0x9E3779B1U + y * 0x85EBCA77U + seed * 0xC2B2AE3DU;
    h ^= h >> 15U;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12U;
    h *= 0x297A2D39U;
    h ^= h >> 15U;
    return static_cast<int>(h & 255U) - 128;
}

/// Bilinear interpolation on a lattice of `size` pixels.
int noise_at(int x, int y, int size, unsigned seed) {
    const auto lattice = [&](int cx, int cy) {
        const int mask = kSide / size - 1;
        return hash_at(static_cast<unsigned>(cx & mask), static_cast<unsigned>(cy & mask), seed);
    };
    const int cx = x / size;
    const int cy = y / size;
    const int u = x % size;
    const int v = y % size;
    const int above = lattice(cx, cy) * (size - u) + lattice(cx + 1, cy) * u;
    const int below = lattice(cx, cy + 1) * (size - u) + lattice(cx + 1, cy + 1) * u;
    return (above * (size - v) + below * v) / (size * size);
}

/// The brightness that is added to the colour of a pixel.
int shade(const Surface& surface, int x, int y, unsigned seed) {
    int shade =
        (surface.coarse * noise_at(x, y, 32, seed) + surface.fine * noise_at(x, y, 2, seed + 1)) / 128;
    if (surface.course_height > 0) {
        const int row = y / surface.course_height;
        const int along = (x + row % 2 * surface.course_width / 2) % kSide;
        const bool joint = y % surface.course_height < 2 || along % surface.course_width < 2;
        const int piece = hash_at(static_cast<unsigned>(along / surface.course_width),
                                  static_cast<unsigned>(row), seed + 2);
        shade += joint ? -34 : piece / 10;
    }
    return shade;
}

scene::Texture image_of(const Surface& surface, unsigned seed) {
    scene::Texture texture;
    texture.name = surface.name;
    texture.width = texture.height = kSide;
    texture.rgba.reserve(std::size_t{4} * kSide * kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const int lighter = shade(surface, x, y, seed);
            for (const int channel : surface.color) {
                texture.rgba.push_back(static_cast<std::uint8_t>(std::clamp(channel + lighter, 0, 255)));
            }
            texture.rgba.push_back(255);
        }
    }
    return texture;
}

/// In the order of SurfaceImage.
std::vector<scene::Texture> surface_images() {
    std::vector<scene::Texture> images;
    images.reserve(std::size(kSurfaces));
    for (const Surface& surface : kSurfaces) {
        images.push_back(image_of(surface, 10U * static_cast<unsigned>(images.size())));
    }
    return images;
}

constexpr double kEyes = 1.68;         ///< metres above the foot
constexpr std::size_t kMaxViews = 24;  ///< three on each of eight paths
constexpr int kStreetViews = 12;       ///< on each of two walks
constexpr float kLevel = 0.7F;         ///< faces whose normals have a greater y are walked on, hence paved

/// The material without an image, after those of the surface images.
constexpr std::size_t kPlainMaterial = 5;

std::size_t material_of(CampusPart part, const Vector3f& normal) {
    const auto image = [](SurfaceImage it) { return static_cast<std::size_t>(it); };
    switch (part) {
        case CampusPart::terrain:
            return image(SurfaceImage::grass);
        case CampusPart::building:
            return image(std::abs(normal.y()) > kLevel ? SurfaceImage::paving : SurfaceImage::bricks);
        case CampusPart::tree:
            return image(SurfaceImage::leaves);
        case CampusPart::bench:
            return image(SurfaceImage::planks);
        case CampusPart::lamp:
            break;
    }
    return kPlainMaterial;
}

bool is_smooth(CampusPart part) {
    return part == CampusPart::terrain || part == CampusPart::tree;
}

/// Texture coordinates by projection along the normal's largest component.
Vector2f texture_coordinates(const Vector3f& at, const Vector3f& normal) {
    const Vector3f side = normal.cwiseAbs();
    const Vector3f p = at / static_cast<float>(kImageMetres);
    if (side.y() >= std::max(side.x(), side.z())) {
        return {p.x(), p.z()};
    }
    return side.x() >= side.z() ? Vector2f(p.z(), -p.y()) : Vector2f(p.x(), -p.y());
}

/// A mesh under construction, which welds equal vertices.
struct Piece {
    scene::WeldTable<5> vertices{1000};
    scene::Mesh mesh;

    std::uint32_t vertex(std::uint32_t position, const Vector3f& at, const Vector3f& normal,
                         const Vector2f& uv) {
        const auto bits = scene::bits_of(normal);
        const std::uint32_t side = scene::bits_of(uv.x());
        const std::uint32_t number = vertices.number_of({position, bits[0], bits[1], bits[2], side});
        if (number == mesh.positions.size()) {
            mesh.positions.push_back(at);
            mesh.normals.push_back(normal);
            mesh.uvs.push_back(uv);
        }
        return number;
    }
};

class Modeller {
public:
    Modeller(const collision::TriangleMesh& mesh, std::span<const CampusRun> runs, double lot)
        : mesh_(mesh), runs_(runs), lot_(lot) {
        smooth_.assign(mesh.positions.size(), Vector3f::Zero());
        for (const auto& t : mesh.triangles) {
            for (const std::uint32_t vertex : t) {
                smooth_[vertex] += across(t);
            }
        }
    }

    scene::Model finish() {
        for (std::size_t run = 0; run < runs_.size(); ++run) {
            const std::size_t end =
                run + 1 < runs_.size() ? runs_[run + 1].first_triangle : mesh_.triangles.size();
            for (std::size_t t = runs_[run].first_triangle; t < end; ++t) {
                add(mesh_.triangles[t], runs_[run].part);
            }
        }
        scene::Model model;
        model.textures = surface_images();
        for (std::size_t i = 0; i <= kPlainMaterial; ++i) {
            scene::Material material;
            material.name = i < kPlainMaterial ? model.textures[i].name : "paint";
            if (i < kPlainMaterial) {
                material.base_color_texture = scene::TextureIndex{static_cast<std::uint32_t>(i)};
            } else {
                material.base_color = {0.06F, 0.09F, 0.08F, 1.0F};
            }
            material.double_sided = i == static_cast<std::size_t>(SurfaceImage::leaves);
            model.materials.push_back(material);
        }
        for (auto& [key, piece] : pieces_) {
            scene::Node node;
            const auto& [row, column, material] = key;
            node.name = "lot-" + std::to_string(row) + "-" + std::to_string(column) + "/" +
                        model.materials[material].name;
            node.meshes.push_back(scene::MeshIndex{static_cast<std::uint32_t>(model.meshes.size())});
            piece.mesh.name = node.name;
            piece.mesh.material = scene::MaterialIndex{static_cast<std::uint32_t>(material)};
            model.nodes.push_back(std::move(node));
            model.meshes.push_back(std::move(piece.mesh));
        }
        return model;
    }

private:
    using Vertices = std::array<std::uint32_t, 3>;

    const Vector3f& at(std::uint32_t position) const { return mesh_.positions[position]; }

    Vector3f across(const Vertices& t) const { return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])); }

    void add(const Vertices& triangle, CampusPart part) {
        const Vector3f face = across(triangle).normalized();
        const Vector3f middle = (at(triangle[0]) + at(triangle[1]) + at(triangle[2])) / 3.0F;
        const auto lot = [&](float coordinate) {
            return static_cast<int>(std::floor(coordinate / lot_ + 500.0));
        };
        Piece& piece = pieces_[{lot(middle.z()), lot(middle.x()), material_of(part, face)}];
        Vertices vertices{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3f normal = is_smooth(part) ? Vector3f(smooth_[triangle[i]].normalized()) : face;
            const Vector3f flat = part == CampusPart::terrain ? Vector3f::UnitY() : face;
            vertices[i] = piece.vertex(triangle[i], at(triangle[i]), normal,
                                       texture_coordinates(at(triangle[i]), flat));
        }
        piece.mesh.triangles.push_back(vertices);
    }

    const collision::TriangleMesh& mesh_;
    std::span<const CampusRun> runs_;
    double lot_;
    std::vector<Vector3f> smooth_;  ///< by position: the sum of its triangles' normals, weighted by area
    std::map<std::tuple<int, int, std::size_t>, Piece> pieces_;
};

Eigen::Vector3d foot_near(const std::vector<Eigen::Vector3d>& feet, double x, double z) {
    return *std::ranges::min_element(
        feet, {}, [&](const Eigen::Vector3d& foot) { return std::hypot(foot.x() - x, foot.z() - z); });
}

}  // namespace

scene::Model drawn_campus(const collision::TriangleMesh& mesh, std::span<const CampusRun> runs, double lot) {
    return Modeller(mesh, runs, lot).finish();
}

std::vector<DrawnView> views_over_hills(const WalkableCampus& campus) {
    const Eigen::Vector3d eyes(0.0, kEyes, 0.0);
    std::vector<DrawnView> views;
    for (const WalkPath& path : campus.paths) {
        if (path.name != "hill") {
            continue;
        }
        const Eigen::Vector3d low = path.start + eyes;
        const Eigen::Vector3d high = path.goals.at(1).at + eyes;
        const Eigen::Vector3d middle = path.goals.at(0).at + eyes;
        const Eigen::Vector3d out = high - low;
        views.push_back({high, low});
        views.push_back({low, low + Eigen::Vector3d(out.x(), 0.0, out.z())});
        views.push_back({middle, middle + Eigen::Vector3d(out.z(), 0.0, -out.x())});
    }
    views.resize(std::min(views.size(), kMaxViews));
    return views;
}

std::vector<DrawnView> views_among_houses(const GeneratedCampus& campus, int lots) {
    const Eigen::Vector3d eyes(0.0, kEyes, 0.0);
    const double side = kGeneratedLot * lots;
    const int half_of_lots = lots / 2;
    const double between_lots = kGeneratedLot * half_of_lots - 0.5 * side;
    std::vector<DrawnView> views;
    for (const bool along_x : {true, false}) {
        const auto eye = [&](int place) -> Eigen::Vector3d {
            const double along = side * (place + 0.5) / (kStreetViews + 1) - 0.5 * side;
            const double x = along_x ? along : between_lots;
            const double z = along_x ? between_lots : along;
            return foot_near(campus.feet, x, z) + eyes;
        };
        for (int place = 0; place < kStreetViews; ++place) {
            views.push_back({eye(place), eye(place + 1)});
        }
    }
    return views;
}

}  // namespace campuswalk::tools::bench
