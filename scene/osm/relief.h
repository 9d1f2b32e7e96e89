#pragma once

#include <vector>

#include "scene/osm/paths.h"
#include "scene/osm/terrain.h"

namespace campuswalk::scene::osm {

/// A map knows no heights, but steps lead up: ground that is level except for a slope beside each flight, as
/// long as the flight, and behind its top a gentle way down again, of one in six. So all flights have their
/// rise, and whoever doesn't take them gets up, too.
Terrain relief_of_steps(const std::vector<Path>& paths, const Box& box);

/// Metres that a flight rises, by its step_count or its length.
double rise_of(const Path& path);

/// The points of a flight from its foot to its top, by "incline"; as drawn, if that says nothing.
std::vector<Point> upward(const Path& path);

double length_of(const std::vector<Point>& line);

}  // namespace campuswalk::scene::osm
