#include "scene/import/gltf/node_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "scene/import/gltf/skin.h"
#include "scene/model/model_limits.h"

namespace campuswalk::scene::gltf {
namespace {

using Quaternion = std::array<float, 4>;  // x, y, z, w

/// Single precision, as glTF's numbers are. Not normalized: the golden logs depend on it.
Eigen::Matrix3f rotation_of(const Quaternion& q) {
    const auto [x, y, z, w] = q;
    Eigen::Matrix3f m;
    m << 1.0F - 2.0F * (y * y + z * z), 2.0F * (x * y - z * w), 2.0F * (x * z + y * w),  //
        2.0F * (x * y + z * w), 1.0F - 2.0F * (x * x + z * z), 2.0F * (y * z - x * w),   //
        2.0F * (x * z - y * w), 2.0F * (y * z + x * w), 1.0F - 2.0F * (x * x + y * y);
    return m;
}

Eigen::Matrix4d transform_of(const Eigen::Vector3f& translation, const Quaternion& rotation,
                             const Eigen::Vector3f& scale) {
    Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
    m.topLeftCorner<3, 3>() = rotation_of(rotation);
    for (int column = 0; column < 3; ++column) {
        m.block<3, 1>(0, column) *= scale[column];
    }
    m.topRightCorner<3, 1>() = translation;
    return m.cast<double>();
}

/// Replaces large translations (map coordinates), where single precision has a spacing of 0.5 mm and more, by
/// their double values.
void refine_translation(const std::vector<double>& written, Eigen::Matrix4d& X_parent_node) {
    constexpr double kLarge = 4096.0;  // metres
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(written[k]) > kLarge) {
            X_parent_node(static_cast<Eigen::Index>(k), 3) = written[k];
        }
    }
}

Eigen::Matrix4d local_transform(const JsonObject& node) {
    if (const auto matrix = node.floats("matrix", 16)) {
        const Eigen::Map<const Eigen::Matrix4f> m(matrix->data());
        if (m.row(3) != Eigen::RowVector4f(0, 0, 0, 1)) {
            node.fail("has a 'matrix' that is not affine; re-export it");
        }
        Eigen::Matrix4d X_parent_node = m.cast<double>();
        const std::vector<double> written = *node.doubles("matrix", 16);
        refine_translation({written.begin() + 12, written.begin() + 15}, X_parent_node);
        return X_parent_node;
    }
    const auto t = node.doubles("translation", 3).value_or(std::vector<double>{0, 0, 0});
    const auto r = node.floats("rotation", 4).value_or(std::vector<float>{0, 0, 0, 1});
    const auto s = node.floats("scale", 3).value_or(std::vector<float>{1, 1, 1});
    const Eigen::Vector3f translation = Eigen::Vector3d(t[0], t[1], t[2]).cast<float>();
    Eigen::Matrix4d X_parent_node = transform_of(translation, {r[0], r[1], r[2], r[3]}, {s[0], s[1], s[2]});
    refine_translation(t, X_parent_node);
    return X_parent_node;
}

std::vector<Eigen::Matrix4d> instances_of(const JsonObject& instancing, Accessors& accessors) {
    const auto attributes = instancing.object("attributes");
    if (!attributes) {
        instancing.fail("lacks 'attributes'");
    }
    std::vector<float> translations;
    std::vector<float> rotations;
    std::vector<float> scales;
    std::optional<std::size_t> counted;
    const auto read = [&](const char* name, std::size_t components, std::vector<float>& out) {
        if (const auto at = attributes->uint(name)) {
            out = accessors.floats(*at, static_cast<int>(components));
            if (counted && *counted != out.size() / components) {
                instancing.fail("has attributes for different numbers of instances");
            }
            counted = out.size() / components;
        }
    };
    read("TRANSLATION", 3, translations);
    read("ROTATION", 4, rotations);
    read("SCALE", 3, scales);
    if (!counted) {
        instancing.fail(
            "has no TRANSLATION, ROTATION or SCALE, so that nothing says where its instances are");
    }
    const std::size_t count = *counted;
    if (count > kMaxNodes) {
        instancing.fail("places " + std::to_string(count) + " instances; a model may have " +
                        std::to_string(kMaxNodes));
    }
    std::vector<Eigen::Matrix4d> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto three = [i](const std::vector<float>& from, float otherwise) {
            return from.size() < 3 * i + 3 ? Eigen::Vector3f(Eigen::Vector3f::Constant(otherwise))
                                           : Eigen::Vector3f(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
        };
        Quaternion rotation = {0, 0, 0, 1};
        if (rotations.size() >= 4 * i + 4) {
            std::copy_n(rotations.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, rotation.begin());
        }
        result.push_back(transform_of(three(translations, 0.0F), rotation, three(scales, 1.0F)));
    }
    return result;
}

/// Whether KHR_node_visibility hides the node, and all below it.
bool hides(const JsonObject& node) {
    const auto extensions = node.object("extensions");
    const auto visibility = extensions ? extensions->object("KHR_node_visibility") : std::nullopt;
    return visibility && visibility->has("visible") && !visibility->boolean("visible");
}

/// Builds the tree. Visit::node is an index in the file; parents are indices in the tree.
class GraphReader {
public:
    GraphReader(const Document& document, Primitives& primitives, Accessors& accessors,
                const Eigen::Matrix4d& X_world_file, GraphNotes& notes)
        : document_(document),
          primitives_(primitives),
          accessors_(accessors),
          X_world_file_(X_world_file),
          notes_(notes),
          number_in_tree_(document.size("nodes")),
          drawn_(primitives.mesh_count(), false) {}

    NodeTree read();

private:
    struct Visit {
        std::size_t node;
        int parent;
        bool hidden = false;
    };
    struct SkinnedNode {
        int node;
        std::size_t mesh;
        std::size_t skin;
        std::vector<float> weights;
    };
    using DeformedKey =
        std::tuple<std::size_t, std::optional<std::size_t>, std::vector<float>>;  // mesh, skin, weights

    std::vector<std::size_t> roots();
    std::vector<std::size_t> nodes_without_a_parent() const;
    void add_tree(std::size_t root, int parent);
    void add_node(const Visit& visit, std::vector<Visit>& pending);
    int add(std::string name, int parent, const Eigen::Matrix4d& X_parent_node);
    void draw(int node, std::size_t mesh);
    void draw_numbers(int node, std::size_t mesh, std::size_t first);
    void draw_deformed(int node, const DeformedKey& key, std::vector<Eigen::Matrix4d> X_node_bound);
    void draw_node(int self, const JsonObject& item, bool hidden);
    std::vector<Eigen::Matrix4d> placed_joints(const SkinnedNode& skinned, const Skin& skin) const;
    void draw_skinned();
    std::vector<float> weights_of(const JsonObject& node, std::size_t mesh) const;
    std::vector<std::size_t> meshes_not_drawn() const;

    const Document& document_;
    Primitives& primitives_;
    Accessors& accessors_;
    const Eigen::Matrix4d& X_world_file_;
    GraphNotes& notes_;
    std::vector<std::optional<int>> number_in_tree_;  // by node of the file
    std::vector<bool> drawn_;                         // by mesh
    std::vector<SkinnedNode> skinned_;                // drawn when all joints are placed
    std::map<DeformedKey, std::size_t> deformed_;     // the numbers of their first primitives
    bool draws_all_meshes_ = false;                   // those that no node places, too
    NodeTree tree_;
};

std::vector<std::size_t> GraphReader::nodes_without_a_parent() const {
    std::vector<bool> is_child(number_in_tree_.size(), false);
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        for (const std::size_t child : document_.item("nodes", i).uints("children")) {
            if (child < is_child.size()) {
                is_child[child] = true;
            }
        }
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) {
            result.push_back(i);
        }
    }
    return result;
}

std::vector<std::size_t> GraphReader::roots() {
    const std::size_t scenes = document_.size("scenes");
    const auto chosen = document_.root().uint("scene");
    draws_all_meshes_ = !chosen && scenes <= 1;
    if (!chosen && scenes == 0) {
        return nodes_without_a_parent();
    }
    notes_.ignored_scenes = scenes > 0 ? scenes - 1 : 0;
    return document_.item("scenes", chosen.value_or(0)).uints("nodes");
}

int GraphReader::add(std::string name, int parent, const Eigen::Matrix4d& X_parent_node) {
    if (tree_.nodes.size() >= kMaxNodes) {
        throw GltfError("has more than " + std::to_string(kMaxNodes) + " nodes and instances; split it");
    }
    Node node;
    node.name = std::move(name);
    node.parent = parent;
    const Eigen::Matrix4d& X_world_parent =
        parent < 0 ? X_world_file_ : tree_.nodes[static_cast<std::size_t>(parent)].X_world_node;
    node.X_world_node = X_world_parent * X_parent_node;
    tree_.nodes.push_back(std::move(node));
    tree_.mesh_numbers.emplace_back();
    return static_cast<int>(tree_.nodes.size()) - 1;
}

void GraphReader::draw_numbers(int node, std::size_t mesh, std::size_t first) {
    const std::size_t count = primitives_.first(mesh + 1) - primitives_.first(mesh);
    for (std::size_t number = first; number < first + count; ++number) {
        tree_.mesh_numbers[static_cast<std::size_t>(node)].push_back(number);
    }
}

void GraphReader::draw(int node, std::size_t mesh) {
    draw_numbers(node, mesh, primitives_.first(mesh));
}

/// Nodes that draw the same mesh in the same shape share its triangles.
void GraphReader::draw_deformed(int node, const DeformedKey& key, std::vector<Eigen::Matrix4d> X_node_bound) {
    const auto& [mesh, skin, weights] = key;
    auto known = deformed_.find(key);
    if (known == deformed_.end()) {
        const std::size_t first = primitives_.add_deformed(mesh, {weights, std::move(X_node_bound)});
        known = deformed_.emplace(key, first).first;
    }
    draw_numbers(node, mesh, known->second);
}

/// The node's default weights, else the mesh's; empty if they are all 0.
std::vector<float> GraphReader::weights_of(const JsonObject& node, std::size_t mesh) const {
    const JsonObject shape = document_.item("meshes", mesh);
    std::vector<float> weights =
        node.has("weights") ? node.all_floats("weights") : shape.all_floats("weights");
    const bool moves = std::ranges::any_of(weights, [](float weight) { return weight != 0.0F; });
    return moves ? std::move(weights) : std::vector<float>{};
}

void GraphReader::draw_node(int self, const JsonObject& item, bool hidden) {
    const auto mesh = item.uint("mesh");
    if (!mesh) {
        return;
    }
    if (*mesh >= drawn_.size()) {
        item.fail("refers to a mesh that does not exist");
    }
    drawn_[*mesh] = true;
    if (hidden) {
        ++notes_.hidden;
        return;
    }
    std::vector<float> weights = weights_of(item, *mesh);
    const auto extensions = item.object("extensions");
    const auto instancing = extensions ? extensions->object("EXT_mesh_gpu_instancing") : std::nullopt;
    if (const auto skin = item.uint("skin")) {
        if (instancing) {
            item.fail("has both a skin and instances, which glTF doesn't define; export it with one of them");
        }
        skinned_.push_back({self, *mesh, *skin, std::move(weights)});
        return;
    }
    const auto draw_at = [&](int node) {
        if (weights.empty()) {
            draw(node, *mesh);
        } else {
            draw_deformed(node, {*mesh, std::nullopt, weights}, {});
        }
    };
    if (!instancing) {
        draw_at(self);
        return;
    }
    const std::string name = tree_.nodes[static_cast<std::size_t>(self)].name;
    std::size_t number = 0;
    for (const Eigen::Matrix4d& X_node_instance : instances_of(*instancing, accessors_)) {
        draw_at(add(name + "#" + std::to_string(++number), self, X_node_instance));
    }
}

/// Where the nodes are that a skin calls its joints.
std::vector<Eigen::Matrix4d> GraphReader::placed_joints(const SkinnedNode& skinned, const Skin& skin) const {
    std::vector<Eigen::Matrix4d> result;
    for (const std::size_t joint : skin.joints) {
        const auto number = joint < number_in_tree_.size() ? number_in_tree_[joint] : std::nullopt;
        if (!number) {
            document_.item("skins", skinned.skin)
                .fail("has a joint that the scene does not place; re-export it");
        }
        result.push_back(tree_.nodes[static_cast<std::size_t>(*number)].X_world_node);
    }
    return result;
}

/// After all nodes are placed. A skinned node moves last, because others may be its children, and it may be a
/// joint itself.
void GraphReader::draw_skinned() {
    std::vector<Eigen::Matrix4d> X_world_moved;
    for (const SkinnedNode& skinned : skinned_) {
        const Skin skin = read_skin(document_, accessors_, skinned.skin);
        std::vector<Eigen::Matrix4d> X_node_bound = placed_joints(skinned, skin);
        Eigen::Matrix4d X_world_node = Eigen::Matrix4d::Identity();
        X_world_node.topRightCorner<3, 1>() = X_node_bound.front().topRightCorner<3, 1>();
        for (std::size_t i = 0; i < X_node_bound.size(); ++i) {
            X_node_bound[i].topRightCorner<3, 1>() -= X_world_node.topRightCorner<3, 1>();
            X_node_bound[i] = (X_node_bound[i] * skin.X_joint_bound[i]).eval();
        }
        draw_deformed(skinned.node, {skinned.mesh, skinned.skin, skinned.weights}, std::move(X_node_bound));
        X_world_moved.push_back(X_world_node);
    }
    for (std::size_t i = 0; i < skinned_.size(); ++i) {
        tree_.nodes[static_cast<std::size_t>(skinned_[i].node)].X_world_node = X_world_moved[i];
    }
}

void GraphReader::add_node(const Visit& visit, std::vector<Visit>& pending) {
    const JsonObject item = document_.item("nodes", visit.node);
    if (number_in_tree_[visit.node]) {
        item.fail("has two parents or is its own ancestor; re-export it");
    }
    std::string name = item.string("name");
    if (name.empty()) {
        name = "nodes[" + std::to_string(visit.node) + "]";
    }
    const int self = add(std::move(name), visit.parent, local_transform(item));
    number_in_tree_[visit.node] = self;
    const bool hidden = visit.hidden || hides(item);
    draw_node(self, item, hidden);
    const std::vector<std::size_t> children = item.uints("children");
    for (std::size_t i = children.size(); i > 0; --i) {  // reversed: the stack pops the first child first
        pending.push_back({children[i - 1], self, hidden});
    }
}

void GraphReader::add_tree(std::size_t root, int parent) {
    std::vector<Visit> pending = {{root, parent}};
    while (!pending.empty()) {
        const Visit visit = pending.back();
        pending.pop_back();
        add_node(visit, pending);
    }
}

std::vector<std::size_t> GraphReader::meshes_not_drawn() const {
    std::vector<std::size_t> result;
    for (std::size_t mesh = 0; mesh < drawn_.size(); ++mesh) {
        if (!drawn_[mesh]) {
            result.push_back(mesh);
        }
    }
    return result;
}

NodeTree GraphReader::read() {
    const std::vector<std::size_t> top = roots();
    int parent = -1;
    if (top.size() != 1) {
        parent = add("ROOT", -1, Eigen::Matrix4d::Identity());
    }
    for (const std::size_t root : top) {
        add_tree(root, parent);
    }
    draw_skinned();
    const std::vector<std::size_t> unplaced = meshes_not_drawn();
    if (!draws_all_meshes_) {
        notes_.unplaced_meshes = unplaced.size();
        return std::move(tree_);
    }
    for (const std::size_t mesh : unplaced) {
        const std::string name = document_.item("meshes", mesh).string("name");
        draw(add(name.empty() ? "meshes[" + std::to_string(mesh) + "]" : name, parent,
                 Eigen::Matrix4d::Identity()),
             mesh);
    }
    notes_.meshes_at_origin = unplaced.size();
    return std::move(tree_);
}

}  // namespace

NodeTree read_node_graph(const Document& document, Primitives& primitives, Accessors& accessors,
                         const Eigen::Matrix4d& X_world_file, GraphNotes& notes) {
    return GraphReader(document, primitives, accessors, X_world_file, notes).read();
}

}  // namespace campuswalk::scene::gltf
