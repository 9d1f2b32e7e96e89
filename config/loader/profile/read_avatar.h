#pragma once

#include <vector>

#include "config/loader/values/checked_map.h"
#include "engine/script/avatar.h"

namespace campuswalk::config {

/// Sets the fields of `profile` whose keys are in the map, and reports an impossible body, such as one that
/// is wider than high or has its eyes above its head. Returns the nodes of `ignore_layers`, whose names the
/// caller checks against the campus.
std::vector<CheckedNode> read_profile_fields(CheckedMap& map, engine::AvatarProfile& profile);

}  // namespace campuswalk::config
