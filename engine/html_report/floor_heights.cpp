#include "engine/html_report/floor_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "collision/mesh/mesh_collider.h"

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

}  // namespace

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

}  // namespace campuswalk::engine
