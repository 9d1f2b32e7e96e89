#include "scene/osm/ways/paths.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "scene/osm/geometry/box_index.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/flight_shape.h"
#include "scene/osm/ways/relief.h"

namespace campuswalk::scene::osm {
namespace {

constexpr std::array<Highway, 26> kHighways = {{
    {"footway", 2.0, 80, false},     {"path", 1.6, 79, false},          {"steps", 2.0, 90, false},
    {"pedestrian", 4.0, 76, false},  {"cycleway", 2.0, 78, false},      {"bridleway", 2.0, 60, false},
    {"corridor", 2.0, 80, false},    {"living_street", 5.0, 74, false}, {"service", 3.5, 72, false},
    {"track", 2.5, 71, false},       {"road", 5.0, 84, true},           {"residential", 6.0, 85, true},
    {"unclassified", 6.0, 85, true}, {"tertiary", 7.0, 86, true},       {"tertiary_link", 5.0, 86, true},
    {"secondary", 8.0, 87, true},    {"secondary_link", 5.0, 87, true}, {"primary", 9.0, 88, true},
    {"primary_link", 5.0, 88, true}, {"trunk", 10.0, 89, true},         {"trunk_link", 5.0, 89, true},
    {"motorway", 11.0, 89, true},    {"motorway_link", 5.0, 89, true},  {"busway", 4.0, 86, true},
    {"platform", 2.5, 83, false},    {"bus_guideway", 3.5, 86, true},
}};

bool is_crossing(const Tags& tags) {
    return tags.is("footway", "crossing") || tags.is("path", "crossing") || tags.is("cycleway", "crossing");
}

double width_of(const Tags& tags, const Highway& highway) {
    constexpr double kMin = 0.8;
    constexpr double kMax = 60.0;
    if (const auto width = length_of(tags, "width")) {
        return std::clamp(*width, kMin, kMax);
    }
    constexpr double kLane = 3.0;
    if (const auto lanes = number_of(tags, "lanes"); lanes && highway.carriageway) {
        return std::clamp(*lanes * kLane, kLane, kMax);
    }
    return highway.width;
}

}  // namespace

const Highway* highway_of(const Tags& tags) {
    const auto* found = std::ranges::find(kHighways, tags.get("highway"), &Highway::value);
    return found == kHighways.end() ? nullptr : found;
}

bool is_unbuilt(const Tags& tags) {
    const double level = number_of(tags, "level").value_or(0.0);
    const bool below =
        number_of(tags, "layer").value_or(0.0) < 0.0 || level < 0.0 || tags.is("location", "underground");
    return (level > 0.0 && affirmed(tags, "indoor")) ||
           (below && !tags.is("tunnel", "building_passage") &&
            (affirmed(tags, "tunnel") || affirmed(tags, "indoor") || tags.is("location", "underground")));
}

bool admits_walkers(const Tags& tags) {
    constexpr std::array<std::string_view, 7> kRefusals = {
        "no", "private", "use_sidepath", "military", "forestry", "agricultural", "delivery"};
    const std::string_view value = tags.has("foot") ? tags.get("foot") : tags.get("access");
    return std::ranges::find(kRefusals, value) == kRefusals.end();
}

bool open_to_walkers(const Tags& tags) {
    const std::string_view highway = tags.get("highway");
    if (highway_of(tags) == nullptr) {
        return false;
    }
    const bool for_vehicles = highway.starts_with("motorway") || highway.starts_with("trunk") ||
                              highway == "busway" || highway == "bus_guideway" || tags.is("motorroad", "yes");
    return admits_walkers(tags) && (tags.has("foot") || !for_vehicles);
}

bool is_entrance(const Tags& tags) {
    return affirmed(tags, "entrance") || affirmed(tags, "door") || tags.is("building", "entrance") ||
           tags.is("railway", "subway_entrance");
}

namespace {

/// Tells the floors of buildings from paths on the ground.
class Indoors {
public:
    explicit Indoors(const std::vector<MapArea>& areas) : areas_(areas) {
        for (std::size_t i = 0; i < areas.size(); ++i) {
            if (is_building(areas[i].tags) && !is_roof_on_posts(areas[i].tags)) {
                buildings_.add(i, box_of(areas[i].polygons));
            }
        }
    }

    /// Tagged as indoors or on another layer or level, and for the most part inside of a building. What leads
    /// through one at the ground, from outside to outside, is a passage, and what is tagged as one.
    bool has(const MapWay& way) const {
        const Tags& tags = way.tags;
        const std::optional<double> level = number_of(tags, "level");
        const double layer = number_of(tags, "layer").value_or(0.0);
        const bool indoor = affirmed(tags, "indoor") || tags.is("highway", "corridor");
        const bool on_floors = level && !tags.is("level", "0");  // "0;1" is two of them
        if ((!indoor && !on_floors && layer == 0.0) || affirmed(tags, "bridge") ||
            tags.is("tunnel", "building_passage")) {
            return false;
        }
        const bool above = level.value_or(0.0) > 0.0 || layer > 0.0;
        for (const std::size_t i : buildings_.near(box_of(way.points))) {
            const Polygons& outline = areas_[i].polygons;
            if (2.0 * length_inside(way.points, outline) > length_of(way.points) &&
                (above || is_deep_in(outline, way.points.front()) ||
                 is_deep_in(outline, way.points.back()))) {
                return true;
            }
        }
        return false;
    }

private:
    /// Inside and not at the wall.
    static bool is_deep_in(const Polygons& outline, const Point& p) {
        constexpr double kAtWall = 0.5;  // metres
        return contains(outline, p) && nearest_on(outline, p).distance > kAtWall;
    }

    const std::vector<MapArea>& areas_;
    BoxIndex buildings_;
};

}  // namespace

std::vector<Path> paths_of(const Map& map, const std::vector<MapArea>& areas, const Box& ground,
                           const PlanGeometry& geometry) {
    const Indoors indoors(areas);
    std::unordered_set<std::int64_t> entrances;
    for (const MapNode& node : map.nodes) {
        if (is_entrance(node.tags)) {
            entrances.insert(node.id);
        }
    }
    std::vector<Path> paths;
    for (const MapWay& way : map.ways) {
        const Highway* highway = highway_of(way.tags);
        if (highway == nullptr || way.points.size() < 2 || !box_of(way.points).overlaps(map.box) ||
            way.tags.is("area", "yes")) {
            continue;
        }
        Path path;
        path.way = &way;
        path.highway = highway->value;
        path.width = width_of(way.tags, *highway);
        path.carriageway = highway->carriageway;
        path.for_walkers = open_to_walkers(way.tags);
        path.priority = highway->priority;
        path.crossing = is_crossing(way.tags);
        path.indoors = indoors.has(way);
        path.unbuilt = path.indoors || is_unbuilt(way.tags);
        path.steps = highway->value == "steps";
        path.leaves_ground =
            path.steps && !(ground.contains(way.points.front()) && ground.contains(way.points.back()));
        path.from_entrance =
            path.steps && entrances.contains(way.nodes.front()) && !entrances.contains(way.nodes.back());
        if (!path.unbuilt) {
            geometry.charge_to(ElementId{ElementKind::way, way.id}.text());
            path.area = path.steps ? geometry.polygon(outline_of_steps(path))
                                   : geometry.buffer(way.points, 0.5 * path.width, Caps::round);
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

std::vector<Passage> passages_of(const std::vector<Path>& paths, const PlanGeometry& geometry) {
    constexpr double kRoom = 0.5;  // metres on either side
    constexpr double kLeastWidth = 2.4;
    constexpr double kNarrowest = 0.3;  // that is tagged
    constexpr double kLowest = 0.5;
    constexpr double kHighest = 8.0;
    std::vector<Passage> passages;
    for (const Path& path : paths) {
        if (path.unbuilt || path.steps) {
            continue;
        }
        const bool road = path.carriageway || path.highway == "service";
        const Tags& tags = path.way->tags;
        const auto tagged_height = length_of(tags, "maxheight");
        const double height = tagged_height.value_or(length_of(tags, "height").value_or(road ? 3.8 : 2.7));
        const auto tagged_width = length_of(tags, "width");
        const double width = tagged_width ? std::max(kNarrowest, *tagged_width)
                                          : std::max(kLeastWidth, path.width + 2.0 * kRoom);
        Passage passage;
        passage.way = path.way;
        passage.tagged = affirmed(tags, "tunnel") || affirmed(tags, "covered") || affirmed(tags, "indoor");
        passage.for_walkers = path.for_walkers;
        geometry.charge_to(ElementId{ElementKind::way, path.way->id}.text());
        passage.area = geometry.buffer(path.way->points, 0.5 * width, Caps::square);
        passage.height = std::clamp(height, kLowest, kHighest);
        if (path.is_above()) {
            const auto [low, high] = std::ranges::minmax(path.deck);
            passage.floor = low;
            passage.height += high - low;
        }
        passages.push_back(std::move(passage));
    }
    return passages;
}

}  // namespace campuswalk::scene::osm
