#include "engine/report/result_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <limits>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/events/decimals.h"
#include "engine/report/artifact_path.h"
#include "engine/report/result_fields.h"
#include "scene/base/json_limits.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeaderKey = "campuswalk_results";
constexpr int kHeaderVersion = 6;

/// JSON has no such numbers; a reader of reports must not fail on a result because of them.
constexpr std::array<std::pair<double, std::string_view>, 3> kNotFinite = {{
    {std::numeric_limits<double>::infinity(), "Infinity"},
    {-std::numeric_limits<double>::infinity(), "-Infinity"},
    {std::numeric_limits<double>::quiet_NaN(), "NaN"},
}};

// ---- writing ------------------------------------------------------------------------------------------

Json json_of(const std::string& value) {
    return value;
}
template <std::integral Number>
Json json_of(Number value) {
    return value;
}
Json json_of(double value) {
    if (std::isnan(value)) {
        return std::string(kNotFinite.back().second);
    }
    for (const auto& [number, name] : kNotFinite) {
        if (value == number) {
            return std::string(name);
        }
    }
    return value;
}
Json json_of(const Eigen::Vector3d& value) {
    return {json_of(value.x()), json_of(value.y()), json_of(value.z())};
}
Json json_of(scene::DiagnosticCode value) {
    return std::string(value.text());
}
Json json_of(Outcome value) {
    return std::string(name_of(value));
}
Json json_of(ReasonKind value) {
    return std::string(name_of(value));
}
template <typename Struct>
requires std::is_class_v<Struct> Json json_of(const Struct& value);
template <typename Value>
Json json_of(const std::optional<Value>& value) {
    return value ? json_of(*value) : Json();
}
/// As in logs: text, because many readers' numbers are all doubles.
Json json_of(const Hash<const std::uint64_t>& hash) {
    return hexadecimal(hash.value);
}
template <typename Item>
Json json_of(const std::vector<Item>& list);

class FieldWriter {
public:
    template <typename Value>
    void operator()(const char* name, const Value& value) {
        json[name] = json_of(value);
    }
    template <typename Value>
    void if_any(const char* name, const Value& value) {
        if (value != Value()) {
            json[name] = json_of(value);
        }
    }

    Json json = Json::object();
};

template <typename Item>
Json json_of(const std::vector<Item>& list) {
    Json json = Json::array();
    for (const Item& item : list) {
        json.push_back(json_of(item));
    }
    return json;
}

template <typename Struct>
requires std::is_class_v<Struct> Json json_of(const Struct& value) {
    FieldWriter writer;
    list_fields(writer, value);
    return std::move(writer.json);
}

// ---- reading ------------------------------------------------------------------------------------------

/// For messages.
std::string shortened(const std::string& text) {
    constexpr std::size_t kShown = 40;
    return text.size() <= kShown ? text : text.substr(0, kShown) + "…";
}

/// `where` is the path to the value: "failures[0].scene.tick".
[[noreturn]] void refuse(const std::string& where, const std::string& expected, const Json& json) {
    // Lists and objects may be nested more deeply than dump() can recurse.
    const std::string found = json.is_array()    ? "a list"
                              : json.is_object() ? "an object"
                                                 : json.dump(-1, ' ', false, Json::error_handler_t::replace);
    throw std::runtime_error(where + " must be " + expected + ", not " + shortened(found));
}

void read(const Json& json, const std::string& where, std::string& value) {
    if (!json.is_string()) {
        refuse(where, "a string", json);
    }
    value = json.get<std::string>();
}
void read(const Json& json, const std::string& where, bool& value) {
    if (!json.is_boolean()) {
        refuse(where, "true or false", json);
    }
    value = json.get<bool>();
}
template <std::integral Number>
void read(const Json& json, const std::string& where, Number& value) {
    const bool fits = json.is_number_unsigned()
                          ? std::in_range<Number>(json.get<std::uint64_t>())
                          : json.is_number_integer() && std::in_range<Number>(json.get<std::int64_t>());
    if (!fits) {
        refuse(where, std::unsigned_integral<Number> ? "a whole number from 0 on" : "a whole number", json);
    }
    value = json.get<Number>();
}
void read(const Json& json, const std::string& where, double& value) {
    for (const auto& [number, name] : kNotFinite) {
        if (json == name) {
            value = number;
            return;
        }
    }
    if (!json.is_number()) {
        refuse(where, "a number", json);
    }
    value = json.get<double>();
}
void read(const Json& json, const std::string& where, Eigen::Vector3d& value) {
    if (!json.is_array() || json.size() != 3) {
        refuse(where, "three numbers", json);
    }
    for (int axis = 0; axis < 3; ++axis) {
        read(json[static_cast<std::size_t>(axis)], where, value[axis]);
    }
}
template <typename Struct>
requires std::is_class_v<Struct>
void read(const Json& json, const std::string& where, Struct& value);
template <typename Value>
void read(const Json& json, const std::string& where, std::optional<Value>& value) {
    if (json.is_null()) {
        value.reset();
    } else {
        read(json, where, value.emplace());
    }
}
void read(const Json& json, const std::string& where, scene::DiagnosticCode& value) {
    std::string text;
    read(json, where, text);
    const std::optional<scene::DiagnosticCode> known = scene::DiagnosticCode::find(text);
    if (!known && !text.empty()) {
        refuse(where, "the code of a diagnostic", json);
    }
    value = known.value_or(scene::DiagnosticCode());
}
void read(const Json& json, const std::string& where, Outcome& value) {
    for (const auto& [outcome, name] : kOutcomeNames) {
        if (json == name) {
            value = outcome;
            return;
        }
    }
    refuse(where, "an outcome", json);
}
void read(const Json& json, const std::string& where, ReasonKind& value) {
    for (const ReasonKind kind : reason_kinds()) {
        if (json == name_of(kind)) {
            value = kind;
            return;
        }
    }
    refuse(where, "the kind of a reason", json);
}
void read(const Json& json, const std::string& where, Hash<std::uint64_t> hash) {
    std::string digits;
    if (json.is_string()) {
        digits = json.get<std::string>();
    }
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), hash.value, 16);
    if (digits.size() != 16 || digits.starts_with('-') || parsed.ptr != digits.data() + digits.size()) {
        refuse(where, "16 hexadecimal digits", json);
    }
}
template <typename Item>
void read(const Json& json, const std::string& where, std::vector<Item>& list);

class FieldReader {
public:
    FieldReader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) {
            refuse(where_.empty() ? "a line" : where_, "an object", json);
        }
    }

    template <typename Value>
    void operator()(const char* name, Value&& value) {
        const auto found = json_.find(name);
        if (found == json_.end()) {
            throw std::runtime_error(path(name) + " is missing");
        }
        read(*found, path(name), value);
        names_.emplace_back(name);
    }
    template <typename Value>
    void if_any(const char* name, Value& value) {
        if (json_.contains(name)) {
            (*this)(name, value);
        }
    }

    /// Refuses other fields.
    void finish() const {
        for (const auto& [name, value] : json_.items()) {
            if (std::ranges::find(names_, name) == names_.end()) {
                throw std::runtime_error("unknown field " + path(shortened(name)));
            }
        }
    }

private:
    std::string path(const std::string& name) const { return where_.empty() ? name : where_ + "." + name; }

    const Json& json_;
    std::string where_;
    std::vector<std::string> names_;
};

template <typename Item>
void read(const Json& json, const std::string& where, std::vector<Item>& list) {
    if (!json.is_array()) {
        refuse(where, "a list", json);
    }
    for (std::size_t i = 0; i < json.size(); ++i) {
        read(json[i], where + "[" + std::to_string(i) + "]", list.emplace_back());
    }
}

template <typename Struct>
void check(const Struct& /*value*/, const std::string& /*where*/, const Json& /*json*/) {}

/// What is read from a report may come from strangers, and other programs open the files that it names.
void check(const Artifact& artifact, const std::string& where, const Json& json) {
    if (!is_artifact_path(artifact.path)) {
        refuse(where + ".path", "a path inside the output folder, without '..', '\\', '|', '[[' and ']]'",
               json["path"]);
    }
    if (artifact.name.empty() || scene::printable(artifact.name) != artifact.name) {
        refuse(where + ".name", "a name without characters that aren't shown", json["name"]);
    }
    if (!is_media_type(artifact.media_type)) {
        refuse(where + ".media_type", "of the form image/png", json["media_type"]);
    }
}

template <typename Struct>
requires std::is_class_v<Struct>
void read(const Json& json, const std::string& where, Struct& value) {
    FieldReader reader(json, where);
    list_fields(reader, value);
    reader.finish();
    check(value, where, json);
}

/// The parser would accept repeated keys and use the last. Throws std::runtime_error.
Json parsed(std::string_view line) {
    if (const std::string why = scene::why_too_complex(line); !why.empty()) {
        throw std::runtime_error(why);
    }
    std::vector<std::set<std::string>> keys;  // of the objects that the parser is in
    const auto visit = [&](int, Json::parse_event_t event, Json& json) {
        if (event == Json::parse_event_t::object_start) {
            keys.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            keys.pop_back();
        } else if (event == Json::parse_event_t::key) {
            const std::string key = json.get<std::string>();
            if (!keys.back().insert(key).second) {
                throw std::runtime_error(shortened(key) + " is repeated");
            }
        }
        return true;
    };
    try {
        return Json::parse(line, visit);
    } catch (const Json::parse_error& error) {  // its words quote all that the parser has read
        throw std::runtime_error("not JSON from byte " + std::to_string(error.byte) + " on");
    } catch (const Json::exception&) {
        throw std::runtime_error("not JSON: it has a number that no double holds");
    }
}

}  // namespace

std::string to_json_line(const WalkResult& result) {
    return scene::printable_json(json_of(result).dump(-1, ' ', false, Json::error_handler_t::replace));
}

WalkResult result_from_json_line(std::string_view line) {
    WalkResult result;
    try {
        read(parsed(line), "", result);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("not a walk's result: ") + error.what());
    }
    return result;
}

std::string to_json(const RunPlan& plan) {
    return scene::printable_json(json_of(plan).dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string to_header_line(const RunPlan& plan) {
    Json header{{kHeaderKey, kHeaderVersion}};
    header.update(json_of(plan));
    return scene::printable_json(header.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::optional<RunPlan> plan_from_header_line(std::string_view line) {
    if (!scene::why_too_complex(line).empty()) {
        return std::nullopt;
    }
    const Json any = Json::parse(line, nullptr, false);
    if (!any.is_object() || !any.contains(kHeaderKey)) {
        return std::nullopt;
    }
    if (any[kHeaderKey] != kHeaderVersion) {
        throw std::runtime_error("a report of another version of campuswalk");
    }
    RunPlan plan;
    try {
        Json header = parsed(line);
        header.erase(kHeaderKey);
        read(header, "", plan);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("not a report's header: ") + error.what());
    }
    return plan;
}

}  // namespace campuswalk::engine
