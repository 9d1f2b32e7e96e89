#include "scene/campus/place_heights.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

#include "collision/world/cast.h"
#include "collision/world/placement.h"

namespace campuswalk::scene {

using collision::Vec3;

namespace {

constexpr double kHeadroom = 2.0;  // metres: a door's height
constexpr double kBetween = 0.01;  // metres: surfaces nearer to each other count as one
constexpr std::size_t kMostLevels = 256;

/// Heights of the solid surfaces above and below a point, from the top; of boxes and the like their tops.
std::vector<double> surfaces_at(const collision::World& world, double x, double z) {
    std::vector<double> heights;
    std::vector<bool> passed(world.size(), false);  // a ray that starts in a box hits it at once
    collision::QueryFilter filter;
    filter.disabled = &passed;
    const double bottom = world.bounds().min.y() - 1.0;
    double top = world.bounds().max.y() + 1.0;
    while (heights.size() < kMostLevels && top > bottom) {
        const auto hit = collision::cast(world, filter, {Vec3(x, top, z), Vec3(x, bottom, z)},
                                         collision::Detection::solid);
        if (!hit) {
            break;
        }
        const double height = top + hit->fraction * (bottom - top);
        if (heights.empty() || height < heights.back()) {
            heights.push_back(height);
        }
        const bool is_mesh = std::holds_alternative<std::shared_ptr<const collision::MeshCollider>>(
            world.object(hit->object).shape);
        passed[index_of(hit->object)] = !is_mesh;
        top = is_mesh ? height - kBetween : height;
    }
    return heights;
}

bool is_inside_something(const collision::World& world, const Vec3& point) {
    std::vector<collision::ObjectId> near;
    world.candidates({point, point}, {}, near);
    return std::ranges::any_of(
        near, [&](collision::ObjectId id) { return collision::contains(world.object(id), point); });
}

std::optional<double> ground_at(const collision::World& world, double x, double z) {
    const std::vector<double> heights = surfaces_at(world, x, z);
    for (std::size_t i = heights.size(); i-- > 0;) {
        const double above = i == 0 ? std::numeric_limits<double>::infinity() : heights[i - 1];
        const auto is_free = [&](double share) {
            return !is_inside_something(world, {x, heights[i] + share * kHeadroom, z});
        };
        if (above - heights[i] >= kHeadroom && is_free(0.5) && is_free(0.95)) {
            return heights[i];
        }
    }
    return heights.empty() ? std::nullopt : std::optional(heights.front());
}

}  // namespace

void put_places_on_ground(const collision::World& world, std::vector<Place>& places,
                          std::vector<Diagnostic>& warnings) {
    const Place* first = nullptr;
    std::size_t others = 0;
    for (Place& place : places) {
        if (place.has_height) {
            continue;
        }
        if (const auto height = ground_at(world, place.position.x(), place.position.z())) {
            place.position.y() = *height;
        } else if (first == nullptr) {
            first = &place;
        } else {
            ++others;
        }
    }
    if (first != nullptr) {
        warnings.push_back({Severity::warning, first->mark, "no-ground-below",
                            "nothing solid is below the place '" + first->name + "'" +
                                (others == 0   ? ""
                                 : others == 1 ? " and one other"
                                               : " and " + std::to_string(others) + " others") +
                                "; check the coordinates and the campus's 'origin'"});
    }
}

}  // namespace campuswalk::scene
