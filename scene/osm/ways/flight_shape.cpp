#include "scene/osm/ways/flight_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/relief.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kLeastRise = 0.1;  // metres

/// The station at a distance from the start; at bends, between the directions.
Station station_at(const std::vector<Point>& line, double distance, double half_width) {
    double done = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        const double length = norm(d);
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

FlightShape shape_of(const Path& path, const Terrain& terrain) {
    std::vector<Point> line = path.way->points;
    const auto [first, last] = end_heights(path, terrain);
    const bool down = first > last;
    if (down) {
        std::reverse(line.begin(), line.end());
    }
    FlightShape shape;
    shape.reversed = down;
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

bool has_treads(const Path& path, const Terrain& terrain) {
    const auto [first, last] = end_heights(path, terrain);
    return path.steps && !path.unbuilt && !path.leaves_ground && std::abs(last - first) >= kLeastRise;
}

Ring outline_of_steps(const Path& path) {
    const std::vector<Point>& line = path.way->points;
    std::vector<Station> stations;
    double done = 0.0;
    stations.push_back(station_at(line, 0.0, 0.5 * path.width));
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        done += norm(d);
        stations.push_back(station_at(line, done, 0.5 * path.width));
    }
    return ring_around(stations);
}

Ring outline_of_treads(const Path& path, const Terrain& terrain) {
    return ring_around(shape_of(path, terrain).stations);
}

}  // namespace campuswalk::scene::osm
