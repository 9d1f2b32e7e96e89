#include "scene/osm/read/read_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/base/why_unreadable.h"
#include "scene/model/projection.h"
#include "scene/osm/read/raw_map.h"

namespace campuswalk::scene::osm {
namespace {

/// Elements so far beyond the section are still read: a building may begin outside.
constexpr double kMargin = 300.0;  // metres
constexpr double kMetresPerDegree = 111'320.0;

GeographicBox square_about(double latitude, double longitude, double radius) {
    const double north = radius / kMetresPerDegree;
    // Close enough to choose what is in the square; its size in metres comes from the projection.
    const Projection here(latitude, longitude);
    const double metres_east = here.project(latitude, longitude + 0.001).x() / 0.001;
    const double east = metres_east > 1.0 ? radius / metres_east : 0.0;
    const double turn = longitude - east < -180.0 ? 360.0 : 0.0;
    return {latitude - north, longitude - east + turn, latitude + north, longitude + east + turn};
}

/// Around all nodes. If that is more than half of the Earth, they lie on both sides of the antimeridian.
GeographicBox box_of_all(const RawMap& raw) {
    const auto box_from = [&](double first_meridian) {
        GeographicBox box{90.0, 540.0, -90.0, -540.0};
        for (const NodeLocation& at : raw.locations) {
            const double longitude = at.longitude() + (at.longitude() < first_meridian ? 360.0 : 0.0);
            box = {std::min(box.south, at.latitude()), std::min(box.west, longitude),
                   std::max(box.north, at.latitude()), std::max(box.east, longitude)};
        }
        return box;
    };
    const GeographicBox box = box_from(-180.0);
    return box.east - box.west > 180.0 ? box_from(0.0) : box;
}

/// The box, and all that is within the margin around it.
GeographicBox with_margin(const GeographicBox& box) {
    const double latitude = std::max(std::abs(box.south), std::abs(box.north));
    const GeographicBox square = square_about(std::min(latitude, 89.0), 0.0, 1.02 * kMargin);
    return {box.south - 0.5 * (square.north - square.south), box.west - square.east,
            box.north + 0.5 * (square.north - square.south), box.east + square.east};
}

std::optional<GeographicBox> box_of_section(const MapSection& section) {
    return section.center
               ? std::optional(square_about(section.center->first, section.center->second, section.radius))
               : section.box;
}

/// Projects the elements of a map.
class Projector {
public:
    Projector(const RawMap& raw, const Projection& projection, double latitude, double longitude)
        : raw_(raw), projection_(projection), latitude_(latitude), longitude_(longitude) {}

    std::optional<Point> at(std::int64_t node) const {
        constexpr double kFarthest = 60.0;  // degrees: the plane doesn't know the Earth's other side
        const NodeLocation* at = raw_.location(node);
        if (at == nullptr) {
            return std::nullopt;
        }
        const double east = std::abs(at->longitude() - longitude_);
        return std::abs(at->latitude() - latitude_) < kFarthest && std::min(east, 360.0 - east) < kFarthest
                   ? std::optional<Point>(projection_.project(at->latitude(), at->longitude()))
                   : std::nullopt;
    }
    void place(MapWay& way) const {
        std::vector<std::int64_t> nodes;
        for (const std::int64_t node : way.nodes) {
            if (const auto p = at(node)) {
                nodes.push_back(node);
                way.points.push_back(*p);
            } else {
                way.complete = false;
            }
        }
        way.nodes = std::move(nodes);
    }

private:
    const RawMap& raw_;
    const Projection& projection_;
    double latitude_;
    double longitude_;
};

void set_boxes(const GeographicBox& geographic, const Projection& projection, const SourceMark& mark,
               Map& map) {
    map.geographic = geographic;
    std::vector<Point> vertices;
    for (const double latitude : {geographic.south, geographic.north}) {
        for (const double longitude : {geographic.west, geographic.east}) {
            vertices.push_back(projection.project(latitude, longitude));
        }
    }
    map.box = box_of(vertices);
    const Point size = map.box.size();
    if (!(size.minCoeff() > 1.0)) {
        throw InputError(mark, "bad-size", "there is no area in the map; pass --bbox or --center");
    }
    if (!(size.maxCoeff() <= kMaxMapSize) || geographic.east - geographic.west > 90.0) {
        constexpr double kMetresPerKilometre = 1000.0;
        const auto kilometres = [&](double metres) {
            return std::to_string(std::lround(metres / kMetresPerKilometre));
        };
        throw InputError(mark, "bad-size",
                         "this is " + kilometres(size.x()) + " km by " + kilometres(size.y()) +
                             " km, and the limit is 20 km; choose a part of it, such as --center " +
                             std::to_string(0.5 * (geographic.south + geographic.north)) + "," +
                             std::to_string(0.5 * (geographic.west + geographic.east)) + " --radius 1000");
    }
}

/// What was left out of the file.
void report_left_out(const RawMap& raw, const SourceMark& mark, std::size_t incomplete,
                     DiagnosticList& warnings) {
    if (raw.bad_locations > 0) {
        warnings.warning(mark, "bad-location",
                         std::to_string(raw.bad_locations) +
                             (raw.bad_locations == 1 ? " node has" : " nodes have") +
                             " no valid coordinates; left out");
    }
    if (!raw.oversized.empty()) {
        const bool one = raw.oversized.size() == 1;
        warnings.warning(
            mark, "oversized-element",
            raw.oversized.front().text() +
                (one ? " is" : " and " + std::to_string(raw.oversized.size() - 1) + " more are") +
                " left out: a way of OpenStreetMap has up to " + std::to_string(kMaxWayNodes) +
                " nodes, a relation " + std::to_string(kMaxMembers) + " members");
    }
    if (!raw.ambiguous.empty()) {
        const bool one = raw.ambiguous.size() == 1;
        warnings.warning(
            mark, "ambiguous-element",
            raw.ambiguous.front().text() +
                (one ? " is" : " and " + std::to_string(raw.ambiguous.size() - 1) + " more are") +
                " in the file more than once, with different contents and the same version; the one with the "
                "most tags, then nodes or members, is taken");
    }
    if (incomplete > 0) {
        warnings.warning(mark, "incomplete-way",
                         std::to_string(incomplete) + (incomplete == 1 ? " way refers" : " ways refer") +
                             " to nodes that the file lacks");
    }
}

Map local_map(RawMap raw, const GeographicBox& box, const SourceMark& mark, DiagnosticList& warnings) {
    const double latitude = 0.5 * (box.south + box.north);
    const double longitude = 0.5 * (box.west + box.east);
    const Projection projection(latitude, longitude);
    Map map;
    set_boxes(box, projection, mark, map);
    map.nodes_read = raw.locations.size();
    const Box near = map.box.grown(kMargin);
    const Projector projector(raw, projection, latitude, longitude);
    for (auto& [id, tags] : raw.nodes) {
        if (const auto at = projector.at(id); at && near.contains(*at)) {
            map.nodes.push_back({id, *at, std::move(tags)});
        }
    }
    std::size_t incomplete = 0;
    for (MapWay& way : raw.ways) {
        projector.place(way);
        if (way.points.empty() || !box_of(way.points).overlaps(near)) {
            continue;
        }
        incomplete += way.complete ? 0 : 1;
        map.ways.push_back(std::move(way));
    }
    map.relations = std::move(raw.relations);
    std::ranges::sort(map.nodes, {}, &MapNode::id);
    std::ranges::sort(map.ways, {}, &MapWay::id);
    std::ranges::sort(map.relations, {}, &MapRelation::id);
    for (std::size_t i = 0; i < map.ways.size(); ++i) {
        map.way_index.emplace(map.ways[i].id, i);
    }
    if (map.nodes.empty() && map.ways.empty()) {
        throw InputError(mark, "bad-size", "nothing of the map lies in the section; check its coordinates");
    }
    report_left_out(raw, mark, incomplete, warnings);
    return map;
}

/// Before a file of gigabytes is read.
void check_size(const GeographicBox& box, const SourceMark& mark) {
    Map ignored;
    set_boxes(box, Projection(0.5 * (box.south + box.north), 0.5 * (box.west + box.east)), mark, ignored);
}

}  // namespace

Map read_map(const std::filesystem::path& file, const SourceMark& mark, const MapSection& section,
             DiagnosticList& warnings) {
    if (const std::string why = why_unreadable(file); !why.empty()) {
        throw InputError(mark, "missing-file", why);
    }
    const std::optional<GeographicBox> chosen = box_of_section(section);
    std::optional<GeographicBox> box = chosen ? chosen : stated_bounds(file, mark);
    if (box) {
        check_size(*box, mark);
    }
    RawMap raw = read_raw_map(file, mark, chosen ? std::optional(with_margin(*chosen)) : std::nullopt);
    box = box ? box : box_of_all(raw);
    return local_map(std::move(raw), *box, mark, warnings);
}

}  // namespace campuswalk::scene::osm
