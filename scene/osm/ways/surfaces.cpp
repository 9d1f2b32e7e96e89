#include "scene/osm/ways/surfaces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "scene/base/ascii.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/crossings.h"
#include "scene/osm/ways/flight_shape.h"
#include "scene/osm/ways/kerbs.h"

namespace campuswalk::scene::osm {

namespace {

constexpr Look kSlabs = {{176, 170, 160}, 235, 255};
constexpr double kUsualWidth = 1.8;  // metres

bool is_there(std::string_view value) {
    return value == "yes";  // "separate" is a path of its own
}

/// The width of the sidewalk on a side, "left" or "right"; nullopt if there is none.
std::optional<double> width_on(const Tags& tags, const std::string& side) {
    const std::string_view value = tags.get("sidewalk");
    const bool there = value == side || value == "both" || value == "yes" ||
                       is_there(tags.get("sidewalk:" + side)) || is_there(tags.get("sidewalk:both"));
    if (!there || tags.is("sidewalk:" + side, "no") || tags.is("sidewalk:" + side, "separate")) {
        return std::nullopt;
    }
    for (const std::string& key :
         {"sidewalk:" + side + ":width", std::string("sidewalk:both:width"), std::string("sidewalk:width")}) {
        if (const auto width = length_of(tags, key)) {
            return std::clamp(*width, 0.5, 20.0);
        }
    }
    return kUsualWidth;
}

/// Strips beside carriageways, by "sidewalk" and "sidewalk:left", "sidewalk:right" and "sidewalk:both"
/// (wiki.openstreetmap.org/wiki/Key:sidewalk), of "sidewalk:width" or 1.8 m.
std::vector<Surface> sidewalks_of(const std::vector<Path>& paths, const PlanGeometry& geometry) {
    constexpr int kPriority = 81;  // above paths, below what they lead to
    std::vector<Surface> sidewalks;
    for (const Path& path : paths) {
        if (!path.carriageway || !path.on_ground()) {
            continue;
        }
        for (const char* side : {"left", "right"}) {
            const auto width = width_on(path.way->tags, side);
            if (!width) {
                continue;
            }
            std::vector<Point> line = path.way->points;
            if (*side == 'r') {
                std::ranges::reverse(line);
            }
            sidewalks.push_back({"sidewalk/" + ElementId{ElementKind::way, path.way->id}.text(),
                                 geometry.left_side(line, 0.5 * path.width + *width), kSlabs, kPriority});
        }
    }
    return sidewalks;
}

// Looks.

constexpr Look kAsphalt = {{98, 98, 102}, 235, 255};
constexpr Look kPaving = {{182, 174, 160}, 230, 255};
constexpr Look kFootAsphalt = {{136, 134, 132}, 235, 255};
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
    return look;
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
        word, [](char c) { return !is_lower(c) && !is_digit(c); }, '-');
    return word;
}

std::optional<Surface> surface_of(const MapArea& area) {
    const Tags& tags = area.tags;
    const bool is_area = tags.is("area", "yes") || area.id.kind == ElementKind::relation;
    if (const Highway* highway = highway_of(tags); highway != nullptr && is_area) {
        if (is_unbuilt(tags)) {
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
    if (affirmed(tags, "building") || affirmed(tags, "building:part") || is_unbuilt(tags) ||
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
    // Not "fountain", as things at nodes are called.
    const std::string_view word = cover->value == "fountain" ? "basin" : cover->value;
    return Surface{word_of(word) + "/" + area.id.text(), area.polygons, look, cover->priority,
                   water ? -kWaterDepth : 0.0,           false,         water};
}

}  // namespace

std::vector<Surface> surfaces_of(const Map& map, const std::vector<Path>& paths,
                                 const std::vector<MapArea>& areas, const PlanGeometry& geometry,
                                 const Terrain& terrain) {
    std::vector<Surface> surfaces;
    for (const Path& path : paths) {
        if (!path.on_ground()) {
            continue;
        }
        const bool treads = has_treads(path, terrain);
        const Look look = path.crossing ? kFootAsphalt : look_of(path.way->tags, *highway_of(path.way->tags));
        surfaces.push_back({word_of(path.crossing ? "crossing" : path.highway) + "/" +
                                ElementId{ElementKind::way, path.way->id}.text(),
                            treads ? geometry.polygon(outline_of_treads(path, terrain)) : path.area, look,
                            path.priority, path.carriageway ? -kKerb : 0.0, treads, false});
    }
    for (std::vector<Surface>& more : std::vector{crossing_surfaces(map, paths, geometry),
                                                  kerb_ramps(map, paths), sidewalks_of(paths, geometry)}) {
        std::ranges::move(more, std::back_inserter(surfaces));
    }
    for (const MapArea& area : areas) {
        if (auto surface = surface_of(area)) {
            surfaces.push_back(std::move(*surface));
        }
    }
    return surfaces;
}

}  // namespace campuswalk::scene::osm
