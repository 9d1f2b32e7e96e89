#include "scene/suggest/house.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "scene/model/world_triangles.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStorey = 2.4;         // metres
constexpr double kMinHeight = 2.2;      // metres
constexpr double kMinFootprint = 12.0;  // m²
constexpr double kMinWidth = 2.0;       // metres
constexpr double kMinHull = 0.55;       // of the box's plan by the house's: a triangle has half of it
constexpr double kMinWalls = 0.3;       // of the area of a wall of one storey around the box
constexpr double kMinSide = 0.15;       // the same of one side
constexpr double kMinLowest = 0.05;     // of the walls around the lowest storey: it may stand on columns

/// The wall's area between two heights.
double area_between(const Wall& wall, double low, double high) {
    const double height = wall.high - wall.low;
    return height > 0.0
               ? wall.area * std::clamp(std::min(high, wall.high) - std::max(low, wall.low), 0.0, height) /
                     height
               : 0.0;
}

/// Areas of the walls near the sides of a box: those across +-`along`, then those across +-across().
struct SideWalls {
    std::array<double, 4> area = {};
    double lowest = 0.0;

    double total() const { return area[0] + area[1] + area[2] + area[3]; }
};

/// The side that a wall is near; none for one in the middle.
std::optional<std::size_t> side_of(const Wall& wall, const UprightBox& box) {
    constexpr double kNear = 0.25;     // of the box's size
    constexpr double kFarthest = 5.0;  // metres: hills are none
    constexpr double kEaves = 1.5;     // metres that a roof may reach over its walls
    const Vector2d middle = 0.5 * (wall.from + wall.to) - Vector2d(box.center.x(), box.center.z());
    const Vector2d local(middle.dot(Vector2d(box.along.x(), box.along.z())),
                         middle.dot(Vector2d(box.across().x(), box.across().z())));
    const Vector2d size(box.size.x(), box.size.z());
    std::optional<std::size_t> side;
    double nearest = 1e300;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double distance = 0.5 * size[axis] - std::abs(local[axis]);
        if (distance < nearest && distance <= std::clamp(kNear * size[axis], kEaves, kFarthest)) {
            nearest = distance;
            side = static_cast<std::size_t>(2 * axis + (local[axis] < 0.0 ? 1 : 0));
        }
    }
    return side;
}

SideWalls walls_about(const std::vector<const Structure*>& structures, const UprightBox& box) {
    const double bottom = box.center.y() - 0.5 * box.size.y();
    SideWalls walls;
    for (const Structure* structure : structures) {
        for (const Wall& wall : structure->walls) {
            if (const auto side = side_of(wall, box)) {
                walls.area[*side] += wall.area;
                walls.lowest += area_between(wall, bottom, bottom + kStorey);
            }
        }
    }
    return walls;
}

bool surround(const SideWalls& walls, const UprightBox& box) {
    const std::array<double, 4> storey = {box.size.z() * kStorey, box.size.z() * kStorey,
                                          box.size.x() * kStorey, box.size.x() * kStorey};
    const double all = 2.0 * (storey[0] + storey[2]);
    int sides = 0;
    for (std::size_t i = 0; i < storey.size(); ++i) {
        sides += walls.area[i] >= kMinSide * storey[i] ? 1 : 0;
    }
    return sides >= 3 && walls.total() >= kMinWalls * all && walls.lowest >= kMinLowest * all;
}

}  // namespace

std::optional<UprightBox> house_of(const Model& model, const std::vector<const Structure*>& structures,
                                   double most) {
    UprightBoxFit fit;
    for (const Structure* structure : structures) {
        for_each_vertex(model, model.nodes[structure->node], [&](const Vector3d& p) { fit.add(p); });
    }
    if (fit.empty()) {
        return std::nullopt;
    }
    const UprightBox box = fit.box();
    const bool fits = box.size.y() > kMinHeight && box.footprint() >= kMinFootprint &&
                      box.footprint() < most && std::min(box.size.x(), box.size.z()) >= kMinWidth &&
                      fit.hull_area() >= kMinHull * box.footprint();
    return fits && surround(walls_about(structures, box), box) ? std::optional(box) : std::nullopt;
}

double shared_plan(const UprightBox& a, const UprightBox& b) {
    const UprightBox& small = a.footprint() <= b.footprint() ? a : b;
    const UprightBox& large = a.footprint() <= b.footprint() ? b : a;
    const Vector3d off = a.center - b.center;
    const double reach = 0.5 * (a.size.x() + a.size.z() + b.size.x() + b.size.z());
    if (std::abs(off.x()) > reach || std::abs(off.z()) > reach) {
        return 0.0;
    }
    int inside = 0;
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            Vector3d p = small.center + (i / 3.0) * small.size.x() * small.along +
                         (j / 3.0) * small.size.z() * small.across();
            p.y() = large.center.y();
            inside += large.depth_of(p) >= 0.0 ? 1 : 0;
        }
    }
    return inside / 9.0;
}

}  // namespace campuswalk::scene
