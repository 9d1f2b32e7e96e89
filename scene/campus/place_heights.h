#pragma once

#include <vector>

#include "collision/world/world.h"
#include "scene/base/diagnostic.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::scene {

/// Sets the heights of the places that have none: the lowest solid surface with 2 m of free space above it
/// that isn't inside of something, so that a place in a house is on its ground floor rather than on the roof,
/// and one under a tree on the ground. Where nothing is so free, the uppermost surface. Warns once if there
/// are places with nothing below (no-ground-below); their height stays.
void put_places_on_ground(const collision::World& world, std::vector<Place>& places,
                          std::vector<Diagnostic>& warnings);

}  // namespace campuswalk::scene
