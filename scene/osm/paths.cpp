#include "scene/osm/paths.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "scene/osm/steps.h"
#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// A value of "highway": how wide it usually is, and what covers what.
struct Highway {
    std::string_view value;
    double width;  ///< metres
    int priority;
    bool carriageway;  ///< between kerbs
};

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

const Highway* highway_of(const Tags& tags) {
    const auto* found = std::ranges::find(kHighways, tags.get("highway"), &Highway::value);
    return found == kHighways.end() ? nullptr : found;
}

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

bool is_underground(const Tags& tags) {
    const bool below = number_of(tags, "layer").value_or(0.0) < 0.0 ||
                       number_of(tags, "level").value_or(0.0) < 0.0 || tags.is("location", "underground");
    return below && !tags.is("tunnel", "building_passage") &&
           (affirmed(tags, "tunnel") || affirmed(tags, "indoor") || tags.is("location", "underground"));
}

// Looks.

constexpr Look kAsphalt = {{98, 98, 102}, 235, 255};
constexpr Look kPaving = {{182, 174, 160}, 230, 255};
constexpr Look kFootAsphalt = {{136, 134, 132}, 235, 255};
constexpr Look kCrossing = {{196, 196, 192}, 220, 255};
constexpr Look kSteps = {{170, 166, 158}, 230, 255};

struct SurfaceColor {
    std::string_view value;
    Color color;
};

constexpr std::array<SurfaceColor, 20> kSurfaceColors = {{
    {"asphalt", {120, 120, 122}},     {"artificial_turf", {84, 140, 80}},
    {"cobblestone", {148, 142, 134}}, {"compacted", {186, 172, 144}},
    {"concrete", {176, 174, 168}},    {"concrete:plates", {180, 178, 172}},
    {"decoturf", {70, 110, 130}},     {"dirt", {148, 122, 92}},
    {"fine_gravel", {192, 180, 156}}, {"grass", {112, 150, 84}},
    {"grass_paver", {134, 150, 112}}, {"gravel", {176, 168, 152}},
    {"ground", {146, 126, 98}},       {"metal", {150, 154, 158}},
    {"paved", {160, 158, 154}},       {"paving_stones", {184, 172, 156}},
    {"sand", {214, 198, 158}},        {"sett", {150, 144, 136}},
    {"unpaved", {172, 154, 124}},     {"wood", {158, 122, 84}},
}};

void apply_surface(const Tags& tags, Look& look) {
    const auto* found = std::ranges::find(kSurfaceColors, tags.get("surface"), &SurfaceColor::value);
    if (found != kSurfaceColors.end()) {
        look.color = found->color;
    }
}

Look look_of(const Tags& tags, const Highway& highway) {
    Look look = highway.carriageway          ? kAsphalt
                : highway.value == "steps"   ? kSteps
                : highway.value == "service" ? Look{{116, 116, 118}, 235, 255}
                : highway.value == "pedestrian" || highway.value == "living_street" ? kPaving
                                                                                    : kFootAsphalt;
    if (highway.value == "cycleway") {
        look.color = {150, 104, 96};
    }
    if (highway.value == "path" || highway.value == "track") {
        look.color = {182, 164, 130};
    }
    apply_surface(tags, look);
    if (highway.carriageway && tags.is("surface", "asphalt")) {
        look = kAsphalt;
    }
    return is_crossing(tags) ? kCrossing : look;
}

/// What areas are covered with, the most specific first.
struct Cover {
    std::string_view key;
    std::string_view value;
    Color color;
    int priority;
};

constexpr std::array<Cover, 38> kCovers = {{
    {"natural", "water", {86, 126, 152}, 66},
    {"waterway", "riverbank", {86, 126, 152}, 66},
    {"leisure", "swimming_pool", {92, 170, 196}, 66},
    {"amenity", "fountain", {110, 158, 180}, 66},
    {"landuse", "basin", {86, 126, 152}, 66},
    {"landuse", "reservoir", {86, 126, 152}, 66},
    {"public_transport", "platform", {174, 170, 162}, 83},
    {"highway", "platform", {174, 170, 162}, 83},
    {"leisure", "pitch", {96, 146, 88}, 58},
    {"leisure", "track", {170, 92, 76}, 57},
    {"leisure", "playground", {206, 180, 128}, 56},
    {"amenity", "parking", {130, 130, 132}, 55},
    {"amenity", "bicycle_parking", {150, 150, 150}, 55},
    {"landuse", "flowerbed", {168, 120, 120}, 48},
    {"natural", "scrub", {104, 136, 76}, 46},
    {"natural", "wood", {92, 124, 70}, 45},
    {"landuse", "forest", {92, 124, 70}, 45},
    {"natural", "sand", {218, 204, 166}, 45},
    {"leisure", "garden", {120, 156, 90}, 44},
    {"landuse", "grass", {116, 154, 86}, 43},
    {"natural", "grassland", {120, 152, 90}, 43},
    {"landuse", "meadow", {126, 154, 92}, 42},
    {"landuse", "village_green", {116, 154, 86}, 42},
    {"landuse", "recreation_ground", {120, 152, 88}, 41},
    {"landuse", "allotments", {128, 146, 92}, 41},
    {"leisure", "park", {124, 154, 92}, 40},
    {"landuse", "cemetery", {126, 148, 100}, 40},
    {"landuse", "construction", {170, 154, 128}, 39},
    {"landuse", "brownfield", {160, 146, 120}, 39},
    {"leisure", "sports_centre", {140, 154, 112}, 34},
    {"amenity", "university", {156, 158, 134}, 30},
    {"amenity", "college", {156, 158, 134}, 30},
    {"amenity", "school", {158, 158, 136}, 30},
    {"amenity", "hospital", {160, 158, 140}, 30},
    {"landuse", "residential", {150, 150, 128}, 20},
    {"landuse", "commercial", {154, 152, 136}, 20},
    {"landuse", "retail", {156, 152, 138}, 20},
    {"landuse", "industrial", {152, 150, 140}, 20},
}};

std::string word_of(std::string_view value) {
    std::string word(value);
    std::ranges::replace_if(
        word, [](char c) { return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')); }, '-');
    return word;
}

std::optional<Surface> surface_of(const MapArea& area) {
    const Tags& tags = area.tags;
    if (const Highway* highway = highway_of(tags); highway != nullptr && tags.is("area", "yes")) {
        if (is_underground(tags)) {
            return std::nullopt;
        }
        return Surface{word_of(highway->value) + "/" + area.id.text(),
                       area.polygons,
                       look_of(tags, *highway),
                       62,
                       0.0,
                       false,
                       false};
    }
    if (affirmed(tags, "building") || affirmed(tags, "building:part") || is_underground(tags) ||
        number_of(tags, "layer").value_or(0.0) != 0.0 || tags.is("parking", "underground") ||
        tags.is("parking", "multi-storey")) {
        return std::nullopt;
    }
    const auto* cover =
        std::ranges::find_if(kCovers, [&](const Cover& known) { return tags.is(known.key, known.value); });
    if (cover == kCovers.end()) {
        return std::nullopt;
    }
    constexpr double kWaterDepth = 1.2;
    const bool water = cover->priority == 66;
    Look look{cover->color, static_cast<std::uint8_t>(water ? 40 : 245),
              static_cast<std::uint8_t>(water ? 190 : 255)};
    if (!water) {
        apply_surface(tags, look);
    }
    return Surface{word_of(cover->value) + "/" + area.id.text(),
                   area.polygons,
                   look,
                   cover->priority,
                   water ? -kWaterDepth : 0.0,
                   false,
                   water};
}

}  // namespace

bool open_to_walkers(const Tags& tags) {
    const std::string_view highway = tags.get("highway");
    if (highway == "construction" || highway == "proposed" || highway_of(tags) == nullptr) {
        return false;
    }
    const auto refuses = [](std::string_view value) {
        return value == "no" || value == "private" || value == "use_sidepath";
    };
    if (tags.has("foot")) {
        return !refuses(tags.get("foot"));
    }
    return !refuses(tags.get("access")) && !highway.starts_with("motorway") &&
           !highway.starts_with("trunk") && highway != "busway" && highway != "bus_guideway";
}

std::vector<Path> paths_of(const Map& map, const PlanGeometry& geometry) {
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
        path.underground = is_underground(way.tags);
        path.steps = highway->value == "steps";
        if (!path.underground) {
            path.area = path.steps ? geometry.polygon(outline_of_steps(path))
                                   : geometry.buffer(way.points, 0.5 * path.width, Caps::round);
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

std::vector<Surface> surfaces_of(const std::vector<Path>& paths, const std::vector<MapArea>& areas,
                                 const PlanGeometry& geometry, const Terrain& terrain) {
    constexpr double kKerb = 0.12;  // metres
    std::vector<Surface> surfaces;
    for (const Path& path : paths) {
        if (!path.on_ground()) {
            continue;
        }
        const Highway& highway = *highway_of(path.way->tags);
        const bool crossing = is_crossing(path.way->tags);
        const bool treads = has_treads(path, terrain);
        surfaces.push_back({word_of(crossing ? "crossing" : highway.value) + "/way-" +
                                ElementId{ElementKind::way, path.way->id}.text().substr(4),
                            treads ? geometry.polygon(outline_of_treads(path, terrain)) : path.area,
                            look_of(path.way->tags, highway), crossing ? 70 : highway.priority,
                            highway.carriageway ? -kKerb : 0.0, treads, false});
    }
    for (const MapArea& area : areas) {
        if (auto surface = surface_of(area)) {
            surfaces.push_back(std::move(*surface));
        }
    }
    return surfaces;
}

std::vector<Passage> passages_of(const std::vector<Path>& paths, const PlanGeometry& geometry) {
    constexpr double kRoom = 0.5;  // metres on either side
    constexpr double kLeastWidth = 2.4;
    std::vector<Passage> passages;
    for (const Path& path : paths) {
        if (path.underground || path.steps) {
            continue;
        }
        const bool road = path.carriageway || path.highway == "service";
        const double height = length_of(path.way->tags, "maxheight").value_or(road ? 3.8 : 2.7);
        const double width = std::max(kLeastWidth, path.width + 2.0 * kRoom);
        const Tags& tags = path.way->tags;
        Passage passage;
        passage.way = path.way;
        passage.tagged = affirmed(tags, "tunnel") || affirmed(tags, "covered") || affirmed(tags, "indoor");
        passage.for_walkers = path.for_walkers;
        passage.area = geometry.buffer(path.way->points, 0.5 * width, Caps::square);
        passage.height = std::clamp(height, 2.2, 8.0);
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
