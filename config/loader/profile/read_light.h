#pragma once

#include "config/loader/values/checked_map.h"
#include "engine/script/light.h"

namespace campuswalk::config {

/// Sets the fields of `light` whose keys stand in the map: sun, sky, ground_light, room_light, fog_distance,
/// shadows, ambient_occlusion, anti_aliasing.
void read_light_fields(CheckedMap& map, engine::LightSettings& light);

}  // namespace campuswalk::config
