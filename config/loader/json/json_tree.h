#pragma once

#include <memory>
#include <string_view>

#include "config/loader/yaml/yaml_tree.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// Parses a JSON text (RFC 8259) into the tree that YAML files are read into, so that the same readers check
/// its values; null if no tree can be built. Strings are quoted scalars. Reports:
///   json-syntax    what the parser reports
///   duplicate-key  at the second of the two; the first is used
///   too-large      nested more than 64 deep, or more than a million values
std::shared_ptr<const YamlNode> parse_json(std::string_view text, const std::string& file,
                                           scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
