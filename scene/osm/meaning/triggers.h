#pragma once

#include <string>

#include "scene/osm/geometry/box_index.h"
#include "scene/osm/ways/site.h"

namespace campuswalk::scene::osm {

/// Knows where visitors can be placed.
class FreeGround {
public:
    FreeGround(const Site& site, const Built& built);

    /// Whether a visitor at `p` touches no building and no obstacle that is there by now.
    bool at(const Point& p) const;
    /// And stands on no flight of steps.
    bool is_start(const Point& p) const;
    /// How far a visitor at `p` looks in a unit direction before a building, something near or the map's edge
    /// is in the way, metres.
    double sight(const Point& p, const Point& direction, double farthest) const;

private:
    bool is_clear_of(const Polygons& area, const Point& p) const;

    const Site& site_;
    const Built& built_;
    BoxIndex volumes_;
    BoxIndex obstacles_;
    BoxIndex flights_;
};

/// Degrees about +Y of a visitor who looks in a direction of the plan.
double yaw_towards(const Point& direction);
/// Degrees about +Y of a box whose length runs in a direction of the plan.
double yaw_along(const Point& direction);

/// A trigger over an area and `margin` metres around it.
DraftTrigger area_trigger(const Site& site, const std::string& id, const Polygons& area, double margin,
                          double height);

/// A trigger at a point; of one inside a building at the outside of the nearest wall.
DraftTrigger node_trigger(const Site& site, const BoxIndex& volumes, const std::string& id, const Point& at);

/// The volume whose ground floor is at a point; null for none.
const Volume* volume_at(const Site& site, const BoxIndex& volumes, const Point& at);

/// All volumes by their place in the site.
BoxIndex index_of_volumes(const Site& site);

}  // namespace campuswalk::scene::osm
