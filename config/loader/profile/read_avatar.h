#pragma once

#include <vector>

#include "config/loader/values/checked_map.h"
#include "engine/script/avatar.h"

namespace campuswalk::config {

/// Sets the fields of `profile` whose keys stand in the map, and complains of a body that can't be: wider
/// than it is high, eyes above its head. Returns the layers the avatar ignores where they are written, for
/// whoever knows the campus.
std::vector<CheckedNode> read_avatar_fields(CheckedMap& map, engine::AvatarProfile& profile);

}  // namespace campuswalk::config
