#include "scene/osm/buildings/volumes.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/geometry/box_index.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kStorey = 3.0;         // metres, where nothing is tagged
constexpr double kMaxHeight = 1'000.0;  // no building on Earth is as high
constexpr double kMaxLength = 5'000.0;  // nor as long

/// What buildings of a kind usually are like.
struct Kind {
    std::string_view value;
    double levels;
};

constexpr std::array<Kind, 31> kKinds = {{
    {"apartments", 4},   {"bungalow", 1}, {"cabin", 1},      {"carport", 1},      {"cathedral", 5},
    {"chapel", 2},       {"church", 4},   {"commercial", 3}, {"construction", 2}, {"detached", 2},
    {"dormitory", 4},    {"farm", 2},     {"garage", 1},     {"garages", 1},      {"greenhouse", 1},
    {"hospital", 4},     {"hotel", 5},    {"house", 2},      {"hut", 1},          {"industrial", 2},
    {"kindergarten", 1}, {"kiosk", 1},    {"office", 4},     {"residential", 3},  {"retail", 2},
    {"roof", 1},         {"school", 3},   {"service", 1},    {"shed", 1},         {"stadium", 4},
    {"university", 4},
}};

double usual_levels(std::string_view kind, double area) {
    constexpr double kLarge = 500.0;  // m²: no house
    const auto* found = std::ranges::find(kKinds, kind, &Kind::value);
    return found != kKinds.end() ? found->levels : area > kLarge ? 3.0 : 2.0;
}

double limited(double height) {
    return std::clamp(height, 0.0, kMaxHeight);
}

/// A number of storeys, such as "building:levels"; what no building has counts as a mistake.
std::optional<double> levels_of(const Tags& tags, const char* key) {
    constexpr double kMost = 200.0;
    const auto levels = number_of(tags, key);
    return levels && *levels >= 0.0 && *levels <= kMost ? levels : std::nullopt;
}

/// Sets heights from tags: height, min_height, roof:height, or levels.
void set_heights(const PlanGeometry& geometry, Volume& volume) {
    const Tags& tags = volume.tags;
    const auto height = length_of(tags, "height");
    const auto levels = levels_of(tags, "building:levels");
    const double min_levels = levels_of(tags, "building:min_level").value_or(0.0);
    // A roof without storeys stands on the ground.
    const bool only_roof = levels && *levels == 0.0 && levels_of(tags, "roof:levels").value_or(0.0) > 0.0;
    const double storeys = levels && (*levels > 0.0 || only_roof)
                               ? *levels
                               : usual_levels(building_kind(tags), area_of(volume.footprint)) + min_levels;
    volume.bottom = limited(length_of(tags, "min_height").value_or(min_levels * kStorey));
    double roof_height = 0.0;
    if (volume.roof.shape != RoofShape::flat) {
        const auto tagged = length_of(tags, "roof:height");
        constexpr double kNoStorey = 1.0;  // metres: a roof under which nobody can stand
        const auto roof_levels = levels_of(tags, "roof:levels");
        const double span = half_span(volume.footprint, volume.roof, geometry);
        const double by_levels =
            roof_levels ? std::max(*roof_levels * kStorey, kNoStorey) : usual_height(volume.roof.shape, span);
        roof_height = tagged ? *tagged : by_levels;
        if (const auto angle = degrees_of(tags, "roof:angle");
            !tagged && angle && *angle > 0 && *angle < 80) {
            const collision::SinCos turn = collision::sin_cos(*angle * kDegree);
            const double run = volume.roof.shape == RoofShape::skillion ? 2.0 * span : span;
            roof_height = run * turn.sin / turn.cos;
        }
        roof_height = limited(roof_height);
    }
    if (height && *height > 0.0) {
        volume.top = limited(*height);
        roof_height = std::min(roof_height, std::max(0.0, volume.top - volume.bottom));
    } else {
        volume.top =
            limited(std::max(storeys * kStorey, volume.bottom + (only_roof ? 0.0 : 0.5)) + roof_height);
    }
    volume.top = std::max(volume.top, volume.bottom + 0.1);
    volume.eaves = std::max(volume.bottom, volume.top - roof_height);
    volume.roof.height = volume.top - volume.eaves;
    if (levels && *levels >= 1.0 && height) {
        volume.storey = std::clamp(volume.eaves / *levels, 2.4, 6.0);
    }
}

void set_roof(const PlanGeometry& geometry, const SourceMark& mark, Volume& volume,
              DiagnosticList& warnings) {
    const std::string_view word = volume.tags.get("roof:shape");
    if (word.empty()) {
        return;
    }
    const std::optional<RoofShape> shape = roof_shape(word);
    volume.roof.shape = shape.value_or(RoofShape::flat);
    const std::string name = volume.id.text();
    if (!shape) {
        warnings.warning(mark, "roof-shape",
                         name + ": roof:shape '" + std::string(word) + "' isn't supported; its roof is flat");
    } else if (!allows(volume.footprint, volume.roof.shape, geometry)) {
        warnings.warning(mark, "roof-shape",
                         name + ": its footprint doesn't allow a " + std::string(word) + " roof; it is flat");
        volume.roof.shape = RoofShape::flat;
    }
    volume.roof.across = volume.tags.is("roof:orientation", "across");
    if (const auto direction = direction_of(volume.tags, "roof:direction")) {
        const collision::SinCos angle = collision::sin_cos(*direction * kDegree);
        volume.roof.directed = true;
        volume.roof.down = {angle.sin, angle.cos};
    }
}

/// Whether tags put a building, or a part of one, below the ground. A layer only orders what is above what:
/// below 0 it counts where neither a height nor storeys are tagged.
bool is_underground(const Tags& tags) {
    if (tags.is("location", "underground")) {
        return true;
    }
    const double levels = levels_of(tags, "building:levels").value_or(0.0);
    if (levels > 0.0 || levels_of(tags, "roof:levels").value_or(0.0) > 0.0 ||
        length_of(tags, "height").value_or(0.0) > 0.0) {
        return false;
    }
    return tags.is("parking", "underground") || number_of(tags, "layer").value_or(0.0) <= -1.0 ||
           number_of(tags, "level").value_or(0.0) < 0.0 ||
           (tags.has("building:levels") &&
            levels_of(tags, "building:levels:underground").value_or(0.0) > 0.0);
}

/// Whether a part is on the roof of its outline, rather than instead of it.
bool is_on_top(const Tags& part, const Tags& outline) {
    const auto roof = length_of(outline, "height");
    const auto levels = levels_of(outline, "building:levels");
    const double top = roof ? *roof : levels ? *levels * kStorey : kMaxHeight;
    const double bottom =
        length_of(part, "min_height").value_or(levels_of(part, "building:min_level").value_or(0.0) * kStorey);
    constexpr double kSame = 0.05;  // metres
    return bottom >= top - kSame;
}

}  // namespace

std::string_view building_kind(const Tags& tags) {
    const std::string_view part = tags.get("building:part");
    const std::string_view kind = tags.get("building");
    return kind.empty() ? part : kind;
}

bool is_roof_on_posts(const Tags& tags) {
    const std::string_view kind = building_kind(tags);
    const std::string_view wall = tags.get("wall");
    return kind == "roof" || kind == "carport" || kind == "canopy" || wall == "no" ||
           (tags.is("amenity", "shelter") && kind.empty());
}

bool is_building(const Tags& tags) {
    return affirmed(tags, "building") && !is_underground(tags);
}

std::vector<Volume> volumes_of(const std::vector<MapArea>& areas, const PlanGeometry& geometry,
                               const Terrain& terrain, const SourceMark& mark, DiagnosticList& warnings) {
    BoxIndex outlines;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (is_building(areas[i].tags)) {
            outlines.add(i, box_of(areas[i].polygons));
        }
    }
    std::map<std::size_t, std::vector<std::size_t>> parts;  // by outline
    std::vector<std::size_t> owner(areas.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        owner[i] = i;
        const Tags& tags = areas[i].tags;
        if (!affirmed(tags, "building:part") || affirmed(tags, "building") || is_underground(tags)) {
            continue;
        }
        double best = 0.0;
        geometry.charge_to(areas[i].id.text());
        for (const std::size_t outline : outlines.near(box_of(areas[i].polygons))) {
            const double shared = area_of(geometry.intersection(areas[i].polygons, areas[outline].polygons));
            if (shared > best + 1e-6) {
                best = shared;
                owner[i] = outline;
            }
        }
        if (best >= 0.5 * area_of(areas[i].polygons)) {
            parts[owner[i]].push_back(i);
        } else {
            owner[i] = i;
        }
    }
    std::vector<Volume> volumes;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const MapArea& area = areas[i];
        const bool part = affirmed(area.tags, "building:part") && !affirmed(area.tags, "building");
        if (!part && !affirmed(area.tags, "building")) {
            continue;
        }
        if (is_underground(area.tags)) {
            warnings.warning(mark, "underground-building",
                             area.id.text() + name_in_parentheses(area.tags) +
                                 " is a building below the ground by its tags; it isn't built. Tag its "
                                 "height or building:levels if it stands above");
            continue;
        }
        if (box_of(area.polygons).size().maxCoeff() > kMaxLength) {
            warnings.warning(mark, "huge-building",
                             area.id.text() + name_in_parentheses(area.tags) +
                                 " is a building of more than 5 km; it isn't built. Correct its nodes");
            continue;
        }
        Volume volume;
        volume.id = area.id;
        volume.building = owner[i];
        volume.node = "building/" + areas[owner[i]].id.text() + (owner[i] == i ? "" : "/" + area.id.text());
        volume.tags = area.tags;
        volume.footprint = area.polygons;
        volume.open = is_roof_on_posts(area.tags);
        if (const auto found = parts.find(i); found != parts.end()) {
            constexpr double kSliver = 0.05;  // of the outline, where parts were drawn imprecisely
            std::vector<const Polygons*> covered;
            for (const std::size_t p : found->second) {
                if (!is_on_top(areas[p].tags, area.tags)) {
                    covered.push_back(&areas[p].polygons);
                }
            }
            geometry.charge_to(volume.node);
            volume.footprint = geometry.difference(volume.footprint, geometry.united(covered));
            if (area_of(volume.footprint) < kSliver * area_of(area.polygons)) {
                continue;
            }
        }
        volume.base = terrain.lowest(areas[owner[i]].polygons);
        geometry.charge_to(volume.node);
        set_roof(geometry, mark, volume, warnings);
        set_heights(geometry, volume);
        for (const char* key : {"building:levels", "building:min_level"}) {
            if (number_of(volume.tags, key) && !levels_of(volume.tags, key)) {
                warnings.warning(mark, "odd-levels",
                                 volume.id.text() + ": no building has " + key + "=" +
                                     std::string(volume.tags.get(key)) + "; it is ignored");
            }
        }
        volumes.push_back(std::move(volume));
    }
    return volumes;
}

}  // namespace campuswalk::scene::osm
