#include "scene/osm/steps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/osm/relief.h"
#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kTreadLook = {{176, 172, 164}, 230, 255};
constexpr Look kNosing = {{140, 136, 130}, 230, 255};
constexpr Look kRail = {{96, 100, 104}, 140, 255};
constexpr double kLeastRise = 0.1;

/// A place along a line, and the direction of the two edges there.
struct Station {
    Point at = Point::Zero();
    Point left = Point(0, 1);  ///< half a width long
};

/// The station at a distance from the start; at bends, between the directions.
Station station_at(const std::vector<Point>& line, double distance, double half_width) {
    double done = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
        if (distance <= done + length + 1e-9 || i + 1 == line.size()) {
            const double t = length > 0.0 ? std::clamp((distance - done) / length, 0.0, 1.0) : 0.0;
            Point direction = unit(d);
            constexpr double kBend = 0.02;
            if (t > 1.0 - kBend && i + 1 < line.size()) {
                direction = unit(direction + unit(line[i + 1] - line[i]));
            } else if (t < kBend && i > 1) {
                direction = unit(direction + unit(line[i - 1] - line[i - 2]));
            }
            return {line[i - 1] + t * d, half_width * left_of(direction)};
        }
        done += length;
    }
    return {line.back(), Point(0, half_width)};
}

struct FlightShape {
    std::vector<Station> stations;  ///< the ends of treads, from the foot
    std::optional<Station> beyond;  ///< where it ends below the deck that it leads to
    double foot = 0.0;
    double top = 0.0;
};

std::size_t count_of(const Path& path, double rise) {
    constexpr double kUsualRiser = 0.16;
    constexpr double kHighestRiser = 0.24;  // what everybody can climb
    const auto tagged = number_of(path.way->tags, "step_count");
    double count = std::max(1.0, std::round(rise / kUsualRiser));
    if (tagged && *tagged >= 1.0 && *tagged <= 1000.0 && rise / *tagged <= kHighestRiser) {
        count = std::round(*tagged);
    }
    return static_cast<std::size_t>(count);
}

/// Heights of its ends: of the ground, or of the bridge that it leads to.
std::pair<double, double> end_heights(const Path& path, const Terrain& terrain) {
    return {path.first_height.value_or(terrain.height(path.way->points.front())),
            path.last_height.value_or(terrain.height(path.way->points.back()))};
}

FlightShape shape_of(const Path& path, const Terrain& terrain) {
    std::vector<Point> line = path.way->points;
    const auto [first, last] = end_heights(path, terrain);
    const bool down = first > last;
    if (down) {
        std::reverse(line.begin(), line.end());
    }
    FlightShape shape;
    shape.foot = std::min(first, last);
    shape.top = std::max(first, last);
    const std::size_t count = count_of(path, shape.top - shape.foot);
    const double length = length_of(line);
    const double before = down ? path.last_trim : path.first_trim;
    const double after = down ? path.first_trim : path.last_trim;
    const double run = std::max(0.3 * length, length - before - after);
    for (std::size_t i = 0; i <= count; ++i) {
        const double at = before + run * static_cast<double>(i) / static_cast<double>(count);
        shape.stations.push_back(station_at(line, at, 0.5 * path.width));
    }
    if (after > 0.0) {
        shape.beyond = station_at(line, length, 0.5 * path.width);
    }
    return shape;
}

void add_treads(const FlightShape& shape, const Terrain& terrain, ObjectMesh& mesh) {
    const std::size_t count = shape.stations.size() - 1;
    const double riser = (shape.top - shape.foot) / static_cast<double>(count);
    constexpr double kBelow = 0.4;
    for (std::size_t i = 0; i < count; ++i) {
        const Station& a = shape.stations[i];
        const Station& b = shape.stations[i + 1];
        const double height = shape.foot + riser * static_cast<double>(i + 1);
        const double bottom =
            std::min({shape.foot, terrain.height(a.at + a.left), terrain.height(a.at - a.left),
                      terrain.height(b.at + b.left), terrain.height(b.at - b.left)}) -
            kBelow;
        const Point left_a = a.at + a.left;
        const Point right_a = a.at - a.left;
        const Point left_b = b.at + b.left;
        const Point right_b = b.at - b.left;
        mesh.quad(kTreadLook, {right_a, height}, {right_b, height}, {left_b, height}, {left_a, height});
        mesh.wall(kNosing, left_a, right_a, i == 0 ? bottom : height - riser, height);
        mesh.wall(kTreadLook, right_a, right_b, bottom, height);
        mesh.wall(kTreadLook, left_b, left_a, bottom, height);
    }
    const Station& end = shape.stations.back();
    mesh.wall(kTreadLook, end.at - end.left, end.at + end.left, shape.foot - kBelow, shape.top);
    if (shape.beyond) {  // no gap between the highest tread, which is straight, and the deck's edge
        constexpr double kLower = 0.12;
        const Station& b = *shape.beyond;
        const double height = shape.top - kLower;
        mesh.quad(kTreadLook, {end.at - end.left, height}, {b.at - b.left, height}, {b.at + b.left, height},
                  {end.at + end.left, height});
    }
}

/// A rail on posts along one edge.
void add_rail(const FlightShape& shape, double side, ObjectMesh& mesh) {
    constexpr double kInset = 0.06;
    constexpr double kPost = 0.025;
    constexpr double kHeight = 0.9;
    const auto place = [&](const Station& station) {
        const Point out = unit(station.left);
        return Point(station.at + side * (station.left - kInset * out));
    };
    const std::size_t count = shape.stations.size() - 1;
    const double riser = (shape.top - shape.foot) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Point a = place(shape.stations[i]);
        const Point b = place(shape.stations[i + 1]);
        const double low = shape.foot + riser * (static_cast<double>(i) + 0.5) + kHeight;
        const double high = low + riser;
        const Point across = 0.02 * left_of(unit(b - a));
        // Four sides of a bar.
        mesh.quad(kRail, {a - across, low}, {b - across, high}, {b + across, high}, {a + across, low});
        mesh.quad(kRail, {a - across, low - 0.05}, {b - across, high - 0.05}, {b - across, high},
                  {a - across, low});
        mesh.quad(kRail, {b + across, high - 0.05}, {a + across, low - 0.05}, {a + across, low},
                  {b + across, high});
        mesh.quad(kRail, {a + across, low - 0.05}, {b + across, high - 0.05}, {b - across, high - 0.05},
                  {a - across, low - 0.05});
        if (i % 4 == 0) {
            mesh.box(kRail, a, unit(b - a), Point(kPost, kPost), low - kHeight - riser, low);
        }
    }
}

Ring ring_around(const std::vector<Station>& stations) {
    Ring ring;
    for (const Station& station : stations) {
        ring.push_back(station.at - station.left);
    }
    for (auto station = stations.rbegin(); station != stations.rend(); ++station) {
        ring.push_back(station->at + station->left);
    }
    return ring;
}

}  // namespace

bool has_treads(const Path& path, const Terrain& terrain) {
    const auto [first, last] = end_heights(path, terrain);
    return path.steps && !path.unbuilt && std::abs(last - first) >= kLeastRise;
}

Ring outline_of_steps(const Path& path) {
    const std::vector<Point>& line = path.way->points;
    std::vector<Station> stations;
    double done = 0.0;
    stations.push_back(station_at(line, 0.0, 0.5 * path.width));
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        done += std::sqrt(d.x() * d.x() + d.y() * d.y());
        stations.push_back(station_at(line, done, 0.5 * path.width));
    }
    return ring_around(stations);
}

Ring outline_of_treads(const Path& path, const Terrain& terrain) {
    return ring_around(shape_of(path, terrain).stations);
}

void add_steps(Composition& composition) {
    for (const Path& path : composition.paths) {
        if (!has_treads(path, composition.terrain) ||
            !composition.map.box.contains(path.way->points.front())) {
            continue;
        }
        const FlightShape shape = shape_of(path, composition.terrain);
        ObjectMesh& mesh =
            composition.model.object("steps/" + ElementId{ElementKind::way, path.way->id}.text());
        add_treads(shape, composition.terrain, mesh);
        const Tags& tags = path.way->tags;
        const bool both = affirmed(tags, "handrail") || affirmed(tags, "handrail:both");
        if (both || affirmed(tags, "handrail:left")) {
            add_rail(shape, 1.0, mesh);
        }
        if (both || affirmed(tags, "handrail:right")) {
            add_rail(shape, -1.0, mesh);
        }
    }
}

}  // namespace campuswalk::scene::osm
