#pragma once

#include "config/loader/values/checked_map.h"
#include "engine/script/light.h"

namespace campuswalk::config {

/// Sets the fields of `light` whose keys are in the map.
void read_profile_fields(CheckedMap& map, engine::LightSettings& light);

}  // namespace campuswalk::config
