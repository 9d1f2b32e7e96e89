#include "tools/campuswalk/bench/draw/drawn_campus.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "scene/weld.h"
#include "tools/campuswalk/bench/draw/surface_pictures.h"

namespace campuswalk::tools::bench {

using Eigen::Vector2f;
using Eigen::Vector3f;
using scene::CampusPart;

namespace {

constexpr double kEyes = 1.68;          ///< metres over the foot
constexpr std::size_t kMostViews = 24;  ///< three on each of eight ways
constexpr float kLevel = 0.7F;          ///< a face whose normal rises more is walked on, hence paved

/// After the surface pictures' own, a material without a picture.
constexpr std::size_t kPaint = 5;

std::size_t material_of(CampusPart part, const Vector3f& normal) {
    const auto picture = [](SurfacePicture it) { return static_cast<std::size_t>(it); };
    switch (part) {
        case CampusPart::terrain:
            return picture(SurfacePicture::grass);
        case CampusPart::course:
            return picture(std::abs(normal.y()) > kLevel ? SurfacePicture::paving : SurfacePicture::bricks);
        case CampusPart::tree:
            return picture(SurfacePicture::leaves);
        case CampusPart::bench:
            return picture(SurfacePicture::planks);
        case CampusPart::lamp:
            break;
    }
    return kPaint;
}

bool is_smooth(CampusPart part) {
    return part == CampusPart::terrain || part == CampusPart::tree;
}

/// Flat on the face's widest side.
Vector2f picture_place(const Vector3f& at, const Vector3f& normal) {
    const Vector3f side = normal.cwiseAbs();
    const Vector3f p = at / static_cast<float>(kPictureMetres);
    if (side.y() >= std::max(side.x(), side.z())) {
        return {p.x(), p.z()};
    }
    return side.x() >= side.z() ? Vector2f(p.z(), -p.y()) : Vector2f(p.x(), -p.y());
}

/// A mesh under construction: corners that are alike are one.
struct Piece {
    scene::WeldTable<5> corners{1000};
    scene::Mesh mesh;

    std::uint32_t corner(std::uint32_t position, const Vector3f& at, const Vector3f& normal,
                         const Vector2f& uv) {
        const auto bits = scene::bits_of(normal);
        const std::uint32_t side = scene::bits_of(uv.x());
        const std::uint32_t number = corners.number_of({position, bits[0], bits[1], bits[2], side});
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
    explicit Modeller(const scene::WalkableCampus& campus) : campus_(campus) {
        smooth_.assign(campus.mesh.positions.size(), Vector3f::Zero());
        for (const auto& t : campus.mesh.triangles) {
            for (const std::uint32_t corner : t) {
                smooth_[corner] += across(t);
            }
        }
    }

    scene::Model finish() {
        for (std::size_t run = 0; run < campus_.runs.size(); ++run) {
            const std::size_t end = run + 1 < campus_.runs.size() ? campus_.runs[run + 1].first_triangle
                                                                  : campus_.mesh.triangles.size();
            for (std::size_t t = campus_.runs[run].first_triangle; t < end; ++t) {
                add(campus_.mesh.triangles[t], campus_.runs[run].part);
            }
        }
        scene::Model model;
        model.textures = surface_pictures();
        for (std::size_t i = 0; i <= kPaint; ++i) {
            scene::Material material;
            material.name = i < kPaint ? model.textures[i].name : "paint";
            if (i < kPaint) {
                material.base_color_texture = scene::TextureIndex{static_cast<std::uint32_t>(i)};
            } else {
                material.base_color = {0.06F, 0.09F, 0.08F, 1.0F};
            }
            material.double_sided = i == static_cast<std::size_t>(SurfacePicture::leaves);
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
    using Corners = std::array<std::uint32_t, 3>;

    const Vector3f& at(std::uint32_t position) const { return campus_.mesh.positions[position]; }

    Vector3f across(const Corners& t) const { return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])); }

    void add(const Corners& triangle, CampusPart part) {
        const Vector3f face = across(triangle).normalized();
        const Vector3f middle = (at(triangle[0]) + at(triangle[1]) + at(triangle[2])) / 3.0F;
        const auto lot = [](float coordinate) {
            return static_cast<int>(std::floor(coordinate / scene::kWalkableLot + 500.0));
        };
        Piece& piece = pieces_[{lot(middle.z()), lot(middle.x()), material_of(part, face)}];
        Corners corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3f normal = is_smooth(part) ? Vector3f(smooth_[triangle[i]].normalized()) : face;
            const Vector3f flat = part == CampusPart::terrain ? Vector3f::UnitY() : face;
            corners[i] =
                piece.corner(triangle[i], at(triangle[i]), normal, picture_place(at(triangle[i]), flat));
        }
        piece.mesh.triangles.push_back(corners);
    }

    const scene::WalkableCampus& campus_;
    std::vector<Vector3f> smooth_;  ///< of each position: the sum over its triangles, by their area
    std::map<std::tuple<int, int, std::size_t>, Piece> pieces_;
};

}  // namespace

scene::Model drawn_campus(const scene::WalkableCampus& campus) {
    return Modeller(campus).finish();
}

std::vector<DrawnView> drawn_views(const scene::WalkableCampus& campus) {
    const Eigen::Vector3d eyes(0.0, kEyes, 0.0);
    std::vector<DrawnView> views;
    for (const scene::WalkPath& path : campus.paths) {
        if (path.name != "hill") {
            continue;
        }
        const Eigen::Vector3d low = path.start + eyes;
        const Eigen::Vector3d high = path.goals.at(1).at + eyes;
        const Eigen::Vector3d half_way = path.goals.at(0).at + eyes;
        const Eigen::Vector3d out = high - low;
        views.push_back({high, low});
        views.push_back({low, low + Eigen::Vector3d(out.x(), 0.0, out.z())});
        views.push_back({half_way, half_way + Eigen::Vector3d(out.z(), 0.0, -out.x())});
    }
    views.resize(std::min(views.size(), kMostViews));
    return views;
}

}  // namespace campuswalk::tools::bench
