#include "engine/html_report/recorded_path.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/html_report/foreign_json.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

using RecordingJson = nlohmann::json;

constexpr double kTellApart = 1.0;  // millimetres, along an axis
// What a walk can't come to: a year of ticks, and a thousand million metres or turns.
constexpr std::int64_t kMostTicks = std::int64_t{1} << 31U;
constexpr std::int64_t kMostUnits = std::int64_t{1} << 40U;

Vector3d point(const RecordedPath::Key& key) {
    return {static_cast<double>(key.at[0]), static_cast<double>(key.at[1]), static_cast<double>(key.at[2])};
}

/// The sums of a list of differences; empty if it isn't a list of whole numbers with sums up to `most`.
std::vector<std::int64_t> summed(const RecordingJson& path, const char* name, std::int64_t most) {
    std::vector<std::int64_t> values;
    const auto list = path.find(name);
    if (list == path.end() || !list->is_array()) {
        return {};
    }
    std::int64_t value = 0;
    for (const RecordingJson& difference : *list) {
        // An unsigned one above the signed numbers reads as a negative one.
        const std::int64_t step =
            difference.is_number_integer() ? difference.get<std::int64_t>() : 2 * most + 1;
        if (step < -2 * most || step > 2 * most || value + step < -most || value + step > most) {
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
bool is_recording(const RecordingJson& json) {
    const auto version = json.is_object() ? json.find("campuswalk_recording") : json.end();
    return version != json.end() && *version == 1 && has_numbers(json, {"ticks_per_second", "ticks"}) &&
           json["ticks_per_second"] > 0 && json.contains("campus") && has_strings(json["campus"], {"file"}) &&
           json.contains("avatar") && has_numbers(json["avatar"], {"radius", "height", "eye_height"}) &&
           json.contains("way") && json["way"].is_object() &&
           has_list(json, "log", [](const RecordingJson& line) { return line.is_string(); });
}

std::optional<RecordedPath> path_of(const RecordingJson& recording) {
    const RecordingJson& stored = recording["way"];
    const std::vector<std::int64_t> ticks = summed(stored, "tick", kMostTicks);
    std::array<std::vector<std::int64_t>, 5> columns;
    constexpr std::array<const char*, 5> kNames = {"x", "y", "z", "yaw", "pitch"};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i] = summed(stored, kNames[i], kMostUnits);
        if (columns[i].size() != ticks.size()) {
            return std::nullopt;
        }
    }
    if (!ascend_from_zero(ticks)) {
        return std::nullopt;
    }
    RecordedPath path;
    path.campus_file = recording["campus"]["file"].get<std::string>();
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        path.keys.push_back({ticks[i], {columns[0][i], columns[1][i], columns[2][i]}, false});
    }
    const bool cuts_fit = has_list(stored, "cut", [&](const RecordingJson& index) {
        const bool fits = index.is_number_unsigned() && index.get<std::uint64_t>() < path.keys.size();
        if (fits) {
            path.keys[index.get<std::size_t>()].cut = true;
        }
        return fits;
    });
    return cuts_fit ? std::optional(std::move(path)) : std::nullopt;
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

std::optional<RecordedPath> read_recorded_path(std::string_view recording) {
    const std::optional<RecordingJson> json = parse_foreign<RecordingJson>(recording);
    return json && is_recording(*json) ? path_of(*json) : std::nullopt;
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
