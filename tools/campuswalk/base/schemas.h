#pragma once

#include <span>
#include <string_view>

namespace campuswalk::tools {

/// A JSON Schema of config/schema/, embedded because an installed program has no repository beside it.
struct EmbeddedSchema {
    std::string_view name;  ///< "walk.schema.json"
    std::string_view text;
};

/// The schemas of the YAML files that users write.
std::span<const EmbeddedSchema> embedded_schemas();

}  // namespace campuswalk::tools
