#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "scene/base/printable.h"

namespace campuswalk::tools {

using Json = nlohmann::ordered_json;

/// On one line without an indent. Bytes that are no UTF-8, which names of files may hold, become U+FFFD; what
/// a terminal would obey is escaped.
inline std::string json_text(const Json& json, int indent = -1) {
    return scene::printable_json(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace campuswalk::tools
