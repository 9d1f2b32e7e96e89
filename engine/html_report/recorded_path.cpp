#include "engine/html_report/recorded_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

using Json = nlohmann::json;

constexpr double kApart = 1.0;  // millimetres, along an axis

Vector3d point(const RecordedPath::Key& key) {
    return {static_cast<double>(key.at[0]), static_cast<double>(key.at[1]), static_cast<double>(key.at[2])};
}

std::vector<std::int64_t> summed(const Json& differences) {
    std::vector<std::int64_t> values;
    std::int64_t value = 0;
    for (const Json& difference : differences) {
        values.push_back(value += difference.get<std::int64_t>());
    }
    return values;
}

RecordedPath path_of(const Json& recording) {
    RecordedPath path;
    path.campus_file = recording.at("campus").at("file").get<std::string>();
    const Json& stored = recording.at("way");
    const std::vector<std::int64_t> ticks = summed(stored.at("tick"));
    const std::vector<std::int64_t> x = summed(stored.at("x"));
    const std::vector<std::int64_t> y = summed(stored.at("y"));
    const std::vector<std::int64_t> z = summed(stored.at("z"));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        path.keys.push_back({ticks[i], {x.at(i), y.at(i), z.at(i)}, false});
    }
    for (const Json& index : stored.at("cut")) {
        path.keys.at(index.get<std::size_t>()).cut = true;
    }
    return path;
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
    const Json json = Json::parse(recording, nullptr, false);
    if (!json.is_object() || json.value("campuswalk_recording", Json()) != 1) {
        return std::nullopt;
    }
    try {
        RecordedPath path = path_of(json);
        return path.keys.empty() ? std::nullopt : std::optional(std::move(path));
    } catch (const Json::exception&) {
        return std::nullopt;
    } catch (const std::out_of_range&) {
        return std::nullopt;
    }
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
    for (Tick tick = 0; tick <= end; ++tick) {
        if ((a.at(tick) - b.at(tick)).cwiseAbs().maxCoeff() > kApart) {
            return tick;
        }
    }
    return a.keys.back().tick != b.keys.back().tick ? std::optional(end + 1) : std::nullopt;
}

}  // namespace campuswalk::engine
