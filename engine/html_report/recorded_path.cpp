#include "engine/html_report/recorded_path.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <simdjson.h>

#include "engine/html_report/foreign_json.h"
#include "scene/base/json_limits.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

namespace dom = simdjson::dom;

constexpr double kTellApart = 1.0;  // millimetres, along an axis
// What a walk can't come to: a year of ticks, and a thousand million metres or turns.
constexpr std::int64_t kMostTicks = std::int64_t{1} << 31U;
constexpr std::int64_t kMostUnits = std::int64_t{1} << 40U;

Vector3d point(const RecordedPath::Key& key) {
    return {static_cast<double>(key.at[0]), static_cast<double>(key.at[1]), static_cast<double>(key.at[2])};
}

/// None if it isn't an object or has no such member. Of several the last: browsers take that one.
std::optional<dom::element> member(const dom::element& json, std::string_view name) {
    dom::object object;
    std::optional<dom::element> found;
    if (json.get(object) == simdjson::SUCCESS) {
        for (const dom::key_value_pair each : object) {
            if (each.key == name) {
                found = each.value;
            }
        }
    }
    return found;
}

/// None if there is no such member of this type.
template <typename Value>
std::optional<Value> member_as(const dom::element& json, std::string_view name) {
    const std::optional<dom::element> found = member(json, name);
    Value value{};
    return found && found->get(value) == simdjson::SUCCESS ? std::optional(value) : std::nullopt;
}

bool has_numbers(const dom::element& json, std::initializer_list<const char*> names) {
    return std::ranges::all_of(names,
                               [&](const char* name) { return member_as<double>(json, name).has_value(); });
}

bool has_list_of_strings(const dom::element& json, const char* name) {
    const auto list = member_as<dom::array>(json, name);
    return list &&
           std::all_of(list->begin(), list->end(), [](const dom::element& item) { return item.is_string(); });
}

/// The sums of a list of differences; empty if it isn't a list of whole numbers with sums up to `most`.
std::vector<std::int64_t> summed(const dom::element& path, const char* name, std::int64_t most) {
    std::vector<std::int64_t> values;
    std::int64_t value = 0;
    const auto list = member_as<dom::array>(path, name);
    if (!list) {
        return {};
    }
    for (const dom::element difference : *list) {
        std::int64_t step = 0;
        if (difference.get(step) != simdjson::SUCCESS || step < -2 * most || step > 2 * most ||
            value + step < -most || value + step > most) {
            return {};
        }
        values.push_back(value += step);
    }
    return values;
}

bool ascend_from_zero(const std::vector<std::int64_t>& ticks) {
    return !ticks.empty() && ticks.front() >= 0 &&
           std::ranges::adjacent_find(ticks, std::ranges::greater_equal()) == ticks.end();
}

/// Whether a viewer finds in it what it reads besides the path.
bool is_recording(const dom::element& json) {
    const auto campus = member(json, "campus");
    const auto avatar = member(json, "avatar");
    return member_as<std::int64_t>(json, "campuswalk_recording") == 1 &&
           has_numbers(json, {"ticks_per_second", "ticks"}) &&
           member_as<double>(json, "ticks_per_second") > 0.0 && campus &&
           member_as<std::string_view>(*campus, "file") && avatar &&
           has_numbers(*avatar, {"radius", "height", "eye_height"}) && has_list_of_strings(json, "log");
}

/// Marks the keys of the list `cut`; false if it isn't a list of their indices.
bool mark_cuts(const dom::element& stored, std::vector<RecordedPath::Key>& keys) {
    const auto list = member_as<dom::array>(stored, "cut");
    return list && std::all_of(list->begin(), list->end(), [&](const dom::element& item) {
               std::uint64_t index = 0;
               const bool fits = item.get(index) == simdjson::SUCCESS && index < keys.size();
               if (fits) {
                   keys[index].cut = true;
               }
               return fits;
           });
}

std::optional<RecordedPath> path_of(const dom::element& recording) {
    const std::optional<dom::element> stored = member(recording, "way");
    if (!stored) {
        return std::nullopt;
    }
    const std::vector<std::int64_t> ticks = summed(*stored, "tick", kMostTicks);
    std::array<std::vector<std::int64_t>, 5> columns;
    constexpr std::array<const char*, 5> kNames = {"x", "y", "z", "yaw", "pitch"};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i] = summed(*stored, kNames[i], kMostUnits);
        if (columns[i].size() != ticks.size()) {
            return std::nullopt;
        }
    }
    if (!ascend_from_zero(ticks)) {
        return std::nullopt;
    }
    RecordedPath path;
    path.campus_file = *member_as<std::string_view>(*member(recording, "campus"), "file");
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        path.keys.push_back({ticks[i], {columns[0][i], columns[1][i], columns[2][i]}, false});
    }
    return mark_cuts(*stored, path.keys) ? std::optional(std::move(path)) : std::nullopt;
}

bool are_apart(const RecordedPath& a, const RecordedPath& b, Tick tick) {
    return (a.at(tick) - b.at(tick)).cwiseAbs().maxCoeff() > kTellApart;
}

/// The first tick after `together` and up to `end` at which they are apart, if both are straight in between.
Tick first_apart(const RecordedPath& a, const RecordedPath& b, Tick together, Tick end) {
    while (end - together > 1) {
        const Tick middle = together + (end - together) / 2;
        (are_apart(a, b, middle) ? end : together) = middle;
    }
    return end;
}

/// Twice the area of the triangle that a point makes with its neighbours: how much it is missed.
double weight(const std::array<Vector3d, 3>& vertex) {
    const Vector3d u = vertex[1] - vertex[0];
    const Vector3d v = vertex[2] - vertex[0];
    return std::abs(u.x() * v.z() - u.z() * v.x());
}

}  // namespace

Vector3d RecordedPath::at(Tick tick) const {
    const auto after = std::ranges::upper_bound(keys, tick, {}, &Key::tick);
    if (after == keys.begin()) {
        return point(keys.front());
    }
    const Key& from = *(after - 1);
    if (after == keys.end() || after->cut || from.tick == tick) {
        return point(from);
    }
    const double share = static_cast<double>(tick - from.tick) / static_cast<double>(after->tick - from.tick);
    return point(from) + share * (point(*after) - point(from));
}

// simdjson, as a run reads a recording of each of its walks: nlohmann's lexer was the largest part of that
// time.
std::optional<RecordedPath> read_recorded_path(std::string_view recording) {
    dom::parser parser;
    dom::element json;
    const bool is_json = !recording.starts_with(kByteOrderMark) &&
                         parser.allocate(recording.size(), scene::kDeepestJson) == simdjson::SUCCESS &&
                         parser.parse(recording.data(), recording.size()).get(json) == simdjson::SUCCESS;
    return is_json && is_recording(json) ? path_of(json) : std::nullopt;
}

// Visvalingam and Whyatt, "Line generalisation by repeated elimination of points", 1993.
std::vector<std::int64_t> plan_of(const RecordedPath& path, std::size_t most) {
    constexpr std::size_t kExamined = 2000;  // of a long path, evenly: the plan is a thumbnail
    std::vector<Vector3d> points;
    const std::size_t stride = path.keys.size() / kExamined + 1;
    for (std::size_t i = 0; i + 1 < path.keys.size(); i += stride) {
        points.push_back(point(path.keys[i]));
    }
    points.push_back(point(path.keys.back()));
    while (points.size() > std::max<std::size_t>(2, most)) {
        std::size_t least = 1;
        double least_weight = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const double own = weight({points[i - 1], points[i], points[i + 1]});
            if (own < least_weight) {
                least = i;
                least_weight = own;
            }
        }
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(least));
    }
    constexpr double kDecimetre = 100.0;  // millimetres
    std::vector<std::int64_t> plan;
    std::array<std::int64_t, 2> last = {};
    for (const Vector3d& each : points) {
        const std::array<std::int64_t, 2> now = {
            static_cast<std::int64_t>(std::floor(each.x() / kDecimetre + 0.5)),
            static_cast<std::int64_t>(std::floor(each.z() / kDecimetre + 0.5))};
        plan.push_back(now[0] - last[0]);
        plan.push_back(now[1] - last[1]);
        last = now;
    }
    return plan;
}

std::optional<Tick> parting_tick(const RecordedPath& a, const RecordedPath& b) {
    const Tick end = std::min(a.keys.back().tick, b.keys.back().tick);
    // Between these the distance along each axis is linear; a cut moves the avatar in the last tick before a
    // key.
    std::vector<Tick> ticks = {0, end};
    for (const RecordedPath* path : {&a, &b}) {
        for (const RecordedPath::Key& key : path->keys) {
            ticks.push_back(std::min(key.tick, end));
            ticks.push_back(std::clamp<Tick>(key.tick - 1, 0, end));
        }
    }
    std::ranges::sort(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        if (are_apart(a, b, ticks[i])) {
            return i == 0 ? ticks[i] : first_apart(a, b, ticks[i - 1], ticks[i]);
        }
    }
    return a.keys.back().tick != b.keys.back().tick ? std::optional(end + 1) : std::nullopt;
}

}  // namespace campuswalk::engine
