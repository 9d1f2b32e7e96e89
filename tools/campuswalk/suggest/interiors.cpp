#include "tools/campuswalk/suggest/interiors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/world/cast.h"
#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

namespace {

constexpr double kBreast = 1.2;  // metres above the feet: over parapets and furniture

/// Whether there is something solid of a building between two points; any building if it is none of the
/// campus'.
bool sees_building(const scene::Campus& campus, std::optional<std::size_t> building, const Vector3d& from,
                   const Vector3d& to) {
    const auto hit = collision::cast(campus.world, {}, {from, to}, collision::Detection::solid);
    return hit && (!building || campus.objects[index_of(hit->object)].building == building);
}

/// Where a level ray from inside the box leaves it.
Vector3d end_in(const scene::UprightBox& box, const Vector3d& eye, const Vector3d& ahead) {
    constexpr double kMargin = 0.2;  // metres
    double length = 1e300;
    for (const auto& [axis, size] :
         {std::pair(box.along, box.size.x()), std::pair(box.across(), box.size.z())}) {
        const double speed = ahead.dot(axis);
        const double at = (eye - box.center).dot(axis);
        if (speed != 0.0) {
            length = std::min(length, (0.5 * size + kMargin - (speed > 0.0 ? at : -at)) / std::abs(speed));
        }
    }
    return eye + std::max(0.0, length) * ahead;
}

bool is_enclosed(const scene::Campus& campus, std::optional<std::size_t> building, const Vector3d& foot,
                 const scene::UprightBox& box) {
    const Vector3d eye = foot + kBreast * Vector3d::UnitY();
    const double top = box.center.y() + 0.5 * box.size.y() + 1.0;
    const bool has_roof = eye.y() < top && sees_building(campus, building, eye, {eye.x(), top, eye.z()});
    int walls = 0;
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            const Vector3d ahead = i * box.along + j * box.across();
            const bool is_level = i != 0 || j != 0;
            walls += is_level && sees_building(campus, {}, eye, end_in(box, eye, ahead)) ? 1 : 0;
        }
    }
    return walls >= (has_roof ? 5 : 7);
}

/// The building's own index, if any of the campus' objects is of it.
std::optional<std::size_t> building_with_solids(const scene::Campus& campus, std::size_t building) {
    const bool has_solids = std::ranges::any_of(campus.objects, [&](const scene::CampusObject& object) {
        return object.building == building && !object.nodes.roots.empty();
    });
    return has_solids ? std::optional(building) : std::nullopt;
}

std::optional<engine::WalkNodeId> place_inside(const scene::Campus& campus, const engine::WalkSpace& reached,
                                               const scene::SuggestedBuilding& building, std::size_t index) {
    constexpr std::size_t kTried = 2000;
    constexpr double kStoreyWeight = 4.0;  // metres to the side that a metre up counts as much as
    const std::optional<scene::UprightBox> box = trigger_inside(building);
    if (!box) {
        return std::nullopt;
    }
    const std::optional<std::size_t> of_building = building_with_solids(campus, index);
    std::vector<std::pair<double, engine::WalkNodeId>> places;
    for (const engine::WalkNodeId& node : reached.nodes_in(box_about(*box))) {
        const Vector3d foot = reached.position(node);
        const Vector3d off = foot - box->center;
        if (reached.node(node).hangs == 0 && box->depth_of(foot + kWaist * Vector3d::UnitY()) >= 0.0) {
            places.emplace_back(
                std::hypot(off.x(), off.z()) + kStoreyWeight * (off.y() + 0.5 * box->size.y()), node);
        }
    }
    std::ranges::stable_sort(places, {}, [](const auto& place) { return place.first; });
    places.resize(std::min(places.size(), kTried));
    const auto inside = std::ranges::find_if(places, [&](const auto& place) {
        return is_enclosed(campus, of_building, reached.position(place.second), building.box);
    });
    return inside == places.end() ? std::nullopt : std::optional(inside->second);
}

/// Most of the places that are looked at, spread over the floor.
bool is_mostly_enclosed(const scene::Campus& campus, std::optional<std::size_t> of_building,
                        const engine::WalkSpace& reached, const engine::Room& room,
                        const scene::UprightBox& box) {
    constexpr std::size_t kSamples = 16;
    std::size_t enclosed = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const std::size_t node = (2 * i + 1) * room.nodes.size() / (2 * kSamples);
        enclosed += is_enclosed(campus, of_building, reached.position(room.nodes[node]), box) ? 1U : 0U;
    }
    return 4 * enclosed >= 3 * kSamples;
}

constexpr double kRoomHeight = 2.0;  // metres

/// Along the building's walls, about the cells of the floor.
scene::UprightBox box_of(const engine::WalkSpace& reached, const engine::Room& room, const Vector3d& along) {
    scene::UprightBox box{Vector3d::Zero(), Vector3d::Zero(), along};
    Vector3d low = Vector3d::Constant(1e300);
    Vector3d high = -low;
    for (const engine::WalkNodeId& node : room.nodes) {
        const Vector3d foot = reached.position(node);
        const Vector3d at(foot.dot(along), foot.y(), foot.dot(box.across()));
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    const double half_cell = 0.5 * reached.grid.cell;
    low -= Vector3d(half_cell, 0.0, half_cell);
    high += Vector3d(half_cell, kRoomHeight, half_cell);
    const Vector3d middle = 0.5 * (low + high);
    box.center = middle.x() * along + middle.y() * Vector3d::UnitY() + middle.z() * box.across();
    box.size = high - low;
    return box;
}

/// Whether the box tells that one is in this room.
bool stands_for(const engine::WalkSpace& reached, const scene::UprightBox& box, const engine::Room& room) {
    constexpr double kLeastWidth = 1.0;   // metres, of where feet get to
    constexpr double kMostRise = 0.5;     // metres: there may be a gentle ramp in it
    constexpr double kLeastFilled = 0.5;  // of the box by the room's floor: there may be furniture
    constexpr double kMostForeign = 0.1;  // doorways among it
    const auto own = static_cast<double>(room.nodes.size());
    double all = 0.0;
    for (const engine::WalkNodeId& node : reached.nodes_in(box_about(box))) {
        const Vector3d foot = reached.position(node);
        const bool is_inside = box.depth_of(foot + kWaist * Vector3d::UnitY()) >= 0.0;
        all += is_inside && reached.node(node).hangs == 0 ? 1.0 : 0.0;
    }
    return std::min(box.size.x(), box.size.z()) >= kLeastWidth && box.size.y() <= kRoomHeight + kMostRise &&
           own * reached.grid.cell * reached.grid.cell >= kLeastFilled * box.footprint() &&
           all - own <= kMostForeign * own;
}

engine::WalkNodeId nearest_to_middle(const engine::WalkSpace& reached, const engine::Room& room,
                                     const scene::UprightBox& box) {
    return *std::ranges::min_element(room.nodes, {}, [&](const engine::WalkNodeId& node) {
        return (reached.position(node) - box.center).squaredNorm();
    });
}

std::vector<SuggestedRoom> rooms_of(const scene::Campus& campus, const engine::WalkSpace& reached,
                                    const scene::SuggestedBuilding& building, std::size_t index,
                                    const std::vector<engine::KnownDoor>& doors) {
    constexpr double kStorey = 1.0;  // metres: floors nearer to one another are of one storey
    const std::optional<std::size_t> of_building = building_with_solids(campus, index);
    std::vector<SuggestedRoom> rooms;
    for (const engine::Room& room :
         engine::find_rooms(campus.world, reached, box_about(building.box), doors)) {
        const scene::UprightBox box = box_of(reached, room, building.box.along);
        if (stands_for(reached, box, room) &&
            is_mostly_enclosed(campus, of_building, reached, room, building.box)) {
            rooms.push_back({box, nearest_to_middle(reached, room, box)});
        }
    }
    if (rooms.size() < 2) {
        return {};
    }
    std::ranges::stable_sort(rooms, {}, [](const SuggestedRoom& room) {
        return std::floor((room.box.center.y() - 0.5 * room.box.size.y()) / kStorey + 0.5);
    });
    return rooms;
}

}  // namespace

std::vector<Interior> find_interiors(const scene::Campus& campus, const engine::WalkSpace& reached,
                                     const std::vector<scene::SuggestedBuilding>& buildings,
                                     const std::vector<engine::KnownDoor>& doors) {
    std::vector<Interior> interiors(buildings.size());
    for (std::size_t b = 0; b < buildings.size(); ++b) {
        interiors[b].place = place_inside(campus, reached, buildings[b], b);
        if (interiors[b].place) {
            interiors[b].rooms = rooms_of(campus, reached, buildings[b], b, doors);
        }
    }
    return interiors;
}

}  // namespace campuswalk::tools
