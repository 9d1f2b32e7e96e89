#include "config/loader/walk/campus_names.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/texts_of.h"

namespace campuswalk::config {

using engine::Target;
using scene::Place;
using scene::Spawn;

namespace {

/// Coordinates as a name without spaces, so that a log line's columns stay separable.
std::string label_of(std::span<const double> coordinates) {
    std::string label;
    for (const double value : coordinates) {
        label += (label.empty() ? "" : ",") + shown_number(value);
    }
    return label;
}

void diagnose_unknown(const CheckedNode& node, const std::string& name, const char* thing,
                      const std::vector<std::string>& known) {
    node.diagnose("unknown-name", "the campus has no " + std::string(thing) + " " + in_quotes(name) +
                                      suggestion_or_list(name, known));
}

}  // namespace

Target CampusNames::target(const CheckedNode& node) const {
    if (node.is_sequence()) {
        return target_at(node);
    }
    if (!node.is_scalar()) {
        node.diagnose("wrong-type", node.what() + " must be a place's name, [x, z] or [x, y, z]");
        return {};
    }
    const std::optional<std::string> name = name_in(node);
    return name ? target_named(node, *name) : Target{};
}

engine::CameraTarget CampusNames::camera_target(const CheckedNode& node) const {
    const std::optional<std::string> name = node.is_scalar() ? name_in(node) : std::nullopt;
    if (name && campus_ != nullptr) {
        const auto building = std::ranges::find(campus_->buildings, *name, &scene::Building::id);
        if (building != campus_->buildings.end()) {
            return {*name, static_cast<std::size_t>(building - campus_->buildings.begin()),
                    Eigen::Vector3d::Zero(), node.mark()};
        }
        const std::vector<std::string> places = target_names();
        if (std::ranges::find(places, *name) == places.end()) {
            diagnose_unknown(node, *name, "building, place or spawn", sight_names());
            return {};
        }
    }
    if (!node.is_scalar() && !node.is_sequence()) {
        node.diagnose("wrong-type", node.what() + " must be a name or [x, y, z]");
        return {};
    }
    if (node.is_scalar() && !name) {
        return {};
    }
    const Target target = this->target(node);
    if (!target.label.empty() && !target.has_height) {
        node.diagnose("bad-value", node.is_sequence()
                                       ? node.what() + " needs a height too: [x, y, z]"
                                       : node.what() + " needs a place with a height, which the file that " +
                                             in_quotes(target.label) + " is from doesn't give");
    }
    return {target.label, std::nullopt, target.point, node.mark()};
}

std::vector<std::string> CampusNames::target_names() const {
    std::vector<std::string> names = scene::texts_of(campus_->places, &scene::Place::name);
    std::ranges::copy(scene::texts_of(campus_->spawns, &scene::Spawn::name), std::back_inserter(names));
    return names;
}

Target CampusNames::target_at(const CheckedNode& node) const {
    const std::vector<CheckedNode> items = node.items("a coordinate");
    if (items.size() != 2 && items.size() != 3) {
        node.diagnose("wrong-type", node.what() + " must be a place's name, [x, z] or [x, y, z]");
        return {};
    }
    std::vector<double> coordinates;
    coordinates.reserve(items.size());
    for (const CheckedNode& item : items) {
        coordinates.push_back(item.number(kCoordinate).value_or(0.0));
    }
    Target target;
    target.label = label_of(coordinates);
    target.has_height = coordinates.size() == 3;
    target.point = {coordinates.front(), target.has_height ? coordinates[1] : 0.0, coordinates.back()};
    return target;
}

Sight CampusNames::sight(const CheckedNode& node) const {
    const std::optional<std::string> name = node.is_scalar() ? name_in(node) : std::nullopt;
    if (name && campus_ != nullptr) {
        const std::vector<std::string> places = target_names();
        const auto building = std::ranges::find(campus_->buildings, *name, &scene::Building::id);
        if (std::ranges::find(places, *name) != places.end()) {
            return {target_named(node, *name), std::nullopt};
        }
        if (building != campus_->buildings.end()) {
            return {{*name, Eigen::Vector3d::Zero(), true},
                    static_cast<std::size_t>(building - campus_->buildings.begin())};
        }
        diagnose_unknown(node, *name, "place, spawn or building", sight_names());
        return {};
    }
    return {target(node), std::nullopt};
}

std::vector<std::string> CampusNames::sight_names() const {
    std::vector<std::string> names;
    std::ranges::transform(campus_->buildings, std::back_inserter(names), &scene::Building::id);
    std::ranges::copy(target_names(), std::back_inserter(names));
    return names;
}

Target CampusNames::target_named(const CheckedNode& node, const std::string& name) const {
    Target target{name, Eigen::Vector3d::Zero(), true};
    if (campus_ == nullptr) {
        return target;
    }
    const auto place = std::ranges::find(campus_->places, name, &Place::name);
    const auto spawn = std::ranges::find(campus_->spawns, name, &Spawn::name);
    if (place != campus_->places.end()) {
        target.point = place->position;
        target.has_height = place->has_height;
    } else if (spawn != campus_->spawns.end()) {
        target.point = spawn->position;
    } else {
        diagnose_unknown(node, name, "place or spawn", target_names());
    }
    return target;
}

Placement CampusNames::spawn(const CheckedNode& node) const {
    return placement(node, false);
}

Placement CampusNames::teleport(const CheckedNode& node) const {
    return placement(node, true);
}

Placement CampusNames::placement(const CheckedNode& node, bool teleports) const {
    if (!node.is_map() && !node.is_scalar()) {
        node.diagnose("wrong-type", node.what() + " must be a name or {at: [x, y, z], yaw_deg: 0}");
        return {};
    }
    if (!node.is_map()) {
        return placement_named(node, teleports);
    }
    CheckedMap map(node, node.what());
    const auto at = map.require("at");
    Placement placed;
    if (at && at->is_scalar() && !at->is_null()) {
        placed = placement_named(*at, teleports);
        map.angle("yaw_deg", kYaw, placed.yaw);
    } else {
        placed = placement_in(map);
    }
    if (!teleports) {
        map.as_bool("fall", placed.fall);
    }
    map.refuse_other_keys();
    return placed;
}

Placement CampusNames::placement_in(CheckedMap& map) const {
    Placement placement;
    map.vector("at", kCoordinate, placement.position);
    map.angle("yaw_deg", kYaw, placement.yaw);
    placement.label = label_of({placement.position.data(), 3});
    return placement;
}

Placement CampusNames::placement_named(const CheckedNode& node, bool also_places) const {
    Placement placement;
    placement.label = name_in(node).value_or("");
    if (placement.label.empty() || campus_ == nullptr) {
        return placement;
    }
    const auto spawn = std::ranges::find(campus_->spawns, placement.label, &Spawn::name);
    const auto place = std::ranges::find(campus_->places, placement.label, &Place::name);
    if (spawn == campus_->spawns.end() && also_places && place != campus_->places.end()) {
        placement.position = place->position;
        placement.place = static_cast<std::size_t>(place - campus_->places.begin());
        return placement;
    }
    if (spawn == campus_->spawns.end()) {
        diagnose_unknown(
            node, placement.label, also_places ? "place or spawn" : "spawn",
            also_places ? target_names() : scene::texts_of(campus_->spawns, &scene::Spawn::name));
        return placement;
    }
    placement.position = spawn->position;
    placement.yaw = spawn->yaw;
    placement.fall = spawn->fall;
    return placement;
}

void CampusNames::check_layer(const CheckedNode& node, const std::string& layer) const {
    if (campus_ != nullptr && std::ranges::find(campus_->layers, layer) == campus_->layers.end()) {
        diagnose_unknown(node, layer, "layer", campus_->layers);
    }
}

}  // namespace campuswalk::config
