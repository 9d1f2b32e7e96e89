#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/osm/geometry/terrain.h"
#include "scene/osm/ways/paths.h"

namespace campuswalk::scene::osm {

/// Ground that rises gently from all sides to a height, such as to the end of a bridge.
struct Mound {
    Point at = Point::Zero();
    double rise = 0.0;  ///< metres above the ground as it was
    double flat = 0.0;  ///< metres around the middle that are as high
};

/// Ground that stays as it is below a bridge, with embankments beside it.
struct Cutting {
    Point at = Point::Zero();
    Point along = Point(1, 0);  ///< unit
    double half_width = 0.0;
    double half_length = 0.0;
};

/// A map knows no heights, but steps lead up: ground that is level except for a slope beside each flight, as
/// long as the flight, and behind its top a gentle way down again, of one in six. So all flights have their
/// rise, and whoever doesn't take them gets up, too. Flights that hang from bridges need none.
Terrain relief_of_steps(const std::vector<Path>& paths, const Box& box);

/// The same ground with mounds on it, of a slope of one in six, but where cuttings keep it low.
Terrain with_mounds(const Terrain& base, const Box& box, const std::vector<Mound>& mounds,
                    const std::vector<Cutting>& cuttings);

/// Of "30%", "-30 %" or "17°" how far up for each metre along; nullopt for others.
std::optional<double> slope_of(std::string_view incline);

/// Metres that a flight rises, by its incline, its step_count or its length.
double rise_of(const Path& path);

/// Metres that a flight can rise at most: as steep as people build them.
double greatest_rise(const Path& path);

/// The points of a flight from its foot to its top, by "incline". Without that, up to an entrance that it
/// begins at, and as drawn otherwise.
std::vector<Point> upward(const Path& path);

double length_of(const std::vector<Point>& line);

}  // namespace campuswalk::scene::osm
