#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a report's index says of a campus, as the members of a JSON object without its braces: name, file,
/// bounds, objects, buildings, spawns, places and storeys. `file` as users named it.
std::string campus_entry(const scene::Campus& campus, const std::string& file);

/// Whether it has what viewers need of such an entry: it may come from a file that somebody else wrote.
bool is_campus_entry(const nlohmann::ordered_json& json);

}  // namespace campuswalk::engine
