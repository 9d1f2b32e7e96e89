#include "scene/osm/geometry/areas.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// Keys that make an area of a closed way, whatever their value.
constexpr std::array<std::string_view, 15> kAreaKeys = {
    "building", "building:part", "landuse", "leisure", "amenity", "area:highway", "water",     "tourism",
    "historic", "shop",          "office",  "place",   "power",   "aeroway",      "healthcare"};

bool stands_for_area(const Tags& tags) {
    if (tags.is("area", "no")) {
        return false;
    }
    if (tags.is("area", "yes")) {
        return true;
    }
    if (tags.is("leisure", "track") || tags.has("barrier")) {
        return tags.has("building");
    }
    const std::string_view natural = tags.get("natural");
    return (!natural.empty() && natural != "tree_row" && natural != "cliff" && natural != "coastline") ||
           tags.is("public_transport", "platform") || tags.is("man_made", "bridge") ||
           affirmed(tags, "bridge:support") || tags.is("waterway", "riverbank") ||
           tags.is("waterway", "dock") ||
           std::ranges::any_of(kAreaKeys, [&](std::string_view key) { return affirmed(tags, key); });
}

Ring ring_of(const MapWay& way) {
    return {way.points.begin(), way.points.end() - 1};
}

bool touches(const Polygons& polygons, const Box& box) {
    return !polygons.empty() && box_of(polygons).overlaps(box);
}

/// The members that bound an area, each once.
struct MemberWays {
    std::vector<const MapWay*> outer;
    std::vector<const MapWay*> inner;
    bool complete = true;  ///< the file has them all
};

MemberWays member_ways(const Map& map, const MapRelation& relation) {
    MemberWays ways;
    std::set<std::int64_t> known;
    for (const Member& member : relation.members) {
        if (member.element.kind != ElementKind::way ||
            (member.role != "outer" && member.role != "inner" && !member.role.empty())) {
            continue;
        }
        const MapWay* way = map.way(member.element.number);
        if (way == nullptr || !way->complete) {
            ways.complete = false;
        } else if (known.insert(way->id).second) {
            (member.role == "inner" ? ways.inner : ways.outer).push_back(way);
        }
    }
    return ways;
}

Polygons enclosed_by(const std::vector<const MapWay*>& ways, const PlanGeometry& geometry) {
    std::vector<std::vector<Point>> lines;
    lines.reserve(ways.size());
    for (const MapWay* way : ways) {
        lines.push_back(way->points);
    }
    const Polygons areas = lines.empty() ? Polygons() : geometry.areas_of_lines(lines);
    return areas.size() > 1 ? geometry.united({&areas}) : areas;
}

/// Without what is thinner than a wall: rings that touch have a gap there if their nodes, which are known to
/// a centimetre, aren't the same.
Polygons without_gaps(const Polygons& area, const PlanGeometry& geometry) {
    constexpr double kHalf = 0.02;    // metres: half of what is too thin
    constexpr double kLeast = 0.005;  // m²: less is the tip of a corner
    const Polygons thick = geometry.grown(geometry.grown(area, -kHalf), 1.5 * kHalf);
    Polygons thin = geometry.difference(area, thick);
    std::erase_if(thin, [](const Polygon& piece) { return area_of({piece}) < kLeast; });
    return thin.empty() ? area : geometry.difference(area, thin);
}

/// What the outer rings enclose and the inner ones don't, and the islands in courts, which both do. Inner
/// rings that share edges, with each other or with an outer ring, are one court; those whose outer ring isn't
/// there enclose nothing.
Polygons area_of_members(const MemberWays& ways, const PlanGeometry& geometry) {
    const Polygons outer = enclosed_by(ways.outer, geometry);
    if (outer.empty()) {
        return {};
    }
    Polygons inner = enclosed_by(ways.inner, geometry);
    if (!ways.complete) {
        inner = geometry.intersection(inner, outer);
    }
    const Polygons area = geometry.symmetric_difference(outer, inner);
    return ways.inner.empty() ? area : without_gaps(area, geometry);
}

using TagsOfBuildings = std::map<std::pair<ElementKind, std::int64_t>, Tags>;

/// What relations of type building, which hold an outline and its parts together, say of the outlines.
TagsOfBuildings tags_of_outlines(const Map& map) {
    TagsOfBuildings tags;
    for (const MapRelation& relation : map.relations) {
        if (!relation.tags.is("type", "building")) {
            continue;
        }
        for (const Member& member : relation.members) {
            if (member.role == "outline") {
                Tags& all = tags[{member.element.kind, member.element.number}];
                all = all.with(relation.tags);
            }
        }
    }
    return tags;
}

/// An element's own tags, and those of the building that it is the outline of.
Tags with_building(const Tags& own, const ElementId& id, const TagsOfBuildings& buildings) {
    const auto found = buildings.find({id.kind, id.number});
    return found == buildings.end() ? own : own.with(found->second);
}

/// The relation's tags, or in the old style those of its outer way.
Tags tags_of_area(const Map& map, const MapRelation& relation) {
    if (stands_for_area(relation.tags) || affirmed(relation.tags, "highway")) {
        return relation.tags;
    }
    for (const Member& member : relation.members) {
        const MapWay* way = member.role == "outer" && member.element.kind == ElementKind::way
                                ? map.way(member.element.number)
                                : nullptr;
        if (way != nullptr && stands_for_area(way->tags)) {
            return way->tags;
        }
    }
    return relation.tags;
}

/// The ways whose area a relation describes, so that it isn't there twice.
void note_outer_ways(const Map& map, const MapRelation& relation, const Tags& tags,
                     std::set<std::int64_t>& replaced) {
    for (const Member& member : relation.members) {
        const MapWay* way = member.role == "outer" && member.element.kind == ElementKind::way
                                ? map.way(member.element.number)
                                : nullptr;
        const bool same =
            way != nullptr &&
            std::ranges::any_of(
                std::array<std::string_view, 5>{"building", "landuse", "leisure", "natural", "amenity"},
                [&](std::string_view key) {
                    return affirmed(way->tags, key) && way->tags.get(key) == tags.get(key);
                });
        if (same) {
            replaced.insert(way->id);
        }
    }
}

}  // namespace

std::string name_in_parentheses(const Tags& tags) {
    return tags.has("name") ? " (" + std::string(tags.get("name")) + ")" : "";
}

std::vector<MapArea> areas_of(const Map& map, const PlanGeometry& geometry, const SourceMark& mark,
                              DiagnosticList& warnings) {
    std::vector<MapArea> of_relations;
    std::set<std::int64_t> replaced;
    const TagsOfBuildings buildings = tags_of_outlines(map);
    for (const MapRelation& relation : map.relations) {
        if (!relation.tags.is("type", "multipolygon")) {
            continue;
        }
        const MemberWays members = member_ways(map, relation);
        std::vector<const MapWay*> ways = members.outer;
        ways.insert(ways.end(), members.inner.begin(), members.inner.end());
        const Tags tags =
            with_building(tags_of_area(map, relation), {ElementKind::relation, relation.id}, buildings);
        if (ways.empty() || (!stands_for_area(tags) && !affirmed(tags, "highway"))) {
            continue;
        }
        geometry.charge_to(ElementId{ElementKind::relation, relation.id}.text());
        MapArea area{{ElementKind::relation, relation.id}, tags, area_of_members(members, geometry), ways};
        if (area.polygons.empty()) {
            warnings.warning(mark, "open-ring",
                             "relation " + std::to_string(relation.id) + " encloses no area" +
                                 (members.complete ? "" : ": the file lacks some of its ways") +
                                 "; left out");
        } else if (touches(area.polygons, map.box)) {
            if (!members.complete) {
                warnings.warning(mark, "incomplete-relation",
                                 "relation " + std::to_string(relation.id) + name_in_parentheses(tags) +
                                     ": the file lacks some of its ways, or of their nodes; parts or courts "
                                     "of it may be missing. Take a larger extract");
            }
            note_outer_ways(map, relation, tags, replaced);
            of_relations.push_back(std::move(area));
        }
    }
    std::vector<MapArea> areas;
    for (const MapWay& way : map.ways) {
        const ElementId id{ElementKind::way, way.id};
        const Tags tags = with_building(way.tags, id, buildings);
        if (!stands_for_area(tags) || replaced.contains(way.id)) {
            continue;
        }
        if (!way.closed() || !way.complete) {
            if (affirmed(tags, "building") || affirmed(tags, "building:part")) {
                warnings.warning(mark, "open-ring",
                                 "building way " + std::to_string(way.id) +
                                     (way.complete ? " isn't closed" : ": the file lacks some of its nodes") +
                                     "; left out");
            }
            continue;
        }
        geometry.charge_to(id.text());
        MapArea area{id, tags, geometry.polygon(ring_of(way)), {&way}};
        if (area.polygons.empty()) {
            warnings.warning(
                mark, "empty-ring",
                "way " + std::to_string(way.id) + " encloses no area, or crosses itself too often; left out");
        } else if (touches(area.polygons, map.box)) {
            areas.push_back(std::move(area));
        }
    }
    for (MapArea& area : of_relations) {
        areas.push_back(std::move(area));
    }
    return areas;
}

}  // namespace campuswalk::scene::osm
