#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "scene/base/glob.h"
#include "scene/campus/object_names.h"
#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kStorey = 2.4;    // metres
constexpr double kRoom = 3.0;      // metres
constexpr double kMaxShare = 0.6;  // of the model's footprint
constexpr double kMinWalls = 0.3;  // of the area of a wall of one storey around the box
constexpr double kVertical = 0.2;  // the largest |y| of a wall's unit normal
constexpr std::size_t kMaxBuildings = 40;

double footprint_of(const Bounds& bounds) {
    return bounds.empty() ? 0.0 : (bounds.max.x() - bounds.min.x()) * (bounds.max.z() - bounds.min.z());
}

/// Decided by its name and its bounds.
bool may_be_building(const NodeReport& node, double whole) {
    if (node.bounds.empty() || is_generated_name(node.name) || is_surroundings_name(node.name)) {
        return false;
    }
    const Vector3d size = node.bounds.max - node.bounds.min;
    return size.y() >= kStorey && size.x() >= kRoom && size.z() >= kRoom &&
           footprint_of(node.bounds) < kMaxShare * whole;
}

/// By node.
using Children = std::vector<std::vector<std::size_t>>;

Children children_of(const Model& model) {
    Children children(model.nodes.size());
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].parent >= 0) {
            children[static_cast<std::size_t>(model.nodes[n].parent)].push_back(n);
        }
    }
    return children;
}

/// The box around a subtree if it has the walls of a building.
std::optional<UprightBox> box_if_walled(const Model& model, const Children& children, std::size_t root) {
    UprightBoxFit fit;
    double walls = 0.0;
    std::vector<std::size_t> stack = {root};
    while (!stack.empty()) {
        const std::size_t n = stack.back();
        stack.pop_back();
        stack.insert(stack.end(), children[n].begin(), children[n].end());
        for_each_vertex(model, model.nodes[n], [&](const Vector3d& p) { fit.add(p); });
        for_each_triangle(model, model.nodes[n],
                          [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                              const Vector3d normal = (b - a).cross(c - a);
                              const double twice_area = normal.norm();
                              walls += std::abs(normal.y()) < kVertical * twice_area ? 0.5 * twice_area : 0.0;
                          });
    }
    const UprightBox box = fit.box();
    const bool wide = box.size.x() >= kRoom && box.size.z() >= kRoom;
    const double wall_area = 2.0 * (box.size.x() + box.size.z()) * kStorey;
    return wide && walls >= kMinWalls * wall_area ? std::optional(box) : std::nullopt;
}

struct Candidate {
    std::size_t node = 0;
    UprightBox box;

    double footprint() const { return box.size.x() * box.size.z(); }
};

/// Without buildings below another one.
std::vector<Candidate> topmost_buildings(const Model& model, const ModelReport& report) {
    std::map<std::string, std::size_t> uses;
    for (const NodeReport& node : report.nodes) {
        ++uses[node.name];
    }
    const double whole = footprint_of(report.bounds);
    const Children children = children_of(model);
    std::vector<bool> inside(report.nodes.size(), false);
    std::vector<Candidate> found;
    for (std::size_t n = 0; n < report.nodes.size(); ++n) {
        const NodeReport& node = report.nodes[n];
        inside[n] = node.parent >= 0 && inside[static_cast<std::size_t>(node.parent)];
        if (inside[n] || uses[node.name] != 1 || !may_be_building(node, whole)) {
            continue;
        }
        if (const auto box = box_if_walled(model, children, n)) {
            inside[n] = true;
            found.push_back({n, *box});
        }
    }
    return found;
}

/// Drops the accents of Latin letters and all other non-ASCII characters.
std::string to_ascii(const std::string& name) {
    constexpr std::string_view kPlain =
        "AAAAAAACEEEEIIIIDNOOOOO OUUUUYTsaaaaaaaceeeeiiiidnooooo ouuuuyty";  // U+00C0 to U+00FF
    std::string ascii;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto byte = static_cast<unsigned char>(name[i]);
        if (byte < 0x80U) {
            ascii += name[i];
        } else if (byte == 0xC3U && i + 1 < name.size()) {
            ascii += kPlain[static_cast<unsigned char>(name[++i]) & 0x3FU];
        }
    }
    return ascii;
}

/// Names without ASCII letters and identifiers, which mean nothing to a reader, become numbers.
std::vector<std::string> ids_of(const std::vector<std::string>& names) {
    std::vector<std::string> words;
    std::size_t unnamed = 0;
    for (const std::string& name : names) {
        const std::string ascii = to_ascii(name);
        const bool no_word = std::ranges::none_of(
            ascii, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
        const bool numbered = no_word || is_identifier(ascii);
        words.push_back(numbered ? "building-" + std::to_string(++unnamed) : ascii);
    }
    return distinct_words(words);
}

}  // namespace

std::vector<SuggestedBuilding> suggest_buildings(const Model& model, const ModelReport& report) {
    std::vector<Candidate> found = topmost_buildings(model, report);
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.footprint() > b.footprint(); });
    found.resize(std::min(found.size(), kMaxBuildings));
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.node < b.node; });
    std::vector<std::string> names;
    names.reserve(found.size());
    for (const Candidate& candidate : found) {
        names.push_back(report.nodes[candidate.node].name);
    }
    const std::vector<std::string> ids = ids_of(names);
    std::vector<SuggestedBuilding> buildings;
    for (std::size_t k = 0; k < found.size(); ++k) {
        buildings.push_back({ids[k], names[k], glob_for(names[k]), found[k].box});
    }
    return buildings;
}

}  // namespace campuswalk::scene
