#pragma once

#include <string>
#include <string_view>

namespace campuswalk::tools::help {

/// The keys of a map with their meanings, one paragraph per key, from a JSON Schema. `location` is the
/// schema's file and, after '#', the map in it: "walk.schema.json#/definitions/step".
std::string key_table(std::string_view location);

}  // namespace campuswalk::tools::help
