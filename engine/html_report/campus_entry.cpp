#include "engine/html_report/campus_entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "collision/mesh/mesh_collider.h"
#include "engine/events/decimals.h"
#include "engine/html_report/foreign_json.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

constexpr double kStep = 0.1;          // metres: heights differ by this
constexpr double kLevel = 0.97;        // cosine of the steepest floor
constexpr double kApart = 2.2;         // metres: no storey is lower
constexpr double kLeastArea = 12.0;    // m²: a room
constexpr double kLeastShare = 0.005;  // of the largest floor
constexpr std::size_t kMost = 40;

using Areas = std::map<std::int64_t, double>;  ///< by height in steps

void add(double height, double area, Areas& areas) {
    areas[static_cast<std::int64_t>(std::floor(height / kStep + 0.5))] += area;
}

void add_mesh(const collision::MeshCollider& mesh, const collision::Pose& X_world_mesh, Areas& areas) {
    for (std::size_t i = 0; i < mesh.mesh().triangles.size(); ++i) {
        const collision::Triangle t = collision::vertices(mesh.mesh(), i);
        const Vector3d normal = X_world_mesh.rotate((t.b - t.a).cross(t.c - t.a));
        const double doubled = normal.norm();
        if (doubled > 0.0 && normal.y() > kLevel * doubled) {
            add((X_world_mesh * Vector3d((t.a + t.b + t.c) / 3.0)).y(), 0.5 * doubled, areas);
        }
    }
}

Areas level_areas(const scene::Campus& campus) {
    Areas areas;
    for (std::size_t i = 0; i < campus.world.size(); ++i) {
        const auto id = static_cast<collision::ObjectId>(i);
        const collision::Object& object = campus.world.object(id);
        if (!any_of(object.detection, collision::Detection::solid)) {
            continue;
        }
        if (const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape)) {
            add_mesh(**mesh, object.X_world_shape, areas);
        } else if (std::holds_alternative<collision::Box>(object.shape)) {
            const collision::Aabb& box = campus.world.bounds(id);
            const Vector3d size = box.max - box.min;
            add(box.max.y(), size.x() * size.z(), areas);
        }
    }
    return areas;
}

/// Heights at which much of the solids' surface is level and faces up: floors and roofs, from below, at least
/// a storey apart; where to cut a campus open. Always at least one. Unlike engine/walkspace/space/storeys.h
/// it takes no walking, and knows of no way to them.
std::vector<double> floor_heights(const scene::Campus& campus) {
    const Areas areas = level_areas(campus);
    std::vector<std::pair<double, std::int64_t>> largest_first;
    for (const auto& [height, area] : areas) {
        largest_first.emplace_back(-area, height);
    }
    std::ranges::sort(largest_first);
    std::vector<double> heights;
    for (const auto& [negative_area, steps] : largest_first) {
        const double least = std::max(kLeastArea, kLeastShare * -largest_first.front().first);
        if (-negative_area < least || heights.size() == kMost) {
            break;
        }
        const double height = static_cast<double>(steps) / (1.0 / kStep);
        if (std::ranges::none_of(heights, [&](double other) { return std::abs(other - height) < kApart; })) {
            heights.push_back(height);
        }
    }
    if (heights.empty()) {
        heights.push_back(campus.world.size() > 0 ? std::floor(campus.world.bounds().min.y()) : 0.0);
    }
    std::ranges::sort(heights);
    return heights;
}

using Json = nlohmann::ordered_json;
using collision::Detection;

constexpr double kMillimetres = 1000.0;

/// In whole millimetres: no reader sees more, and the text is shorter.
double rounded(double value) {
    return std::floor(value * kMillimetres + 0.5) / kMillimetres;
}

Json list_of(const Vector3d& value) {
    return {rounded(value.x()), rounded(value.y()), rounded(value.z())};
}

Json axes_of(const Eigen::Matrix3d& rotation) {
    constexpr double kDigits = 1e6;
    Json list = Json::array();
    for (Eigen::Index column = 0; column < 3; ++column) {
        for (Eigen::Index row = 0; row < 3; ++row) {
            list.push_back(std::floor(rotation(row, column) * kDigits + 0.5) / kDigits);
        }
    }
    return list;
}

// The dimensions of each shape; a capsule lies along its y axis, a wheel along its x axis.

void describe(const std::shared_ptr<const collision::MeshCollider>&, Json& json) {
    json["shape"] = "mesh";
}
void describe(const collision::Box& box, Json& json) {
    json["shape"] = "box";
    json["size"] = list_of(2.0 * box.half_extents);
}
void describe(const collision::Sphere& sphere, Json& json) {
    json["shape"] = "sphere";
    json["radius"] = rounded(sphere.radius);
}
void describe(const collision::Capsule& capsule, Json& json) {
    json["shape"] = "capsule";
    json["radius"] = rounded(capsule.radius);
    json["height"] = rounded(2.0 * (capsule.half_length + capsule.radius));
}
void describe(const collision::Wheel& wheel, Json& json) {
    json["shape"] = "wheel";
    json["radius"] = rounded(wheel.radius);
    json["width"] = rounded(2.0 * wheel.half_width);
}

Json modes_of(Detection detection) {
    constexpr std::array<std::pair<Detection, const char*>, 3> kNames = {
        {{Detection::solid, "solid"}, {Detection::trigger, "trigger"}, {Detection::ray, "ray"}}};
    Json list = Json::array();
    for (const auto& [mode, name] : kNames) {
        if (any_of(detection, mode)) {
            list.push_back(name);
        }
    }
    return list;
}

Json objects_of(const scene::Campus& campus) {
    Json list = Json::array();
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        const auto id = static_cast<collision::ObjectId>(i);
        const collision::Object& object = campus.world.object(id);
        const collision::Aabb& box = campus.world.bounds(id);
        const auto& building = campus.objects[i].building;
        Json json = {{"id", campus.objects[i].id},
                     {"building", building ? static_cast<std::int64_t>(*building) : -1},
                     {"modes", modes_of(object.detection)}};
        std::visit([&](const auto& shape) { describe(shape, json); }, object.shape);
        json["min"] = list_of(box.min);
        json["max"] = list_of(box.max);
        if (json["shape"] != "mesh") {
            json["center"] = list_of(object.X_world_shape.translation);
            json["axes"] = axes_of(object.X_world_shape.rotation);
        }
        list.push_back(std::move(json));
    }
    return list;
}

Json buildings_of(const scene::CampusDescription& campus) {
    Json list = Json::array();
    for (const scene::Building& building : campus.buildings) {
        Json info = Json::array();
        for (const scene::InfoField& field : building.info) {
            info.push_back({{"name", field.name}, {"value", field.value}});
        }
        list.push_back({{"id", building.id},
                        {"title", building.title},
                        {"text", building.text},
                        {"kind", building.kind},
                        {"hours", building.hours},
                        {"floors", building.floors},
                        {"info", std::move(info)}});
    }
    return list;
}

Json spawns_of(const scene::CampusDescription& campus) {
    Json list = Json::array();
    for (const scene::Spawn& spawn : campus.spawns) {
        list.push_back({{"name", spawn.name},
                        {"at", list_of(spawn.position)},
                        {"yaw_deg", rounded(degrees(spawn.yaw))}});
    }
    return list;
}

Json places_of(const scene::CampusDescription& campus) {
    Json list = Json::array();
    for (const scene::Place& place : campus.places) {
        list.push_back({{"name", place.name}, {"at", list_of(place.position)}});
    }
    return list;
}

}  // namespace

std::string campus_entry(const scene::Campus& campus, const std::string& file) {
    scene::Bounds bounds;
    for (const scene::Model& model : campus.models) {
        bounds.extend(scene::world_bounds(model));
    }
    if (campus.world.size() > 0) {
        bounds.extend(campus.world.bounds().min);
        bounds.extend(campus.world.bounds().max);
    }
    const Json json = {{"name", campus.description.name},
                       {"file", file},
                       {"min", list_of(bounds.empty() ? Vector3d(Vector3d::Zero()) : bounds.min)},
                       {"max", list_of(bounds.empty() ? Vector3d(Vector3d::Zero()) : bounds.max)},
                       {"objects", objects_of(campus)},
                       {"buildings", buildings_of(campus.description)},
                       {"spawns", spawns_of(campus.description)},
                       {"places", places_of(campus.description)},
                       {"storeys", floor_heights(campus)}};
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.substr(1, text.size() - 2);
}

bool is_campus_entry(const Json& json) {
    const auto is_object = [](const Json& object) {
        return has_strings(object, {"id", "shape"}) && has_numbers(object, {"building"}) &&
               has_points(object, {"min", "max"}) &&
               has_list(object, "modes", [](const Json& mode) { return mode.is_string(); });
    };
    const auto is_building = [](const Json& building) { return has_strings(building, {"id", "title"}); };
    const auto is_place = [](const Json& place) {
        return has_strings(place, {"name"}) && has_points(place, {"at"});
    };
    return has_strings(json, {"name", "file"}) && has_points(json, {"min", "max"}) &&
           has_list(json, "objects", is_object) && has_list(json, "buildings", is_building) &&
           has_list(json, "spawns", is_place) && has_list(json, "places", is_place) &&
           has_list(json, "storeys", [](const Json& height) { return height.is_number(); });
}

}  // namespace campuswalk::engine
