#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/LU>

#include "scene/lint/closed_doors.h"
#include "scene/lint/model_report.h"
#include "scene/lint/named_sizes.h"
#include "scene/lint/wording.h"
#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

constexpr double kMaxSpacing = 0.005;  // metres between adjacent float32 coordinates

void check_size(const Bounds& bounds, std::vector<ModelLint>& out) {
    const double size = (bounds.max - bounds.min).maxCoeff();
    if (size == 0.0) {
        out.push_back({"odd-scale", "all its vertices lie at one point"});
    }
    const Eigen::Vector3d center = bounds.center();
    const double distance = center.norm();
    if (center.cwiseAbs().maxCoeff() > kFarAway) {  // the criterion of origin_near
        out.push_back({"far-from-origin",
                       "its centre is " + in_metres(distance) +
                           " from the origin; set `origin: {at: near}` in the campus file to move it there"});
    }
}

/// The spacing of a mesh's float32 coordinates in the world frame.
void check_precision(const Model& model, std::vector<ModelLint>& out) {
    constexpr double kRelativeStep = 1.0 / (1 << 23U);
    double coarsest = 0.0;
    std::string worst;
    for (const Node& node : model.nodes) {
        const double scale = node.X_world_node.topLeftCorner<3, 3>().colwise().norm().maxCoeff();
        for (const MeshIndex index : node.meshes) {
            float largest = 0.0F;
            for (const Eigen::Vector3f& p : model.meshes[index_of(index)].positions) {
                largest = std::max(largest, p.cwiseAbs().maxCoeff());
            }
            const double step = static_cast<double>(largest) * scale * kRelativeStep;
            if (step > coarsest) {
                coarsest = step;
                worst = node.name;
            }
        }
    }
    if (coarsest > kMaxSpacing) {
        out.push_back({"coarse-position",
                       "vertices of node '" + worst + "' lie on a grid of about " + in_metres(coarsest) +
                           " because they are so far from the file's origin; move the origin "
                           "near the model before export"});
    }
}

void check_nodes(const Model& model, std::vector<ModelLint>& out) {
    std::size_t unnamed = 0;
    std::size_t mirrored = 0;
    std::string mirrored_example;
    std::map<std::string, std::size_t> uses;
    for (const Node& node : model.nodes) {
        if (node.meshes.empty()) {
            continue;
        }
        if (is_generated_name(node.name)) {
            ++unnamed;
        } else {
            ++uses[node.name];
        }
        if (node.X_world_node.topLeftCorner<3, 3>().determinant() < 0.0) {
            ++mirrored;
            mirrored_example = mirrored_example.empty() ? node.name : mirrored_example;
        }
    }
    if (mirrored > 0) {
        out.push_back({"mirrored-node", plural(mirrored, "node") +
                                            " with a mirroring transform, for example '" + mirrored_example +
                                            "'; their triangle winding was corrected"});
    }
    if (unnamed > 0) {
        out.push_back({"unnamed-node", plural(unnamed, "node") +
                                           " with triangles but no stable name; name them so that "
                                           "colliders and buildings can refer to them"});
    }
    const auto repeated = std::ranges::count_if(uses, [](const auto& use) { return use.second > 1; });
    if (repeated > 0) {
        const auto example = std::ranges::find_if(uses, [](const auto& use) { return use.second > 1; });
        out.push_back({"repeated-name", plural(static_cast<std::size_t>(repeated), "name") +
                                            " shared by several nodes, for example '" + example->first +
                                            "' (" + std::to_string(example->second) + " times)"});
    }
}

void check_duplicates(const Model& model, const Bounds& bounds, std::vector<ModelLint>& out) {
    ModelLint lint{"duplicate-faces", "", {}};
    std::size_t count = 0;
    const DuplicateFaces* most = nullptr;
    const std::vector<DuplicateFaces> duplicates = find_duplicate_faces(model, bounds);
    for (const DuplicateFaces& own : duplicates) {
        lint.places.push_back({model.nodes[own.node].name, own.first});
        count += own.count;
        most = most == nullptr || own.count > most->count ? &own : most;
    }
    if (most != nullptr) {
        lint.message = plural(count, "triangle") + " on top of another, facing the same way, " +
                       (duplicates.size() > 1 ? "most of them (" + std::to_string(most->count) + ") " : "") +
                       "in node '" + model.nodes[most->node].name + "'; delete the duplicates";
        out.push_back(lint);
    }
}

void check_outliers(const Model& model, const ModelReport& report, std::vector<ModelLint>& out) {
    ModelLint lint{"outlier", "", {}};
    for (const std::size_t n : outlier_nodes(model)) {
        const Bounds& bounds = report.nodes[n].bounds;
        lint.places.push_back({model.nodes[n].name, bounds.center()});
    }
    if (!lint.places.empty()) {
        lint.message = plural(lint.places.size(), "node") + " far from everything else, for example '" +
                       lint.places.front().node +
                       "', stretch the bounds; move them or exclude them from the export";
        out.push_back(lint);
    }
}

}  // namespace

ModelLint solid_doors(std::vector<ModelLint::Place> doors) {
    const std::string message = plural(doors.size(), "door") + " that " +
                                (doors.size() == 1 ? "closes" : "close") + " a doorway, for example '" +
                                doors.front().node +
                                "'; open them or exclude their nodes from solid colliders";
    return {"solid-door", message, std::move(doors)};
}

std::vector<ModelLint> find_lints(const Model& model, const ModelReport& report) {
    std::vector<ModelLint> lints;
    if (report.bounds.empty()) {
        lints.push_back({"no-triangles", "it has no triangles: nothing to see and nothing to walk on"});
        return lints;
    }
    check_size(report.bounds, lints);
    check_precision(model, lints);
    check_nodes(model, lints);
    check_duplicates(model, report.bounds, lints);
    check_outliers(model, report, lints);
    const std::vector<ModelLint> size_lints = lint_named_sizes(model, report.nodes);
    lints.insert(lints.end(), size_lints.begin(), size_lints.end());
    return lints;
}

}  // namespace campuswalk::scene
