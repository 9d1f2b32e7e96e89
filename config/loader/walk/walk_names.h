#pragma once

#include "config/loader/walk/avatar_reader.h"
#include "config/loader/walk/campus_names.h"

namespace campuswalk::config {

/// What a walk names, for the readers of its parts.
struct WalkNames {
    const CampusNames& campus;
    const AvatarReader& avatars;
};

}  // namespace campuswalk::config
