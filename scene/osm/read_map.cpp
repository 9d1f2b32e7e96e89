#include "scene/osm/read_map.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <unordered_map>
#include <utility>

#include <osmium/io/pbf_input.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm/entity_bits.hpp>

#include "scene/base/utf8.h"
#include "scene/model/projection.h"

namespace campuswalk::scene::osm {
namespace {

/// Elements so far beyond the section are still read: a building may begin outside.
constexpr double kMargin = 300.0;  // metres
constexpr double kMetresPerDegree = 111'320.0;

/// The file's elements, in degrees.
struct RawMap {
    std::unordered_map<std::int64_t, osmium::Location> locations;
    std::vector<std::pair<std::int64_t, Tags>> nodes;  ///< with tags
    std::vector<MapWay> ways;
    std::vector<MapRelation> relations;
    std::optional<GeographicBox> bounds;
    std::string copyright;
    std::size_t bad_locations = 0;
};

/// Text as printable words: what isn't UTF-8 and what would change how a line is shown become spaces.
std::string clean(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        const bool shown = length > 0 && !controls_display(code_point(text.substr(at, length)));
        shown ? result += text.substr(at, length) : result += ' ';
        at += std::max<std::size_t>(length, 1);
    }
    return result;
}

Tags tags_of(const osmium::TagList& list) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const osmium::Tag& tag : list) {
        std::string key = clean(tag.key());
        std::string value = clean(tag.value());
        if (!key.empty() && !value.empty()) {
            pairs.emplace_back(std::move(key), std::move(value));
        }
    }
    return Tags(std::move(pairs));
}

void take_node(const osmium::Node& node, RawMap& raw) {
    const osmium::Location at = node.location();
    if (!at.valid()) {
        ++raw.bad_locations;
        return;
    }
    if (!raw.locations.try_emplace(node.id(), at).second) {
        return;  // the first of several, as of ways
    }
    if (!node.tags().empty()) {
        raw.nodes.emplace_back(node.id(), tags_of(node.tags()));
    }
}

void take_way(const osmium::Way& way, RawMap& raw) {
    MapWay& copy = raw.ways.emplace_back();
    copy.id = way.id();
    copy.tags = tags_of(way.tags());
    for (const osmium::NodeRef& node : way.nodes()) {
        if (copy.nodes.empty() || copy.nodes.back() != node.ref()) {
            copy.nodes.push_back(node.ref());
        }
    }
}

ElementKind kind_of(osmium::item_type type) {
    return type == osmium::item_type::node  ? ElementKind::node
           : type == osmium::item_type::way ? ElementKind::way
                                            : ElementKind::relation;
}

void take_relation(const osmium::Relation& relation, RawMap& raw) {
    MapRelation& copy = raw.relations.emplace_back();
    copy.id = relation.id();
    copy.tags = tags_of(relation.tags());
    for (const osmium::RelationMember& member : relation.members()) {
        copy.members.push_back({{kind_of(member.type()), member.ref()}, clean(member.role())});
    }
}

void take_header(const osmium::io::Header& header, RawMap& raw) {
    const osmium::Box box = header.joined_boxes();
    if (box.valid()) {
        raw.bounds = GeographicBox{box.bottom_left().lat(), box.bottom_left().lon(), box.top_right().lat(),
                                   box.top_right().lon()};
    }
}

RawMap read_elements(const std::filesystem::path& file) {
    RawMap raw;
    osmium::io::Reader reader(osmium::io::File(file.string()), osmium::osm_entity_bits::nwr,
                              osmium::io::read_meta::no);
    take_header(reader.header(), raw);
    while (const osmium::memory::Buffer buffer = reader.read()) {
        for (const osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
            if (!object.visible()) {
                continue;  // deleted
            }
            switch (object.type()) {
                case osmium::item_type::node:
                    take_node(static_cast<const osmium::Node&>(object), raw);
                    break;
                case osmium::item_type::way:
                    take_way(static_cast<const osmium::Way&>(object), raw);
                    break;
                case osmium::item_type::relation:
                    take_relation(static_cast<const osmium::Relation&>(object), raw);
                    break;
                default:
                    break;
            }
        }
    }
    reader.close();
    return raw;
}

GeographicBox square_about(double latitude, double longitude, double radius) {
    const double north = radius / kMetresPerDegree;
    // Close enough to choose what is in the square; its size in metres comes from the projection.
    const Projection here(latitude, longitude);
    const double metres_east = here.project(latitude, longitude + 0.001).x() / 0.001;
    const double east = metres_east > 1.0 ? radius / metres_east : 0.0;
    return {latitude - north, longitude - east, latitude + north, longitude + east};
}

GeographicBox box_of_all(const RawMap& raw) {
    GeographicBox box{90.0, 180.0, -90.0, -180.0};
    for (const auto& [id, at] : raw.locations) {
        box = {std::min(box.south, at.lat()), std::min(box.west, at.lon()), std::max(box.north, at.lat()),
               std::max(box.east, at.lon())};
    }
    return box;
}

GeographicBox box_to_read(const RawMap& raw, const MapSection& section) {
    if (section.box) {
        return *section.box;
    }
    if (section.center) {
        return square_about(section.center->first, section.center->second, section.radius);
    }
    return raw.bounds ? *raw.bounds : box_of_all(raw);
}

/// Projects elements and keeps those near the box.
class Projector {
public:
    Projector(const RawMap& raw, const Projection& projection, double latitude, double longitude) {
        points_.reserve(raw.locations.size());
        constexpr double kFarthest = 60.0;  // degrees: the plane doesn't know the Earth's other side
        for (const auto& [id, at] : raw.locations) {
            const double east = std::abs(at.lon() - longitude);
            if (std::abs(at.lat() - latitude) < kFarthest && std::min(east, 360.0 - east) < kFarthest) {
                points_.emplace(id, projection.project(at.lat(), at.lon()));
            }
        }
    }
    const Point* at(std::int64_t node) const {
        const auto found = points_.find(node);
        return found == points_.end() ? nullptr : &found->second;
    }
    void place(MapWay& way) const {
        std::vector<std::int64_t> nodes;
        for (const std::int64_t node : way.nodes) {
            if (const Point* p = at(node)) {
                nodes.push_back(node);
                way.points.push_back(*p);
            } else {
                way.complete = false;
            }
        }
        way.nodes = std::move(nodes);
    }

private:
    std::unordered_map<std::int64_t, Point> points_;
};

template <typename Element>
void sort_unique(std::vector<Element>& elements) {
    std::ranges::stable_sort(elements, {}, &Element::id);
    elements.erase(std::unique(elements.begin(), elements.end(),
                               [](const Element& a, const Element& b) { return a.id == b.id; }),
                   elements.end());
}

void set_boxes(const GeographicBox& geographic, const Projection& projection, const SourceMark& mark,
               Map& map) {
    map.geographic = geographic;
    std::vector<Point> vertices;
    for (const double latitude : {geographic.south, geographic.north}) {
        for (const double longitude : {geographic.west, geographic.east}) {
            vertices.push_back(projection.project(latitude, longitude));
        }
    }
    map.box = box_of(vertices);
    const Point size = map.box.size();
    if (!(size.minCoeff() > 1.0)) {
        throw InputError(mark, "bad-size", "there is no area in the map; pass --bbox or --center");
    }
    if (!(size.maxCoeff() <= kMaxMapSize) || geographic.east - geographic.west > 90.0) {
        throw InputError(mark, "bad-size",
                         "the map is larger than 20 km; choose a part of it with --bbox or --center");
    }
}

Map local_map(RawMap raw, const SourceMark& mark, const MapSection& section, DiagnosticList& warnings) {
    const GeographicBox box = box_to_read(raw, section);
    const double latitude = 0.5 * (box.south + box.north);
    const double longitude = 0.5 * (box.west + box.east);
    const Projection projection(latitude, longitude);
    Map map;
    set_boxes(box, projection, mark, map);
    const Box near = map.box.grown(kMargin);
    const Projector projector(raw, projection, latitude, longitude);
    for (auto& [id, tags] : raw.nodes) {
        if (const Point* at = projector.at(id); at != nullptr && near.contains(*at)) {
            map.nodes.push_back({id, *at, std::move(tags)});
        }
    }
    std::size_t incomplete = 0;
    for (MapWay& way : raw.ways) {
        projector.place(way);
        if (way.points.empty() || !box_of(way.points).overlaps(near)) {
            continue;
        }
        incomplete += way.complete ? 0 : 1;
        map.ways.push_back(std::move(way));
    }
    map.relations = std::move(raw.relations);
    sort_unique(map.nodes);
    sort_unique(map.ways);
    sort_unique(map.relations);
    for (std::size_t i = 0; i < map.ways.size(); ++i) {
        map.way_index.emplace(map.ways[i].id, i);
    }
    if (map.nodes.empty() && map.ways.empty()) {
        throw InputError(mark, "bad-size", "nothing of the map lies in the section; check its coordinates");
    }
    if (raw.bad_locations > 0) {
        warnings.warning(mark, "bad-location",
                         std::to_string(raw.bad_locations) + " nodes have no valid coordinates; left out");
    }
    if (incomplete > 0) {
        warnings.warning(mark, "incomplete-way",
                         std::to_string(incomplete) + (incomplete == 1 ? " way refers" : " ways refer") +
                             " to nodes that the file lacks");
    }
    return map;
}

void check_file(const std::filesystem::path& file, const SourceMark& mark) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(mark, "missing-file", "there is no such file; check the path");
    }
}

}  // namespace

Map read_map(const std::filesystem::path& file, const SourceMark& mark, const MapSection& section,
             DiagnosticList& warnings) {
    check_file(file, mark);
    RawMap raw;
    try {
        raw = read_elements(file);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const osmium::xml_error& error) {
        SourceMark at = mark;
        at.line = static_cast<int>(error.line);
        at.column = static_cast<int>(error.column);
        throw InputError(at, "bad-map", "it isn't well-formed XML: " + clean(error.error_string));
    } catch (const std::exception& error) {  // libosmium's, protozero's and zlib's have no common base
        throw InputError(mark, "bad-map", "it can't be read as a map: " + clean(error.what()));
    }
    return local_map(std::move(raw), mark, section, warnings);
}

}  // namespace campuswalk::scene::osm
