#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "scene/model_report.h"

namespace campuswalk::scene {
namespace {

constexpr double kLeastSize = 0.5;       // metres
constexpr double kGreatestSize = 20e3;   // metres
constexpr double kFarAway = 10e3;        // metres
constexpr double kCoarsestStep = 0.005;  // metres between neighbouring float32 coordinates
constexpr double kFacing = 0.9;          // cosine within which a face counts as facing an axis

std::string in_metres(double length) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g m", length);
    return text.data();
}

std::string plural(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// The unit that would bring a length into the range of rooms and campuses, if it was read as metres.
std::string unit_guess(double size) {
    struct Unit {
        const char* name;
        double factor;
    };
    constexpr std::array<Unit, 6> kUnits = {{{"unit: cm", 0.01},
                                             {"unit: mm", 0.001},
                                             {"unit: in", 0.0254},
                                             {"scale: 100", 100.0},
                                             {"scale: 1000", 1000.0},
                                             {"scale: 10", 10.0}}};
    for (const Unit& unit : kUnits) {
        const double scaled = size * unit.factor;
        if (scaled >= 5.0 && scaled <= 3000.0) {
            return "; with `" + std::string(unit.name) + "` it would be " + in_metres(scaled);
        }
    }
    return "";
}

void check_size(const Bounds& bounds, std::vector<Oddity>& out) {
    const double size = (bounds.max - bounds.min).maxCoeff();
    if (size < kLeastSize || size > kGreatestSize) {
        out.push_back(
            {"odd-scale", "it is " + in_metres(size) + " across, which no campus is" + unit_guess(size)});
    }
    const double distance = (0.5 * (bounds.min + bounds.max)).norm();
    if (distance > kFarAway) {
        out.push_back({"far-from-origin", "its middle lies " + in_metres(distance) +
                                              " from the origin; move it with `position`"});
    }
}

/// Float32 coordinates in a mesh, scaled as its node places them.
void check_precision(const Model& model, std::vector<Oddity>& out) {
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
    if (coarsest > kCoarsestStep) {
        out.push_back({"coarse-position",
                       "vertices of node '" + worst + "' lie on a grid of about " + in_metres(coarsest) +
                           " because they are so far from the file's origin; move the origin "
                           "near the model before export"});
    }
}

/// A map-like model (flat along z) whose area faces z, not y. A façade alone looks the same, hence
/// "probably".
void check_up_axis(const Model& model, const Bounds& bounds, std::vector<Oddity>& out) {
    const Eigen::Vector3d size = bounds.max - bounds.min;
    if (size.z() >= 0.5 * std::min(size.x(), size.y())) {
        return;
    }
    double facing_y = 0.0;
    double facing_z = 0.0;
    for (const Node& node : model.nodes) {
        const Eigen::Matrix3d linear = node.X_world_node.topLeftCorner<3, 3>();
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            for (const auto& t : mesh.triangles) {
                const Eigen::Vector3d ab =
                    linear * (mesh.positions[t[1]] - mesh.positions[t[0]]).cast<double>();
                const Eigen::Vector3d ac =
                    linear * (mesh.positions[t[2]] - mesh.positions[t[0]]).cast<double>();
                const Eigen::Vector3d n = ab.cross(ac);
                const double area = n.norm();
                facing_y += std::abs(n.y()) > kFacing * area ? area : 0.0;
                facing_z += std::abs(n.z()) > kFacing * area ? area : 0.0;
            }
        }
    }
    if (facing_z > 2.0 * facing_y) {
        out.push_back({"z-up",
                       "it stands on edge: most of its area faces z and it is flat along z; probably "
                       "`up: z` is meant"});
    }
}

void check_nodes(const Model& model, std::vector<Oddity>& out) {
    std::size_t unnamed = 0;
    std::size_t mirrored = 0;
    std::string mirrored_example;
    std::map<std::string, std::size_t> uses;
    for (const Node& node : model.nodes) {
        if (node.meshes.empty()) {
            continue;
        }
        if (is_made_up_name(node.name)) {
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
        out.push_back({"mirrored-node", plural(mirrored, "node") + " with a mirroring transform, such as '" +
                                            mirrored_example +
                                            "'; their triangles were turned right side out"});
    }
    if (unnamed > 0) {
        out.push_back({"unnamed-node", plural(unnamed, "node") +
                                           " with triangles without a name of its own; give names, so that "
                                           "colliders and buildings can refer to them"});
    }
    const auto repeated = std::ranges::count_if(uses, [](const auto& use) { return use.second > 1; });
    if (repeated > 0) {
        const auto example = std::ranges::find_if(uses, [](const auto& use) { return use.second > 1; });
        out.push_back({"repeated-name", plural(static_cast<std::size_t>(repeated), "name") +
                                            " used by several nodes, such as '" + example->first + "' (" +
                                            std::to_string(example->second) + " times)"});
    }
}

}  // namespace

bool is_made_up_name(const std::string& name) {
    return name.empty() || name.starts_with("nodes[") || name.starts_with("$ColladaAutoName$") ||
           name.starts_with("<") || name == "defaultobject";
}

std::vector<Oddity> find_oddities(const Model& model, const Bounds& bounds) {
    std::vector<Oddity> oddities;
    if (bounds.empty()) {
        oddities.push_back({"no-triangles", "it has no triangle: nothing to see and nothing to walk on"});
        return oddities;
    }
    check_size(bounds, oddities);
    check_precision(model, oddities);
    check_up_axis(model, bounds, oddities);
    check_nodes(model, oddities);
    if (const std::size_t count = count_duplicate_faces(model, bounds); count > 0) {
        oddities.push_back(
            {"duplicate-faces", plural(count, "triangle") + " on top of another, facing the same way"});
    }
    const std::vector<std::size_t> outliers = outlier_nodes(model);
    if (!outliers.empty()) {
        oddities.push_back({"outlier", plural(outliers.size(), "node") + " far from all the rest, such as '" +
                                           model.nodes[outliers.front()].name + "', stretch the bounds"});
    }
    return oddities;
}

}  // namespace campuswalk::scene
