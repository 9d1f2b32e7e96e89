#include "scene/lint/named_sizes.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "scene/lint/unit_guess.h"
#include "scene/lint/wording.h"
#include "scene/model/name_words.h"
#include "scene/model/named_parts.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kMinDoor = 0.3;       // metres: a cupboard's
constexpr double kMaxDoor = 6.0;       // metres: a cathedral's
constexpr double kMinUsualDoor = 1.8;  // metres
constexpr double kMaxUsualDoor = 3.2;  // metres
constexpr double kMaxRiser = 0.32;     // metres: avatars step up 0.3 m

ModelLint::Place place_of(const NodeReport& node) {
    Vector3d foot = node.bounds.center();
    foot.y() = node.bounds.min.y();
    return {node.name, foot};
}

/// Indices of the parts with triangles.
std::vector<std::size_t> find_parts(const Model& model, const std::vector<NodeReport>& nodes,
                                    bool (*name_matches)(std::string_view)) {
    const std::vector<std::size_t> part = named_parts(model, name_matches);
    std::vector<std::size_t> found;
    for (std::size_t n = 0; n < part.size(); ++n) {
        if (part[n] == n && !nodes[n].bounds.empty()) {
            found.push_back(n);
        }
    }
    return found;
}

bool lies_flat(const Vector3d& size) {
    const double length = std::max(size.x(), size.z());
    const double width = std::min(size.x(), size.z());
    return size.y() <= 0.3 && length >= 1.8 && length <= 2.6 && width >= 0.6;
}

bool is_implausible_door(double height) {
    return height < kMinDoor || height > kMaxDoor;
}

std::string unit_hint(double height) {
    const auto unit = guess_unit(height, kMinUsualDoor, kMaxUsualDoor);
    return unit ? "with `" + std::string(unit->yaml) + "` it would be " + in_metres(height * unit->factor)
                : "scale the model if everything in it is off";
}

void check_doors(const Model& model, const std::vector<NodeReport>& nodes, std::vector<ModelLint>& out) {
    ModelLint lint{"door-size", "", {}};
    ModelLint flat{"door-size", "", {}};
    double height = 0.0;
    for (const std::size_t n : find_parts(model, nodes, is_door_name)) {
        const Vector3d size = nodes[n].bounds.max - nodes[n].bounds.min;
        if (lies_flat(size)) {
            flat.places.push_back(place_of(nodes[n]));
        } else if (is_implausible_door(size.y())) {
            height = lint.places.empty() ? size.y() : height;
            lint.places.push_back(place_of(nodes[n]));
        }
    }
    if (!lint.places.empty()) {
        lint.message = plural(lint.places.size(), "door") +
                       " with an unlikely height for a door, for example '" + lint.places.front().node +
                       "' of " + in_metres(height) + "; " + unit_hint(height);
        out.push_back(lint);
    }
    if (!flat.places.empty()) {
        flat.message = plural(flat.places.size(), "door") + " lying on the ground, for example '" +
                       flat.places.front().node + "'; if the whole model does, set `up: z`";
        out.push_back(flat);
    }
}

/// By part: the heights of its horizontal faces.
std::map<std::size_t, std::vector<double>> heights_of_stairs(const Model& model) {
    constexpr double kTreadCosine = 0.99;
    const std::vector<std::size_t> part = named_parts(model, is_stairs_name);
    std::map<std::size_t, std::vector<double>> heights;
    for (std::size_t n = 0; n < part.size(); ++n) {
        if (part[n] == kNoPart) {
            continue;
        }
        std::vector<double>& own = heights[part[n]];
        for_each_triangle(model, model.nodes[n],
                          [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
                              const Vector3d normal = (b - a).cross(c - a);
                              if (normal.y() > kTreadCosine * normal.norm()) {
                                  own.push_back(a.y());
                              }
                          });
    }
    return heights;
}

void check_stairs(const Model& model, const std::vector<NodeReport>& nodes, std::vector<ModelLint>& out) {
    ModelLint lint{"stair-riser", "", {}};
    double riser = 0.0;
    for (auto& [part, heights] : heights_of_stairs(model)) {
        const double own = riser_of(std::move(heights));
        if (own > kMaxRiser) {
            riser = lint.places.empty() ? own : riser;
            lint.places.push_back(place_of(nodes[part]));
        }
    }
    if (lint.places.empty()) {
        return;
    }
    lint.message = plural(lint.places.size(), "flight") +
                   " of stairs with risers too high to climb, for example '" + lint.places.front().node +
                   "' with risers of " + in_metres(riser) + "; the default avatar steps up 0.3 m";
    out.push_back(lint);
}

}  // namespace

double riser_of(std::vector<double> heights) {
    std::sort(heights.begin(), heights.end());
    std::vector<double> risers;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        constexpr double kSameTread = 0.01;  // metres; triangles of one tread
        if (heights[i] - heights[i - 1] > kSameTread) {
            risers.push_back(heights[i] - heights[i - 1]);
        }
    }
    if (risers.size() < 2) {
        return 0.0;
    }
    std::sort(risers.begin(), risers.end());
    return risers[risers.size() / 2];
}

std::vector<ModelLint> lint_named_sizes(const Model& model, const std::vector<NodeReport>& nodes) {
    std::vector<ModelLint> lints;
    check_doors(model, nodes, lints);
    check_stairs(model, nodes, lints);
    return lints;
}

}  // namespace campuswalk::scene
