#include "scene/export/mesh_groups.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace campuswalk::scene {

using Eigen::Vector3d;

namespace {

Vector3d whole_steps(const Vector3d& point, double step) {
    return step > 0.0 ? Vector3d((point / step).array().round() * step) : point;
}

/// Texture coordinates on a fine grid: half a texel of a 512-pixel texture, and easier to compress.
float rounded_uv(float value) {
    constexpr float kSteps = 1024.0F;
    return std::round(value * kSteps) / kSteps;
}

std::array<std::int8_t, 4> packed_normal(const Vector3d& normal) {
    const double length = normal.norm();
    const Vector3d unit = length > 0.0 ? Vector3d(normal / length) : Vector3d(Vector3d::UnitY());
    std::array<std::int8_t, 4> packed = {};
    for (int i = 0; i < 3; ++i) {
        packed[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(unit[i] * 127.0));
    }
    return packed;
}

/// A mesh at a node, in world coordinates.
struct Placed {
    const Mesh& mesh;
    Eigen::Matrix3d linear;
    Vector3d offset;
    Eigen::Matrix3d cofactor;  ///< for normals: unlike the inverse it exists for flattened nodes, too

    Placed(const Mesh& placed, const Eigen::Matrix4d& X_world_node)
        : mesh(placed),
          linear(X_world_node.topLeftCorner<3, 3>()),
          offset(X_world_node.topRightCorner<3, 1>()) {
        for (int i = 0; i < 3; ++i) {
            cofactor.col(i) = linear.col((i + 1) % 3).cross(linear.col((i + 2) % 3));
        }
        if (linear.determinant() < 0.0) {
            cofactor = -cofactor;
        }
    }

    Vector3d position(std::uint32_t i) const { return linear * mesh.positions[i].cast<double>() + offset; }
    Vector3d normal(std::uint32_t i) const {
        return i < mesh.normals.size() ? Vector3d(cofactor * mesh.normals[i].cast<double>())
                                       : Vector3d(Vector3d::UnitY());
    }
};

/// Drops triangles that have two equal positions.
void drop_degenerate(MeshGroup& group) {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 2 < group.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> t = {group.indices[i], group.indices[i + 1], group.indices[i + 2]};
        const auto& a = group.vertices[t[0]].position;
        const auto& b = group.vertices[t[1]].position;
        const auto& c = group.vertices[t[2]].position;
        if (a != b && b != c && c != a) {
            std::ranges::copy(t, group.indices.begin() + static_cast<std::ptrdiff_t>(count));
            count += 3;
        }
    }
    group.indices.resize(count);
}

/// Whether all vertices have their faces' normals, to a few degrees. Then faces share vertices without them,
/// of which there are half as many.
bool is_flat(const MeshGroup& group) {
    constexpr double kCosine = 0.998;
    const auto position = [&](std::size_t i) {
        const auto& p = group.vertices[group.indices[i]].position;
        return Vector3d(p[0], p[1], p[2]);
    };
    for (std::size_t i = 0; i + 2 < group.indices.size(); i += 3) {
        const Vector3d face = (position(i + 1) - position(i)).cross(position(i + 2) - position(i));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& n = group.vertices[group.indices[i + k]].normal;
            const Vector3d normal(n[0], n[1], n[2]);
            if (face.dot(normal) < kCosine * face.norm() * normal.norm()) {
                return false;
            }
        }
    }
    return true;
}

/// Merges equal vertices.
void weld(MeshGroup& group) {
    drop_degenerate(group);
    group.is_flat = is_flat(group);
    if (group.is_flat) {
        for (ExportVertex& vertex : group.vertices) {
            vertex.normal = {};
        }
    }
    if (group.indices.empty()) {
        group.vertices.clear();
        return;
    }
    std::vector<unsigned int> remap(group.vertices.size());
    std::vector<ExportVertex> welded(
        meshopt_generateVertexRemap(remap.data(), group.indices.data(), group.indices.size(),
                                    group.vertices.data(), group.vertices.size(), sizeof(ExportVertex)));
    meshopt_remapVertexBuffer(welded.data(), group.vertices.data(), group.vertices.size(),
                              sizeof(ExportVertex), remap.data());
    meshopt_remapIndexBuffer(group.indices.data(), group.indices.data(), group.indices.size(), remap.data());
    group.vertices = std::move(welded);
}

class Grouper {
public:
    explicit Grouper(const GroupSettings& settings) : settings_(settings) {}

    void add(const Placed& placed, const std::string& node, std::size_t material, const Tags& tags) {
        sort_triangles(placed, material, tags);
        for (std::size_t first = 0; first < sorted_.size();) {
            std::size_t end = first + 1;
            while (end < sorted_.size() && sorted_[end].first == sorted_[first].first) {
                ++end;
            }
            MeshGroup& group = groups_[sorted_[first].first];
            name(group, node);
            add_triangles(placed, group, first, end);
            first = end;
        }
    }

    std::vector<MeshGroup> finish() {
        std::vector<MeshGroup> ordered;
        ordered.reserve(groups_.size());
        for (const auto& [key, number] : numbers_) {
            MeshGroup& group = groups_[number];
            weld(group);
            if (!group.indices.empty()) {
                ordered.push_back(std::move(group));
            }
        }
        return ordered;
    }

private:
    using Key = std::tuple<std::size_t, Tags, std::int64_t, std::int64_t>;

    void sort_triangles(const Placed& placed, std::size_t material, const Tags& tags) {
        sorted_.clear();
        Key key{material, tags, 0, 0};
        std::size_t number = 0;
        bool known = false;
        for (std::size_t i = 0; i < placed.mesh.triangles.size(); ++i) {
            const auto& t = placed.mesh.triangles[i];
            const Vector3d centre =
                (placed.position(t[0]) + placed.position(t[1]) + placed.position(t[2])) / 3.0;
            const auto x = static_cast<std::int64_t>(std::floor(centre.x() / settings_.cell));
            const auto z = static_cast<std::int64_t>(std::floor(centre.z() / settings_.cell));
            if (!known || std::get<2>(key) != x || std::get<3>(key) != z) {
                std::get<2>(key) = x;
                std::get<3>(key) = z;
                number = number_of(key);
                known = true;
            }
            sorted_.emplace_back(number, static_cast<std::uint32_t>(i));
        }
        std::ranges::stable_sort(sorted_, {}, &std::pair<std::size_t, std::uint32_t>::first);
    }

    std::size_t number_of(const Key& key) {
        const auto [there, is_new] = numbers_.try_emplace(key, groups_.size());
        if (is_new) {
            MeshGroup& group = groups_.emplace_back();
            group.material = std::get<0>(key);
            group.tags = std::get<1>(key);
            const Vector3d low_edge(static_cast<double>(std::get<2>(key)), 0.0,
                                    static_cast<double>(std::get<3>(key)));
            group.origin = whole_steps(settings_.cell * low_edge, settings_.step);
        }
        return there->second;
    }

    static void name(MeshGroup& group, const std::string& node) {
        if (group.indices.empty()) {
            group.node = node;
        } else if (group.node != node) {
            group.node.clear();
        }
    }

    void add_triangles(const Placed& placed, MeshGroup& group, std::size_t first, std::size_t end) {
        constexpr std::uint32_t kNone = 0xFFFFFFFF;
        local_.assign(placed.mesh.positions.size(), kNone);
        for (std::size_t i = first; i < end; ++i) {
            for (const std::uint32_t vertex : placed.mesh.triangles[sorted_[i].second]) {
                if (local_[vertex] == kNone) {
                    local_[vertex] = static_cast<std::uint32_t>(group.vertices.size());
                    group.vertices.push_back(vertex_of(placed, vertex, group));
                }
                group.indices.push_back(local_[vertex]);
            }
        }
    }

    ExportVertex vertex_of(const Placed& placed, std::uint32_t i, MeshGroup& group) const {
        ExportVertex vertex;
        const Vector3d position = whole_steps(placed.position(i), settings_.step) - group.origin;
        for (int k = 0; k < 3; ++k) {
            vertex.position[static_cast<std::size_t>(k)] = static_cast<float>(position[k]) + 0.0F;
        }
        vertex.normal = packed_normal(placed.normal(i));
        if (i < placed.mesh.uvs.size()) {
            group.has_uvs = true;
            vertex.uv = {rounded_uv(placed.mesh.uvs[i].x()), rounded_uv(placed.mesh.uvs[i].y())};
        }
        if (i < placed.mesh.colors.size()) {
            vertex.color = placed.mesh.colors[i];
            group.has_colors =
                group.has_colors || vertex.color != std::array<std::uint8_t, 4>{255, 255, 255, 255};
        }
        return vertex;
    }

    const GroupSettings& settings_;
    std::map<Key, std::size_t> numbers_;
    std::vector<MeshGroup> groups_;
    std::vector<std::pair<std::size_t, std::uint32_t>> sorted_;  ///< group and triangle of the mesh
    std::vector<std::uint32_t> local_;                           ///< by the mesh's vertex: the group's
};

}  // namespace

std::vector<MeshGroup> group_triangles(std::span<const Model> models, const GroupSettings& settings) {
    Grouper grouper(settings);
    for (std::size_t m = 0; m < models.size(); ++m) {
        const Model& model = models[m];
        for (std::size_t n = 0; n < model.nodes.size(); ++n) {
            const Node& node = model.nodes[n];
            if (node.meshes.empty()) {
                continue;
            }
            const Tags tags = settings.tags_of(m, n);
            for (const MeshIndex index : node.meshes) {
                const Mesh& mesh = model.meshes[index_of(index)];
                grouper.add(Placed(mesh, node.X_world_node), node.name,
                            settings.material_of(m, mesh.material), tags);
            }
        }
    }
    return grouper.finish();
}

}  // namespace campuswalk::scene
