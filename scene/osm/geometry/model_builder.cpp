#include "scene/osm/geometry/model_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene::osm {
namespace {

Eigen::Vector3f world(const Point3& p) {
    return {static_cast<float>(p.at.x()), static_cast<float>(p.height), static_cast<float>(-p.at.y())};
}

/// The fifth root of a number from 0 to 1, by Newton's method: pow() differs between machines.
double fifth_root(double value) {
    double root = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double fourth = root * root * root * root;
        root -= (root * fourth - value) / (5.0 * fourth);
    }
    return root;
}

/// glTF's colours are linear: sRGB's transfer function (IEC 61966-2-1), with x^2.4 as x² times the fifth root
/// of x².
float linear(std::uint8_t value) {
    const double x = value / 255.0;
    if (x <= 0.04045) {
        return static_cast<float>(x / 12.92);
    }
    const double y = (x + 0.055) / 1.055;
    return static_cast<float>(y * y * fifth_root(y * y));
}

/// Of the material: colour, roughness and alpha, as readers may merge materials of one name.
std::string name_of(const Look& look) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "surface-";
    const auto append = [&](std::uint8_t part) {
        text += kDigits[part >> 4U];
        text += kDigits[part & 15U];
    };
    std::ranges::for_each(look.color, append);
    text += "-";
    append(look.roughness);
    append(look.alpha);
    return text;
}

struct VertexKey {
    std::array<float, 6> values{};
    friend bool operator==(const VertexKey&, const VertexKey&) = default;
};

/// The vertices of a mesh by position and normal, in one table without a node for each, which would take most
/// of an import's time besides GEOS.
class VertexTable {
public:
    /// For so many vertices at most; there is room for twice as many.
    explicit VertexTable(std::size_t most) : slots_(std::bit_ceil(2 * most + 2)) {}

    std::size_t size() const { return size_; }
    void clear() {
        std::ranges::fill(slots_, Slot());
        size_ = 0;
    }
    /// The index of an equal vertex, or `next` for a new one.
    std::uint32_t index_of(const VertexKey& key, std::uint32_t next) {
        for (std::size_t at = hash_of(key) & (slots_.size() - 1);; at = (at + 1) & (slots_.size() - 1)) {
            Slot& slot = slots_[at];
            if (slot.index == kFree) {
                slot = {key, next};
                ++size_;
                return next;
            }
            if (slot.key == key) {
                return slot.index;
            }
        }
    }

private:
    static constexpr std::uint32_t kFree = 0xFFFFFFFF;
    struct Slot {
        VertexKey key;
        std::uint32_t index = kFree;
    };

    static std::size_t hash_of(const VertexKey& key) {
        std::uint64_t hash = 0;
        for (const float value : key.values) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x9E3779B97F4A7C15ULL;
            hash ^= hash >> 32U;
        }
        return static_cast<std::size_t>(hash);
    }

    std::vector<Slot> slots_;
    std::size_t size_ = 0;
};

/// Triangles with vertices shared where position and normal are the same.
Mesh welded(const std::deque<std::array<Eigen::Vector3f, 3>>& triangles) {
    Mesh mesh;
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector3f> normals;
    std::vector<std::array<std::uint32_t, 3>> faces;
    constexpr std::size_t kMostKnown = 1U << 15U;  // what is shared was added together: the rest is forgotten
    VertexTable known(std::min(3 * triangles.size(), kMostKnown + 3));
    faces.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
        if (known.size() > kMostKnown) {
            known.clear();
        }
        const Eigen::Vector3d ab = (b - a).cast<double>();
        const Eigen::Vector3d ac = (c - a).cast<double>();
        const Eigen::Vector3d cross(ab.y() * ac.z() - ab.z() * ac.y(), ab.z() * ac.x() - ab.x() * ac.z(),
                                    ab.x() * ac.y() - ab.y() * ac.x());
        const double length =
            std::sqrt(cross.x() * cross.x() + cross.y() * cross.y() + cross.z() * cross.z());
        constexpr double kThinnest = 1e-5;  // metres, the height of a triangle: none is left of thinner ones
        const auto squared = [](const Eigen::Vector3d& v) {
            return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
        };
        const double longest = std::sqrt(std::max({squared(ab), squared(ac), squared(ac - ab)}));
        if (!(length > kThinnest * longest)) {
            continue;
        }
        // Rounded, so that coplanar faces share vertices.
        Eigen::Vector3f normal;
        for (Eigen::Index i = 0; i < 3; ++i) {
            normal[i] = static_cast<float>(std::round(cross[i] / length * 4096.0) / 4096.0) + 0.0F;
        }
        std::array<std::uint32_t, 3> face{};
        std::size_t at = 0;
        for (const Eigen::Vector3f& p : {a, b, c}) {
            const VertexKey key{
                {p.x() + 0.0F, p.y() + 0.0F, p.z() + 0.0F, normal.x(), normal.y(), normal.z()}};
            const auto next = static_cast<std::uint32_t>(positions.size());
            face[at] = known.index_of(key, next);
            if (face[at++] == next) {
                positions.push_back(p);
                normals.push_back(normal / std::sqrt(normal.x() * normal.x() + normal.y() * normal.y() +
                                                     normal.z() * normal.z()));
            }
        }
        faces.push_back(face);
    }
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
    mesh.triangles = std::move(faces);
    return mesh;
}

}  // namespace

void ObjectMesh::triangle(const Look& look, const Point3& a, const Point3& b, const Point3& c) {
    if (++*made_ > kMaxMapTriangles) {
        throw TooManyTriangles();
    }
    parts_[look].push_back({world(a), world(b), world(c)});
}

void ObjectMesh::quad(const Look& look, const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    triangle(look, a, b, c);
    triangle(look, a, c, d);
}

void ObjectMesh::level(const Look& look, const Triangulation& area, double height) {
    for (const auto& [a, b, c] : area.triangles) {
        triangle(look, {area.points[a], height}, {area.points[b], height}, {area.points[c], height});
    }
}

void ObjectMesh::ceiling(const Look& look, const Triangulation& area, double height) {
    for (const auto& [a, b, c] : area.triangles) {
        triangle(look, {area.points[a], height}, {area.points[c], height}, {area.points[b], height});
    }
}

void ObjectMesh::wall(const Look& look, const Point& a, const Point& b, double bottom, double top) {
    if (top > bottom) {
        quad(look, {a, bottom}, {b, bottom}, {b, top}, {a, top});
    }
}

void ObjectMesh::walls(const Look& look, const Polygons& polygons, double bottom, double top) {
    const auto around = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            wall(look, ring[i], ring[(i + 1) % ring.size()], bottom, top);
        }
    };
    for (const Polygon& polygon : polygons) {
        around(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            around(hole);
        }
    }
}

void ObjectMesh::box(const Look& look, const Point& center, const Point& along, const Point& half_size,
                     double bottom, double top) {
    const Point u = half_size.x() * along;
    const Point v = half_size.y() * Point(-along.y(), along.x());
    const Ring ring = {center - u - v, center + u - v, center + u + v, center - u + v};
    walls(look, {Polygon{ring, {}}}, bottom, top);
    quad(look, {ring[0], top}, {ring[1], top}, {ring[2], top}, {ring[3], top});
    quad(look, {ring[0], bottom}, {ring[3], bottom}, {ring[2], bottom}, {ring[1], bottom});
}

void ObjectMesh::cylinder(const Look& look, const Point& center, double bottom_radius, double top_radius,
                          int sides, double bottom, double top) {
    std::vector<Point> circle;
    for (int i = 0; i < sides; ++i) {
        const collision::SinCos angle = collision::sin_cos(2.0 * std::numbers::pi * i / sides);
        circle.emplace_back(angle.cos, angle.sin);
    }
    for (std::size_t i = 0; i < circle.size(); ++i) {
        const Point& a = circle[i];
        const Point& b = circle[(i + 1) % circle.size()];
        const Point3 low_a{center + bottom_radius * a, bottom};
        const Point3 low_b{center + bottom_radius * b, bottom};
        const Point3 high_a{center + top_radius * a, top};
        const Point3 high_b{center + top_radius * b, top};
        quad(look, low_a, low_b, high_b, high_a);
        triangle(look, {center, top}, high_a, high_b);
        triangle(look, {center, bottom}, low_b, low_a);
    }
}

ObjectMesh& ModelBuilder::object(const std::string& name) {
    const auto [known, is_new] = known_.try_emplace(name, objects_.size());
    if (is_new) {
        objects_.emplace_back(name, ObjectMesh(triangles_));
    }
    return objects_[known->second].second;
}

MaterialIndex ModelBuilder::material(const Look& look, Model& model) {
    const auto [known, is_new] =
        materials_.try_emplace(look, static_cast<MaterialIndex>(model.materials.size()));
    if (is_new) {
        Material& material = model.materials.emplace_back();
        material.name = name_of(look);
        material.base_color = {linear(look.color[0]), linear(look.color[1]), linear(look.color[2]),
                               static_cast<float>(look.alpha) / 255.0F};
        material.roughness = static_cast<float>(look.roughness) / 255.0F;
        material.alpha_mode = look.alpha < 255 ? AlphaMode::blend : AlphaMode::opaque;
    }
    return known->second;
}

std::pair<std::string, std::size_t> ModelBuilder::largest() const {
    std::pair<std::string, std::size_t> most;
    for (const auto& [name, mesh] : objects_) {
        std::size_t triangles = 0;
        for (const auto& part : mesh.parts_) {
            triangles += part.second.size();
        }
        if (triangles > most.second) {
            most = {name, triangles};
        }
    }
    return most;
}

Model ModelBuilder::finish() {
    Model model;
    for (auto& [name, object] : objects_) {
        Node node;
        node.name = name;
        for (auto& [look, triangles] : object.parts_) {
            Mesh mesh = welded(triangles);
            triangles = {};
            if (mesh.triangles.empty()) {
                continue;
            }
            mesh.name = name;
            mesh.material = material(look, model);
            node.meshes.push_back(static_cast<MeshIndex>(model.meshes.size()));
            model.meshes.push_back(std::move(mesh));
        }
        if (!node.meshes.empty()) {
            model.nodes.push_back(std::move(node));
        }
    }
    return model;
}

}  // namespace campuswalk::scene::osm
