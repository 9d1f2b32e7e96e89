#include "scene/osm/meaning/gates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace campuswalk::scene::osm {
namespace {

constexpr Look kGateSteel = {{96, 100, 104}, 150, 255};
constexpr Look kGatePost = {{120, 112, 100}, 220, 255};
constexpr Look kBarrierRed = {{190, 60, 50}, 200, 255};
constexpr double kHalfGate = 0.9;  // metres, without a path

/// The points of a line within a distance of one of its points, on one side of it; nearest first.
std::vector<Point> part_of(const MapWay& way, std::size_t place, bool forwards, double reach) {
    std::vector<Point> part;
    const std::size_t count = way.points.size();
    Point from = way.points[place];
    double left = reach;
    std::size_t at = place;
    for (std::size_t i = 1; i < count && left > 0.0; ++i) {
        if (forwards ? at + 1 == count : at == 0) {
            if (!way.closed()) {
                break;
            }
            at = forwards ? 0 : count - 1;
        }
        at = forwards ? at + 1 : at - 1;
        const Point d = way.points[at] - from;
        const double length = norm(d);
        if (length > 0.0) {
            part.push_back(length <= left ? way.points[at] : Point(from + d * (left / length)));
        }
        left -= length;
        from = way.points[at];
    }
    return part;
}

/// As tagged, metres.
std::optional<double> half_width(const Tags& tags) {
    for (const char* key : {"maxwidth:physical", "width"}) {
        if (const auto width = length_of(tags, key)) {
            return std::clamp(0.5 * *width, 0.15, 10.0);
        }
    }
    return std::nullopt;
}

}  // namespace

bool is_gate(const Tags& tags) {
    constexpr std::array<std::string_view, 10> kGates = {
        "gate",      "swing_gate", "lift_gate",   "entrance",   "kissing_gate",
        "turnstile", "stile",      "wicket_gate", "toll_booth", "sliding_gate"};
    return std::ranges::find(kGates, tags.get("barrier")) != kGates.end();
}

bool is_closed(const Tags& tags) {
    return !admits_walkers(tags) || (tags.is("locked", "yes") && !tags.has("foot"));
}

double sine_between(const Point& a, const Point& b) {
    constexpr double kLeast = 1.0 / 3.0;
    return std::max(kLeast, std::abs(a.x() * b.y() - a.y() * b.x()));
}

std::vector<Point> gate_opening(const MapWay& barrier, std::size_t place, const MapNode& gate,
                                const PathNode& path) {
    double half = kHalfGate;
    if (const auto tagged = half_width(gate.tags)) {
        half = *tagged;
    } else if (path.path != nullptr) {
        half = std::max(
            half, 0.5 * path.path->width / sine_between(direction_at(barrier.points, place), path.along));
    }
    std::vector<Point> opening = part_of(barrier, place, false, half);
    std::vector<Point> after = part_of(barrier, place, true, half);
    // Where the barrier ends, or another one begins, straight on.
    const Point& at = barrier.points[place];
    const Point along = direction_at(barrier.points, place);
    if (opening.empty()) {
        opening.push_back(at - half * along);
    }
    if (after.empty()) {
        after.push_back(at + half * along);
    }
    std::ranges::reverse(opening);
    opening.push_back(at);
    opening.insert(opening.end(), after.begin(), after.end());
    return opening;
}

std::vector<Point> gate_opening(const MapNode& gate, const PathNode& path) {
    const double usual = path.path == nullptr ? kHalfGate : std::max(kHalfGate, 0.5 * path.path->width);
    const double half = half_width(gate.tags).value_or(usual);
    const Point across = left_of(path.along);
    return {gate.at - half * across, gate.at + half * across};
}

std::vector<Point> gate_opening(const MapWay& gate) {
    if (!gate.closed()) {
        return gate.points;
    }
    const Point& from = gate.points.front();
    return {from, *std::ranges::max_element(gate.points, {}, [&](const Point& p) { return norm(p - from); })};
}

void add_gate(const ElementId& id, const Tags& tags, const std::vector<Point>& opening,
              const Terrain& terrain, ModelBuilder& model, Built& built) {
    constexpr double kPostHalf = 0.08;
    if (opening.size() < 2) {
        return;
    }
    ObjectMesh& mesh = model.object("gate/" + id.text());
    const Point first = unit(opening[1] - opening[0]);
    const Point last = unit(opening.back() - opening[opening.size() - 2]);
    const double ground = terrain.height(opening.front());
    for (const auto& [at, along] :
         {std::pair<Point, Point>{opening.front(), -first}, {opening.back(), last}}) {
        const Point post = at + kPostHalf * along;
        const double foot = terrain.height(post);
        mesh.box(kGatePost, post, along, Point(kPostHalf, kPostHalf), foot - 0.2, foot + 1.4);
        built.add_obstacle(post, kPostHalf);
    }
    const std::string_view barrier = tags.get("barrier");
    if (barrier == "entrance") {
        return;
    }
    if (is_closed(tags)) {
        for (std::size_t i = 1; i < opening.size(); ++i) {
            const Point d = opening[i] - opening[i - 1];
            const double half = 0.5 * norm(d);
            const Point middle = 0.5 * (opening[i] + opening[i - 1]);
            const double foot = std::min(terrain.height(opening[i]), terrain.height(opening[i - 1]));
            mesh.box(kGateSteel, middle, unit(d), Point(half, 0.03), foot + 0.05, foot + 1.35);
            built.add_obstacle(middle, half * unit(d), 0.03 * left_of(unit(d)));
        }
    } else if (barrier == "lift_gate") {  // raised, as walkers go through
        mesh.box(kBarrierRed, opening.front(), first, Point(0.04, 0.04), ground + 0.9, ground + 3.0);
    } else {  // the leaf is turned aside
        const double half = std::min(1.5, 0.5 * (opening.back() - opening.front()).norm());
        const Point middle = opening.front() + half * left_of(first);
        mesh.box(kGateSteel, middle, left_of(first), Point(half, 0.03), ground + 0.1, ground + 1.3);
        built.add_obstacle(middle, half * left_of(first), 0.03 * first);
    }
}

}  // namespace campuswalk::scene::osm
