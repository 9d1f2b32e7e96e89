#include "scene/osm/meaning/doors.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

constexpr Look kLeaf = {{92, 66, 48}, 160, 255};
constexpr Look kMainLeaf = {{70, 84, 96}, 90, 255};

/// A node of a building's outline.
struct Door {
    std::int64_t node = 0;  ///< nothing if it is assumed
    Point at = Point::Zero();
    std::size_t area = 0;
    const Tags* tags = nullptr;  ///< null: not tagged
    bool assumed = false;
    std::optional<double> height = {};  ///< of a bridge that leads to it; else it is at the ground
};

/// The paths on the ground that walkers may take.
class PathSegments {
public:
    static constexpr double kFarthest = 40.0;  ///< metres: what is farther isn't looked for

    explicit PathSegments(const std::vector<Path>& paths) {
        for (const Path& path : paths) {
            if (!path.for_walkers || !path.on_ground() || path.steps) {
                continue;
            }
            for (std::size_t i = 1; i < path.way->points.size(); ++i) {
                index_.add(segments_.size(), box_of({path.way->points[i - 1], path.way->points[i]}));
                segments_.push_back({path.way->points[i - 1], path.way->points[i]});
            }
        }
    }

    /// Large if none is near.
    double distance_to(const Point& p) const {
        double nearest = 1e300;
        for (const std::size_t i : index_.near(Box{p, p}.grown(kFarthest))) {
            nearest = std::min(nearest, nearest_on(segments_[i], false, p).distance);
        }
        return nearest;
    }

private:
    std::vector<std::vector<Point>> segments_;
    BoxIndex index_;
};

class Doors {
public:
    Doors(const Site& site, const FreeGround& free, const std::vector<Polygons>& openings,
          ModelBuilder& model, CampusDraft& draft)
        : site_(site),
          free_(free),
          open_(openings),
          model_(model),
          draft_(draft),
          volumes_(index_of_volumes(site)) {
        for (const Volume& volume : site.volumes) {
            walled_.insert(volume.building);
        }
        for (const std::size_t area : walled_) {
            outlines_.add(area, box_of(site.areas[area].polygons));
        }
        for (std::size_t i = 0; i < openings.size(); ++i) {
            openings_.add(i, box_of(openings[i]));
        }
        for (const Path& path : site.paths) {
            for (const std::size_t i : ends_for_visitors(path)) {
                const bool is_new = led_to_.try_emplace(path.way->nodes[i], height_at(path, i)).second;
                if (!is_new && !path.is_above()) {  // rather on the ground than on a bridge
                    led_to_[path.way->nodes[i]].reset();
                }
            }
        }
        for (std::size_t i = 0; i < site.areas.size(); ++i) {
            for (const MapWay* way : site.areas[i].outlines) {
                for (std::size_t k = 0; walled_.contains(i) && k < way->nodes.size(); ++k) {
                    on_wall_.try_emplace(way->nodes[k], i);
                }
            }
        }
    }

    void add_tagged() {
        std::vector<const MapNode*> on_other_floors;
        for (const MapNode& node : site_.map.nodes) {
            if (!is_entrance(node.tags)) {
                continue;
            }
            const auto wall = on_wall_.find(node.id);
            const auto led_to = led_to_.find(node.id);
            const bool is_led_to = wall != on_wall_.end() && led_to != led_to_.end();
            if (number_of(node.tags, "level").value_or(0.0) != 0.0 && !is_led_to) {
                if (site_.map.box.contains(node.at)) {
                    on_other_floors.push_back(&node);
                }
            } else if (wall != on_wall_.end()) {
                add({node.id, node.at, wall->second, &node.tags, false,
                     is_led_to ? led_to->second : std::nullopt});
            } else if (affirmed(node.tags, "entrance")) {
                add_beside(node);
            }
        }
        if (!on_other_floors.empty()) {
            const bool one = on_other_floors.size() == 1;
            site_.warn(
                "entrance-on-floor",
                std::to_string(on_other_floors.size()) + (one ? " entrance (" : " entrances (the first: ") +
                    "node " + std::to_string(on_other_floors.front()->id) + ", level=" +
                    std::string(on_other_floors.front()->tags.get("level")) + (one ? ") is" : ") are") +
                    " on another floor than the ground floor, with no way that leads there; left "
                    "out");
        }
    }

    void add_untagged() {
        for (const Path& path : site_.paths) {
            for (const std::size_t i : ends_for_visitors(path)) {
                if (const auto wall = on_wall_.find(path.way->nodes[i]); wall != on_wall_.end()) {
                    add({path.way->nodes[i], path.way->points[i], wall->second, nullptr, false,
                         height_at(path, i)});
                }
            }
        }
    }

    /// Every building with a name can be entered: where no door is known, at its wall nearest to a path.
    void add_assumed() {
        const PathSegments segments(site_.paths);
        for (const std::size_t area : walled_) {
            const MapArea& building = site_.areas[area];
            if (!building.tags.has("name") || with_door_.contains(area) ||
                building.polygons.front().outer.size() < 3) {
                continue;
            }
            if (const auto at = wall_nearest_to(segments, building.polygons.front().outer)) {
                add({0, *at, area, nullptr, true});
            }
        }
    }

private:
    /// Where a path may lead to doors.
    static std::vector<std::size_t> ends_for_visitors(const Path& path) {
        if (!path.for_walkers || path.unbuilt || path.highway == "service" || path.width > 4.5) {
            return {};
        }
        return {0, path.way->nodes.size() - 1};
    }

    /// How high a bridge is at one of its nodes; nullopt for a path on the ground.
    static std::optional<double> height_at(const Path& path, std::size_t place) {
        return path.is_above() ? std::optional(path.deck[place]) : std::nullopt;
    }

    /// The middle of the ring's side that is nearest to a path and has room in front.
    std::optional<Point> wall_nearest_to(const PathSegments& segments, const Ring& ring) const {
        constexpr double kLeastDoorWall = 2.0;
        double nearest = PathSegments::kFarthest;
        std::optional<Point> at;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& a = ring[i];
            const Point& b = ring[(i + 1) % ring.size()];
            const Point middle = 0.5 * (a + b);
            if (norm(b - a) < kLeastDoorWall || !free_.at(middle + 1.0 * -left_of(unit(b - a)))) {
                continue;
            }
            if (const double distance = segments.distance_to(middle); distance < nearest) {
                nearest = distance;
                at = middle;
            }
        }
        return at;
    }

    /// At the nearest wall: some are drawn beside it.
    void add_beside(const MapNode& node) {
        constexpr double kFarthest = 3.0;  // metres
        double nearest = kFarthest;
        Point at = node.at;
        std::optional<std::size_t> area;
        for (const std::size_t i : outlines_.near(Box{node.at, node.at}.grown(kFarthest))) {
            if (const Nearest wall = nearest_on(site_.areas[i].polygons, node.at); wall.distance < nearest) {
                nearest = wall.distance;
                at = wall.at;
                area = i;
            }
        }
        if (area) {
            add({node.id, at, *area, &node.tags, false});
        } else if (site_.map.box.contains(node.at)) {
            site_.warn("entrance-without-wall",
                       "node " + std::to_string(node.id) + " is an entrance, but no wall is near");
        }
    }

    void add(const Door& door) {
        if (!site_.map.box.contains(door.at) || (!door.assumed && !done_.insert(door.node).second)) {
            return;
        }
        const Nearest wall = nearest_on(site_.areas[door.area].polygons, door.at);
        constexpr double kOnWall = 0.05;
        const double floor = door.height.value_or(site_.terrain.height(door.at));
        if (wall.distance > kOnWall || (!door.height && !is_wall_at(door.at))) {
            return;
        }
        if (!door.height) {
            with_door_.insert(door.area);
        }
        const Point out(wall.along.y(), -wall.along.x());  // rings run counter-clockwise, holes clockwise
        const MapArea& area = site_.areas[door.area];
        const std::string building = draft_id("building", area.id);
        const std::string name =
            door.assumed ? draft_id("assumed-entrance", area.id)
                         : draft_id("entrance", {ElementKind::way, door.node});  // no "n" before it
        const bool main = door.tags != nullptr && door.tags->is("entrance", "main");
        const bool in_passage = is_open_at(door.at);
        if (!in_passage) {
            const ElementId id = door.assumed ? area.id : ElementId{ElementKind::node, door.node};
            model_.object("door/" + id.text())
                .box(main ? kMainLeaf : kLeaf, door.at, wall.along, Point(main ? 0.9 : 0.55, 0.05),
                     floor - 0.05, floor + 2.15);
        }
        DraftTrigger trigger;
        trigger.id = building + "/" + name;
        trigger.building = area.tags.has("name") ? building : "";
        trigger.size = {main ? 2.4 : 1.6, 2.4, 2.4};
        trigger.center = {door.at.x(), floor + 1.2, -door.at.y()};
        trigger.yaw_deg = yaw_along(wall.along);
        trigger.layer = "door";
        draft_.triggers.push_back(trigger);
        if (!door.height && !add_place_before(door, name, out, trigger.id, main) && door.tags != nullptr) {
            site_.warn("blocked-door", "node " + std::to_string(door.node) + " is an entrance of " +
                                           area.id.text() +
                                           ", but nobody can stand before it; no walk goes there");
        }
    }

    /// On the ground; of bridges, not every one can be got onto. False if there is no room.
    bool add_place_before(const Door& door, const std::string& name, const Point& out,
                          const std::string& trigger, bool main) {
        const bool titled = site_.areas[door.area].tags.has("name");
        for (const double distance : {1.0, 0.75}) {
            const Point front = door.at + distance * out;
            if (free_.at(front)) {
                draft_.places.push_back({name, site_.world(front), trigger,
                                         (titled ? 4 : 0) + (main ? 2 : 0) + (door.tags != nullptr ? 1 : 0)});
                return true;
            }
        }
        return false;
    }

    /// Whether a wall stands on the ground there: some outlines are those of roofs, or of parts above.
    bool is_wall_at(const Point& at) const {
        constexpr double kOnWall = 0.3;
        return std::ranges::any_of(volumes_.near(Box{at, at}.grown(kOnWall)), [&](std::size_t i) {
            return nearest_on(site_.volumes[i].footprint, at).distance < kOnWall;
        });
    }

    bool is_open_at(const Point& at) const {
        const std::vector<std::size_t> near = openings_.at(at);
        return std::ranges::any_of(near, [&](std::size_t i) { return contains(open_[i], at); });
    }

    const Site& site_;
    const FreeGround& free_;
    const std::vector<Polygons>& open_;  ///< in walls
    ModelBuilder& model_;
    CampusDraft& draft_;
    std::set<std::size_t> walled_;
    BoxIndex openings_;
    BoxIndex outlines_;                                      ///< of areas with walls
    BoxIndex volumes_;                                       ///< that stand on the ground
    std::unordered_map<std::int64_t, std::size_t> on_wall_;  ///< areas by node
    /// For each node at which paths end, the height of the bridge that leads there, if exactly one does.
    std::unordered_map<std::int64_t, std::optional<double>> led_to_;
    std::set<std::int64_t> done_;
    std::set<std::size_t> with_door_;
};

}  // namespace

void add_doors(const Site& site, const FreeGround& free, const std::vector<Polygons>& openings,
               ModelBuilder& model, CampusDraft& draft) {
    Doors doors(site, free, openings, model, draft);
    doors.add_tagged();
    doors.add_untagged();
    doors.add_assumed();
    draft.solids.push_back({"door", {"door/*"}, "", "door", true});  // left out if there is none
}

}  // namespace campuswalk::scene::osm
