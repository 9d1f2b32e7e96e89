#include "scene/osm/barriers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "scene/osm/box_index.h"
#include "scene/osm/extrude.h"
#include "scene/osm/path_nodes.h"
#include "scene/osm/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// A kind of line that one can't pass.
struct LineKind {
    std::string_view value;
    double height;  ///< metres, where nothing is tagged
    double thickness;
    Look look;
};

constexpr std::array<LineKind, 8> kLines = {{
    {"wall", 1.6, 0.3, {{186, 178, 164}, 235, 255}},
    {"retaining_wall", 1.0, 0.4, {{168, 164, 156}, 235, 255}},
    {"city_wall", 5.0, 1.0, {{180, 168, 146}, 235, 255}},
    {"fence", 1.5, 0.06, {{108, 116, 112}, 200, 150}},
    {"hedge", 1.3, 0.7, {{76, 112, 58}, 250, 255}},
    {"guard_rail", 0.75, 0.15, {{160, 164, 166}, 150, 255}},
    {"handrail", 0.95, 0.06, {{110, 114, 118}, 150, 255}},
    {"jersey_barrier", 0.8, 0.5, {{176, 174, 168}, 235, 255}},
}};

constexpr Look kGateSteel = {{96, 100, 104}, 150, 255};
constexpr Look kGatePost = {{120, 112, 100}, 220, 255};
constexpr Look kBarrierRed = {{190, 60, 50}, 200, 255};

const LineKind* line_kind(const Tags& tags) {
    const auto* found = std::ranges::find(kLines, tags.get("barrier"), &LineKind::value);
    return found == kLines.end() ? nullptr : found;
}

/// Whether nobody gets through.
bool is_closed(const Tags& tags) {
    if (tags.has("foot")) {
        return tags.is("foot", "no") || tags.is("foot", "private");
    }
    return tags.is("locked", "yes") || tags.is("access", "no");
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

Polygons square(const Point& center, double half) {
    return {Polygon{{center + Point(-half, -half), center + Point(half, -half), center + Point(half, half),
                     center + Point(-half, half)},
                    {}}};
}

class Barriers {
public:
    explicit Barriers(Composition& composition)
        : composition_(composition), on_path_(path_nodes(composition.paths)) {
        for (std::size_t i = 0; i < composition.paths.size(); ++i) {
            if (composition.paths[i].for_walkers && composition.paths[i].on_ground()) {
                paths_.add(i, box_of(composition.paths[i].way->points));
            }
        }
        for (const MapNode& node : composition.map.nodes) {
            if (is_gate(node.tags)) {
                gates_.emplace(node.id, &node);
            }
        }
    }

    void add_lines() {
        for (const MapWay& way : composition_.map.ways) {
            const LineKind* kind = line_kind(way.tags);
            if (kind == nullptr || way.points.size() < 2 || affirmed(way.tags, "building") ||
                number_of(way.tags, "layer").value_or(0.0) < 0.0) {
                continue;
            }
            add_line(way, *kind);
        }
    }

    void add_nodes() {
        for (const MapNode& node : composition_.map.nodes) {
            if (!composition_.map.box.contains(node.at)) {
                continue;
            }
            const std::string_view barrier = node.tags.get("barrier");
            const auto found = on_path_.find(node.id);
            const PathNode here = found == on_path_.end() ? PathNode{} : found->second;
            if (is_gate(node.tags)) {
                add_gate(node, here);
            } else if (barrier == "bollard") {
                add_bollards(node, here);
            } else if (barrier == "block") {
                add_block(node, here);
            } else if (barrier == "cycle_barrier") {
                add_chicane(node, here);
            }
        }
    }

private:
    void add_line(const MapWay& way, const LineKind& kind) {
        const PlanGeometry& geometry = composition_.geometry;
        const double height = std::clamp(length_of(way.tags, "height").value_or(kind.height), 0.1, 30.0);
        const double thickness =
            std::clamp(length_of(way.tags, "width").value_or(kind.thickness), 0.04, 10.0);
        Polygons area =
            geometry.clipped(geometry.buffer(way.points, 0.5 * thickness, Caps::flat), composition_.map.box);
        for (const Polygons& gap : gaps_of(way, thickness)) {
            area = geometry.difference(area, gap);
        }
        Look look = kind.look;
        if (const auto color = color_of(way.tags, "colour", "color")) {
            look.color = *color;
        } else if (const auto material = material_color(way.tags.get("material"))) {
            look.color = *material;
        }
        constexpr double kBelow = 0.3;
        extrude(look, area, kBelow, height, geometry, composition_.terrain,
                composition_.model.object(std::string(kind.value) + "/" +
                                          ElementId{ElementKind::way, way.id}.text()));
        kinds_.insert(std::string(kind.value));
    }

    std::vector<Polygons> gaps_of(const MapWay& way, double thickness) const {
        constexpr double kRoom = 0.35;
        constexpr double kLeast = 0.9;
        std::vector<Polygons> gaps;
        for (std::size_t i = 0; i < way.nodes.size(); ++i) {
            if (gates_.contains(way.nodes[i])) {
                gaps.push_back(square(way.points[i], half_gap(way.nodes[i]) + 0.1));
            }
        }
        for (const std::size_t number : paths_.near(box_of(way.points))) {
            const Path& path = composition_.paths[number];
            std::vector<Point> crossings;
            for (std::size_t i = 1; i < way.points.size(); ++i) {
                add_crossings(way.points[i - 1], way.points[i], path.way->points, crossings);
            }
            for (const Point& at : crossings) {
                gaps.push_back(square(at, std::max(kLeast, 0.5 * path.width + kRoom) + 0.5 * thickness));
            }
        }
        return gaps;
    }

    double half_gap(std::int64_t node) const {
        const auto found = on_path_.find(node);
        return found == on_path_.end() ? 0.9 : std::max(0.9, 0.5 * found->second.path->width);
    }

    ObjectMesh& object(const std::string& kind, const MapNode& node) {
        kinds_.insert(kind);
        return composition_.model.object(kind + "/" + ElementId{ElementKind::node, node.id}.text());
    }

    void add_gate(const MapNode& node, const PathNode& here) {
        constexpr double kPostHalf = 0.08;
        const double half = half_gap(node.id);
        const Point across = left_of(here.along);
        const double ground = composition_.terrain.height(node.at);
        ObjectMesh& mesh = object("gate", node);
        for (const double side : {1.0, -1.0}) {
            mesh.box(kGatePost, node.at + side * (half + kPostHalf) * across, here.along,
                     Point(kPostHalf, kPostHalf), ground - 0.2, ground + 1.4);
        }
        const std::string_view barrier = node.tags.get("barrier");
        if (barrier == "entrance") {
            return;
        }
        if (barrier == "lift_gate") {  // raised, as walkers go through
            const Point foot = node.at + half * across;
            mesh.box(kBarrierRed, foot, here.along, Point(0.04, 0.04), ground + 0.9,
                     ground + 0.9 + 2.0 * half);
        } else if (is_closed(node.tags)) {
            mesh.box(kGateSteel, node.at, across, Point(half, 0.03), ground + 0.05, ground + 1.35);
        } else {  // the leaf is turned aside
            mesh.box(kGateSteel, node.at + half * across + 0.5 * half * here.along, here.along,
                     Point(0.5 * half, 0.03), ground + 0.1, ground + 1.3);
        }
    }

    void add_bollards(const MapNode& node, const PathNode& here) {
        constexpr double kSpacing = 1.5;
        const double half = here.path == nullptr ? 0.75 : 0.5 * here.path->width;
        ObjectMesh& mesh = object("bollard", node);
        const int pairs = std::max(1, static_cast<int>((half + 0.75) / kSpacing));
        for (int i = 0; i < pairs; ++i) {
            for (const double side : {1.0, -1.0}) {
                const Point at = here.path == nullptr
                                     ? node.at
                                     : Point(node.at + side * (0.5 + i) * kSpacing * left_of(here.along));
                const double ground = composition_.terrain.height(at);
                mesh.cylinder(kGateSteel, at, 0.08, 0.08, 8, ground - 0.2, ground + 0.9);
                if (here.path == nullptr) {
                    return;
                }
            }
        }
    }

    void add_block(const MapNode& node, const PathNode& here) {
        const double half = here.path == nullptr ? 0.0 : 0.5 * here.path->width;
        for (const double side : {1.0, -1.0}) {
            const Point at = node.at + side * std::max(0.8, 0.6 * half) * left_of(here.along);
            const double ground = composition_.terrain.height(at);
            object("block", node)
                .box(kLines[1].look, at, here.along, Point(0.3, 0.3), ground - 0.2, ground + 0.7);
        }
    }

    /// Two bars, one behind the other, each from one side to near the middle.
    void add_chicane(const MapNode& node, const PathNode& here) {
        constexpr double kFree = 0.4;
        const double half = here.path == nullptr ? 1.0 : std::max(1.0, 0.5 * here.path->width);
        for (const double side : {1.0, -1.0}) {
            const Point at = node.at + side * (0.8 * here.along + 0.5 * (half + kFree) * left_of(here.along));
            const double ground = composition_.terrain.height(at);
            object("cycle-barrier", node)
                .box(kBarrierRed, at, left_of(here.along), Point(0.5 * (half - kFree), 0.03), ground - 0.1,
                     ground + 1.0);
        }
    }

public:
    const std::set<std::string>& kinds() const { return kinds_; }

private:
    Composition& composition_;
    std::unordered_map<std::int64_t, PathNode> on_path_;
    std::unordered_map<std::int64_t, const MapNode*> gates_;
    BoxIndex paths_;
    std::set<std::string> kinds_;
};

}  // namespace

bool is_gate(const Tags& tags) {
    constexpr std::array<std::string_view, 10> kGates = {
        "gate",      "swing_gate", "lift_gate",   "entrance",   "kissing_gate",
        "turnstile", "stile",      "wicket_gate", "toll_booth", "sliding_gate"};
    return std::ranges::find(kGates, tags.get("barrier")) != kGates.end();
}

void add_barriers(Composition& composition) {
    Barriers barriers(composition);
    barriers.add_lines();
    barriers.add_nodes();
    for (const std::string& kind : barriers.kinds()) {
        std::string id = kind;
        std::ranges::replace(id, '_', '-');
        composition.draft.solids.push_back({id, {kind + "/*"}, "", id, true});
    }
}

}  // namespace campuswalk::scene::osm
