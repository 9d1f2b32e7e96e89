#pragma once

#include "scene/osm/buildings/volumes.h"
#include "scene/osm/geometry/model_builder.h"

namespace campuswalk::scene::osm {

// As tagged, else what is plausible for its kind; the same building always looks the same.

Look wall_look(const Volume& volume);
Look roof_look(const Volume& volume);
bool has_windows(const Volume& volume);

}  // namespace campuswalk::scene::osm
