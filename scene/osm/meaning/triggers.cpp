#include "scene/osm/meaning/triggers.h"

#include <algorithm>
#include <cmath>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kRoom = 0.6;  // metres around a visitor

bool is_at_ground(const Volume& volume) {
    constexpr double kHeadroom = 2.2;
    return !volume.open && volume.bottom < kHeadroom;
}

Eigen::Vector3d standing_on(const Composition& composition, const Point& at, double height) {
    return composition.world(at, 0.5 * height);
}

}  // namespace

double yaw_towards(const Point& direction) {
    return collision::angle_of(-direction.x(), direction.y()) / kDegree;
}

double yaw_along(const Point& direction) {
    return collision::angle_of(direction.y(), direction.x()) / kDegree;
}

BoxIndex index_of_volumes(const Composition& composition) {
    BoxIndex index;
    for (std::size_t i = 0; i < composition.volumes.size(); ++i) {
        if (is_at_ground(composition.volumes[i])) {
            index.add(i, box_of(composition.volumes[i].footprint));
        }
    }
    return index;
}

const Volume* volume_at(const Composition& composition, const BoxIndex& volumes, const Point& at) {
    for (const std::size_t i : volumes.at(at)) {
        if (contains(composition.volumes[i].footprint, at)) {
            return &composition.volumes[i];
        }
    }
    return nullptr;
}

FreeGround::FreeGround(const Composition& composition)
    : composition_(composition), volumes_(index_of_volumes(composition)) {
    const auto add_all = [](const std::vector<Polygons>& areas, BoxIndex& index) {
        for (std::size_t i = 0; i < areas.size(); ++i) {
            if (!areas[i].empty()) {
                index.add(i, box_of(areas[i]));
            }
        }
    };
    add_all(composition.obstacles, obstacles_);
    add_all(composition.flights, flights_);
}

bool FreeGround::at(const Point& p) const {
    const Box around = Box{p, p}.grown(kRoom);
    return std::ranges::all_of(
               volumes_.near(around),
               [&](std::size_t i) { return is_clear_of(composition_.volumes[i].footprint, p); }) &&
           std::ranges::all_of(obstacles_.near(around),
                               [&](std::size_t i) { return is_clear_of(composition_.obstacles[i], p); });
}

bool FreeGround::is_start(const Point& p) const {
    return at(p) && std::ranges::all_of(flights_.near(Box{p, p}.grown(kRoom)), [&](std::size_t i) {
               return is_clear_of(composition_.flights[i], p);
           });
}

double FreeGround::sight(const Point& p, const Point& direction, double farthest) const {
    constexpr double kStep = 0.25;
    constexpr double kNear = 6.0;  // farther away one sees past poles, hedges and the like
    const auto has = [](const Polygons& area, const Point& at) { return contains(area, at); };
    for (int i = 1; i * kStep < farthest; ++i) {
        const double distance = i * kStep;
        const Point at = p + distance * direction;
        const bool hidden =
            !composition_.map.box.contains(at) ||
            std::ranges::any_of(volumes_.at(at),
                                [&](std::size_t k) { return has(composition_.volumes[k].footprint, at); }) ||
            (distance < kNear && std::ranges::any_of(obstacles_.at(at), [&](std::size_t k) {
                 return has(composition_.obstacles[k], at);
             }));
        if (hidden) {
            return distance;
        }
    }
    return farthest;
}

bool FreeGround::is_clear_of(const Polygons& area, const Point& p) const {
    return !contains(area, p) && nearest_on(area, p).distance >= kRoom;
}

void add_area_trigger(Composition& composition, const std::string& id, const std::string& building,
                      const Polygons& area, double margin, double height) {
    std::vector<Point> all;
    for (const Polygon& polygon : area) {
        all.insert(all.end(), polygon.outer.begin(), polygon.outer.end());
    }
    Ring rectangle = area.size() == 1 ? composition.geometry.least_rectangle(all) : Ring();
    if (rectangle.empty()) {
        const Box box = box_of(all);
        rectangle = {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
    }
    const Point along = rectangle[1] - rectangle[0];
    const Point across = rectangle[2] - rectangle[1];
    const double length = norm(along);
    const double width = norm(across);
    const double low = composition.terrain.lowest(area);
    const double high = composition.terrain.highest(area) + height;
    const Point middle = 0.5 * (rectangle[0] + rectangle[2]);
    DraftTrigger trigger;
    trigger.id = id;
    trigger.building = building;
    trigger.center = {middle.x(), 0.5 * (low + high), -middle.y()};
    trigger.size = {length + 2.0 * margin, high - low + 1.0, width + 2.0 * margin};
    trigger.yaw_deg = yaw_along(along);
    composition.draft.triggers.push_back(std::move(trigger));
}

void add_node_trigger(Composition& composition, const BoxIndex& volumes, const std::string& id,
                      const std::string& building, const Point& at) {
    constexpr double kSize = 4.0;
    constexpr double kHeight = 3.0;
    DraftTrigger trigger;
    trigger.id = id;
    trigger.building = building;
    trigger.size = {kSize, kHeight, kSize};
    Point center = at;
    if (const Volume* volume = volume_at(composition, volumes, at)) {
        Nearest nearest;  // of the outer walls: not everyone gets into a courtyard
        for (const Polygon& polygon : volume->footprint) {
            const Nearest other = nearest_on(polygon.outer, true, at);
            nearest = other.distance < nearest.distance ? other : nearest;
        }
        center = nearest.at;
        trigger.yaw_deg = yaw_along(nearest.along);
    }
    trigger.center = standing_on(composition, center, kHeight);
    composition.draft.triggers.push_back(std::move(trigger));
}

}  // namespace campuswalk::scene::osm
