#include "engine/observers/json_lines.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "engine/events/decimals.h"
#include "scene/base/printable.h"

namespace campuswalk::engine {

namespace {

using Json = nlohmann::ordered_json;

/// The number that the text log prints, without the noise after its last digit.
double rounded(double value, int digits) {
    const std::string text = fixed(value, digits);
    double shown = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), shown);
    return shown;
}

Json json_of(std::int64_t value) {
    return value;
}
Json json_of(const Decimal& value) {
    return rounded(value.value, value.digits);
}
Json json_of(const Eigen::Vector3d& value) {
    return {rounded(value.x(), 3), rounded(value.y(), 3), rounded(value.z(), 3)};
}
Json json_of(const std::string& value) {
    return value;
}
Json json_of(const Text& value) {
    return value.value;
}
Json json_of(const std::shared_ptr<const Reason>& value) {
    return text_of(*value);
}

Json exactly(const Eigen::Vector3d& value) {
    return {value.x(), value.y(), value.z()};
}

/// With all bits, to convert back to a map's coordinates.
Json json_of(const scene::Origin& origin) {
    Json json = {{"at", exactly(origin.at)}};
    if (const auto& place = origin.geographic) {
        json["latitude_deg"] = place->latitude_deg;
        json["longitude_deg"] = place->longitude_deg;
        json["height"] = place->height;
        json["of"] = exactly(place->at);
    }
    return json;
}

std::string line_of(const Json& json) {
    return scene::printable_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

void JsonLines::begin(const Walk& walk) {
    Json header = {{"walk_log", 1},
                   {"walk", walk.name},
                   {"campus", walk.campus_name},
                   {"tps", walk.sim.ticks_per_second}};
    if (!walk.project.empty()) {
        header["project"] = walk.project;
    }
    if (walk.timeout) {
        header["timeout"] = *walk.timeout;  // with all bits, to replay the walk
    }
    if (walk.origin.is_known()) {
        header["origin"] = json_of(walk.origin);
    }
    sink_(line_of(header));
}

void JsonLines::on_tick(const TickRecord& record) {
    for (const Event& event : record.events) {
        Json json = {{"tick", event.tick},
                     {"time", rounded(record.time, 6)},
                     {"event", std::string(name_of(event.kind))},
                     {"object", event.object}};
        for (const Field& field : event.fields) {
            json[std::string(field.name)] = std::visit([](const auto& v) { return json_of(v); }, field.value);
        }
        sink_(line_of(json));
    }
}

}  // namespace campuswalk::engine
