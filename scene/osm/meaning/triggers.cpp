#include "scene/osm/meaning/triggers.h"

#include <algorithm>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kRoom = 0.6;  // metres around a visitor

bool is_at_ground(const Volume& volume) {
    constexpr double kHeadroom = 2.2;
    return !volume.open && volume.bottom < kHeadroom;
}

Eigen::Vector3d standing_on(const Site& site, const Point& at, double height) {
    return site.world(at, 0.5 * height);
}

}  // namespace

double yaw_towards(const Point& direction) {
    return collision::angle_of(-direction.x(), direction.y()) / kDegree;
}

double yaw_along(const Point& direction) {
    return collision::angle_of(direction.y(), direction.x()) / kDegree;
}

BoxIndex index_of_volumes(const Site& site) {
    BoxIndex index;
    for (std::size_t i = 0; i < site.volumes.size(); ++i) {
        if (is_at_ground(site.volumes[i])) {
            index.add(i, box_of(site.volumes[i].footprint));
        }
    }
    return index;
}

const Volume* volume_at(const Site& site, const BoxIndex& volumes, const Point& at) {
    for (const std::size_t i : volumes.at(at)) {
        if (contains(site.volumes[i].footprint, at)) {
            return &site.volumes[i];
        }
    }
    return nullptr;
}

FreeGround::FreeGround(const Site& site, const Built& built)
    : site_(site), built_(built), volumes_(index_of_volumes(site)) {
    const auto add_all = [](const std::vector<Polygons>& areas, BoxIndex& index) {
        for (std::size_t i = 0; i < areas.size(); ++i) {
            if (!areas[i].empty()) {
                index.add(i, box_of(areas[i]));
            }
        }
    };
    add_all(built.obstacles, obstacles_);
    add_all(built.flights, flights_);
}

bool FreeGround::at(const Point& p) const {
    const Box around = Box{p, p}.grown(kRoom);
    return std::ranges::all_of(volumes_.near(around),
                               [&](std::size_t i) { return is_clear_of(site_.volumes[i].footprint, p); }) &&
           std::ranges::all_of(obstacles_.near(around),
                               [&](std::size_t i) { return is_clear_of(built_.obstacles[i], p); });
}

bool FreeGround::is_start(const Point& p) const {
    return at(p) && std::ranges::all_of(flights_.near(Box{p, p}.grown(kRoom)),
                                        [&](std::size_t i) { return is_clear_of(built_.flights[i], p); });
}

double FreeGround::sight(const Point& p, const Point& direction, double farthest) const {
    constexpr double kStep = 0.25;
    constexpr double kNear = 6.0;  // farther away one sees past poles, hedges and the like
    const auto has = [](const Polygons& area, const Point& at) { return contains(area, at); };
    for (int i = 1; i * kStep < farthest; ++i) {
        const double distance = i * kStep;
        const Point at = p + distance * direction;
        const bool hidden =
            !site_.map.box.contains(at) ||
            std::ranges::any_of(volumes_.at(at),
                                [&](std::size_t k) { return has(site_.volumes[k].footprint, at); }) ||
            (distance < kNear && std::ranges::any_of(obstacles_.at(at), [&](std::size_t k) {
                 return has(built_.obstacles[k], at);
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

DraftTrigger area_trigger(const Site& site, const std::string& id, const Polygons& area, double margin,
                          double height) {
    std::vector<Point> all;
    for (const Polygon& polygon : area) {
        all.insert(all.end(), polygon.outer.begin(), polygon.outer.end());
    }
    Ring rectangle = area.size() == 1 ? site.geometry.least_rectangle(all) : Ring();
    if (rectangle.empty()) {
        const Box box = box_of(all);
        rectangle = {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
    }
    const Point along = rectangle[1] - rectangle[0];
    const Point across = rectangle[2] - rectangle[1];
    const double length = norm(along);
    const double width = norm(across);
    const double low = site.terrain.lowest(area);
    const double high = site.terrain.highest(area) + height;
    const Point middle = 0.5 * (rectangle[0] + rectangle[2]);
    DraftTrigger trigger;
    trigger.id = id + "/around";
    trigger.building = id;
    trigger.center = {middle.x(), 0.5 * (low + high), -middle.y()};
    trigger.size = {length + 2.0 * margin, high - low + 1.0, width + 2.0 * margin};
    trigger.yaw_deg = yaw_along(along);
    return trigger;
}

DraftTrigger node_trigger(const Site& site, const BoxIndex& volumes, const std::string& id, const Point& at) {
    constexpr double kSize = 4.0;
    constexpr double kHeight = 3.0;
    DraftTrigger trigger;
    trigger.id = id + "/around";
    trigger.building = id;
    trigger.size = {kSize, kHeight, kSize};
    Point center = at;
    if (const Volume* volume = volume_at(site, volumes, at)) {
        Nearest nearest;  // of the outer walls: not everyone gets into a courtyard
        for (const Polygon& polygon : volume->footprint) {
            const Nearest other = nearest_on(polygon.outer, true, at);
            nearest = other.distance < nearest.distance ? other : nearest;
        }
        center = nearest.at;
        trigger.yaw_deg = yaw_along(nearest.along);
    }
    trigger.center = standing_on(site, center, kHeight);
    return trigger;
}

}  // namespace campuswalk::scene::osm
