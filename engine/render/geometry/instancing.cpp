#include "engine/render/geometry/instancing.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/LU>

namespace campuswalk::engine::render {
namespace {

// Measured on llvmpipe with 30 to 2,000 trees of 12 to 500 triangles: drawing takes the same time either way,
// except for small meshes, whose draw calls add up. Instancing saves 75 bytes per triangle.
constexpr std::size_t kMinPlacements = 8;
constexpr std::size_t kMinSavedTriangles = 20000;  // per mesh: 1.5 MB

constexpr double kMaxScale =
    4.0;  // scale relative to the first placement, whose vertices were rounded to floats
constexpr double kTolerance = 1e-6;  // of an element of a rotation matrix

bool is_similarity(const Eigen::Matrix4d& transform) {
    const Eigen::Matrix3d linear = transform.topLeftCorner<3, 3>();
    const double volume = linear.determinant();
    if (!(volume > 0.0) || !std::isfinite(volume)) {
        return false;
    }
    const double scale = std::cbrt(volume);
    if (scale > kMaxScale) {
        return false;
    }
    const Eigen::Matrix3d gram = linear.transpose() * linear / (scale * scale);
    return (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kTolerance;
}

Eigen::AlignedBox3d transformed(const Eigen::AlignedBox3d& box, const Instance& instance) {
    const Eigen::Affine3d X = placement_of(instance);
    Eigen::AlignedBox3d result;
    for (int i = 0; i < 8; ++i) {
        result.extend(X * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    }
    return result;
}

struct PlacedInstance {
    std::int64_t cell_x = 0;
    std::int64_t cell_z = 0;
    Eigen::AlignedBox3d bounds;
    Instance instance;

    bool same_cell(const PlacedInstance& o) const { return cell_x == o.cell_x && cell_z == o.cell_z; }
};

}  // namespace

std::vector<bool> meshes_to_instance(const scene::Model& model) {
    std::vector<std::size_t> placements(model.meshes.size(), 0);
    for (const scene::Node& node : model.nodes) {
        for (const scene::MeshIndex mesh : node.meshes) {
            ++placements[index_of(mesh)];
        }
    }
    std::vector<bool> instanced(model.meshes.size(), false);
    for (std::size_t i = 0; i < instanced.size(); ++i) {
        const scene::Mesh& mesh = model.meshes[i];
        const std::size_t material = index_of(mesh.material);
        // Blended triangles are sorted individually.
        const bool blend = material < model.materials.size() &&
                           model.materials[material].alpha_mode == scene::AlphaMode::blend;
        instanced[i] = !blend && placements[i] >= kMinPlacements &&
                       (placements[i] - 1) * mesh.triangles.size() >= kMinSavedTriangles;
    }
    return instanced;
}

InstancedMesh::InstancedMesh(const Eigen::Matrix4d& X_campus_first, std::uint32_t node) {
    const Eigen::Matrix4d inverse = X_campus_first.inverse();
    if (inverse.allFinite()) {
        X_mesh_campus_ = inverse;
    }
    instances_.push_back({.node = node});
}

bool InstancedMesh::add(const Eigen::Matrix4d& X_campus_mesh, std::uint32_t node) {
    if (!X_mesh_campus_) {
        return false;
    }
    const Eigen::Matrix4d from_first = X_campus_mesh * *X_mesh_campus_;
    if (!is_similarity(from_first)) {
        return false;
    }
    Instance instance{.node = node};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            instance.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                static_cast<float>(from_first(row, column));
        }
    }
    instances_.push_back(instance);
    return true;
}

std::vector<InstanceGroup> InstancedMesh::group(const Eigen::AlignedBox3d& first, double cell_size) {
    std::vector<PlacedInstance> sorted;
    for (const Instance& instance : instances_) {
        const Eigen::AlignedBox3d bounds = transformed(first, instance);
        const Eigen::Vector3d cell = bounds.center() / cell_size;
        sorted.push_back({static_cast<std::int64_t>(std::floor(cell.x())),
                          static_cast<std::int64_t>(std::floor(cell.z())), bounds, instance});
    }
    std::ranges::stable_sort(sorted, [](const PlacedInstance& a, const PlacedInstance& b) {
        return std::tie(a.cell_x, a.cell_z) < std::tie(b.cell_x, b.cell_z);
    });
    std::vector<InstanceGroup> groups;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i == 0 || !sorted[i].same_cell(sorted[i - 1])) {
            groups.emplace_back().first = i;
        }
        ++groups.back().count;
        groups.back().bounds.extend(sorted[i].bounds);
        instances_[i] = sorted[i].instance;
    }
    return groups;
}

}  // namespace campuswalk::engine::render
