#include "tools/campuswalk/import/draft_text.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "scene/base/printable.h"
#include "tools/campuswalk/base/yaml_text.h"

namespace campuswalk::tools {

using scene::osm::CampusDraft;
using scene::osm::DraftBuilding;
using scene::osm::DraftPlace;
using scene::osm::DraftSolid;
using scene::osm::DraftSpawn;
using scene::osm::DraftTrigger;

namespace {

/// In a comment and in code of Markdown.
std::string plain_name(const std::string& map_file) {
    std::string name = scene::printable(map_file);
    std::ranges::replace(name, '`', '_');
    return name;
}

/// Pop-ups replace {words}: braces of the map are doubled.
std::string literal(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += c;
        if (c == '{' || c == '}') {
            result += c;
        }
    }
    return yaml_string(result);
}

std::string decimal(double value, int digits) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value,
                                   std::chars_format::fixed, digits);
    std::string text(buffer.data(), end.ptr);
    if (text.find('.') != std::string::npos) {  // cities have thousands of these
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text.find_first_not_of("-0.") == std::string::npos ? text.substr(text.front() == '-' ? 1 : 0)
                                                              : text;
}

std::string list(const Eigen::Vector3d& v) {
    return "[" + decimal(v.x(), 2) + ", " + decimal(v.y(), 2) + ", " + decimal(v.z(), 2) + "]";
}

std::string with_layer(const std::string& layer) {
    return layer.empty() ? "" : ", layer: " + layer;
}

std::string building_yaml(const DraftBuilding& building) {
    std::string text = "  - id: " + building.id + "\n    title: " + literal(building.title) + "\n";
    text += building.kind.empty() ? "" : "    kind: " + yaml_string(building.kind) + "\n";
    text += building.hours.empty() ? "" : "    hours: " + yaml_string(building.hours) + "\n";
    text += building.floors ? "    floors: " + std::to_string(*building.floors) + "\n" : "";
    if (building.info.empty()) {
        return text;
    }
    std::string body;
    text += "    info:\n";
    for (const auto& [name, value] : building.info) {
        text.append("      ").append(name).append(": ").append(yaml_string(value)).append("\n");
        std::string label = name == "address" || name.starts_with("name-") ? "" : name + ": ";
        std::ranges::replace(label, '-', ' ');
        body.append(body.empty() ? "" : "\\n").append(label).append("{").append(name).append("}");
    }
    return text + "    text: \"" + body + "\"\n";
}

std::string solid_yaml(const DraftSolid& solid) {
    return "  - {id: " + solid.id + ", nodes: " + globs_yaml(solid.globs) + ", shape: mesh, mode: solid" +
           (solid.each ? ", each: true" : "") +
           (solid.building.empty() ? "" : ", building: " + solid.building + ", popup: false") +
           with_layer(solid.layer) + "}\n";
}

std::string trigger_yaml(const DraftTrigger& trigger) {
    return "  - {id: " + trigger.id + ", shape: box, center: " + list(trigger.center) +
           ", size: " + list(trigger.size) +
           (trigger.yaw_deg == 0.0 ? "" : ", yaw_deg: " + decimal(trigger.yaw_deg, 1)) + ", mode: trigger" +
           (trigger.building.empty() ? "" : ", building: " + trigger.building) + with_layer(trigger.layer) +
           "}\n";
}

}  // namespace

std::string building_of(const DraftPlace& place) {
    return place.trigger.substr(0, place.trigger.find('/'));
}

std::string building_title(const CampusDraft& draft, const DraftPlace& place) {
    const auto building = std::ranges::find(draft.buildings, building_of(place), &DraftBuilding::id);
    return building == draft.buildings.end() ? "" : building->title;
}

std::string draft_yaml(const CampusDraft& draft, const std::string& map_file) {
    std::string text = "# Made from " + plain_name(map_file) +
                       " by `campuswalk import osm`. © OpenStreetMap contributors, see ATTRIBUTION.md.\n"
                       "scenes:\n  - {file: campus.glb}\n"
                       "# [0, 0, 0] on the Earth; +X is east, -Z is north.\n"
                       "origin: {latitude_deg: " +
                       decimal(draft.latitude_deg, 9) +
                       ", longitude_deg: " + decimal(draft.longitude_deg, 9) + "}\n";
    std::string layers;
    for (const std::string& layer : draft.layers) {
        layers += (layers.empty() ? "" : ", ") + layer;
    }
    text += layers.empty() ? "" : "layers: [" + layers + "]\n";
    text += draft.buildings.empty() ? "" : "buildings:\n";
    for (const DraftBuilding& building : draft.buildings) {
        text += building_yaml(building);
    }
    text += "colliders:\n";
    for (const DraftSolid& solid : draft.solids) {
        text += solid_yaml(solid);
    }
    for (const DraftTrigger& trigger : draft.triggers) {
        text += trigger_yaml(trigger);
    }
    text += draft.spawns.empty() ? "" : "spawns:\n";
    for (const DraftSpawn& spawn : draft.spawns) {
        text += "  " + spawn.name + ": {at: " + list(spawn.at) +
                (spawn.yaw_deg == 0.0 ? "" : ", yaw_deg: " + decimal(spawn.yaw_deg, 1)) + "}\n";
    }
    text += draft.places.empty() ? "" : "places:\n";
    for (const DraftPlace& place : draft.places) {
        text += "  " + place.name + ": " + list(place.at) + yaml_comment(building_title(draft, place)) + "\n";
    }
    return text;
}

std::string attribution_text(const std::string& map_file) {
    return "# Attribution\n\n"
           "`campus.glb` and the campus file in this folder were made from `" +
           plain_name(map_file) +
           "`, which is a part of OpenStreetMap.\n\n"
           "© [OpenStreetMap contributors](https://www.openstreetmap.org/copyright). The data is available "
           "under the [Open Database License](https://opendatacommons.org/licenses/odbl/) (ODbL) 1.0.\n\n"
           "Whoever publishes pictures, reports or other works made from these files must show this notice; "
           "whoever passes on the files, or data made from them, must do so under the same licence.\n";
}

}  // namespace campuswalk::tools
