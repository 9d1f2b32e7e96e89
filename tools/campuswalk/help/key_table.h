#pragma once

#include <string>
#include <string_view>

namespace campuswalk::tools::help {

/// The keys of a map and what they mean, a paragraph each, out of a JSON Schema. `place` is the schema's file
/// and, after '#', the map in it: "walk.schema.json#/definitions/step".
std::string key_table(std::string_view place);

/// The text in lines of at most 100 columns; those after the first are indented by `indent`.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent);

}  // namespace campuswalk::tools::help
