#include "engine/render/geometry/campus_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <Eigen/LU>

#include "engine/render/geometry/instancing.h"
#include "engine/render/geometry/reversed_duplicates.h"

namespace campuswalk::engine::render {
namespace {

std::int16_t to_signed_16(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767.0));
}

// An opaque triangle with its sort key.
struct SortedTriangle {
    std::size_t material = 0;
    std::uint32_t shared = 0;  // one-based number of its instanced mesh; 0 for none
    std::int32_t cell_x = 0;
    std::int32_t cell_z = 0;
    std::array<std::uint32_t, 3> vertices = {0, 0, 0};

    std::tuple<std::size_t, std::uint32_t, std::int32_t, std::int32_t> order() const {
        return {material, shared, cell_x, cell_z};
    }
    bool same_batch(const SortedTriangle& o) const { return order() == o.order(); }
};

class Baker {
public:
    Baker(std::span<const scene::Model> models, double cell_size, bool instancing)
        : cell_size_(cell_size), instancing_(instancing) {
        geometry_.instances.emplace_back();
        for (const scene::Model& model : models) {
            const scene::Bounds bounds = scene::world_bounds(model);
            if (!bounds.empty()) {
                geometry_.bounds.extend(bounds.min);
                geometry_.bounds.extend(bounds.max);
            }
        }
        if (!geometry_.bounds.empty()) {
            geometry_.origin = geometry_.bounds.center();
        }
        for (const scene::Model& model : models) {
            add_model(model);
        }
    }

    CampusGeometry finish() {
        // Stable: triangles of a batch keep the models' order, so equal depths resolve the same way
        // everywhere.
        std::ranges::stable_sort(triangles_, {}, &SortedTriangle::order);
        geometry_.indices.reserve(3 * triangles_.size());
        for (const SortedTriangle& triangle : triangles_) {
            geometry_.indices.insert(geometry_.indices.end(), triangle.vertices.begin(),
                                     triangle.vertices.end());
        }
        const std::vector<bool> single_sided = single_sided_triangles();
        for (std::size_t first = 0; first < triangles_.size();) {
            std::size_t end = first + 1;
            while (end < triangles_.size() && triangles_[end].same_batch(triangles_[first])) {
                ++end;
            }
            add_batches(first, end, single_sided);
            first = end;
        }
        geometry_.vertices.shrink_to_fit();  // it grew geometrically
        return std::move(geometry_);
    }

private:
    bool is_double_sided(std::size_t material) const {
        return geometry_.materials[material].material.double_sided;
    }

    // Drawn double-sided, coincident triangles of opposite winding would z-fight: each shows its front only.
    std::vector<bool> single_sided_triangles() const {
        const bool any = std::ranges::any_of(
            triangles_, [this](const SortedTriangle& t) { return is_double_sided(t.material); });
        if (!any) {
            return std::vector<bool>(triangles_.size(), true);
        }
        // Only within a mesh: an instanced mesh may coincide with other geometry at its first placement.
        std::vector<std::uint32_t> groups;
        groups.reserve(triangles_.size());
        for (const SortedTriangle& triangle : triangles_) {
            groups.push_back(triangle.shared);
        }
        return find_reversed_duplicates(geometry_.vertices, geometry_.indices, groups);
    }

    // Adds the triangles of one material and cell: double-sided ones, then the others.
    void add_batches(std::size_t first, std::size_t end, const std::vector<bool>& single_sided) {
        const std::size_t material = triangles_[first].material;
        std::size_t at = 3 * first;
        for (const bool double_sided : {true, false}) {
            Batch batch;
            batch.material = material;
            batch.first = at;
            batch.double_sided = double_sided;
            for (std::size_t i = first; i < end; ++i) {
                if ((is_double_sided(material) && !single_sided[i]) != double_sided) {
                    continue;
                }
                for (const std::uint32_t vertex : triangles_[i].vertices) {
                    geometry_.indices[at++] = vertex;
                    batch.bounds.extend(position(vertex).cast<double>());
                }
                batch.count += 3;
            }
            if (batch.count > 0) {
                add_batch(batch, triangles_[first].shared);
            }
        }
    }

    void add_batch(const Batch& batch, std::uint32_t shared) {
        if (shared == 0) {
            geometry_.batches.push_back(batch);
            return;
        }
        InstancedMesh& mesh = instanced_meshes_[shared - 1];
        const std::vector<InstanceGroup> groups = mesh.group(batch.bounds, cell_size_);
        for (const InstanceGroup& group : groups) {
            Batch& added = geometry_.batches.emplace_back(batch);
            added.first_instance = geometry_.instances.size() + group.first;
            added.instances = group.count;
            added.bounds = group.bounds;
        }
        geometry_.instances.insert(geometry_.instances.end(), mesh.instances().begin(),
                                   mesh.instances().end());
    }

    Eigen::Vector3f position(std::uint32_t vertex) const {
        return Eigen::Vector3f(geometry_.vertices[vertex].position.data());
    }

    void add_model(const scene::Model& model) {
        const std::size_t first_material = geometry_.materials.size();
        for (const scene::Material& material : model.materials) {
            geometry_.materials.push_back({material, &model});
        }
        const std::size_t default_material = geometry_.materials.size();  // for meshes without a material
        geometry_.materials.emplace_back();
        const std::vector<bool> instanced =
            instancing_ ? meshes_to_instance(model) : std::vector<bool>(model.meshes.size(), false);
        std::vector<std::optional<std::size_t>> shared(model.meshes.size());  // index into instanced_meshes_
        for (const scene::Node& node : model.nodes) {
            ++node_;
            Eigen::Matrix4d X_campus_node = node.X_world_node;
            X_campus_node.topRightCorner<3, 1>() -= geometry_.origin;
            for (const scene::MeshIndex mesh_index : node.meshes) {
                const std::size_t i = index_of(mesh_index);
                if (shared[i] && instanced_meshes_[*shared[i]].add(X_campus_node, node_)) {
                    continue;
                }
                std::uint32_t number = 0;
                if (instanced[i] && !shared[i]) {
                    shared[i] = instanced_meshes_.size();
                    instanced_meshes_.emplace_back(X_campus_node, node_);
                    number = static_cast<std::uint32_t>(instanced_meshes_.size());
                }
                const std::size_t material = index_of(model.meshes[i].material);
                add_mesh(model.meshes[i], X_campus_node,
                         material < model.materials.size() ? first_material + material : default_material,
                         number);
            }
        }
    }

    void add_mesh(const scene::Mesh& mesh, const Eigen::Matrix4d& X_campus_mesh, std::size_t material,
                  std::uint32_t shared) {
        const auto first = static_cast<std::uint32_t>(geometry_.vertices.size());
        geometry_.placements.push_back({first, node_});
        const Eigen::Matrix3d linear = X_campus_mesh.topLeftCorner<3, 3>();
        const Eigen::Vector3d offset = X_campus_mesh.topRightCorner<3, 1>();
        // Normals transform by the cofactor matrix, which unlike the inverse exists for flattened nodes too.
        Eigen::Matrix3d cofactor;
        for (int i = 0; i < 3; ++i) {
            cofactor.col(i) = linear.col((i + 1) % 3).cross(linear.col((i + 2) % 3));
        }
        if (linear.determinant() < 0.0) {
            cofactor = -cofactor;
        }
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Eigen::Vector3d normal = i < mesh.normals.size()
                                               ? Eigen::Vector3d(cofactor * mesh.normals[i].cast<double>())
                                               : Eigen::Vector3d::UnitY();
            geometry_.vertices.push_back(make_vertex(
                linear * mesh.positions[i].cast<double>() + offset, normal.normalized(),
                i < mesh.uvs.size() ? mesh.uvs[i] : Eigen::Vector2f(0, 0),
                i < mesh.colors.size() ? mesh.colors[i] : std::array<std::uint8_t, 4>{255, 255, 255, 255}));
        }
        for (const auto& t : mesh.triangles) {
            add_triangle({first + t[0], first + t[1], first + t[2]}, material, shared);
        }
    }

    void add_triangle(const std::array<std::uint32_t, 3>& vertices, std::size_t material,
                      std::uint32_t shared) {
        const Eigen::Vector3f centre =
            (position(vertices[0]) + position(vertices[1]) + position(vertices[2])) / 3.0F;
        if (geometry_.materials[material].material.alpha_mode == scene::AlphaMode::blend) {
            geometry_.blend.push_back({material, vertices, centre});
            return;
        }
        const auto cell = [&](float value) {  // an instanced mesh stays whole: its instances have cells
            return shared > 0 ? 0 : static_cast<std::int32_t>(std::floor(value / cell_size_));
        };
        triangles_.push_back({material, shared, cell(centre.x()), cell(centre.z()), vertices});
    }

    double cell_size_;
    bool instancing_;
    std::uint32_t node_ = 0;  // number of the node that is being added
    CampusGeometry geometry_;
    std::vector<InstancedMesh> instanced_meshes_;
    std::vector<SortedTriangle> triangles_;
};

}  // namespace

Vertex make_vertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, const Eigen::Vector2f& uv,
                   const std::array<std::uint8_t, 4>& color) {
    Vertex vertex;
    for (int i = 0; i < 3; ++i) {
        vertex.position[static_cast<std::size_t>(i)] = static_cast<float>(position[i]);
        vertex.normal[static_cast<std::size_t>(i)] = to_signed_16(normal[i]);
    }
    vertex.uv = {uv.x(), uv.y()};
    vertex.color = color;
    return vertex;
}

Eigen::Affine3d placement_of(const Instance& instance) {
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    for (std::size_t row = 0; row < 3; ++row) {
        placement.matrix().row(static_cast<Eigen::Index>(row)) =
            Eigen::RowVector4f(instance.rows[row].data()).cast<double>();
    }
    return placement;
}

CampusGeometry bake(std::span<const scene::Model> models, double cell_size, bool instancing) {
    return Baker(models, cell_size, instancing).finish();
}

}  // namespace campuswalk::engine::render
