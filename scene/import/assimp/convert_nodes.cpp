#include "scene/import/assimp/convert_nodes.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include <assimp/scene.h>

namespace campuswalk::scene {
namespace {

Eigen::Matrix4d to_matrix(const aiMatrix4x4& m) {
    Eigen::Matrix4d result;
    for (unsigned int row = 0; row < 4; ++row) {
        for (unsigned int column = 0; column < 4; ++column) {
            result(row, column) = static_cast<double>(m[row][column]);
        }
    }
    result.bottomRows<1>() << 0, 0, 0, 1;  // whatever the file says
    return result;
}

/// What a node of assimp's stands for.
enum class Link {
    node,              ///< a node of the file
    transform,         ///< a part of the transform of the node that follows
    geometry,          ///< a part of what moves that node's meshes alone
    geometry_inverse,  ///< takes it back before the children
};

/// assimp names the links of an FBX node called X `X_$AssimpFbx$_PART`. They draw nothing, and lead to
/// something.
Link link_of(const aiNode& node) {
    const std::string_view name = node.mName.C_Str();
    constexpr std::string_view kTag = "_$AssimpFbx$_";
    constexpr std::array<std::string_view, 3> kGeometry = {"GeometricTranslation", "GeometricRotation",
                                                           "GeometricScaling"};
    constexpr std::array<std::string_view, 3> kInverse = {
        "GeometricTranslationInverse", "GeometricRotationInverse", "GeometricScalingInverse"};
    constexpr std::array<std::string_view, 11> kTransform = {
        "Translation",  "RotationOffset", "RotationPivot",        "PreRotation",
        "Rotation",     "PostRotation",   "RotationPivotInverse", "ScalingOffset",
        "ScalingPivot", "Scaling",        "ScalingPivotInverse"};
    const std::size_t at = name.rfind(kTag);
    if (at == std::string_view::npos || node.mNumMeshes > 0 || node.mNumChildren == 0) {
        return Link::node;
    }
    const std::string_view part = name.substr(at + kTag.size());
    const auto is_in = [part](const auto& parts) { return std::ranges::find(parts, part) != parts.end(); };
    return is_in(kTransform)  ? Link::transform
           : is_in(kGeometry) ? Link::geometry
           : is_in(kInverse)  ? Link::geometry_inverse
                              : Link::node;
}

struct Visit {
    const aiNode* node = nullptr;
    int parent = -1;
    Eigen::Matrix4d X_world_parent;  // with the links so far
    Eigen::Matrix4d X_node_geometry = Eigen::Matrix4d::Identity();
};

class Conversion {
public:
    explicit Conversion(const aiScene& scene) : scene_(scene) {}

    NodeTree run(const Eigen::Matrix4d& X_world_file);

private:
    void visit(const Visit& at);
    int add(const Visit& at, const Eigen::Matrix4d& X_world_node);

    const aiScene& scene_;
    NodeTree tree_;
    std::vector<Visit> pending_;
};

int Conversion::add(const Visit& at, const Eigen::Matrix4d& X_world_node) {
    Node node;
    node.name = at.node->mName.C_Str();
    node.parent = at.parent;
    node.X_world_node = X_world_node * at.X_node_geometry;
    tree_.nodes.push_back(std::move(node));
    std::vector<std::size_t>& meshes = tree_.mesh_numbers.emplace_back();
    std::copy_if(at.node->mMeshes, at.node->mMeshes + at.node->mNumMeshes, std::back_inserter(meshes),
                 [this](unsigned int number) { return number < scene_.mNumMeshes; });
    return static_cast<int>(tree_.nodes.size()) - 1;
}

void Conversion::visit(const Visit& at) {
    const Link link = link_of(*at.node);
    const Eigen::Matrix4d X_link = to_matrix(at.node->mTransformation);
    Visit next{nullptr, at.parent, at.X_world_parent, at.X_node_geometry};
    if (link == Link::geometry) {
        next.X_node_geometry = at.X_node_geometry * X_link;
    } else if (link != Link::geometry_inverse) {
        next.X_world_parent = at.X_world_parent * X_link;
    }
    if (link == Link::node) {
        next.parent = add(at, next.X_world_parent);
        next.X_node_geometry.setIdentity();
    }
    for (unsigned int i = at.node->mNumChildren; i > 0; --i) {  // the stack pops the first child first
        next.node = at.node->mChildren[i - 1];
        pending_.push_back(next);
    }
}

NodeTree Conversion::run(const Eigen::Matrix4d& X_world_file) {
    pending_.push_back({scene_.mRootNode, -1, X_world_file});
    while (!pending_.empty()) {
        const Visit at = pending_.back();
        pending_.pop_back();
        visit(at);
    }
    return std::move(tree_);
}

/// Whether its InheritType makes it stand elsewhere below a parent with these axes.
bool inherits_otherwise(const aiNode& node, const Eigen::Matrix3d& of_parent) {
    constexpr int kWithoutShear = 0;  // RrSs: the parent's scale along the world's axes
    constexpr int kWithoutScale = 2;  // Rrs
    int type = 1;
    if (node.mMetaData == nullptr || !node.mMetaData->Get("InheritType", type)) {
        return false;
    }
    const Eigen::Matrix3d squared = of_parent.transpose() * of_parent;
    const double scale = type == kWithoutScale ? 1.0 : squared.trace() / 3.0;
    const bool is_scaled = (squared - scale * Eigen::Matrix3d::Identity()).norm() > 1e-4 * squared.norm();
    return is_scaled && (type == kWithoutShear || type == kWithoutScale);
}

}  // namespace

NodeTree convert_nodes(const aiScene& scene, const Eigen::Matrix4d& X_world_file) {
    return Conversion(scene).run(X_world_file);
}

std::vector<std::string> nodes_of_other_inheritance(const aiScene& scene) {
    struct Scaled {
        const aiNode* node = nullptr;
        Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();     // with the links so far
        Eigen::Matrix3d of_parent = Eigen::Matrix3d::Identity();  // of the last node of the file
    };
    std::vector<std::string> names;
    std::vector<Scaled> pending = {{scene.mRootNode}};
    while (!pending.empty()) {
        Scaled at = pending.back();
        pending.pop_back();
        at.linear *= to_matrix(at.node->mTransformation).topLeftCorner<3, 3>();
        if (link_of(*at.node) == Link::node) {
            if (inherits_otherwise(*at.node, at.of_parent)) {
                names.emplace_back(at.node->mName.C_Str());
            }
            at.of_parent = at.linear;
        }
        for (unsigned int i = at.node->mNumChildren; i > 0; --i) {
            pending.push_back({at.node->mChildren[i - 1], at.linear, at.of_parent});
        }
    }
    return names;
}

}  // namespace campuswalk::scene
