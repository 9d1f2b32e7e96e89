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

/// A part of a schema, and its file, which its references are relative to.
struct SchemaPart {
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

SchemaPart part_at(std::string_view reference, const std::string& from) {
    const std::size_t hash = std::min(reference.find('#'), reference.size());
    const std::string file = hash == 0 ? from : std::string(reference.substr(0, hash));
    const std::string pointer(reference.substr(std::min(hash + 1, reference.size())));
    return {file, file_of(file).at(Json::json_pointer(pointer))};
}

/// Follows the part if it is a reference; a description beside that takes precedence.
SchemaPart resolved(SchemaPart part) {
    while (part.schema.contains("$ref")) {
        SchemaPart target = part_at(part.schema["$ref"].get<std::string>(), part.file);
        if (part.schema.contains("description")) {
            target.schema["description"] = part.schema["description"];
        }
        part = std::move(target);
    }
    return part;
}

/// The keys of a value that may be a map.
std::vector<std::string> keys_of(const SchemaPart& part) {
    std::vector<std::string> keys;
    const Json properties = part.schema.value("properties", Json::object());
    for (const auto& [key, unused] : properties.items()) {
        keys.push_back(key);
    }
    for (const char* list : {"anyOf", "oneOf"}) {
        if (!keys.empty() || !part.schema.contains(list)) {
            continue;
        }
        for (const Json& alternative : part.schema[list]) {
            for (const std::string& key : keys_of(resolved({part.file, alternative}))) {
                if (std::ranges::find(keys, key) == keys.end()) {
                    keys.push_back(key);
                }
            }
        }
    }
    return keys;
}

/// The schema of a list's entries or of the values of a map with free keys; any other part itself.
SchemaPart element_schema(const SchemaPart& part) {
    for (const char* key : {"items", "additionalProperties"}) {
        if (part.schema.contains(key) && part.schema[key].is_object()) {
            return resolved({part.file, part.schema[key]});
        }
    }
    return part;
}

std::string description_of(const SchemaPart& part) {
    std::string text = part.schema.value("description", "");
    if (part.schema.contains("default")) {
        const Json& value = part.schema["default"];
        text += " Default: " + (value.is_string() ? value.get<std::string>() : value.dump()) + ".";
    }
    const SchemaPart map = element_schema(part);
    std::string keys;
    for (const std::string& key :
         map.schema.contains("maxProperties") ? std::vector<std::string>() : keys_of(map)) {
        keys += (keys.empty() ? " Keys: " : ", ") + key;
    }
    return text + keys + (keys.empty() ? "" : ".");
}

/// The text in lines of at most kWidth columns. The first one starts at `column`, the others at `indent`.
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

}  // namespace

std::string key_table(std::string_view location) {
    const SchemaPart map = resolved(part_at(location, ""));
    std::size_t widest = 0;
    for (const auto& [key, unused] : map.schema.at("properties").items()) {
        widest = std::max(widest, key.size());
    }
    std::string text;
    const std::size_t indent = widest + 4;
    for (const auto& [key, value] : map.schema.at("properties").items()) {
        text += "  " + key + std::string(indent - 2 - key.size(), ' ') +
                wrapped(description_of(resolved({map.file, value})), indent, indent) + "\n";
    }
    return text;
}

}  // namespace campuswalk::tools::help
