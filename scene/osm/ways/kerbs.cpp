#include "scene/osm/ways/kerbs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "scene/osm/geometry/box_index.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/surfaces.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kLowered = 0.03;  // metres, the highest that wheelchairs get over
constexpr double kRolled = 0.06;

/// The height of a kerb by its tags, metres; nullopt if they say nothing.
std::optional<double> kerb_height(const Tags& tags) {
    if (const auto height = length_of(tags, "kerb:height")) {
        return std::clamp(*height, 0.0, kKerb);
    }
    const std::string_view kerb = tags.get("kerb");
    return kerb == "lowered"                       ? std::optional(kLowered)
           : kerb == "flush" || kerb == "no"       ? std::optional(0.0)
           : kerb == "rolled"                      ? std::optional(kRolled)
           : kerb == "raised" || kerb == "regular" ? std::optional(kKerb)
                                                   : std::nullopt;
}

class KerbFinder {
public:
    KerbFinder(const Map& map, const std::vector<Path>& paths) : paths_(paths) {
        for (const MapNode& node : map.nodes) {
            if (const auto height = kerb_height(node.tags)) {
                tagged_.emplace(node.id, *height);
            }
            if (node.tags.is("highway", "crossing")) {
                crossings_.insert(node.id);
            }
        }
        for (std::size_t i = 0; i < paths.size(); ++i) {
            if (paths[i].carriageway && paths[i].on_ground() && !paths[i].area.empty()) {
                roads_.add(i, box_of(paths[i].area));
            }
            if (paths[i].crossing) {
                crossings_.insert(paths[i].way->nodes.begin(), paths[i].way->nodes.end());
            }
        }
    }

    void add_ramps(const Path& path, std::vector<Surface>& ramps) const {
        const std::vector<Point>& line = path.way->points;
        for (const std::size_t number : roads_.near(box_of(line))) {
            const Path& road = paths_[number];
            for (std::size_t i = 1; i < line.size(); ++i) {
                if (!box_of({line[i - 1], line[i]}).overlaps(box_of(road.area))) {
                    continue;
                }
                for (const Polygon& polygon : road.area) {
                    add_at_ring(path, road, i, polygon.outer, ramps);
                    for (const Ring& hole : polygon.holes) {
                        add_at_ring(path, road, i, hole, ramps);
                    }
                }
            }
        }
    }

private:
    /// Where the path's segment crosses a ring of a carriageway.
    void add_at_ring(const Path& path, const Path& road, std::size_t segment, const Ring& ring,
                     std::vector<Surface>& ramps) const {
        const Point& a = path.way->points[segment - 1];
        const Point d = path.way->points[segment] - a;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Point e = ring[(k + 1) % ring.size()] - ring[k];
            const double cross = d.x() * e.y() - d.y() * e.x();
            if (std::abs(cross) < 1e-9) {
                continue;
            }
            const Point from = ring[k] - a;
            const double t = (from.x() * e.y() - from.y() * e.x()) / cross;
            const double u = (from.x() * d.y() - from.y() * d.x()) / cross;
            if (t >= 0.0 && t <= 1.0 && u >= 0.0 && u < 1.0) {
                add_ramp(path, road, a + t * d, unit(e), ramps);
            }
        }
    }

    void add_ramp(const Path& path, const Path& road, const Point& at, const Point& along,
                  std::vector<Surface>& ramps) const {
        constexpr double kRun = 1.2;  // metres
        constexpr double kLeastWidth = 1.2;
        constexpr double kInwards = 0.3;  // hidden below the carriageway
        constexpr int kPriority = 83;     // above sidewalks
        constexpr Look kLook = {{168, 164, 156}, 235, 255};
        const double height = height_at(path, road, at);
        if (height > kKerb - 0.01) {
            return;
        }
        const Point out(along.y(), -along.x());  // rings run counter-clockwise, holes clockwise
        const Point half = 0.5 * std::max(kLeastWidth, path.width) * along;
        const Ring ring = {at - half + kRun * out, at - half - kInwards * out, at + half - kInwards * out,
                           at + half + kRun * out};
        Surface ramp{"kerb-ramp/" + ElementId{ElementKind::way, path.way->id}.text(),
                     {Polygon{ring, {}}},
                     kLook,
                     kPriority,
                     height - kKerb};
        ramp.fall = Fall{at, -out, (kKerb - height) / kRun};
        if (signed_area(ring) < 0.0) {
            std::ranges::reverse(ramp.area.front().outer);
        }
        ramps.push_back(std::move(ramp));
    }

    double height_at(const Path& path, const Path& road, const Point& at) const {
        constexpr double kNear = 3.0;  // metres: kerbs are where the carriageway was wider or narrower
        std::optional<double> height;
        double nearest = kNear;
        bool crossing = path.crossing;
        for (std::size_t i = 0; i < path.way->nodes.size(); ++i) {
            const Point off = path.way->points[i] - at;
            const double distance = norm(off);
            const auto tagged = tagged_.find(path.way->nodes[i]);
            if (tagged != tagged_.end() && distance < nearest) {
                nearest = distance;
                height = tagged->second;
            }
            crossing =
                crossing || (distance < 0.5 * road.width + 1.5 && crossings_.contains(path.way->nodes[i]));
        }
        if (height) {
            return *height;
        }
        return kerb_height(path.way->tags).value_or(crossing ? kLowered : kKerb);
    }

    const std::vector<Path>& paths_;
    std::unordered_map<std::int64_t, double> tagged_;
    std::unordered_set<std::int64_t> crossings_;
    BoxIndex roads_;
};

}  // namespace

std::vector<Surface> kerb_ramps(const Map& map, const std::vector<Path>& paths) {
    const KerbFinder finder(map, paths);
    std::vector<Surface> ramps;
    for (const Path& path : paths) {
        if (!path.carriageway && !path.steps && path.on_ground()) {
            finder.add_ramps(path, ramps);
        }
    }
    return ramps;
}

}  // namespace campuswalk::scene::osm
