#include "scene/lint/doors.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "collision/geometry/disjoint_sets.h"
#include "scene/lint/closed_doors.h"
#include "scene/model/connected_pieces.h"
#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/model/upright_box.h"

namespace campuswalk::scene {

namespace {

struct Leaf {
    Bounds bounds;
    UprightBoxFit fit;
};

/// Adds each connected piece of a node.
void add_pieces(const Model& model, const Node& node, std::vector<Leaf>& leaves) {
    const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
    const Eigen::Vector3d offset = node.X_world_node.topRightCorner<3, 1>();
    for (const Piece& piece : connected_pieces(model, node)) {
        Leaf& leaf = leaves.emplace_back();
        for (const auto& [m, t] : piece) {
            const Mesh& mesh = model.meshes[index_of(node.meshes[m])];
            for (const std::uint32_t vertex : mesh.triangles[t]) {
                const Eigen::Vector3d p = linear * mesh.positions[vertex].cast<double>() + offset;
                leaf.bounds.extend(p);
                leaf.fit.add(p);
            }
        }
    }
}

bool touch(const Bounds& a, const Bounds& b) {
    constexpr double kNear = 0.15;  // metres
    return ((a.min - b.max).array() <= kNear).all() && ((b.min - a.max).array() <= kNear).all();
}

/// The boxes around those pieces of one part that touch.
std::vector<UprightBox> boxes_apart(std::vector<Leaf> leaves) {
    constexpr std::size_t kMost = 1'000;  // pieces; more are one thing
    const bool are_one = leaves.size() > kMost;
    collision::DisjointSets sets(leaves.size());
    for (std::size_t a = 0; a < leaves.size(); ++a) {
        for (std::size_t b = 0; b < (are_one ? std::min<std::size_t>(a, 1) : a); ++b) {
            if (are_one || touch(leaves[a].bounds, leaves[b].bounds)) {
                sets.join(a, b);
            }
        }
    }
    std::map<std::uint32_t, UprightBoxFit> fits;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        UprightBoxFit& fit = fits[sets.root(i)];
        for (const Eigen::Vector3d& vertex : leaves[i].fit.vertices()) {
            fit.add(vertex);
        }
    }
    std::vector<UprightBox> boxes;
    boxes.reserve(fits.size());
    for (auto& [root, fit] : fits) {
        boxes.push_back(fit.box());
    }
    return boxes;
}

}  // namespace

std::vector<Door> find_doors(const Model& model) {
    const std::vector<std::size_t> parts = named_parts(model, is_door_name);
    std::vector<std::vector<Leaf>> leaves(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (parts[n] != kNoPart) {
            add_pieces(model, model.nodes[n], leaves[parts[n]]);
        }
    }
    std::vector<Door> doors;
    for (const ClosedDoor& closed : find_closed_doors(model)) {
        doors.push_back({closed.node, closed.foot, closed.width, closed.height, true});
        leaves[closed.node].clear();
    }
    for (std::size_t n = 0; n < leaves.size(); ++n) {
        for (const UprightBox& box : boxes_apart(std::move(leaves[n]))) {
            const Eigen::Vector3d foot = box.center - 0.5 * box.size.y() * Eigen::Vector3d::UnitY();
            doors.push_back({n, foot, std::max(box.size.x(), box.size.z()), box.size.y(), false});
        }
    }
    std::ranges::stable_sort(doors, {}, &Door::node);
    return doors;
}

}  // namespace campuswalk::scene
