#pragma once

#include "engine/script/avatar.h"
#include "engine/walkspace/explore/explore.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// Of a body of this profile, on a campus from all its spawns.
ExploreSettings explore_settings(const scene::Campus& campus, const AvatarProfile& avatar,
                                 int ticks_per_second);

}  // namespace campuswalk::engine
