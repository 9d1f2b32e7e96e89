#include "scene/campus/place_scene.h"

#include <utility>

#include <Eigen/Geometry>

#include "scene/model/model_limits.h"

namespace campuswalk::scene {
namespace {

constexpr std::size_t kMaxMegabytes = 1024;  // of all nodes with their names, which are copied

Eigen::Matrix4d transform_of(const ScenePlacement& placement) {
    Eigen::Matrix4d X_world_scene = Eigen::Matrix4d::Identity();
    X_world_scene.topLeftCorner<3, 3>() = placement.rotation * placement.scale;
    X_world_scene.topRightCorner<3, 1>() = placement.position;
    return X_world_scene;
}

void refuse_too_many(const SceneFile& scene, std::size_t count, std::size_t most, const char* what) {
    if (count > most) {
        throw InputError(scene.mark, "bad-model",
                         "'" + scene.file + "', placed " + std::to_string(scene.placements.size()) +
                             " times, has " + std::to_string(count) + " " + what + "; a model may have " +
                             std::to_string(most) + ": place it less often or simplify it");
    }
}

std::size_t bytes_of_nodes(const Model& model) {
    std::size_t bytes = 0;
    for (const Node& node : model.nodes) {
        bytes += sizeof(Node) + node.name.size() + node.meshes.size() * sizeof(MeshIndex);
    }
    return bytes;
}

/// The only placement has no name of its own: the model's nodes stay the topmost.
bool keeps_hierarchy(const SceneFile& scene) {
    return scene.placements.size() == 1 && scene.placements.front().name.empty();
}

std::string name_of(const SceneFile& scene, std::size_t number) {
    const std::string& given = scene.placements[number].name;
    return given.empty() ? scene.path.stem().string() + "#" + std::to_string(number + 1) : given;
}

void append_placed(const std::vector<Node>& nodes, const std::string& name,
                   const Eigen::Matrix4d& X_world_scene, std::vector<Node>& out) {
    const int root = static_cast<int>(out.size());
    out.push_back({name, -1, X_world_scene, {}});
    for (const Node& node : nodes) {
        Node& copy = out.emplace_back(node);
        copy.parent = node.parent < 0 ? root : root + 1 + node.parent;
        copy.X_world_node = X_world_scene * node.X_world_node;
    }
}

}  // namespace

void place_scene(const SceneFile& scene, Model& model) {
    if (scene.placements.empty()) {
        return;
    }
    const std::size_t times = scene.placements.size();
    refuse_too_many(scene, times * (model.nodes.size() + 1), kMaxNodes, "nodes");
    refuse_too_many(scene, (times * bytes_of_nodes(model)) >> 20U, kMaxMegabytes, "MB of nodes");
    refuse_too_many(scene, times * count_triangles(model), kMaxTriangles, "triangles");
    const Eigen::Matrix4d X_world_first = transform_of(scene.placements.front());
    if (times > 1) {
        model.geographic.reset();  // the file doesn't say where on the Earth which of them is
    } else if (model.geographic) {
        model.geographic->at = (X_world_first * model.geographic->at.homogeneous()).head<3>();
    }
    if (keeps_hierarchy(scene)) {
        for (Node& node : model.nodes) {
            node.X_world_node = X_world_first * node.X_world_node;
        }
        return;
    }
    const std::vector<Node> nodes = std::exchange(model.nodes, {});
    model.nodes.reserve(times * (nodes.size() + 1));
    for (std::size_t i = 0; i < times; ++i) {
        append_placed(nodes, name_of(scene, i), transform_of(scene.placements[i]), model.nodes);
    }
}

ContentHash placed_contents(const SceneFile& scene, const ContentHash& contents) {
    if (scene.placements.empty()) {
        return contents;
    }
    ContentHasher hasher;
    hasher.add_hash(contents);
    for (std::size_t i = 0; i < scene.placements.size(); ++i) {
        hasher.add_text(keeps_hierarchy(scene) ? "" : name_of(scene, i));
        const Eigen::Matrix4d X_world_scene = transform_of(scene.placements[i]);
        for (const double number : X_world_scene.reshaped()) {
            hasher.add_number(number);
        }
    }
    return hasher.result();
}

}  // namespace campuswalk::scene
