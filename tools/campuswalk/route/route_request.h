#pragma once

#include <string>

#include "engine/script/mentions.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::tools::route {

/// A place's or spawn's name (places first), "x,z" or "x,y,z". Throws bad-value or unknown-name about
/// `option`.
engine::Target parse_target(const scene::CampusDescription& campus, const std::string& text,
                            const std::string& option);

}  // namespace campuswalk::tools::route
