#include "scene/osm/bridges/bridge_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// Lines that bridges lead over, besides paths.
struct LineBelow {
    std::string_view key;
    std::string_view value;
    double width;  ///< metres, where nothing is tagged
    double clearance;
};

constexpr double kOverWater = 0.6;
constexpr std::array<LineBelow, 11> kLinesBelow = {{
    {"railway", "rail", 4.0, 5.8},
    {"railway", "light_rail", 3.5, 5.0},
    {"railway", "tram", 3.0, 5.0},
    {"railway", "subway", 3.5, 4.5},
    {"railway", "narrow_gauge", 3.0, 4.5},
    {"railway", "monorail", 3.0, 4.5},
    {"waterway", "river", 8.0, kOverWater},
    {"waterway", "canal", 6.0, kOverWater},
    {"waterway", "stream", 2.0, kOverWater},
    {"waterway", "ditch", 1.5, kOverWater},
    {"waterway", "drain", 1.5, kOverWater},
}};

double clearance_over(const Path& path) {
    const bool road = path.carriageway;
    const bool vehicles = road || path.highway == "service" || path.highway == "living_street";
    const double usual = road ? 4.5 : vehicles ? 3.8 : 2.5;
    return std::clamp(length_of(path.way->tags, "maxheight").value_or(usual), 0.5, 8.0);
}

/// Whether two segments cross, and where along the first.
bool cross(const Point& a, const Point& b, const Point& c, const Point& d, double& t) {
    const Point r = b - a;
    const Point s = d - c;
    const double area = r.x() * s.y() - r.y() * s.x();
    if (std::abs(area) < 1e-9) {
        return false;
    }
    const Point from = c - a;
    t = (from.x() * s.y() - from.y() * s.x()) / area;
    const double u = (from.x() * r.y() - from.y() * r.x()) / area;
    return t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0;
}

/// Whether they are joined there rather than one above the other.
bool is_shared(const MapWay& a, const MapWay& b, const Point& at) {
    constexpr double kSame = 0.3;  // metres
    if ((a.points.front() - at).norm() < kSame || (a.points.back() - at).norm() < kSame) {
        return true;  // at a bridge's end, though they have no node in common
    }
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        if ((a.points[i] - at).norm() < kSame && std::ranges::find(b.nodes, a.nodes[i]) != b.nodes.end()) {
            return true;
        }
    }
    return false;
}

}  // namespace

double layer_of(const Tags& tags) {
    if (const auto layer = number_of(tags, "layer")) {
        return std::clamp(*layer, -9.0, 9.0);
    }
    return affirmed(tags, "bridge")                                             ? 1.0
           : affirmed(tags, "tunnel") && !tags.is("tunnel", "building_passage") ? -1.0
                                                                                : 0.0;
}

CrossedByBridges::CrossedByBridges(const Map& map, const std::vector<MapArea>& areas,
                                   const std::vector<Path>& paths) {
    for (const Path& path : paths) {
        if (!path.unbuilt) {
            lines_.push_back({path.way, &path, layer_of(path.way->tags), path.width, clearance_over(path)});
        }
    }
    for (const MapWay& way : map.ways) {
        const auto* kind = std::ranges::find_if(
            kLinesBelow, [&](const LineBelow& line) { return way.tags.is(line.key, line.value); });
        if (kind != kLinesBelow.end() && way.points.size() > 1 && layer_of(way.tags) >= 0.0) {
            lines_.push_back({&way, nullptr, layer_of(way.tags),
                              std::clamp(length_of(way.tags, "width").value_or(kind->width), 0.5, 100.0),
                              kind->clearance});
        }
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const std::vector<Point>& points = lines_[i].way->points;
        for (std::size_t k = 1; k < points.size(); ++k) {
            near_segments_.add(segments_.size(), box_of({points[k - 1], points[k]}));
            segments_.emplace_back(i, k);
        }
    }
    for (const MapArea& area : areas) {
        if (area.tags.is("natural", "water") || area.tags.is("waterway", "riverbank") ||
            area.tags.is("landuse", "basin") || area.tags.is("landuse", "reservoir")) {
            near_water_.add(water_.size(), box_of(area.polygons));
            water_.push_back(&area);
        }
    }
}

std::vector<Crossed> CrossedByBridges::below(const Path& bridge) const {
    std::vector<Crossed> found;
    const std::vector<Point>& line = bridge.way->points;
    const double layer = layer_of(bridge.way->tags);
    std::vector<std::array<std::size_t, 3>> pairs;  // of segments: the line, of the bridge, of the line
    for (std::size_t i = 1; i < line.size(); ++i) {
        for (const std::size_t number : near_segments_.near(box_of({line[i - 1], line[i]}))) {
            const auto [other, k] = segments_[number];
            if (lines_[other].way != bridge.way && lines_[other].layer < layer) {
                pairs.push_back({other, i, k});
            }
        }
    }
    std::ranges::sort(pairs);
    for (const auto& [number, i, k] : pairs) {
        const Line& other = lines_[number];
        const Point& c = other.way->points[k - 1];
        const Point& d = other.way->points[k];
        double t = 0.0;
        if (!cross(line[i - 1], line[i], c, d, t)) {
            continue;
        }
        const Point at = line[i - 1] + t * (line[i] - line[i - 1]);
        if (!is_shared(*bridge.way, *other.way, at)) {
            found.push_back({at, unit(d - c), other.width, other.clearance, other.path, i - 1, t});
        }
    }
    add_water(bridge, found);
    return found;
}

/// Where it is over areas of water, from bank to bank.
void CrossedByBridges::add_water(const Path& bridge, std::vector<Crossed>& found) const {
    constexpr double kSample = 0.5;  // metres
    const std::vector<Point>& line = bridge.way->points;
    for (const std::size_t number : near_water_.near(box_of(line))) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point d = line[i] - line[i - 1];
            const double length = norm(d);
            const int samples = std::clamp(static_cast<int>(length / kSample), 1, 4'000);
            int wet = 0;
            Point sum = Point::Zero();
            for (int k = 0; k < samples; ++k) {
                const Point p = line[i - 1] + d * ((k + 0.5) / samples);
                if (contains(water_[number]->polygons, p)) {
                    sum += p;
                    ++wet;
                }
            }
            if (wet > 0) {
                const Point middle = sum / wet;
                const double t =
                    length > 0.0 ? std::clamp((middle - line[i - 1]).norm() / length, 0.0, 1.0) : 0.0;
                found.push_back(
                    {middle, left_of(unit(d)), length * wet / samples, kOverWater, nullptr, i - 1, t});
            }
        }
    }
}

}  // namespace campuswalk::scene::osm
