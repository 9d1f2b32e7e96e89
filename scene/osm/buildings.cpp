#include "scene/osm/buildings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/box_index.h"
#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kStorey = 3.0;         // metres, where nothing is tagged
constexpr double kMaxHeight = 1'000.0;  // no building on Earth is as high

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

std::string_view kind_of(const Tags& tags) {
    const std::string_view part = tags.get("building:part");
    const std::string_view kind = tags.get("building");
    return kind.empty() ? part : kind;
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
                               : usual_levels(kind_of(tags), area_of(volume.footprint)) + min_levels;
    volume.bottom = limited(length_of(tags, "min_height").value_or(min_levels * kStorey));
    double roof_height = 0.0;
    if (volume.roof.shape != RoofShape::flat) {
        const auto tagged = length_of(tags, "roof:height");
        const auto roof_levels = levels_of(tags, "roof:levels");
        const double span = half_span(volume.footprint, volume.roof, geometry);
        const double usual = volume.roof.shape == RoofShape::dome || volume.roof.shape == RoofShape::onion
                                 ? (volume.roof.shape == RoofShape::dome ? span : 2.5 * span)
                                 : std::min(0.6 * span, 6.0);
        roof_height = tagged ? *tagged : roof_levels ? *roof_levels * kStorey : usual;
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
    bool known = false;
    volume.roof.shape = roof_shape(word, known);
    const std::string name = volume.id.text();
    if (!known) {
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

bool is_open(const Tags& tags) {
    const std::string_view kind = kind_of(tags);
    const std::string_view wall = tags.get("wall");
    return kind == "roof" || kind == "carport" || kind == "canopy" || wall == "no" ||
           (tags.is("amenity", "shelter") && kind.empty());
}

// What surfaces look like.

constexpr std::array<Color, 6> kPlaster = {
    {{226, 216, 196}, {214, 206, 190}, {204, 190, 166}, {220, 204, 176}, {198, 196, 190}, {208, 184, 160}}};
constexpr std::array<Color, 4> kBrick = {{{160, 92, 72}, {172, 108, 84}, {146, 84, 68}, {182, 130, 104}}};
constexpr std::array<Color, 3> kTiles = {{{150, 80, 62}, {138, 76, 60}, {122, 74, 64}}};

template <std::size_t Count>
Color chosen(const std::array<Color, Count>& colors, const ElementId& id) {
    // Spread over the numbers, which are dense.
    const auto number = static_cast<std::uint64_t>(id.number) * 0x9E3779B97F4A7C15ULL;
    return colors[(number >> 32U) % Count];
}

Look wall_look(const Volume& volume) {
    const std::string_view kind = kind_of(volume.tags);
    Look look{chosen(kPlaster, volume.id), 235, 255};
    if (kind == "house" || kind == "school" || kind == "dormitory" || kind == "industrial") {
        look.color = chosen(kBrick, volume.id);
    } else if (kind == "garage" || kind == "garages" || kind == "service" || kind == "shed") {
        look.color = {170, 166, 158};
    }
    if (const auto material = material_color(volume.tags.get("building:material"))) {
        look.color = *material;
    }
    if (const auto color = color_of(volume.tags, "building:colour", "building:color")) {
        look.color = *color;
    }
    return look;
}

Look roof_look(const Volume& volume) {
    Look look{{142, 140, 136}, 240, 255};
    if (volume.roof.shape == RoofShape::dome || volume.roof.shape == RoofShape::onion) {
        look.color = {110, 150, 134};
    } else if (volume.roof.shape != RoofShape::flat) {
        look.color = chosen(kTiles, volume.id);
    }
    if (const auto material = material_color(volume.tags.get("roof:material"))) {
        look.color = *material;
    }
    if (const auto color = color_of(volume.tags, "roof:colour", "roof:color")) {
        look.color = *color;
    }
    return look;
}

bool has_windows(const Volume& volume) {
    const std::string_view kind = kind_of(volume.tags);
    return kind != "garage" && kind != "garages" && kind != "shed" && kind != "service" &&
           kind != "carport" && kind != "roof" && !affirmed(volume.tags, "bridge:support") &&
           !volume.tags.is("building:part", "steps") && !volume.tags.is("window", "no");
}

constexpr Look kGlass = {{74, 92, 108}, 60, 255};

/// A level's windows, from and to such a height above its floor.
constexpr double kSill = 0.9;
constexpr double kLintel = 0.7;     // below the next floor
constexpr double kPier = 0.6;       // metres of wall beside windows, at a wall's ends
constexpr double kBay = 3.0;        // from window to window, about
constexpr double kLeastWall = 2.4;  // of a wall with windows

/// Upright strips of a facade.
class Facade {
public:
    Facade(const Volume& volume, const Look& wall, ObjectMesh& mesh)
        : volume_(volume), wall_(wall), mesh_(mesh), windows_(has_windows(volume)) {}

    void add(const Polygons& polygons, double bottom, double top) const {
        for (const Polygon& polygon : polygons) {
            add_ring(polygon.outer, bottom, top);
            for (const Ring& hole : polygon.holes) {
                add_ring(hole, bottom, top);
            }
        }
    }

private:
    void add_ring(const Ring& ring, double bottom, double top) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            add_wall(ring[i], ring[(i + 1) % ring.size()], bottom, top);
        }
    }

    void add_wall(const Point& a, const Point& b, double bottom, double top) const {
        const Point d = b - a;
        const double length = norm(d);
        if (!windows_ || length < kLeastWall) {
            mesh_.wall(wall_, a, b, bottom, top);
            return;
        }
        double done = bottom;
        const double eaves = volume_.base + volume_.eaves;
        for (double floor = volume_.base + first_floor(); floor + volume_.storey <= eaves + 0.3;
             floor += volume_.storey) {
            const double low = floor + kSill;
            const double high = std::min(floor + volume_.storey - kLintel, eaves - 0.3);
            if (low < done || high > top || high - low < 0.4) {
                continue;
            }
            mesh_.wall(wall_, a, b, done, low);
            add_windows(a, b, length, low, high);
            done = high;
        }
        mesh_.wall(wall_, a, b, done, top);
    }

    /// Windows of equal width between piers.
    void add_windows(const Point& a, const Point& b, double length, double low, double high) const {
        const int count = std::max(1, static_cast<int>((length - kPier) / kBay));
        const double bay = (length - kPier) / count;
        const Point along = (b - a) / length;
        Point done = a;
        for (int i = 0; i < count; ++i) {
            const Point left = a + (kPier + i * bay) * along;
            const Point right = a + (i + 1) * bay * along;
            mesh_.wall(wall_, done, left, low, high);
            mesh_.wall(kGlass, left, right, low, high);
            done = right;
        }
        mesh_.wall(wall_, done, b, low, high);
    }

    /// Of parts above others, their own lowest level.
    double first_floor() const { return std::floor(volume_.bottom / volume_.storey) * volume_.storey; }

    const Volume& volume_;
    Look wall_;
    ObjectMesh& mesh_;
    bool windows_;
};

void add_ceiling(const Look& look, const Polygons& area, double height, const PlanGeometry& geometry,
                 ObjectMesh& mesh) {
    for (const Polygon& polygon : area) {
        mesh.ceiling(look, geometry.triangulated(polygon), height);
    }
}

/// A slab on posts at its vertices.
void add_open_roof(const Volume& volume, const PlanGeometry& geometry, const Terrain& terrain,
                   ObjectMesh& mesh) {
    constexpr double kSlab = 0.25;
    constexpr double kPost = 0.1;
    constexpr double kInset = 0.4;
    const Look look = roof_look(volume);
    const double eaves = volume.base + volume.eaves;
    const double under = eaves - std::min(kSlab, 0.5 * volume.eaves);
    mesh.walls(look, volume.footprint, under, eaves);
    add_ceiling(look, volume.footprint, under, geometry, mesh);
    add_roof(volume.footprint, volume.roof, eaves, look, look, geometry, mesh);
    const Polygons inner = geometry.grown(volume.footprint, -kInset);
    for (const Polygon& polygon : inner) {
        for (const Point& p : polygon.outer) {
            mesh.box({{120, 120, 122}, 200, 255}, p, Point(1, 0), Point(kPost, kPost), terrain.height(p),
                     under);
        }
    }
}

/// Where paths lead through a volume.
struct Opening {
    const Polygons* area = nullptr;
    double bottom = 0.0;
    double top = 0.0;
};

std::vector<Opening> openings_of(const Volume& volume, const std::vector<const Passage*>& passages,
                                 const PlanGeometry& geometry, const Terrain& terrain) {
    constexpr double kSlab = 0.3;  // that stays below the roof
    constexpr double kHeadroom = 2.2;
    const double bottom = volume.base + volume.bottom;
    const double eaves = volume.base + volume.eaves;
    const double highest = eaves - kSlab < bottom + kHeadroom ? eaves : eaves - kSlab;
    std::vector<Opening> openings;
    for (const Passage* passage : passages) {
        const double floor = std::max(bottom, passage->floor.value_or(bottom));
        const double ground =
            passage->floor.value_or(terrain.highest(geometry.intersection(passage->area, volume.footprint)));
        const double top = std::min(highest, ground + passage->height);
        if (top > floor) {
            openings.push_back({&passage->area, floor, top});
        }
    }
    return openings;
}

/// What is open all the way between two heights.
Polygons open_area(const std::vector<Opening>& openings, double low, double high, const Polygons& footprint,
                   const PlanGeometry& geometry) {
    std::vector<const Polygons*> areas;
    for (const Opening& opening : openings) {
        if (opening.bottom <= low && opening.top >= high) {
            areas.push_back(opening.area);
        }
    }
    return areas.empty() ? Polygons() : geometry.intersection(geometry.united(areas), footprint);
}

}  // namespace

namespace {

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

bool is_building(const Tags& tags) {
    return affirmed(tags, "building") && !tags.is("location", "underground") &&
           number_of(tags, "layer").value_or(0.0) > -1.0;
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
        if (!affirmed(tags, "building:part") || affirmed(tags, "building")) {
            continue;
        }
        double best = 0.0;
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
        if (!part && !is_building(area.tags)) {
            continue;
        }
        Volume volume;
        volume.id = area.id;
        volume.building = owner[i];
        volume.node = "building/" + areas[owner[i]].id.text() + (owner[i] == i ? "" : "/" + area.id.text());
        volume.tags = area.tags;
        volume.footprint = area.polygons;
        volume.open = is_open(area.tags);
        if (const auto found = parts.find(i); found != parts.end()) {
            constexpr double kSliver = 0.05;  // of the outline, where parts were drawn imprecisely
            std::vector<const Polygons*> covered;
            for (const std::size_t p : found->second) {
                if (!is_on_top(areas[p].tags, area.tags)) {
                    covered.push_back(&areas[p].polygons);
                }
            }
            volume.footprint = geometry.difference(volume.footprint, geometry.united(covered));
            if (area_of(volume.footprint) < kSliver * area_of(area.polygons)) {
                continue;
            }
        }
        volume.base = terrain.lowest(areas[owner[i]].polygons);
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

void add_volume(const Volume& volume, const std::vector<const Passage*>& passages,
                const PlanGeometry& geometry, const Terrain& terrain, ModelBuilder& model) {
    ObjectMesh& mesh = model.object(volume.node);
    if (volume.open) {
        add_open_roof(volume, geometry, terrain, mesh);
        return;
    }
    const Look wall = wall_look(volume);
    const Facade facade(volume, wall, mesh);
    const double eaves = volume.base + volume.eaves;
    const double bottom = volume.base + volume.bottom;
    const std::vector<Opening> openings = openings_of(volume, passages, geometry, terrain);
    std::vector<double> heights = {bottom, eaves};
    for (const Opening& opening : openings) {
        heights.push_back(opening.bottom);
        heights.push_back(opening.top);
    }
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    Polygons below = volume.bottom > 0.0 ? Polygons() : volume.footprint;  // what is solid there
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const Polygons open = open_area(openings, heights[i - 1], heights[i], volume.footprint, geometry);
        const Polygons solid = open.empty() ? volume.footprint : geometry.difference(volume.footprint, open);
        facade.add(solid, heights[i - 1], heights[i]);
        if (i > 1 || volume.bottom > 0.0) {
            add_ceiling(wall, geometry.difference(solid, below), heights[i - 1], geometry, mesh);
            for (const Polygon& polygon : i > 1 ? geometry.difference(below, solid) : Polygons()) {
                mesh.level(wall, geometry.triangulated(polygon), heights[i - 1]);
            }
        }
        below = solid;
    }
    add_roof(volume.footprint, volume.roof, eaves, roof_look(volume), wall, geometry, mesh);
}

}  // namespace campuswalk::scene::osm
