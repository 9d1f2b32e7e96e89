#include "config/loader/campus/read_campus.h"

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "config/loader/campus/read_collider.h"
#include "config/loader/campus/read_places.h"
#include "config/loader/campus/read_popup.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/yaml/wording.h"
#include "scene/model/node_frame.h"
#include "scene/model/scene_file.h"

namespace campuswalk::config {

using scene::Building;
using scene::CampusDescription;
using scene::CampusOrigin;
using scene::ColliderDescription;
using scene::GeographicPlace;
using scene::Spawn;
namespace fs = std::filesystem;
using scene::SceneFile;
using scene::ScenePlacement;
using scene::SourceMark;
using scene::UpAxis;

namespace {

constexpr Range kFactor{0.0, 1e6, true, ""};
constexpr std::array kUpAxes = {Choice<UpAxis>{"y", UpAxis::y}, Choice<UpAxis>{"z", UpAxis::z}};
constexpr std::array kUnits = {Choice<double>{"m", 1.0}, Choice<double>{"cm", 0.01},
                               Choice<double>{"mm", 0.001}, Choice<double>{"in", 0.0254},
                               Choice<double>{"ft", 0.3048}};

/// The scene's file, and which others it may refer to.
void read_scene_file(const CheckedNode& file, const fs::path& folder, const ReadRoots& roots,
                     SceneFile& scene) {
    scene.mark = file.mark();
    scene.file = file.line().value_or("");
    scene.path = folder / scene.file;
    if (scene.file.empty()) {
        return;  // which has been reported
    }
    // What it refers to is looked up from where it is named, even if that is a link to another place.
    std::error_code ignored;
    const fs::path model_folder =
        fs::weakly_canonical(fs::absolute(scene.path, ignored).parent_path(), ignored);
    for (const fs::path& path : {scene.path, model_folder / "any"}) {
        if (const std::string why = roots.why_unreadable(path); !why.empty()) {
            file.diagnose("outside-project", in_quotes(scene.file) + " " + why);
            break;
        }
    }
    scene.roots.assign(roots.others().begin(), roots.others().end());
    scene.images_beside = roots.why_unreadable(model_folder.parent_path() / "textures").empty();
}

void read_quaternion(const CheckedNode& node, Eigen::Matrix3d& rotation) {
    const auto value = node.vector4({-1e6, 1e6, false, ""});
    if (!value) {
        return;
    }
    constexpr double kLeastLength = 1e-6;
    if (value->norm() < kLeastLength) {
        node.diagnose("bad-value", "'quaternion' has no direction; [0, 0, 0, 1] turns nothing");
        return;
    }
    const Eigen::Vector4d unit = *value / value->norm();
    rotation = Eigen::Quaterniond(unit.w(), unit.x(), unit.y(), unit.z()).toRotationMatrix();
}

void read_rotation(CheckedMap& map, Eigen::Matrix3d& rotation) {
    std::optional<Eigen::Vector3d> degrees;
    map.vector("rotation_deg", kYaw, degrees);
    if (degrees) {
        rotation = scene::rotation_xyz({radians(degrees->x()), radians(degrees->y()), radians(degrees->z())});
    }
    if (const auto quaternion = map.find("quaternion")) {
        if (map.has("rotation_deg")) {
            quaternion->diagnose("bad-value",
                                 "'quaternion' says what 'rotation_deg' says: write one of them");
            return;
        }
        read_quaternion(*quaternion, rotation);
    }
}

/// Position, rotation and name: of a scene that is placed once, or of one of its placements.
ScenePlacement read_placement_keys(const SourceMark& mark, CheckedMap& map) {
    ScenePlacement placement;
    placement.mark = mark;
    if (const auto name = map.find("name")) {
        placement.name = name->line().value_or("");
    }
    map.vector("position", kCoordinate, placement.position);
    read_rotation(map, placement.rotation);
    return placement;
}

std::vector<ScenePlacement> read_placements(const CheckedNode& section) {
    std::vector<ScenePlacement> placements;
    for (const CheckedNode& node : section.items("a placement")) {
        CheckedMap map(node, "a placement");
        placements.push_back(read_placement_keys(node.mark(), map));
        map.number("scale", kFactor, placements.back().scale);
        map.refuse_other_keys();
    }
    if (placements.empty() && (section.is_sequence() || section.is_null())) {
        section.diagnose("bad-value", "'placements' needs at least one entry, such as {position: [0, 0, 0]}");
    }
    return placements;
}

void read_scene_placements(const SourceMark& mark, CheckedMap& map, SceneFile& scene) {
    const auto placements = map.find("placements");
    const ScenePlacement only = read_placement_keys(mark, map);
    if (!placements) {
        if (map.has("name") || map.has("rotation_deg") || map.has("quaternion")) {
            scene.placements.push_back(only);
        } else {
            scene.position = only.position;
        }
        return;
    }
    for (const char* key : {"name", "position", "rotation_deg", "quaternion"}) {
        if (map.has(key)) {
            map.diagnose_at(
                key, "bad-value",
                "'" + std::string(key) + "' stands beside 'placements': write it in each of these instead");
        }
    }
    scene.placements = read_placements(*placements);
}

SceneFile read_scene(const CheckedNode& node, const fs::path& folder, const ReadRoots& roots) {
    SceneFile scene;
    CheckedMap map(node, "a scene");
    if (const auto file = map.require("file")) {
        read_scene_file(*file, folder, roots, scene);
    }
    map.choice("up", kUpAxes, scene.up);
    map.choice("unit", kUnits, scene.metres_per_unit);
    map.number("scale", kFactor, scene.scale);
    read_scene_placements(node.mark(), map, scene);
    map.refuse_other_keys();
    return scene;
}

/// The list `scenes` of a campus: model files, and where each is put. `folder`: the campus file's; `roots`:
/// where models may be.
std::vector<SceneFile> read_scenes(const CheckedNode& section, const fs::path& folder,
                                   const ReadRoots& roots) {
    std::vector<SceneFile> scenes;
    for (const CheckedNode& node : section.items("a scene")) {
        scenes.push_back(read_scene(node, folder, roots));
    }
    if (scenes.empty() && (section.is_sequence() || section.is_null())) {
        section.diagnose("bad-value", "'scenes' needs at least one model file");
    }
    return scenes;
}

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
