#include "config/loader/campus/read_collider.h"

#include <algorithm>
#include <array>

#include "config/loader/campus/read_popup.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/texts_of.h"

namespace campuswalk::config {

using scene::BoxShape;
using scene::CampusDescription;
using scene::CapsuleShape;
using scene::ColliderDescription;
using scene::DetectionModes;
using scene::ShapeDescription;
using scene::SphereShape;
using scene::WheelShape;

namespace {

ShapeDescription read_mesh(CheckedMap& /*map*/) {
    return scene::MeshShape{};
}

ShapeDescription read_box(CheckedMap& map) {
    BoxShape box;
    map.vector("center", kCoordinate, box.center);
    map.vector("size", kPositiveLength, box.size);
    map.angle("yaw_deg", kYaw, box.yaw);
    return box;
}

ShapeDescription read_sphere(CheckedMap& map) {
    SphereShape sphere;
    map.vector("center", kCoordinate, sphere.center);
    map.number("radius", kPositiveLength, sphere.radius);
    return sphere;
}

ShapeDescription read_capsule(CheckedMap& map) {
    CapsuleShape capsule;
    map.vector("base", kCoordinate, capsule.base);
    map.number("radius", kPositiveLength, capsule.radius);
    map.number("height", kPositiveLength, capsule.height);
    if (capsule.radius && capsule.height && *capsule.height < 2.0 * *capsule.radius) {
        map.diagnose_at("height", "bad-value",
                        "'height' is the capsule's total height and must be at least twice its radius of " +
                            shown_number(*capsule.radius) + " m");
    }
    return capsule;
}

Eigen::Vector3d read_axis(const CheckedNode& node) {
    const std::array axes = {Choice<Eigen::Vector3d>{"x", Eigen::Vector3d::UnitX()},
                             Choice<Eigen::Vector3d>{"y", Eigen::Vector3d::UnitY()},
                             Choice<Eigen::Vector3d>{"z", Eigen::Vector3d::UnitZ()}};
    if (!node.is_sequence()) {
        return node.choice(axes).value_or(Eigen::Vector3d::UnitX());
    }
    const Eigen::Vector3d axis = node.vector(kCoordinate).value_or(Eigen::Vector3d::UnitX());
    if (axis.norm() < 1e-6) {
        node.diagnose("bad-value", "'axis' must be a direction, not [0, 0, 0]");
        return Eigen::Vector3d::UnitX();
    }
    return axis.normalized();
}

ShapeDescription read_wheel(CheckedMap& map) {
    WheelShape wheel;
    map.vector("center", kCoordinate, wheel.center);
    map.number("radius", kPositiveLength, wheel.radius);
    map.number("width", kPositiveLength, wheel.width);
    if (const auto axis = map.find("axis")) {
        wheel.axis = read_axis(*axis);
    }
    return wheel;
}

using ShapeReader = ShapeDescription (*)(CheckedMap&);
constexpr std::array kShapes = {Choice<ShapeReader>{"mesh", read_mesh}, Choice<ShapeReader>{"box", read_box},
                                Choice<ShapeReader>{"sphere", read_sphere},
                                Choice<ShapeReader>{"capsule", read_capsule},
                                Choice<ShapeReader>{"wheel", read_wheel}};

/// Accepts the keys of every shape, for a collider whose shape is missing or unknown.
void accept_keys_of_any_shape(CheckedMap& map) {
    for (const char* key : {"center", "base", "size", "yaw_deg", "radius", "height", "width", "axis"}) {
        map.find(key);
    }
}

using ModeFlag = bool DetectionModes::*;
constexpr std::array kModes = {Choice<ModeFlag>{"solid", &DetectionModes::solid},
                               Choice<ModeFlag>{"trigger", &DetectionModes::trigger},
                               Choice<ModeFlag>{"ray", &DetectionModes::ray}};

DetectionModes read_modes(const CheckedNode& node) {
    DetectionModes modes;
    const std::vector<CheckedNode> words = node.items_or_one("'mode'");
    for (const CheckedNode& word : words) {
        if (const auto flag = word.choice(kModes)) {
            modes.*(*flag) = true;
        }
    }
    if (words.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value", "'mode' must be solid, trigger or ray, or a list of them");
    }
    return modes;
}

/// A name that must be one of `known`, which the campus declares in `section`; empty if it isn't.
std::string known_name(const CheckedNode& node, const std::vector<std::string>& known, const char* section) {
    const std::optional<std::string> name = name_in(node);
    if (name && std::ranges::find(known, *name) == known.end()) {
        node.diagnose("unknown-name",
                      in_quotes(*name) + " is not in '" + section + "'" + suggestion_or_list(*name, known));
        return "";
    }
    return name.value_or("");
}

/// Sets the collider's building and takes over that building's `popup`, which the collider's own may replace.
void read_building_of(const CheckedNode& id, const CampusDescription& campus, ColliderDescription& collider) {
    collider.building = known_name(id, scene::texts_of(campus.buildings, &scene::Building::id), "buildings");
    collider.popup = true;
    const auto building = std::ranges::find(campus.buildings, collider.building, &scene::Building::id);
    if (building != campus.buildings.end()) {
        collider.popup = building->popup;
        collider.popup_rule = building->popup_rule;
    }
}

}  // namespace

std::vector<scene::NodeGlob> node_globs(const CheckedNode& node) {
    std::vector<scene::NodeGlob> globs;
    for (const CheckedNode& item : node.items_or_one("a node glob")) {
        if (std::optional<std::string> pattern = name_in(item)) {
            globs.push_back({item.mark(), std::move(*pattern)});
        }
    }
    return globs;
}

ColliderDescription read_collider(const CheckedNode& node, const CampusDescription& campus,
                                  UniqueNames& ids) {
    ColliderDescription collider;
    collider.mark = node.mark();
    CheckedMap map(node, "a collider");
    if (const auto id = map.require("id")) {
        collider.id = id_path(*id).value_or("");
        ids.add(collider.id, *id);
    }
    if (const auto building = map.find("building")) {
        read_building_of(*building, campus, collider);
    }
    read_popup_rule(map, collider.popup, collider.popup_rule);
    if (collider.popup && !map.has("building")) {
        map.diagnose_at("popup", "missing-key", "a collider with a pop-up needs the key 'building'");
    }
    if (const auto nodes = map.find("nodes")) {
        collider.nodes = node_globs(*nodes);
    }
    if (const auto except = map.find("except")) {
        collider.except = node_globs(*except);
    }
    map.as_bool("each", collider.each);
    if (const auto layer = map.find("layer")) {
        collider.layer = known_name(*layer, campus.layers, "layers");
    }
    if (const auto mode = map.require("mode")) {
        collider.modes = read_modes(*mode);
    }
    std::optional<ShapeReader> read_shape;
    if (const auto shape = map.require("shape")) {
        read_shape = shape->choice(kShapes);
    }
    if (read_shape) {
        collider.shape = (*read_shape)(map);
    } else {
        accept_keys_of_any_shape(map);
    }
    map.refuse_other_keys();
    return collider;
}

}  // namespace campuswalk::config
