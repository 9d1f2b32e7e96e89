// The schemas describe keys for help, editors and config/README.md; their defaults are those that the loader
// leaves in the structs. tests/tools/schemas_test.py compares keys, words and limits with the loader.

#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "config/loader/campus/geojson_points.h"
#include "config/loader/load_profile.h"
#include "config/loader/walks_config.h"
#include "engine/script/image_tolerance.h"
#include "engine/script/walk.h"
#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using nlohmann::json;

const std::filesystem::path kSchemas = std::filesystem::path(CAMPUSWALK_SOURCE_FOLDER) / "config" / "schema";

double degrees(double radians) {
    return radians * 180.0 / 3.141592653589793;
}

/// Every "default" in a schema, by the file's name and the place in it.
void collect_defaults(const json& schema, const std::string& place, std::map<std::string, json>& found) {
    for (const auto& [key, value] : schema.items()) {
        if (key == "default" && !schema.is_array()) {
            found[place] = value;
        } else if (value.is_structured()) {
            std::string below = place;
            below.append("/").append(key);
            collect_defaults(value, below, found);
        }
    }
}

std::map<std::string, json> schema_defaults() {
    std::map<std::string, json> found;
    for (const char* file : {"campus", "walk", "steps", "avatar", "light", "walks-config"}) {
        std::ifstream in(kSchemas / (std::string(file) + ".schema.json"));
        collect_defaults(json::parse(in), file, found);
    }
    return found;
}

std::multimap<std::string, json> avatar_defaults() {
    const engine::AvatarProfile avatar;
    return {{"avatar/properties/height", avatar.height},
            {"avatar/properties/radius", avatar.radius},
            {"avatar/properties/eye_height", avatar.eye_height},
            {"avatar/properties/speed", avatar.speed},
            {"avatar/properties/step_height", avatar.step_height},
            {"avatar/properties/max_slope_deg", degrees(avatar.max_slope)},
            {"avatar/properties/skin_width", avatar.skin_width},
            {"avatar/properties/turn_speed_deg", degrees(avatar.turn_speed)},
            {"avatar/properties/look_distance", avatar.look_distance}};
}

std::multimap<std::string, json> campus_defaults() {
    const scene::SceneFile scene;
    const scene::ScenePlacement placement;
    const bool turned = placement.rotation != Eigen::Matrix3d::Identity();
    const scene::Building building;
    return {{"campus/definitions/place_file/anyOf/1/properties/name", PointFile().name_property},
            {"campus/definitions/scene/properties/up", scene.up == scene::UpAxis::y ? "y" : "z"},
            {"campus/definitions/scene/properties/unit", scene.metres_per_unit == 1.0 ? "m" : "another"},
            {"campus/definitions/scene/properties/scale", scene.scale},
            {"campus/definitions/placement/properties/scale", placement.scale},
            {"campus/definitions/placed_rotation", turned ? json() : json{0, 0, 0}},
            {"campus/definitions/placed_quaternion", turned ? json() : json{0, 0, 0, 1}},
            {"campus/definitions/origin/properties/height", scene::GeographicPlace().height},
            {"campus/definitions/yaw_deg", scene::Spawn().yaw},
            {"campus/definitions/spawn/properties/fall", scene::Spawn().fall},
            {"campus/definitions/yaw_deg", scene::BoxShape().yaw},
            {"campus/definitions/each", scene::ColliderDescription().each},
            {"campus/definitions/popup/anyOf/0", building.popup},
            {"campus/definitions/popup/anyOf/1/properties/once", building.popup_rule.once},
            {"campus/definitions/popup/anyOf/1/properties/cooldown", building.popup_rule.cooldown},
            {"campus/definitions/popup/anyOf/1/properties/dwell", building.popup_rule.dwell}};
}

std::multimap<std::string, json> walk_defaults() {
    const engine::Walk walk;
    const engine::CameraSettings& camera = walk.camera;
    const bool runs = walk.status.kind == engine::WalkStatus::Kind::run;
    const bool descends_bvh8 = walk.sim.tree == collision::TreeKind::bvh8;
    const bool is_first_person = std::holds_alternative<engine::FirstPersonView>(camera.view);
    return {{"walk/definitions/status_word", runs ? "run" : "another"},
            {"walk/definitions/sim/properties/ticks_per_second", walk.sim.ticks_per_second},
            {"walk/definitions/sim/properties/stay_every", walk.sim.stay_every},
            {"walk/definitions/sim/properties/gaze_hold", walk.sim.gaze_hold},
            {"walk/definitions/sim/properties/tree", descends_bvh8 ? "bvh8" : "another"},
            {"walk/definitions/view", is_first_person ? "first_person" : "another"},
            {"walk/definitions/width", camera.width},
            {"walk/definitions/height", camera.height},
            {"walk/definitions/fov_deg", degrees(camera.fov)},
            {"walk/definitions/height_above", engine::TopView().height_above}};
}

std::multimap<std::string, json> step_defaults() {
    const engine::WalkToStep walk_to;
    const bool fails = walk_to.if_blocked == engine::IfBlocked::fail;
    const std::string step = "walk/definitions/step/properties/";
    return {{step + "spawn/anyOf/1/properties/fall", engine::SpawnStep().fall},
            {"walk/definitions/within", walk_to.within},
            {"walk/definitions/within", engine::FollowStep().within},
            {"walk/definitions/if_blocked", fails ? "fail" : "another"},
            {step + "jump/anyOf/2/properties/forward", engine::JumpStep().forward},
            {step + "wait_until/anyOf/1/properties/timeout", engine::WaitUntilStep().timeout}};
}

std::multimap<std::string, json> expectation_defaults() {
    const engine::ImageTolerance tolerance;
    const std::string definitions = "walk/definitions/";
    return {{definitions + "place_radius", engine::ExpectReaches().within},
            {definitions + "place_radius", engine::ExpectNear().within},
            {definitions + "near/anyOf/1/properties/at", engine::ExpectNear().at ? "an event" : "end"},
            {definitions + "ratio", engine::ExpectVisits().ratio},
            {definitions + "ratio", engine::ExpectGrounded().ratio},
            {definitions + "no_penetration/anyOf/1/properties/tolerance",
             engine::ExpectNoPenetration().tolerance},
            {definitions + "visible/properties/min_pixels", engine::ExpectVisible().min_pixels},
            {definitions + "threshold", tolerance.threshold},
            {definitions + "min_tile_ssim", tolerance.min_tile_ssim}};
}

json numbers(const std::optional<Eigen::Vector3d>& color) {
    const Eigen::Vector3d& c = color.value();
    return {c.x(), c.y(), c.z()};
}

/// Without a `light`, images are drawn by day: tests/tools/images_test.py.
std::multimap<std::string, json> light_defaults() {
    const engine::LightSettings day = load_light(kSchemas / ".." / "lights" / "day.light.yaml");
    const bool smooth = day.anti_aliasing == engine::AntiAliasing::msaa;
    return {{"light/properties/glow", day.glow.value()},
            {"light/properties/fog_distance", day.fog_distance.value()},
            {"light/properties/shadows", day.shadows.value()},
            {"light/properties/contact_shading", day.ambient_occlusion.value()},
            {"light/properties/anti_aliasing", smooth ? "msaa" : "another"},
            {"light/properties/ground_light", numbers(day.ground_light)},
            {"light/properties/room_light", numbers(day.room_light)},
            {"light/definitions/sun/properties/color", numbers(day.sun_color)},
            {"light/definitions/sun/properties/disc", day.sun_disc.value()},
            {"light/definitions/sky/properties/zenith", numbers(day.zenith_color)},
            {"light/definitions/sky/properties/horizon", numbers(day.horizon_color)},
            {"light/definitions/sky/properties/light", numbers(day.sky_light)}};
}

std::multimap<std::string, json> loader_defaults() {
    std::multimap<std::string, json> all = {
        {"walks-config/properties/forbid_only", WalksConfig().forbid_only},
        {"walks-config/properties/strict", WalksConfig().strict}};
    for (auto part : {avatar_defaults(), campus_defaults(), walk_defaults(), step_defaults(),
                      expectation_defaults(), light_defaults()}) {
        all.merge(part);
    }
    return all;
}

TEST(SchemaDefaults, MatchTheLoader) {
    const std::map<std::string, json> documented = schema_defaults();
    for (const auto& [place, value] : loader_defaults()) {
        ASSERT_TRUE(documented.contains(place)) << place;
        if (value.is_number()) {
            ASSERT_TRUE(documented.at(place).is_number()) << place;
            EXPECT_DOUBLE_EQ(documented.at(place).get<double>(), value.get<double>()) << place;
        } else {
            EXPECT_EQ(documented.at(place), value) << place;
        }
    }
}

TEST(SchemaDefaults, AreAllCompared) {
    std::set<std::string> compared;
    for (const auto& [place, unused] : loader_defaults()) {
        compared.insert(place);
    }
    for (const auto& [place, value] : schema_defaults()) {
        EXPECT_TRUE(compared.contains(place)) << place << " = " << value << ": add it to this test";
    }
}

}  // namespace
}  // namespace campuswalk::config
