#pragma once

#include "scene/osm/buildings/volumes.h"
#include "scene/osm/geometry/model_builder.h"
#include "scene/osm/geometry/terrain.h"

namespace campuswalk::scene::osm {

/// The walls of a volume, with a row of windows for each level; none where the ground covers them.
class Facade {
public:
    Facade(const Volume& volume, const Look& wall, const Terrain& terrain, ObjectMesh& mesh);

    /// An upright strip of it around polygons, between two heights.
    void add(const Polygons& polygons, double bottom, double top) const;

private:
    void add_ring(const Ring& ring, double bottom, double top) const;
    void add_wall(const Point& a, const Point& b, double bottom, double top) const;
    /// Windows of equal width between piers.
    void add_windows(const Point& a, const Point& b, double length, double low, double high) const;
    /// Whether the ground between two points of a wall is higher than a sill.
    bool is_buried(const Point& a, const Point& b, double sill) const;
    /// Of parts above others, their own lowest level.
    double first_floor() const;

    const Volume& volume_;
    Look wall_;
    const Terrain& terrain_;
    ObjectMesh& mesh_;
    bool windows_;
};

}  // namespace campuswalk::scene::osm
