#pragma once

#include <string>

#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a report's index says of a campus, as the members of a JSON object without its braces: name, file,
/// bounds, objects, buildings, spawns, places and storeys. `file` as users named it.
std::string campus_entry(const scene::Campus& campus, const std::string& file);

}  // namespace campuswalk::engine
