#include "tools/campuswalk/logs/log_lines.h"

#include <algorithm>
#include <cmath>

#include "config/loader/values/ranges.h"
#include "engine/events/decimals.h"
#include "engine/events/event_text.h"
#include "scene/base/json_limits.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools {

namespace {

bool is_header(const Json& json) {
    return json.is_object() && json.value("walk_log", Json()) == 1;
}

/// Discarded if it isn't JSON, or is more complex than any log's line.
Json parsed(std::string_view line) {
    return scene::why_too_complex(line).empty() ? Json::parse(line, nullptr, false)
                                                : Json(Json::value_t::discarded);
}

bool is_event(const Json& json) {
    const auto has = [&](const char* name, auto is) {
        const auto found = json.find(name);
        return found != json.end() && is(*found);
    };
    const auto text = [](const Json& value) { return value.is_string(); };
    return json.is_object() && has("tick", [](const Json& value) { return value.is_number_integer(); }) &&
           has("time", [](const Json& value) { return value.is_number(); }) && has("event", text) &&
           has("object", text);
}

/// The member if it is a string, otherwise an empty one.
std::string text_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// As the text log prints it: metres in millimetres, a yaw in tenths of a degree.
std::string shown(const std::string& name, const Json& value) {
    if (value.is_array()) {
        std::string all;
        for (const Json& part : value) {
            all += (all.empty() ? "" : ",") + shown(name, part);
        }
        return all;
    }
    if (value.is_number_float()) {
        return engine::fixed(value.get<double>(), name == "time" ? 6 : name == "yaw" ? 1 : 3);
    }
    if (value.is_string() && name != "title" && name != "body" && name != "message") {
        return value.get<std::string>();
    }
    return json_text(value);
}

/// When and what, without the details.
std::string short_text(const Json& json) {
    if (json.is_discarded()) {
        return "a line that isn't a log's JSON";
    }
    return is_event(json) ? shown("time", Json(json["time"].get<double>())) + " s " + text_in(json, "event") +
                                " " + text_in(json, "object")
                          : json_text(json);
}

/// Whether both are the same event; details may differ.
bool same_event(const Json& a, const Json& b) {
    return is_event(a) && is_event(b) && a["tick"] == b["tick"] && a["event"] == b["event"] &&
           a["object"] == b["object"];
}

std::string differing_fields(const Json& expected, const Json& found) {
    std::string all;
    const auto add = [&](const std::string& text) { all += (all.empty() ? "" : ", ") + text; };
    for (const auto& [name, value] : found.items()) {
        const auto was = expected.find(name);
        if (was == expected.end()) {
            add(name + "=" + shown(name, value) + " is new");
        } else if (*was != value) {
            add(name + " is " + shown(name, value) + " instead of " + shown(name, *was));
        }
    }
    for (const auto& [name, value] : expected.items()) {
        if (!found.contains(name)) {
            add(name + "=" + shown(name, value) + " is missing");
        }
    }
    return all.empty() ? "its details come in another order" : all;
}

}  // namespace

bool is_log_header(std::string_view line) {
    return is_header(parsed(line));
}

std::optional<LogHeader> log_header(std::string_view line) {
    const Json json = parsed(line);
    if (!is_header(json)) {
        return std::nullopt;
    }
    LogHeader header;
    header.walk = text_in(json, "walk");
    header.project = text_in(json, "project");
    if (const auto timeout = json.find("timeout"); timeout != json.end() && timeout->is_number()) {
        header.timeout = timeout->get<double>();
    }
    return header;
}

std::optional<LoggedEvent> logged_event(std::string_view line) {
    const Json json = parsed(line);
    if (!is_event(json)) {
        return std::nullopt;
    }
    LoggedEvent event;
    event.tick = json["tick"].get<engine::Tick>();
    event.time = json["time"].get<double>();
    event.kind = text_in(json, "event");
    event.hash = text_in(json, "hash");
    const auto at = json.find("pos");
    const auto number = [](const Json& part) {
        return part.is_number() && std::abs(part.get<double>()) <= config::kCoordinate.max;
    };
    if (at != json.end() && at->is_array() && at->size() == 3 &&
        std::all_of(at->begin(), at->end(), number)) {
        event.position = {(*at)[0].get<double>(), (*at)[1].get<double>(), (*at)[2].get<double>()};
    }
    return event;
}

std::string as_text_line(std::string_view line) {
    const Json json = parsed(line);
    if (!is_event(json)) {
        return std::string(line);
    }
    std::string details;
    for (const auto& [name, value] : json.items()) {
        if (name != "tick" && name != "time" && name != "event" && name != "object") {
            details += " " + name + "=" + shown(name, value);
        }
    }
    return engine::text_line(json["tick"].get<engine::Tick>(), json["time"].get<double>(),
                             text_in(json, "event"), text_in(json, "object"), details);
}

std::optional<std::string> difference(std::string_view expected, std::string_view found) {
    if (expected == found) {
        return std::nullopt;
    }
    const Json was = parsed(expected);
    const Json is = parsed(found);
    if (!was.is_discarded() && was == is) {
        return std::nullopt;
    }
    if (is_header(was) && is_header(is)) {
        return "what it ran with: " + differing_fields(was, is);
    }
    if (same_event(was, is)) {
        return short_text(is) + ": " + differing_fields(was, is);
    }
    return short_text(is) + " instead of " + short_text(was);
}

std::optional<std::size_t> first_divergence(std::span<const std::string> a, std::span<const std::string> b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < shorter; ++i) {
        if (difference(a[i], b[i])) {
            return i;
        }
    }
    return a.size() == b.size() ? std::nullopt : std::optional(shorter);
}

}  // namespace campuswalk::tools
