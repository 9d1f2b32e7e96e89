#include "scene/osm/objects/barriers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "scene/osm/geometry/box_index.h"
#include "scene/osm/geometry/extrude.h"
#include "scene/osm/meaning/gates.h"
#include "scene/osm/read/tag_values.h"
#include "scene/osm/ways/path_nodes.h"

namespace campuswalk::scene::osm {
namespace {

/// A kind of line that one can't pass.
struct LineKind {
    std::string_view value;
    double height;  ///< metres, where nothing is tagged
    double thickness;
    Look look;
};

constexpr std::array<LineKind, 11> kLines = {{
    {"wall", 1.6, 0.3, {{186, 178, 164}, 235, 255}},
    {"retaining_wall", 1.0, 0.4, {{168, 164, 156}, 235, 255}},
    {"city_wall", 5.0, 1.0, {{180, 168, 146}, 235, 255}},
    {"fence", 1.5, 0.06, {{108, 116, 112}, 200, 150}},
    {"hedge", 1.3, 0.7, {{76, 112, 58}, 250, 255}},
    {"guard_rail", 0.75, 0.15, {{160, 164, 166}, 150, 255}},
    {"handrail", 0.95, 0.06, {{110, 114, 118}, 150, 255}},
    {"jersey_barrier", 0.8, 0.5, {{176, 174, 168}, 235, 255}},
    {"cable_barrier", 0.75, 0.06, {{160, 164, 166}, 150, 150}},
    {"chain", 0.6, 0.05, {{110, 114, 118}, 150, 150}},
    {"cycle_barrier", 1.0, 0.06, {{190, 60, 50}, 200, 255}},
}};

constexpr Look kGateSteel = {{96, 100, 104}, 150, 255};
constexpr Look kBarrierRed = {{190, 60, 50}, 200, 255};

const LineKind* line_kind(const Tags& tags) {
    const auto* found = std::ranges::find(kLines, tags.get("barrier"), &LineKind::value);
    return found == kLines.end() ? nullptr : found;
}

/// Where a segment crosses a line of points, if it does.
void add_crossings(const Point& a, const Point& b, const std::vector<Point>& line,
                   std::vector<Point>& found) {
    const Point d = b - a;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point e = line[i] - line[i - 1];
        const double cross = d.x() * e.y() - d.y() * e.x();
        if (std::abs(cross) < 1e-12) {
            continue;
        }
        const Point from = line[i - 1] - a;
        const double t = (from.x() * e.y() - from.y() * e.x()) / cross;
        const double u = (from.x() * d.y() - from.y() * d.x()) / cross;
        constexpr double kSlack = 1e-6;
        if (t >= -kSlack && t <= 1.0 + kSlack && u >= -kSlack && u <= 1.0 + kSlack) {
            found.push_back(a + t * d);
        }
    }
}

bool is_built(const MapWay& way) {
    return way.points.size() > 1 && !affirmed(way.tags, "building") &&
           number_of(way.tags, "layer").value_or(0.0) >= 0.0;
}

bool is_line(const MapWay& way) {
    return line_kind(way.tags) != nullptr && is_built(way);
}

/// Where a map's barriers are open: at gates, and where paths cross them.
class Openings {
public:
    explicit Openings(const Site& site) : site_(site), on_path_(path_nodes(site.paths)) {
        for (std::size_t i = 0; i < site.paths.size(); ++i) {
            if (site.paths[i].for_walkers && site.paths[i].on_ground()) {
                paths_.add(i, box_of(site.paths[i].way->points));
            }
        }
        for (const MapNode& node : site.map.nodes) {
            if (is_gate(node.tags)) {
                gates_.emplace(node.id, &node);
            }
        }
        for (const MapWay& way : site.map.ways) {
            if (is_built(way) && is_gate(way.tags)) {
                gate_lines_.add(gate_ways_.size(), box_of(way.points));
                gate_ways_.push_back(&way);
            }
            for (std::size_t i = 0; is_line(way) && i < way.nodes.size(); ++i) {
                if (const auto gate = gates_.find(way.nodes[i]); gate != gates_.end()) {
                    along_barriers_.try_emplace(gate->first,
                                                gate_opening(way, i, *gate->second, path_at(gate->first)));
                }
            }
        }
    }

    PathNode path_at(std::int64_t node) const {
        const auto found = on_path_.find(node);
        return found == on_path_.end() ? PathNode{} : found->second;
    }

    /// Of a gate: along the barrier that it is in, if it is in one.
    std::vector<Point> at_gate(const MapNode& gate) const {
        const auto found = along_barriers_.find(gate.id);
        return found == along_barriers_.end() ? gate_opening(gate, path_at(gate.id)) : found->second;
    }

    /// What is to be cut out of a barrier of this thickness.
    std::vector<Polygons> gaps_of(const MapWay& way, double thickness) const {
        constexpr double kDeep = 0.15;  // beyond the barrier's faces
        std::vector<Polygons> gaps;
        std::vector<Point> gates;
        for (std::size_t i = 0; i < way.nodes.size(); ++i) {
            if (const auto gate = gates_.find(way.nodes[i]); gate != gates_.end()) {
                if (!is_closed(gate->second->tags)) {  // where two barriers end, the gap is in both
                    gaps.push_back(
                        site_.geometry.buffer(gate_opening(way, i, *gate->second, path_at(way.nodes[i])),
                                              0.5 * thickness + kDeep, Caps::flat));
                }
                gaps.push_back(site_.geometry.buffer(along_barriers_.at(way.nodes[i]),
                                                     0.5 * thickness + kDeep, Caps::flat));
                gates.push_back(way.points[i]);
            }
        }
        for (const std::size_t number : gate_lines_.near(box_of(way.points))) {
            gaps.push_back(site_.geometry.buffer(gate_opening(*gate_ways_[number]), 0.5 * thickness + kDeep,
                                                 Caps::flat));
        }
        for (std::size_t i = 1; i < way.points.size(); ++i) {
            const Point& a = way.points[i - 1];
            const Point& b = way.points[i];
            for (const std::size_t number : paths_.near(box_of({a, b}))) {
                add_gaps_for(site_.paths[number], a, b, 0.5 * thickness + kDeep, gates, gaps);
            }
        }
        return gaps;
    }

private:
    /// Where a path crosses a segment of a barrier, besides at gates.
    void add_gaps_for(const Path& path, const Point& a, const Point& b, double half_depth,
                      const std::vector<Point>& gates, std::vector<Polygons>& gaps) const {
        constexpr double kRoom = 0.35;
        constexpr double kLeast = 0.9;
        constexpr double kAtGate = 0.6;
        std::vector<Point> crossings;
        add_crossings(a, b, path.way->points, crossings);
        for (const Point& at : crossings) {
            const std::vector<std::size_t> near = gate_lines_.near(Box{at, at}.grown(kAtGate));
            if (std::ranges::any_of(gates, [&](const Point& gate) { return (gate - at).norm() < kAtGate; }) ||
                std::ranges::any_of(near, [&](std::size_t i) {
                    return nearest_on(gate_opening(*gate_ways_[i]), false, at).distance < kAtGate;
                })) {
                continue;
            }
            const Point along = unit(b - a);
            const Nearest nearest = nearest_on(path.way->points, false, at);
            const double half =
                std::max(kLeast, 0.5 * path.width + kRoom) / sine_between(along, nearest.along);
            const Point u = half * along;
            const Point v = std::max(half_depth, kLeast) * left_of(along);
            gaps.push_back({Polygon{{at - u - v, at + u - v, at + u + v, at - u + v}, {}}});
        }
    }

    const Site& site_;
    std::unordered_map<std::int64_t, PathNode> on_path_;
    std::unordered_map<std::int64_t, const MapNode*> gates_;               ///< by number
    std::unordered_map<std::int64_t, std::vector<Point>> along_barriers_;  ///< by gate
    std::vector<const MapWay*> gate_ways_;
    BoxIndex gate_lines_;  ///< into them
    BoxIndex paths_;
};

class Barriers {
public:
    Barriers(const Site& site, ModelBuilder& model) : site_(site), model_(model), openings_(site) {}

    void add_lines() {
        for (const MapWay& way : site_.map.ways) {
            if (is_line(way)) {
                add_line(way, *line_kind(way.tags));
            }
        }
    }

    void add_nodes() {
        for (const MapNode& node : site_.map.nodes) {
            if (!site_.map.box.contains(node.at)) {
                continue;
            }
            const std::string_view barrier = node.tags.get("barrier");
            const PathNode here = openings_.path_at(node.id);
            if (is_gate(node.tags)) {
                kinds_.insert("gate");
                add_gate({ElementKind::node, node.id}, node.tags, openings_.at_gate(node), site_.terrain,
                         model_, built_);
            } else if (barrier == "bollard") {
                add_bollards(node, here);
            } else if (barrier == "block") {
                add_blocks(node, here);
            } else if (barrier == "cycle_barrier") {
                add_chicane(node, here);
            }
        }
    }

    /// Gates, and rows of bollards and blocks.
    void add_ways() {
        std::vector<const MapWay*> unknown;
        for (const MapWay& way : site_.map.ways) {
            const std::string_view barrier = way.tags.get("barrier");
            if (barrier.empty() || barrier == "no" || !is_built(way) ||
                !box_of(way.points).overlaps(site_.map.box)) {
                continue;
            }
            if (is_gate(way.tags)) {
                add_gate_way(way);
            } else if (barrier == "bollard" || barrier == "block") {
                add_row(way, barrier == "bollard");
            } else if (!is_line(way)) {
                unknown.push_back(&way);
            }
        }
        if (!unknown.empty()) {
            const bool one = unknown.size() == 1;
            site_.warn("unknown-barrier",
                       std::to_string(unknown.size()) + (one ? " way (" : " ways (the first: ") + "way " +
                           std::to_string(unknown.front()->id) +
                           ", barrier=" + std::string(unknown.front()->tags.get("barrier")) +
                           (one ? ") is a barrier" : ") are barriers") +
                           " of a kind that isn't built; left out");
        }
    }

    Built built() {
        std::map<std::string, std::vector<std::string>>
            globs;  // by id: of cycle barriers there are two kinds
        for (const std::string& kind : kinds_) {
            std::string id = kind;
            std::ranges::replace(id, '_', '-');
            globs[id].push_back(kind + "/*");
        }
        for (const auto& [id, of_kind] : globs) {
            built_.solids.push_back({id, of_kind, "", id, true});
        }
        return std::move(built_);
    }

private:
    void add_gate_way(const MapWay& way) {
        const std::vector<Point> opening = gate_opening(way);
        if (site_.map.box.contains(0.5 * (opening.front() + opening.back()))) {
            kinds_.insert("gate");
            add_gate({ElementKind::way, way.id}, way.tags, opening, site_.terrain, model_, built_);
        }
    }

    void add_row(const MapWay& way, bool bollards) {
        constexpr double kSpacing = 1.5;
        constexpr double kOutline = 2.0;  // metres: what is drawn around a single one is smaller
        constexpr double kBelow = 0.2;
        constexpr std::size_t kMost = 2'000;
        ObjectMesh& mesh = object(bollards ? "bollard" : "block", {ElementKind::way, way.id});
        if (way.closed() && box_of(way.points).size().maxCoeff() < kOutline) {
            const Polygons area = site_.geometry.clipped(
                site_.geometry.polygon({way.points.begin(), way.points.end() - 1}), site_.map.box);
            extrude(bollards ? kGateSteel : kLines[1].look, area, kBelow, bollards ? 0.9 : 0.7,
                    site_.geometry, site_.terrain, mesh);
            built_.obstacles.push_back(area);
            return;
        }
        std::size_t placed = 0;
        for (std::size_t i = 1; i < way.points.size(); ++i) {
            const Point d = way.points[i] - way.points[i - 1];
            const double spaces = std::clamp(std::round(norm(d) / kSpacing), 1.0, 1.0 * kMost);
            const bool end = i + 1 == way.points.size() && !way.closed();
            for (int k = 0; k < static_cast<int>(spaces) + (end ? 1 : 0) && placed < kMost; ++k) {
                const Point at = way.points[i - 1] + d * (k / spaces);
                if (site_.map.box.contains(at)) {
                    ++placed;
                    bollards ? add_bollard(at, mesh) : add_block(at, unit(d), mesh);
                }
            }
        }
    }

    void add_bollard(const Point& at, ObjectMesh& mesh) {
        const double ground = site_.terrain.height(at);
        built_.add_obstacle(at, 0.1);
        mesh.cylinder(kGateSteel, at, 0.08, 0.08, 8, ground - 0.2, ground + 0.9);
    }

    void add_block(const Point& at, const Point& along, ObjectMesh& mesh) {
        const double ground = site_.terrain.height(at);
        built_.add_obstacle(at, 0.45);
        mesh.box(kLines[1].look, at, along, Point(0.3, 0.3), ground - 0.2, ground + 0.7);
    }

    void add_line(const MapWay& way, const LineKind& kind) {
        const PlanGeometry& geometry = site_.geometry;
        geometry.charge_to(ElementId{ElementKind::way, way.id}.text());
        const double height = std::clamp(length_of(way.tags, "height").value_or(kind.height), 0.1, 30.0);
        const double thickness =
            std::clamp(length_of(way.tags, "width").value_or(kind.thickness), 0.04, 10.0);
        Polygons area =
            geometry.clipped(geometry.buffer(way.points, 0.5 * thickness, Caps::flat), site_.map.box);
        const std::vector<Polygons> gaps = openings_.gaps_of(way, thickness);
        std::vector<const Polygons*> all;
        all.reserve(gaps.size());
        for (const Polygons& gap : gaps) {
            all.push_back(&gap);
        }
        area = geometry.difference(area, all.empty() ? Polygons() : geometry.united(all));
        Look look = kind.look;
        if (const auto color = color_of(way.tags, "colour", "color")) {
            look.color = *color;
        } else if (const auto material = material_color(way.tags.get("material"))) {
            look.color = *material;
        }
        constexpr double kBelow = 0.3;
        extrude(look, area, kBelow, height, geometry, site_.terrain,
                model_.object(std::string(kind.value) + "/" + ElementId{ElementKind::way, way.id}.text()));
        kinds_.insert(std::string(kind.value));
        built_.obstacles.push_back(std::move(area));
    }

    ObjectMesh& object(const std::string& kind, const ElementId& id) {
        kinds_.insert(kind);
        return model_.object(kind + "/" + id.text());
    }

    void add_bollards(const MapNode& node, const PathNode& here) {
        constexpr double kSpacing = 1.5;
        const double half = here.path == nullptr ? 0.75 : 0.5 * here.path->width;
        ObjectMesh& mesh = object("bollard", {ElementKind::node, node.id});
        const int pairs = std::max(1, static_cast<int>((half + 0.75) / kSpacing));
        for (int i = 0; i < pairs; ++i) {
            for (const double side : {1.0, -1.0}) {
                const Point at = here.path == nullptr
                                     ? node.at
                                     : Point(node.at + side * (0.5 + i) * kSpacing * left_of(here.along));
                add_bollard(at, mesh);
                if (here.path == nullptr) {
                    return;
                }
            }
        }
    }

    void add_blocks(const MapNode& node, const PathNode& here) {
        const double half = here.path == nullptr ? 0.0 : 0.5 * here.path->width;
        for (const double side : {1.0, -1.0}) {
            add_block(node.at + side * std::max(0.8, 0.6 * half) * left_of(here.along), here.along,
                      object("block", {ElementKind::node, node.id}));
        }
    }

    /// Two bars, one behind the other, each from one side to near the middle.
    void add_chicane(const MapNode& node, const PathNode& here) {
        constexpr double kFree = 0.4;
        const double half = here.path == nullptr ? 1.0 : std::max(1.0, 0.5 * here.path->width);
        for (const double side : {1.0, -1.0}) {
            const Point at = node.at + side * (0.8 * here.along + 0.5 * (half + kFree) * left_of(here.along));
            const double ground = site_.terrain.height(at);
            built_.add_obstacle(at, 0.5 * half);
            object("cycle-barrier", {ElementKind::node, node.id})
                .box(kBarrierRed, at, left_of(here.along), Point(0.5 * (half - kFree), 0.03), ground - 0.1,
                     ground + 1.0);
        }
    }

    const Site& site_;
    ModelBuilder& model_;
    Built built_;
    Openings openings_;
    std::set<std::string> kinds_;
};

}  // namespace

Built add_barriers(const Site& site, ModelBuilder& model) {
    Barriers barriers(site, model);
    barriers.add_lines();
    barriers.add_nodes();
    barriers.add_ways();
    return barriers.built();
}

}  // namespace campuswalk::scene::osm
