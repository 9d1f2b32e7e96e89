#include "scene/osm/buildings/buildings.h"

#include <algorithm>
#include <cmath>

#include "scene/osm/buildings/building_looks.h"

namespace campuswalk::scene::osm {

namespace {

constexpr Look kGlass = {{74, 92, 108}, 60, 255};

/// A level's windows, from and to such a height above its floor.
constexpr double kSill = 0.9;
constexpr double kLintel = 0.7;     // below the next floor
constexpr double kPier = 0.6;       // metres of wall beside windows, at a wall's ends
constexpr double kBay = 3.0;        // from window to window, about
constexpr double kLeastWall = 2.4;  // of a wall with windows

/// The walls of a volume, with a row of windows for each level; none where the ground covers them.
class Facade {
public:
    Facade(const Volume& volume, const Look& wall, const Terrain& terrain, ObjectMesh& mesh)
        : volume_(volume), wall_(wall), terrain_(terrain), mesh_(mesh), windows_(has_windows(volume)) {}

    /// An upright strip of it around polygons, between two heights.
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
            if (is_buried(left, right, low)) {
                continue;
            }
            mesh_.wall(wall_, done, left, low, high);
            mesh_.wall(kGlass, left, right, low, high);
            done = right;
        }
        mesh_.wall(wall_, done, b, low, high);
    }

    /// Whether the ground between two points of a wall is higher than a sill.
    bool is_buried(const Point& a, const Point& b, double sill) const {
        return std::ranges::any_of(terrain_.split(a, b),
                                   [&](const Point& p) { return terrain_.height(p) > sill; });
    }

    /// Returns the height of the lowest level; a part above others has one of its own.
    double first_floor() const { return std::floor(volume_.bottom / volume_.storey) * volume_.storey; }

    const Volume& volume_;
    Look wall_;
    const Terrain& terrain_;
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
    const double thin = eaves - std::min(kSlab, 0.5 * volume.eaves);
    const double under = volume.bottom > 0.0 ? std::min(thin, volume.base + volume.bottom) : thin;
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

void add_volume(const Volume& volume, const std::vector<const Passage*>& passages,
                const PlanGeometry& geometry, const Terrain& terrain, ModelBuilder& model) {
    geometry.charge_to(volume.node);
    ObjectMesh& mesh = model.object(volume.node);
    if (volume.open) {
        add_open_roof(volume, geometry, terrain, mesh);
        return;
    }
    const Look wall = wall_look(volume);
    const Facade facade(volume, wall, terrain, mesh);
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
    if (heights.size() == 1 && volume.bottom > 0.0) {  // all of it is roof
        add_ceiling(wall, volume.footprint, bottom, geometry, mesh);
    }
    add_roof(volume.footprint, volume.roof, eaves, roof_look(volume), wall, geometry, mesh);
}

}  // namespace campuswalk::scene::osm
