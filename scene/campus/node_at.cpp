#include "scene/campus/node_at.h"

#include <algorithm>
#include <vector>

#include "collision/geometry/closest.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {

namespace {

/// The distance of the node's own geometry, if that is less than `limit`; else `limit`.
double distance_below(const Model& model, const Node& node, const Eigen::Vector3d& point, double limit) {
    for_each_triangle(model, node, [&](const auto& a, const auto& b, const auto& c) {
        const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c);
        const Eigen::Vector3d high = a.cwiseMax(b).cwiseMax(c);
        const double outside = (low - point).cwiseMax(point - high).maxCoeff();
        if (outside < limit) {
            collision::Feature feature{};
            limit =
                std::min(limit, (collision::closest_on_triangle({a, b, c}, point, feature) - point).norm());
        }
    });
    return limit;
}

}  // namespace

std::string node_at(const Campus& campus, const CampusObject& object, const Eigen::Vector3d& point) {
    if (campus.models.empty()) {
        return "";  // only what is collided with was kept
    }
    const std::vector<NodeRef> nodes = nodes_of(campus.models, object.nodes);
    if (nodes.size() == 1) {
        return campus.models[nodes.front().model].nodes[nodes.front().node].name;
    }
    std::string nearest;
    double distance = 1e300;
    for (const NodeRef& ref : nodes) {
        const Model& model = campus.models[ref.model];
        const double other = distance_below(model, model.nodes[ref.node], point, distance);
        if (other < distance) {
            distance = other;
            nearest = model.nodes[ref.node].name;
        }
    }
    return nearest;
}

}  // namespace campuswalk::scene
