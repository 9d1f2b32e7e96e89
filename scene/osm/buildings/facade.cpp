#include "scene/osm/buildings/facade.h"

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

}  // namespace

Facade::Facade(const Volume& volume, const Look& wall, const Terrain& terrain, ObjectMesh& mesh)
    : volume_(volume), wall_(wall), terrain_(terrain), mesh_(mesh), windows_(has_windows(volume)) {}

void Facade::add(const Polygons& polygons, double bottom, double top) const {
    for (const Polygon& polygon : polygons) {
        add_ring(polygon.outer, bottom, top);
        for (const Ring& hole : polygon.holes) {
            add_ring(hole, bottom, top);
        }
    }
}

void Facade::add_ring(const Ring& ring, double bottom, double top) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        add_wall(ring[i], ring[(i + 1) % ring.size()], bottom, top);
    }
}

void Facade::add_wall(const Point& a, const Point& b, double bottom, double top) const {
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

void Facade::add_windows(const Point& a, const Point& b, double length, double low, double high) const {
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

bool Facade::is_buried(const Point& a, const Point& b, double sill) const {
    return std::ranges::any_of(terrain_.split(a, b),
                               [&](const Point& p) { return terrain_.height(p) > sill; });
}

double Facade::first_floor() const {
    return std::floor(volume_.bottom / volume_.storey) * volume_.storey;
}

}  // namespace campuswalk::scene::osm
