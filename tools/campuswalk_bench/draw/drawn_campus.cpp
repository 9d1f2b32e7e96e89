#include "tools/campuswalk_bench/draw/drawn_campus.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "scene/model/weld.h"
#include "tools/campuswalk_bench/draw/procedural_textures.h"

namespace campuswalk::tools::bench {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

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
