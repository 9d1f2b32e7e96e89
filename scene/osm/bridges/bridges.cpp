#include "scene/osm/bridges/bridges.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "scene/osm/bridges/bridge_crossings.h"
#include "scene/osm/bridges/bridge_network.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kHigh = 0.3;  // metres above the ground: below that it is the ground

class Planner {
public:
    Planner(const Map& map, const std::vector<MapArea>& areas, const Terrain& base, const SourceMark& mark,
            std::vector<Path>& paths, DiagnosticList& warnings)
        : map_(map),
          base_(base),
          mark_(mark),
          paths_(paths),
          warnings_(warnings),
          network_(areas, paths),
          crossed_(map, areas, paths) {}

    BridgePlan plan() {
        for (Bridge& bridge : network_.bridges()) {
            if (raise(bridge)) {
                plan_.bridges.push_back(std::move(bridge));
            }
        }
        return std::move(plan_);
    }

private:
    /// Gives its paths their heights; false if they stay at the ground.
    bool raise(Bridge& bridge) {
        std::unordered_map<std::int64_t, double> heights = heights_between_ends(bridge);
        double lack = -1e300;
        std::vector<Crossed> below;
        for (const std::size_t i : bridge.paths) {
            const Path& path = paths_[i];
            for (const Crossed& crossed : crossed_.below(path)) {
                const double from = heights.at(path.way->nodes[crossed.segment]);
                const double to = heights.at(path.way->nodes[crossed.segment + 1]);
                const double ground = crossed.path != nullptr && crossed.path->is_above()
                                          ? deck_height(*crossed.path, crossed.at)
                                          : base_.height(crossed.at);
                lack = std::max(
                    lack, ground + crossed.clearance + bridge.thickness - (from + crossed.t * (to - from)));
                below.push_back(crossed);
                add_cutting(crossed, path);
            }
        }
        const double rise = std::max(0.0, lack);
        if (below.empty() && !is_over_a_valley(bridge, heights)) {
            warn_of_ground(bridge);
            return false;
        }
        for (const std::size_t i : bridge.paths) {
            Path& path = paths_[i];
            for (const std::int64_t node : path.way->nodes) {
                path.deck.push_back(heights.at(node) + rise);
            }
        }
        for (const std::int64_t end : bridge.open_ends) {
            add_mound(end, heights.at(end) + rise, 1.0 + 0.5 * network_.width_at(end));
            note_paths(end, heights.at(end) + rise, bridge);
        }
        for (const std::int64_t end : bridge.stair_ends) {
            hang_stairs(end, heights.at(end) + rise, 0);
            note_paths(end, heights.at(end) + rise, bridge);
        }
        return true;
    }

    void note_paths(std::int64_t node, double height, Bridge& bridge) const {
        for (const auto& [path, place] : network_.at(node)) {
            if (paths_[path].steps) {
                bridge.stairs.push_back({path, place, height});
            } else if (!BridgeNetwork::may_be_above(paths_[path])) {
                bridge.leading_on.push_back({path, place, height});
            }
        }
    }

    /// Straight from end to end.
    std::unordered_map<std::int64_t, double> heights_between_ends(const Bridge& bridge) const {
        constexpr std::size_t kMostEnds = 8;
        std::vector<std::int64_t> ends = bridge.open_ends.empty() ? bridge.stair_ends : bridge.open_ends;
        if (ends.empty()) {
            for (const std::size_t i : bridge.paths) {
                ends.push_back(paths_[i].way->nodes.front());
                ends.push_back(paths_[i].way->nodes.back());
            }
        }
        ends.resize(std::min(ends.size(), kMostEnds));
        std::unordered_map<std::int64_t, std::pair<double, double>> sums;  // of weights, and weighted heights
        for (const std::int64_t end : ends) {
            const auto& [path, place] = network_.at(end).front();
            const double height = base_.height(paths_[path].way->points[place]);
            for (const auto& [node, distance] : network_.distances_from(end, bridge)) {
                const double weight = 1.0 / std::max(distance, 1e-6);
                sums[node].first += weight;
                sums[node].second += weight * height;
            }
        }
        std::unordered_map<std::int64_t, double> heights;
        for (const auto& [node, sum] : sums) {
            heights[node] = sum.second / sum.first;
        }
        return heights;
    }

    bool is_over_a_valley(const Bridge& bridge,
                          const std::unordered_map<std::int64_t, double>& heights) const {
        for (const std::size_t i : bridge.paths) {
            const MapWay& way = *paths_[i].way;
            for (std::size_t k = 1; k < way.nodes.size(); ++k) {
                constexpr int kSamples = 16;
                for (int s = 0; s <= kSamples; ++s) {
                    const double t = static_cast<double>(s) / kSamples;
                    const double deck = heights.at(way.nodes[k - 1]) +
                                        t * (heights.at(way.nodes[k]) - heights.at(way.nodes[k - 1]));
                    if (deck - base_.height(way.points[k - 1] + t * (way.points[k] - way.points[k - 1])) >
                        kHigh + bridge.thickness) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    void warn_of_ground(const Bridge& bridge) const {
        for (const std::size_t i : bridge.paths) {
            const Path& path = paths_[i];
            if (affirmed(path.way->tags, "bridge") && box_of(path.way->points).overlaps(map_.box)) {
                warnings_.warning(
                    mark_, "bridge-at-ground",
                    "way " + std::to_string(path.way->id) +
                        " is a bridge, but nothing that the map has passes below it; it is at the "
                        "ground");
            }
        }
    }

    void add_cutting(const Crossed& crossed, const Path& bridge) {
        constexpr double kBeside = 0.5;
        if (crossed.path == nullptr || !crossed.path->is_above()) {
            plan_.cuttings.push_back(
                {crossed.at, crossed.along, 0.5 * crossed.width + kBeside, 0.5 * bridge.width + 2.0});
        }
    }

    void add_mound(std::int64_t node, double height, double flat) {
        const auto& [path, place] = network_.at(node).front();
        const Point at = paths_[path].way->points[place];
        const double rise = height - base_.height(at);
        if (rise > 0.02) {
            plan_.mounds.push_back({at, rise, flat});
        }
    }

    /// Lets the steps at a node begin at a height, and what they lead to follow.
    void hang_stairs(std::int64_t node, double height, int depth) {
        constexpr int kMostFlights = 64;
        for (const auto& [number, place] : network_.at(node)) {
            Path& path = paths_[number];
            const std::size_t last = path.way->nodes.size() - 1;
            if (!path.steps || (place != 0 && place != last) || path.hangs() || last == 0) {
                continue;
            }
            const std::size_t far = place == 0 ? last : 0;
            const std::int64_t other = path.way->nodes[far];
            const double ground = base_.height(path.way->points[far]);
            double low = std::max(ground, height - greatest_rise(path));
            low = low - ground < kHigh ? ground : low;
            (place == 0 ? path.first_height : path.last_height) = height;
            (place == 0 ? path.last_height : path.first_height) = low;
            if (low <= ground || depth > kMostFlights) {
                continue;
            }
            const bool only_steps = std::ranges::all_of(
                network_.at(other), [&](const auto& at) { return paths_[at.first].steps; });
            if (only_steps && network_.at(other).size() > 1) {
                hang_stairs(other, low, depth + 1);
            } else {
                add_mound(other, low, 1.0 + 0.5 * network_.width_at(other));
            }
        }
    }

    const Map& map_;
    const Terrain& base_;
    const SourceMark& mark_;
    std::vector<Path>& paths_;
    DiagnosticList& warnings_;
    BridgeNetwork network_;
    CrossedByBridges crossed_;
    BridgePlan plan_;
};

/// Says what is below the ground, and how much is on floors of buildings.
void warn_of_unbuilt(const Map& map, const std::vector<Path>& paths, const SourceMark& mark,
                     DiagnosticList& warnings) {
    std::vector<std::int64_t> indoors;
    for (const Path& path : paths) {
        if (!box_of(path.way->points).overlaps(map.box)) {
            continue;
        }
        const std::string way = "way " + std::to_string(path.way->id);
        if (path.indoors) {
            indoors.push_back(path.way->id);
        } else if (path.unbuilt) {
            warnings.warning(mark, "underground",
                             way + " runs below the ground, or indoors on another floor; it isn't built");
        } else if (layer_of(path.way->tags) < 0.0 && !affirmed(path.way->tags, "tunnel")) {
            warnings.warning(mark, "underground", way + " has a layer below 0; it is at the ground");
        }
    }
    if (!indoors.empty()) {
        const bool one = indoors.size() == 1;
        warnings.warning(
            mark, "indoor-ways",
            std::to_string(indoors.size()) + (one ? " way (" : " ways (the first: ") + "way " +
                std::to_string(indoors.front()) + (one ? ") is" : ") are") +
                " on floors inside of buildings; left out, as buildings are closed blocks. Tag a "
                "passage at the ground with tunnel=building_passage");
    }
}

}  // namespace

double height_along(const std::vector<Point>& line, const std::vector<double>& heights, const Point& p) {
    double nearest = 1e300;
    double height = heights.empty() ? 0.0 : heights.front();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point d = line[i] - line[i - 1];
        const double length2 = d.x() * d.x() + d.y() * d.y();
        const Point from = p - line[i - 1];
        const double t =
            length2 > 0.0 ? std::clamp((from.x() * d.x() + from.y() * d.y()) / length2, 0.0, 1.0) : 0.0;
        const Point off = from - t * d;
        const double distance = off.x() * off.x() + off.y() * off.y();
        if (distance < nearest) {
            nearest = distance;
            height = heights[i - 1] + t * (heights[i] - heights[i - 1]);
        }
    }
    return height;
}

double deck_height(const Path& path, const Point& p) {
    return height_along(path.way->points, path.deck, p);
}

BridgePlan plan_bridges(const Map& map, const std::vector<MapArea>& areas, const Terrain& base,
                        const SourceMark& mark, std::vector<Path>& paths, DiagnosticList& warnings) {
    for (Path& path : paths) {
        path.deck.clear();
        path.first_height.reset();
        path.last_height.reset();
    }
    warn_of_unbuilt(map, paths, mark, warnings);
    return Planner(map, areas, base, mark, paths, warnings).plan();
}

}  // namespace campuswalk::scene::osm
