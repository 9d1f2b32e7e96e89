#include "tests/scene/box_model.h"

#include <cmath>

#include <Eigen/Geometry>

#include "tests/support/angles.h"

namespace campuswalk::scene::test {
namespace {

MeshIndex add_mesh(Model& model, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    if (model.materials.empty()) {
        model.materials.emplace_back();
    }
    Mesh mesh;
    for (int vertex = 0; vertex < 8; ++vertex) {
        mesh.positions.emplace_back(static_cast<float>((vertex & 1) != 0 ? high.x() : low.x()),
                                    static_cast<float>((vertex & 2) != 0 ? high.y() : low.y()),
                                    static_cast<float>((vertex & 4) != 0 ? high.z() : low.z()));
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    model.meshes.push_back(mesh);
    return static_cast<MeshIndex>(model.meshes.size() - 1);
}

}  // namespace

std::size_t add_group(Model& model, const std::string& name, int parent) {
    Node node;
    node.name = name;
    node.parent = parent;
    model.nodes.push_back(node);
    return model.nodes.size() - 1;
}

std::size_t add_box(Model& model, const std::string& name, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high, int parent) {
    const std::size_t node = add_group(model, name, parent);
    model.nodes[node].meshes.push_back(add_mesh(model, low, high));
    return node;
}

std::size_t add_turned_box(Model& model, const std::string& name, const Eigen::Vector3d& center,
                           const Eigen::Vector3d& size, double yaw_deg) {
    const std::size_t node = add_box(model, name, -0.5 * size, 0.5 * size);
    const double yaw = support::radians(yaw_deg);
    Eigen::Matrix4d& X = model.nodes[node].X_world_node;
    X.topLeftCorner<3, 3>() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()).toRotationMatrix();
    X.topRightCorner<3, 1>() = center;
    return node;
}

std::size_t add_boxes(Model& model, const std::string& name, const std::vector<Box>& boxes) {
    const std::size_t node = add_group(model, name);
    for (const Box& box : boxes) {
        model.nodes[node].meshes.push_back(add_mesh(model, box.low, box.high));
    }
    return node;
}

}  // namespace campuswalk::scene::test
