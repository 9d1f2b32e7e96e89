#include "tools/campuswalk/help/key_table.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/schemas.h"

namespace campuswalk::tools::help {

namespace {

constexpr std::size_t kWidth = 100;

/// A schema with the file it stands in, which its references start from.
struct Placed {
    std::string file;
    Json schema;
};

Json file_of(std::string_view name) {
    const auto schemas = embedded_schemas();
    const auto found = std::ranges::find(schemas, name, &EmbeddedSchema::name);
    if (found == schemas.end()) {
        throw std::logic_error("no schema is called " + std::string(name));
    }
    return Json::parse(found->text);
}

Placed at(std::string_view reference, const std::string& from) {
    const std::size_t hash = std::min(reference.find('#'), reference.size());
    const std::string file = hash == 0 ? from : std::string(reference.substr(0, hash));
    const std::string pointer(reference.substr(std::min(hash + 1, reference.size())));
    return {file, file_of(file).at(Json::json_pointer(pointer))};
}

/// Follows the reference, if it is one; a description beside it goes first.
Placed resolved(Placed placed) {
    while (placed.schema.contains("$ref")) {
        Placed target = at(placed.schema["$ref"].get<std::string>(), placed.file);
        if (placed.schema.contains("description")) {
            target.schema["description"] = placed.schema["description"];
        }
        placed = std::move(target);
    }
    return placed;
}

/// Names of the keys of the map that the value may be.
std::vector<std::string> keys_in(const Placed& placed) {
    std::vector<std::string> keys;
    const Json properties = placed.schema.value("properties", Json::object());
    for (const auto& [key, unused] : properties.items()) {
        keys.push_back(key);
    }
    for (const char* list : {"anyOf", "oneOf"}) {
        if (!keys.empty() || !placed.schema.contains(list)) {
            continue;
        }
        for (const Json& alternative : placed.schema[list]) {
            for (const std::string& key : keys_in(resolved({placed.file, alternative}))) {
                if (std::ranges::find(keys, key) == keys.end()) {
                    keys.push_back(key);
                }
            }
        }
    }
    return keys;
}

/// The map that the entries of a list or the named values of a map are.
Placed inner(const Placed& placed) {
    for (const char* part : {"items", "additionalProperties"}) {
        if (placed.schema.contains(part) && placed.schema[part].is_object()) {
            return resolved({placed.file, placed.schema[part]});
        }
    }
    return placed;
}

std::string meaning_of(const Placed& placed) {
    std::string text = placed.schema.value("description", "");
    if (placed.schema.contains("default")) {
        const Json& value = placed.schema["default"];
        text += " Default: " + (value.is_string() ? value.get<std::string>() : value.dump()) + ".";
    }
    const Placed map = inner(placed);
    std::string keys;
    for (const std::string& key :
         map.schema.contains("maxProperties") ? std::vector<std::string>() : keys_in(map)) {
        keys += (keys.empty() ? " Keys: " : ", ") + key;
    }
    return text + keys + (keys.empty() ? "" : ".");
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t column, std::size_t indent) {
    std::istringstream words{std::string(text)};
    std::string result;
    for (std::string word; words >> word;) {
        if (column + 1 + word.size() > kWidth && column > indent) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (!result.empty()) {
            result += " ";
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result;
}

std::string key_table(std::string_view place) {
    const Placed map = resolved(at(place, ""));
    std::size_t widest = 0;
    for (const auto& [key, unused] : map.schema.at("properties").items()) {
        widest = std::max(widest, key.size());
    }
    std::string text;
    const std::size_t indent = widest + 4;
    for (const auto& [key, value] : map.schema.at("properties").items()) {
        text += "  " + key + std::string(indent - 2 - key.size(), ' ') +
                wrapped(meaning_of(resolved({map.file, value})), indent, indent) + "\n";
    }
    return text;
}

}  // namespace campuswalk::tools::help
