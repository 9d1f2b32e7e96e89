#include "config/loader/campus/read_scenes.h"

#include <array>

#include <Eigen/Geometry>

#include "config/loader/values/checked_map.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/wording.h"
#include "scene/model/node_frame.h"

namespace campuswalk::config {

using scene::SceneFile;
using scene::ScenePlacement;
using scene::SourceMark;
using scene::UpAxis;

namespace fs = std::filesystem;

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

}  // namespace

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

}  // namespace campuswalk::config
