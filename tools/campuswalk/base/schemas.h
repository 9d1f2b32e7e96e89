#pragma once

#include <span>
#include <string_view>

namespace campuswalk::tools {

/// A JSON Schema of config/schema/, kept in the program: an installed one has no repository beside it.
struct EmbeddedSchema {
    std::string_view name;  ///< "walk.schema.json"
    std::string_view text;
};

/// Those of the YAML files that users write.
std::span<const EmbeddedSchema> embedded_schemas();

}  // namespace campuswalk::tools
