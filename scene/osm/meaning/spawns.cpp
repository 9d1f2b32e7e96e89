#include "scene/osm/meaning/spawns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "collision/geometry/trigonometry.h"
#include "scene/osm/meaning/gates.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/path_nodes.h"

namespace campuswalk::scene::osm {
namespace {

DraftSpawn spawn_at(const Site& site, const std::string& name, const Point& at, const Point& towards) {
    return {name, site.world(at), yaw_towards(towards)};
}

/// Where somebody could start, and how much one would rather start elsewhere.
struct Candidate {
    Point at = Point::Zero();
    Point towards = Point(0, 1);
    double cost = 1e300;
};

/// Points of paths for walkers, the nearer to the middle the better, rather than beside traffic.
void consider_paths(const Site& site, const FreeGround& free, const Point& middle, Candidate& best) {
    constexpr double kRoad = 50.0;  // metres of detour to stand beside the traffic
    constexpr double kSample = 3.0;
    const Box box = site.map.box.grown(-2.0);
    for (const Path& path : site.paths) {
        if (!path.for_walkers || !path.on_ground() || path.steps) {
            continue;
        }
        const double road = path.width > 4.5 ? kRoad : 0.0;
        const std::vector<Point>& points = path.way->points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point d = points[i] - points[i - 1];
            const double length = norm(d);
            const int samples = std::clamp(static_cast<int>(length / kSample), 1, 2'000);
            for (int k = 0; k <= samples; ++k) {
                const Point p = points[i - 1] + d * (static_cast<double>(k) / samples);
                const Point off = p - middle;
                const double cost = norm(off) + road;
                if (cost < best.cost && box.contains(p) && free.is_start(p)) {
                    best = {p, unit(d), cost};
                }
            }
        }
    }
}

/// Points in ever larger squares around the middle.
void consider_open_ground(const Site& site, const FreeGround& free, const Point& middle, Candidate& best) {
    constexpr double kStep = 3.0;
    constexpr int kMost = 200;
    for (int ring = 0; ring < kMost && best.cost > 1e299; ++ring) {
        for (int x = -ring; x <= ring; ++x) {
            for (int y = -ring; y <= ring; ++y) {
                const Point p = middle + kStep * Point(x, y);
                if (std::max(std::abs(x), std::abs(y)) == ring && site.map.box.contains(p) &&
                    free.is_start(p)) {
                    best = {p, Point(0, 1), 0.0};
                    return;
                }
            }
        }
    }
}

DraftSpawn start_of(const Site& site, const FreeGround& free) {
    const Point middle = 0.5 * (site.map.box.min + site.map.box.max);
    Candidate best;
    consider_paths(site, free, middle, best);
    if (best.cost > 1e299) {
        consider_open_ground(site, free, middle, best);
    }
    if (best.cost > 1e299) {
        best = {site.map.box.min + Point(1, 1), Point(0, 1), 0.0};
        site.warn("no-start", "there is no free ground to start on");
    }
    return spawn_at(site, "start", best.at, best.towards);
}

/// From a stop: the nearest door of a building with a name that is seen from there, or else where the view
/// is free the farthest.
Point view_from(const std::vector<DraftPlace>& places, const FreeGround& free, const Point& at) {
    constexpr double kFarthest = 80.0;  // metres
    constexpr double kBeforeDoor = 3.0;
    constexpr int kTitled = 4;  // the least importance of places at buildings with a name
    Point best(0, 1);
    double nearest = kFarthest;
    for (const DraftPlace& place : places) {
        const Point door = Point(place.at.x(), -place.at.z()) - at;
        const double distance = norm(door);
        if (place.importance >= kTitled && distance < nearest &&
            free.sight(at, unit(door), distance) >= distance - kBeforeDoor) {
            nearest = distance;
            best = unit(door);
        }
    }
    if (nearest < kFarthest) {
        return best;
    }
    constexpr int kDirections = 16;
    double farthest = 0.0;
    for (int i = 0; i < kDirections; ++i) {
        const collision::SinCos angle = collision::sin_cos(i * (360.0 / kDirections) * kDegree);
        const Point direction(angle.sin, angle.cos);
        if (const double sight = free.sight(at, direction, kFarthest); sight > farthest) {
            farthest = sight;
            best = direction;
        }
    }
    return best;
}

/// A step before or behind a gate, facing it, or a stop, with a view.
void add_beside(const Site& site, const FreeGround& free, CampusDraft& draft, const ElementId& id, bool gate,
                const Point& of, const Point& towards) {
    constexpr double kStep = 2.0;
    for (const Point& at : {Point(of - kStep * towards), Point(of + kStep * towards)}) {
        if (free.is_start(at) && site.map.box.contains(at)) {
            draft.spawns.push_back(spawn_at(site, draft_id(gate ? "gate" : "stop", id), at,
                                            gate ? Point(of - at) : view_from(draft.places, free, at)));
            return;
        }
    }
}

/// At gates a step away along the path, at stops beside them.
void add_gates_and_stops(const Site& site, const FreeGround& free, CampusDraft& draft) {
    std::map<std::int64_t, std::pair<const MapWay*, std::size_t>> on_path;  // by node
    for (const Path& path : site.paths) {
        for (std::size_t i = 0; path.for_walkers && path.on_ground() && i < path.way->nodes.size(); ++i) {
            on_path.try_emplace(path.way->nodes[i], path.way, i);
        }
    }
    for (const MapNode& node : site.map.nodes) {
        const bool gate = is_gate(node.tags);
        if (!site.map.box.grown(-1.0).contains(node.at) || (!gate && !is_stop(node.tags))) {
            continue;
        }
        Point towards(0, 1);
        if (const auto found = on_path.find(node.id); found != on_path.end()) {
            towards = direction_at(found->second.first->points, found->second.second);
        }
        add_beside(site, free, draft, {ElementKind::node, node.id}, gate, node.at, towards);
    }
    for (const MapWay& way : site.map.ways) {
        if (is_gate(way.tags) && way.points.size() > 1) {
            const std::vector<Point> opening = gate_opening(way);
            const Point middle = 0.5 * (opening.front() + opening.back());
            if (site.map.box.grown(-1.0).contains(middle)) {
                add_beside(site, free, draft, {ElementKind::way, way.id}, true, middle,
                           left_of(unit(opening.back() - opening.front())));
            }
        }
    }
}

}  // namespace

bool is_stop(const Tags& tags) {
    return tags.is("highway", "bus_stop") || tags.is("railway", "tram_stop") ||
           tags.is("railway", "station") || tags.is("public_transport", "platform") ||
           tags.is("public_transport", "station") || tags.is("amenity", "taxi");
}

void add_spawns(const Site& site, const FreeGround& free, CampusDraft& draft) {
    draft.spawns.push_back(start_of(site, free));
    add_gates_and_stops(site, free, draft);
}

}  // namespace campuswalk::scene::osm
