#include "scene/import/gltf/deformation.h"

#include <optional>
#include <utility>

#include <Eigen/LU>

namespace campuswalk::scene::gltf {
namespace {

using Affine = Eigen::Matrix<double, 3, 4>;

/// Whether the number that a vertex has is that of a joint; not if it is NaN.
bool is_joint(float number, const std::vector<Eigen::Matrix4d>& X_node_bound) {
    return number >= 0.0F && number < static_cast<float>(X_node_bound.size());
}

/// The mean of a vertex's joints by their weights; nullopt if one doesn't exist.
std::optional<Affine> blend(const std::vector<Eigen::Matrix4d>& X_node_bound,
                            const std::vector<JointSet>& sets, std::size_t vertex) {
    Affine sum = Affine::Zero();
    double total = 0.0;
    for (const JointSet& set : sets) {
        for (Eigen::Index k = 0; k < 4; ++k) {
            const auto weight = static_cast<double>(set.weights[vertex][k]);
            const float joint = set.joints[vertex][k];
            if (weight == 0.0) {
                continue;
            }
            if (!is_joint(joint, X_node_bound)) {
                return std::nullopt;
            }
            sum += weight * X_node_bound[static_cast<std::size_t>(joint)].topRows<3>();
            total += weight;
        }
    }
    if (total > 0.0) {
        return sum / total;
    }
    const float first = sets.front().joints[vertex][0];
    if (!is_joint(first, X_node_bound)) {
        return std::nullopt;
    }
    return X_node_bound[static_cast<std::size_t>(first)].topRows<3>();
}

/// The matrix that keeps normals perpendicular, with the sign of the determinant: normals point away from the
/// mirrored outside.
Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m) {
    Eigen::Matrix3d result;
    result.col(0) = m.col(1).cross(m.col(2));
    result.col(1) = m.col(2).cross(m.col(0));
    result.col(2) = m.col(0).cross(m.col(1));
    return result;
}

}  // namespace

void apply_morph_targets(const std::vector<MorphTarget>& targets, RawMesh& mesh) {
    for (const MorphTarget& target : targets) {
        for (std::size_t i = 0; i < target.positions.size(); ++i) {
            mesh.positions[i] += target.weight * target.positions[i];
        }
        for (std::size_t i = 0; i < target.normals.size(); ++i) {
            mesh.normals[i] += target.weight * target.normals[i];
        }
    }
}

bool apply_skin(const std::vector<Eigen::Matrix4d>& X_node_bound, const std::vector<JointSet>& sets,
                RawMesh& mesh) {
    std::vector<bool> mirrored(mesh.positions.size(), false);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const auto X = blend(X_node_bound, sets, i);
        if (!X) {
            return false;
        }
        const Eigen::Matrix3d linear = X->leftCols<3>();
        mesh.positions[i] = (linear * mesh.positions[i].cast<double>() + X->col(3)).cast<float>();
        mirrored[i] = linear.determinant() < 0.0;
        if (!mesh.normals.empty()) {
            const double side = mirrored[i] ? -1.0 : 1.0;
            mesh.normals[i] =
                (side * cofactors(linear) * mesh.normals[i].cast<double>()).normalized().cast<float>();
        }
    }
    for (auto& triangle : mesh.triangles) {
        if (triangle[0] < mirrored.size() && mirrored[triangle[0]]) {
            std::swap(triangle[1], triangle[2]);
        }
    }
    return true;
}

}  // namespace campuswalk::scene::gltf
