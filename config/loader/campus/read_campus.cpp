#include "config/loader/campus/read_campus.h"

#include "config/loader/campus/read_collider.h"
#include "config/loader/campus/read_places.h"
#include "config/loader/campus/read_popup.h"
#include "config/loader/campus/read_scenes.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/yaml/wording.h"

namespace campuswalk::config {

using scene::Building;
using scene::CampusDescription;
using scene::CampusOrigin;
using scene::ColliderDescription;
using scene::GeographicPlace;
using scene::Spawn;

namespace fs = std::filesystem;

namespace {

constexpr Range kLatitude{-scene::kMaxLatitude, scene::kMaxLatitude, false, "degrees"};
constexpr Range kLongitude{-scene::kMaxLongitude, scene::kMaxLongitude, false, "degrees"};

void read_origin_at(const CheckedNode& node, CampusOrigin& origin) {
    if (!node.is_scalar()) {
        origin.origin.at = node.vector(kCoordinate).value_or(origin.origin.at);
        return;
    }
    origin.near = node.line() == "near";
    if (!origin.near) {
        node.diagnose("bad-value", "'at' must be near, or three numbers, as in [84000, 0, -447000]");
    }
}

/// `{at: near, latitude_deg: 52.0, longitude_deg: 4.37}`
CampusOrigin read_origin(const CheckedNode& node) {
    CampusOrigin origin;
    CheckedMap map(node, "'origin'");
    if (const auto at = map.find("at")) {
        read_origin_at(*at, origin);
    }
    GeographicPlace place;
    map.number("latitude_deg", kLatitude, place.latitude_deg);
    map.number("longitude_deg", kLongitude, place.longitude_deg);
    map.number("height", kCoordinate, place.height);
    if (map.has("latitude_deg") || map.has("longitude_deg") || map.has("height")) {
        map.require("latitude_deg");
        map.require("longitude_deg");
        origin.origin.geographic = place;
    }
    map.refuse_other_keys();
    return origin;
}

Building read_building(const CheckedNode& node, UniqueNames& ids) {
    Building building;
    building.mark = node.mark();
    CheckedMap map(node, "a building");
    if (const auto id = map.require("id")) {
        building.id = id_word(*id).value_or("");
        ids.add(building.id, *id);
    }
    if (const auto nodes = map.find("nodes")) {
        building.nodes = node_globs(*nodes);
    }
    const auto title = map.require("title");
    if (title) {
        building.title = title->line().value_or("");
    }
    map.text("kind", building.kind);
    const auto text = map.find("text");
    if (text) {
        building.text = text->text().value_or("");
    }
    map.text("hours", building.hours);
    map.as_int("floors", 0, 1000, building.floors);
    if (const auto info = map.find("info")) {
        building.info = read_info(*info);
    }
    if (title) {
        check_popup_title(*title, building);  // after the fields that it may name
    }
    if (text) {
        check_popup_text(*text, building);
    }
    read_popup_rule(map, building.popup, building.popup_rule);
    map.refuse_other_keys();
    return building;
}

Spawn read_spawn(const CheckedNode::Entry& entry) {
    Spawn spawn{entry.key_mark, id_key(entry)};
    CheckedMap map(entry.value, "a spawn");
    map.require("at");
    map.vector("at", kCoordinate, spawn.position);
    map.angle("yaw_deg", kYaw, spawn.yaw);
    map.as_bool("fall", spawn.fall);
    map.refuse_other_keys();
    return spawn;
}

std::vector<std::string> read_layers(const CheckedNode& section) {
    std::vector<std::string> layers;
    UniqueNames names("layer");
    for (const CheckedNode& node : section.items("a layer")) {
        layers.push_back(id_word(node).value_or(""));
        names.add(layers.back(), node);
    }
    return layers;
}

std::vector<Building> read_buildings(const CheckedNode& section) {
    std::vector<Building> buildings;
    UniqueNames ids("building");
    for (const CheckedNode& node : section.items("a building")) {
        buildings.push_back(read_building(node, ids));
    }
    return buildings;
}

std::vector<ColliderDescription> read_colliders(const CheckedNode& section, const CampusDescription& campus) {
    std::vector<ColliderDescription> colliders;
    UniqueNames ids("collider");
    for (const CheckedNode& node : section.items("a collider")) {
        colliders.push_back(read_collider(node, campus, ids));
    }
    return colliders;
}

/// Keyed by name: the YAML map rules out duplicates, but not one name in two spellings.
std::vector<Spawn> read_spawns(const CheckedNode& section) {
    std::vector<Spawn> spawns;
    UniqueNames names("spawn");
    for (const CheckedNode::Entry& entry : section.entries()) {
        spawns.push_back(read_spawn(entry));
        names.add(spawns.back().name, entry.value);
    }
    return spawns;
}

}  // namespace

std::optional<CampusDescription> open_campus(const fs::path& path, const ReadRoots& roots,
                                             const scene::SourceMark& named_at,
                                             scene::DiagnosticList& diagnostics) {
    const auto file = YamlFile::open(path, ".campus.yaml", roots, named_at, diagnostics);
    if (!file) {
        return std::nullopt;
    }
    const fs::path folder = path.parent_path();
    CampusDescription campus;
    campus.name = file->name();
    campus.mark = file->mark();
    CheckedMap map(file->root(), "a campus");
    if (const auto section = map.require("scenes")) {
        campus.scenes = read_scenes(*section, folder, roots);
    }
    if (const auto section = map.find("origin")) {
        campus.origin = read_origin(*section);
    }
    if (const auto section = map.find("layers")) {
        campus.layers = read_layers(*section);
    }
    if (const auto section = map.find("buildings")) {
        campus.buildings = read_buildings(*section);
    }
    if (const auto section = map.require("colliders")) {
        campus.colliders = read_colliders(*section, campus);  // after the layers and buildings they name
    }
    if (const auto section = map.find("spawns")) {
        campus.spawns = read_spawns(*section);
    }
    if (const auto section = map.find("places")) {
        read_places(*section, folder, roots, campus);  // after the origin, which their files may need
    }
    map.refuse_other_keys();
    return campus;
}

}  // namespace campuswalk::config
