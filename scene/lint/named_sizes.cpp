#include "scene/lint/named_sizes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "scene/lint/named_parts.h"
#include "scene/lint/unit_guess.h"
#include "scene/lint/wording.h"
#include "scene/model/name_words.h"
#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

constexpr double kLowestDoor = 0.3;     // metres: that of a cupboard
constexpr double kHighestDoor = 6.0;    // metres: that of a cathedral
constexpr double kUsualLow = 1.8;       // metres
constexpr double kUsualHigh = 3.2;      // metres
constexpr double kHighestRiser = 0.32;  // metres: avatars step 0.3 m

ModelLint::Place foot_of(const NodeReport& node) {
    Vector3d foot = 0.5 * (node.bounds.min + node.bounds.max);
    foot.y() = node.bounds.min.y();
    return {node.name, foot};
}

/// Indices of the parts that have triangles.
std::vector<std::size_t> parts_called(const Model& model, const std::vector<NodeReport>& nodes,
                                      bool (*is_called)(std::string_view)) {
    const std::vector<std::size_t> part = named_parts(model, is_called);
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

bool is_odd_height(double height) {
    return height < kLowestDoor || height > kHighestDoor;
}

std::string unit_hint(double height) {
    const auto unit = guess_unit(height, kUsualLow, kUsualHigh);
    return unit ? "with `" + std::string(unit->yaml) + "` it would be " + in_metres(height * unit->factor)
                : "scale the model if everything in it is off";
}

void check_doors(const Model& model, const std::vector<NodeReport>& nodes, int up,
                 std::vector<ModelLint>& out) {
    ModelLint odd{"door-size", "", {}};
    ModelLint flat{"door-size", "", {}};
    double height = 0.0;
    for (const std::size_t n : parts_called(model, nodes, is_door_name)) {
        const Vector3d size = nodes[n].bounds.max - nodes[n].bounds.min;
        if (up == 1 && lies_flat(size)) {
            flat.places.push_back(foot_of(nodes[n]));
        } else if (is_odd_height(size[up])) {
            height = odd.places.empty() ? size[up] : height;
            odd.places.push_back(foot_of(nodes[n]));
        }
    }
    if (!odd.places.empty()) {
        odd.message = plural(odd.places.size(), "door") +
                      " with an unlikely height for a door, for example '" + odd.places.front().node +
                      "' of " + in_metres(height) + "; " + unit_hint(height);
        out.push_back(odd);
    }
    if (!flat.places.empty()) {
        flat.message = plural(flat.places.size(), "door") + " lying on the ground, for example '" +
                       flat.places.front().node + "'; if the whole model does, set `up: z`";
        out.push_back(flat);
    }
}

/// By part, the heights of its level faces.
std::map<std::size_t, std::vector<double>> heights_of_stairs(const Model& model) {
    constexpr double kLevel = 0.99;  // cosine
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
                              if (normal.y() > kLevel * normal.norm()) {
                                  own.push_back(a.y());
                              }
                          });
    }
    return heights;
}

void check_stairs(const Model& model, const std::vector<NodeReport>& nodes, std::vector<ModelLint>& out) {
    ModelLint odd{"stair-riser", "", {}};
    double riser = 0.0;
    for (auto& [part, heights] : heights_of_stairs(model)) {
        const double own = riser_of(std::move(heights));
        if (own > kHighestRiser) {
            riser = odd.places.empty() ? own : riser;
            odd.places.push_back(foot_of(nodes[part]));
        }
    }
    if (!odd.places.empty()) {
        odd.message = plural(odd.places.size(), "flight") +
                      " of stairs with risers too high to climb, for example '" + odd.places.front().node +
                      "' with risers of " + in_metres(riser) + "; the default avatar steps up 0.3 m";
        out.push_back(odd);
    }
}

}  // namespace

double riser_of(std::vector<double> heights) {
    std::sort(heights.begin(), heights.end());
    std::vector<double> risers;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        constexpr double kSame = 0.01;  // metres, between the triangles of one tread
        if (heights[i] - heights[i - 1] > kSame) {
            risers.push_back(heights[i] - heights[i - 1]);
        }
    }
    if (risers.size() < 2) {
        return 0.0;
    }
    std::sort(risers.begin(), risers.end());
    return risers[risers.size() / 2];
}

std::vector<ModelLint> lint_named_sizes(const Model& model, const std::vector<NodeReport>& nodes, int up) {
    std::vector<ModelLint> lints;
    check_doors(model, nodes, up, lints);
    if (up == 1) {
        check_stairs(model, nodes, lints);
    }
    return lints;
}

std::optional<double> scale_from_doors(const Model& model, const std::vector<NodeReport>& nodes) {
    std::vector<double> heights;
    for (const std::size_t n : parts_called(model, nodes, is_door_name)) {
        heights.push_back(nodes[n].bounds.max.y() - nodes[n].bounds.min.y());
    }
    if (heights.empty()) {
        return std::nullopt;
    }
    std::sort(heights.begin(), heights.end());
    const double middle = heights[heights.size() / 2];
    const auto unit = is_odd_height(middle) ? guess_unit(middle, kUsualLow, kUsualHigh) : std::nullopt;
    return unit ? std::optional(unit->factor) : std::nullopt;
}

}  // namespace campuswalk::scene
