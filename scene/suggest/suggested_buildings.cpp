#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <map>

#include "scene/object_names.h"

namespace campuswalk::scene {
namespace {

constexpr double kStorey = 2.2;    // metres
constexpr double kRoom = 2.0;      // metres
constexpr double kMostOfIt = 0.6;  // of the whole model's ground
constexpr std::size_t kMost = 40;

double ground_of(const Bounds& bounds) {
    return bounds.empty() ? 0.0 : (bounds.max.x() - bounds.min.x()) * (bounds.max.z() - bounds.min.z());
}

bool may_be_building(const NodeReport& node, double whole) {
    if (node.bounds.empty()) {
        return false;
    }
    const Eigen::Vector3d size = node.bounds.max - node.bounds.min;
    return size.y() >= kStorey && size.x() >= kRoom && size.z() >= kRoom &&
           ground_of(node.bounds) < kMostOfIt * whole;
}

std::string glob_of(const std::string& name) {
    std::string glob;
    for (const char c : name) {
        if (c == '*' || c == '?' || c == '[' || c == '\\') {
            glob += '\\';
        }
        glob += c;
    }
    return glob;
}

/// Of the report's nodes, without those below another of them.
std::vector<std::size_t> topmost_buildings(const ModelReport& report) {
    std::map<std::string, std::size_t> uses;
    for (const NodeReport& node : report.nodes) {
        ++uses[node.name];
    }
    const double whole = ground_of(report.bounds);
    std::vector<bool> inside(report.nodes.size(), false);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < report.nodes.size(); ++i) {
        const NodeReport& node = report.nodes[i];
        const bool below = node.parent >= 0 && inside[static_cast<std::size_t>(node.parent)];
        const bool chosen =
            !below && !is_made_up_name(node.name) && uses[node.name] == 1 && may_be_building(node, whole);
        inside[i] = below || chosen;
        if (chosen) {
            found.push_back(i);
        }
    }
    return found;
}

}  // namespace

std::vector<SuggestedBuilding> suggest_buildings(const ModelReport& report) {
    std::vector<std::size_t> found = topmost_buildings(report);
    std::stable_sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
        return ground_of(report.nodes[a].bounds) > ground_of(report.nodes[b].bounds);
    });
    found.resize(std::min(found.size(), kMost));
    std::sort(found.begin(), found.end());
    std::vector<std::string> names;
    for (const std::size_t i : found) {
        names.push_back(report.nodes[i].name);
    }
    const std::vector<std::string> ids = distinct_words(names);
    std::vector<SuggestedBuilding> buildings;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const NodeReport& node = report.nodes[found[k]];
        buildings.push_back({ids[k], node.name, glob_of(node.name), node.bounds});
    }
    return buildings;
}

}  // namespace campuswalk::scene
