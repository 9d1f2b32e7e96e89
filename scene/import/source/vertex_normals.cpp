#include "scene/import/source/vertex_normals.h"

#include <Eigen/Geometry>

#include "scene/model/weld.h"

namespace campuswalk::scene {
namespace {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

// A vertex with more faces is not smoothed: its cost is quadratic.
constexpr std::size_t kMaxSmoothedFaces = 128;

Eigen::Vector3d area_vector(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Eigen::Vector3d origin = a.cast<double>();
    return (b.cast<double>() - origin).cross(c.cast<double>() - origin);
}

Eigen::Vector3d unit_or_up(const Eigen::Vector3d& v) {
    const double length = v.norm();
    return length > 0.0 ? Eigen::Vector3d(v / length) : Eigen::Vector3d::UnitY();
}

/// The triangles at each welded position p: `faces[first[p] .. first[p + 1])`.
struct FaceAdjacency {
    std::vector<std::uint32_t> position_of_vertex;
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> faces;
};

FaceAdjacency find_adjacency(std::span<const Eigen::Vector3f> positions, Triangles triangles) {
    FaceAdjacency adjacency;
    WeldTable<3> welded(positions.size());
    for (const auto& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            adjacency.position_of_vertex.push_back(welded.number_of(bits_of(positions[vertex])));
        }
    }
    adjacency.first.assign(welded.size() + 1, 0);
    for (const std::uint32_t position : adjacency.position_of_vertex) {
        ++adjacency.first[position + 1];
    }
    for (std::size_t i = 1; i < adjacency.first.size(); ++i) {
        adjacency.first[i] += adjacency.first[i - 1];
    }
    adjacency.faces.resize(adjacency.position_of_vertex.size());
    std::vector<std::uint32_t> next = adjacency.first;
    for (std::size_t index = 0; index < adjacency.position_of_vertex.size(); ++index) {
        adjacency.faces[next[adjacency.position_of_vertex[index]]++] = static_cast<std::uint32_t>(index / 3);
    }
    return adjacency;
}

}  // namespace

Eigen::Vector3f face_normal(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    return unit_or_up(area_vector(a, b, c)).cast<float>();
}

std::vector<Eigen::Vector3f> vertex_normals(std::span<const Eigen::Vector3f> positions, Triangles triangles,
                                            double crease_cosine) {
    std::vector<Eigen::Vector3d> areas(triangles.size());
    std::vector<Eigen::Vector3d> normals(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& t = triangles[i];
        areas[i] = area_vector(positions[t[0]], positions[t[1]], positions[t[2]]);
        normals[i] = unit_or_up(areas[i]);
    }
    std::vector<Eigen::Vector3f> result(triangles.size() * 3);
    if (crease_cosine >= 1.0) {
        for (std::size_t index = 0; index < result.size(); ++index) {
            result[index] = normals[index / 3].cast<float>();
        }
        return result;
    }
    const FaceAdjacency adjacency = find_adjacency(positions, triangles);
    for (std::size_t index = 0; index < result.size(); ++index) {
        const std::size_t face = index / 3;
        const std::uint32_t position = adjacency.position_of_vertex[index];
        const std::size_t begin = adjacency.first[position];
        const std::size_t end = adjacency.first[position + 1];
        Eigen::Vector3d sum = areas[face];
        for (std::size_t i = begin; i < end && end - begin <= kMaxSmoothedFaces; ++i) {
            const std::uint32_t other = adjacency.faces[i];
            if (other != face && normals[other].dot(normals[face]) >= crease_cosine) {
                sum += areas[other];
            }
        }
        result[index] = unit_or_up(sum).cast<float>();
    }
    return result;
}

}  // namespace campuswalk::scene
