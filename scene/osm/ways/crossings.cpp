#include "scene/osm/ways/crossings.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/path_nodes.h"
#include "scene/osm/ways/surfaces.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kMarks = {{226, 226, 220}, 220, 255};
constexpr Look kIsland = {{172, 168, 160}, 235, 255};
constexpr int kMarksPriority = 95;
constexpr int kIslandPriority = 96;

enum class Markings { none, stripes, lines, both };

Markings markings_in(const Tags& tags) {
    const std::string_view markings = tags.get("crossing:markings");
    if (!markings.empty()) {
        return markings == "yes" || markings.starts_with("zebra")                  ? Markings::stripes
               : markings.starts_with("ladder")                                    ? Markings::both
               : markings == "lines" || markings == "dashes" || markings == "dots" ? Markings::lines
                                                                                   : Markings::none;
    }
    const std::string_view crossing = tags.get("crossing");
    if (tags.is("crossing_ref", "zebra") || crossing == "zebra" || crossing == "marked" ||
        crossing == "uncontrolled") {
        return Markings::stripes;
    }
    return crossing == "traffic_signals" ? Markings::lines : Markings::none;
}

bool has_island(const Tags& tags) {
    return affirmed(tags, "crossing:island") || tags.is("crossing", "island") ||
           tags.is("traffic_calming", "island");
}

/// Where a path crosses a carriageway.
struct Crossing {
    ElementId id;
    const Path* road = nullptr;
    Point at = Point::Zero();
    Point along = Point(1, 0);   ///< unit: of the carriageway
    Point across = Point(0, 1);  ///< unit: of the path that crosses
    double width = 3.5;          ///< of the path, metres
    Markings markings = Markings::none;
    bool island = false;
};

Polygon parallelogram(const Point& center, const Point& u, const Point& v) {
    Ring ring = {center - u - v, center + u - v, center + u + v, center - u + v};
    if (signed_area(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return {std::move(ring), {}};
}

class CrossingFinder {
public:
    CrossingFinder(const Map& map, const std::vector<Path>& paths) {
        for (const MapNode& node : map.nodes) {
            if (node.tags.is("highway", "crossing") || node.tags.has("crossing")) {
                nodes_.emplace(node.id, &node);
            }
        }
        for (const Path& path : paths) {
            for (std::size_t i = 0; path.carriageway && path.on_ground() && i < path.way->nodes.size(); ++i) {
                roads_.try_emplace(path.way->nodes[i], &path, i);
            }
        }
        for (const Path& path : paths) {
            if (path.crossing && path.on_ground()) {
                add_path(path);
            }
        }
        for (const MapNode& node : map.nodes) {
            const auto road = roads_.find(node.id);
            if (node.tags.is("highway", "crossing") && road != roads_.end() && !done_.contains(node.id)) {
                add_node(node, *road->second.first, road->second.second);
            }
        }
    }

    const std::vector<Crossing>& found() const { return found_; }

private:
    void add_path(const Path& path) {
        constexpr double kMin = 2.0;
        constexpr double kMax = 10.0;
        for (std::size_t i = 0; i < path.way->nodes.size(); ++i) {
            const std::int64_t node = path.way->nodes[i];
            const auto road = roads_.find(node);
            if (road == roads_.end() || road->second.first == &path) {
                continue;
            }
            const auto tagged = nodes_.find(node);
            const Tags none;
            const Tags& node_tags = tagged == nodes_.end() ? none : tagged->second->tags;
            Crossing crossing;
            crossing.id = {ElementKind::way, path.way->id};
            crossing.road = road->second.first;
            crossing.at = path.way->points[i];
            crossing.along = direction_at(crossing.road->way->points, road->second.second);
            crossing.across = direction_at(path.way->points, i);
            crossing.width =
                std::clamp(length_of(path.way->tags, "width").value_or(crossing.width), kMin, kMax);
            crossing.markings = markings_in(path.way->tags);
            if (crossing.markings == Markings::none && !path.way->tags.has("crossing:markings") &&
                !path.way->tags.has("crossing")) {
                crossing.markings = markings_in(node_tags);
            }
            crossing.island = has_island(path.way->tags) || has_island(node_tags);
            done_.insert(node);
            found_.push_back(crossing);
        }
    }

    void add_node(const MapNode& node, const Path& road, std::size_t place) {
        Crossing crossing;
        crossing.id = {ElementKind::node, node.id};
        crossing.road = &road;
        crossing.at = node.at;
        crossing.along = direction_at(road.way->points, place);
        crossing.across = left_of(crossing.along);
        crossing.markings = markings_in(node.tags);
        crossing.island = has_island(node.tags);
        found_.push_back(crossing);
    }

    std::unordered_map<std::int64_t, const MapNode*> nodes_;
    std::unordered_map<std::int64_t, std::pair<const Path*, std::size_t>> roads_;
    std::unordered_set<std::int64_t> done_;
    std::vector<Crossing> found_;
};

/// How far one goes across the carriageway on the crossing path for a metre straight across.
Point step_across(const Crossing& crossing) {
    constexpr double kLeastAngle = 0.5;  // of its cosine: paths that run along the road are drawn straight
    const Point straight = left_of(crossing.along);
    const double cosine = crossing.across.dot(straight);
    return std::abs(cosine) < kLeastAngle ? straight : Point(crossing.across / cosine);
}

/// Bars along the carriageway, half a metre wide and half a metre apart.
Polygons stripes_of(const Crossing& crossing) {
    constexpr double kBar = 0.5;
    const Point across = step_across(crossing);
    const int count = std::max(1, static_cast<int>((crossing.road->width - kBar) / (2.0 * kBar)));
    Polygons bars;
    for (int i = 0; i < count; ++i) {
        const double offset = 2.0 * kBar * (i - 0.5 * (count - 1));
        bars.push_back(parallelogram(crossing.at + offset * across, 0.5 * crossing.width * crossing.along,
                                     0.5 * kBar * left_of(crossing.along)));
    }
    return bars;
}

/// A line on either side.
Polygons lines_of(const Crossing& crossing) {
    constexpr double kLine = 0.2;
    Polygons lines;
    for (const double side : {0.5, -0.5}) {
        lines.push_back(parallelogram(crossing.at + side * crossing.width * crossing.along,
                                      0.5 * kLine * crossing.along,
                                      0.5 * crossing.road->width * step_across(crossing)));
    }
    return lines;
}

/// Two islands in the middle of the carriageway, between which one crosses.
Polygons islands_of(const Crossing& crossing) {
    constexpr double kLength = 2.4;
    constexpr double kBreadth = 1.5;
    Polygons islands;
    for (const double side : {1.0, -1.0}) {
        islands.push_back(
            parallelogram(crossing.at + side * 0.5 * (crossing.width + kLength) * crossing.along,
                          0.5 * kLength * crossing.along, 0.5 * kBreadth * left_of(crossing.along)));
    }
    return islands;
}

}  // namespace

std::vector<Surface> crossing_surfaces(const Map& map, const std::vector<Path>& paths,
                                       const PlanGeometry& geometry) {
    constexpr double kLeastForIsland = 5.5;  // metres of carriageway
    std::vector<Surface> surfaces;
    const CrossingFinder finder(map, paths);
    for (const Crossing& crossing : finder.found()) {
        Polygons marks;
        if (crossing.markings == Markings::stripes || crossing.markings == Markings::both) {
            marks = stripes_of(crossing);
        }
        if (crossing.markings == Markings::lines || crossing.markings == Markings::both) {
            const Polygons lines = lines_of(crossing);
            marks.insert(marks.end(), lines.begin(), lines.end());
        }
        const std::string id = crossing.id.text();
        if (!marks.empty()) {
            surfaces.push_back({"crossing/" + id,
                                geometry.intersection(geometry.united({&marks}), crossing.road->area), kMarks,
                                kMarksPriority, -kKerb});
        }
        if (crossing.island && crossing.road->width >= kLeastForIsland) {
            const Polygons islands = islands_of(crossing);
            surfaces.push_back({"island/" + id, geometry.intersection(islands, crossing.road->area), kIsland,
                                kIslandPriority, 0.0});
        }
    }
    return surfaces;
}

}  // namespace campuswalk::scene::osm
