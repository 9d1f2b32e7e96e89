#pragma once

#include "config/loader/checked_node.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads a campus' `origin`: `{at: near, latitude_deg: 52.0, longitude_deg: 4.37}`.
scene::CampusOrigin read_origin(const CheckedNode& node);

}  // namespace campuswalk::config
