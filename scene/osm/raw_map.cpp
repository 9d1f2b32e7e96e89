#include "scene/osm/raw_map.h"

#include <new>
#include <string_view>

#include <osmium/io/pbf_input.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm/entity_bits.hpp>

#include "scene/base/utf8.h"

namespace campuswalk::scene::osm {
namespace {

/// Characters that take no ink: a name of such isn't one.
bool is_blank(char32_t code) {
    return code == U' ' || code == 0xA0 || code == 0xAD || (code >= 0x2000 && code <= 0x200D) ||
           code == 0x202F || code == 0x205F || code == 0x2060 || code == 0x3000 || code == 0x3164;
}

/// Text as printable words: what isn't UTF-8 and what would change how a line is shown become spaces. Empty
/// if nothing of it can be seen.
std::string clean(std::string_view text) {
    std::string result;
    std::size_t characters = 0;
    bool visible = false;
    for (std::size_t at = 0; at < text.size() && characters < kMaxTextCharacters; ++characters) {
        const std::size_t length = utf8_length(text, at);
        const char32_t code = length > 0 ? code_point(text.substr(at, length)) : U' ';
        const bool shown = length > 0 && !controls_display(code);
        visible = visible || (shown && !is_blank(code));
        shown ? result += text.substr(at, length) : result += ' ';
        at += std::max<std::size_t>(length, 1);
    }
    return visible ? result : std::string();
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

/// The file under the name that the user gave it, which says what it is: a link's target may be called
/// anything.
osmium::io::File file_of(const std::filesystem::path& file, const SourceMark& mark) {
    const std::string_view name = mark.file;
    const bool is_pbf = name.ends_with(".pbf");
    const bool is_xml = name.ends_with(".osm") || name.ends_with(".xml");
    return osmium::io::File(file.string(), is_pbf ? "pbf" : is_xml ? "osm" : "");
}

std::optional<GeographicBox> bounds_of(const osmium::io::Header& header) {
    const osmium::Box box = header.joined_boxes();
    return box.valid() ? std::optional(GeographicBox{box.bottom_left().lat(), box.bottom_left().lon(),
                                                     box.top_right().lat(), box.top_right().lon()})
                       : std::nullopt;
}

/// Calls the functions of `visitor` with all elements of these kinds that aren't deleted.
template <typename Visitor>
void visit(const osmium::io::File& file, osmium::osm_entity_bits::type kinds, Visitor&& visitor) {
    osmium::io::Reader reader(file, kinds, osmium::io::read_meta::no);
    while (const osmium::memory::Buffer buffer = reader.read()) {
        for (const osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
            if (!object.visible()) {
                continue;
            }
            if (object.type() == osmium::item_type::node) {
                visitor.node(static_cast<const osmium::Node&>(object));
            } else if (object.type() == osmium::item_type::way) {
                visitor.way(static_cast<const osmium::Way&>(object));
            } else if (object.type() == osmium::item_type::relation) {
                visitor.relation(static_cast<const osmium::Relation&>(object));
            }
        }
    }
    reader.close();
}

ElementKind kind_of(osmium::item_type type) {
    return type == osmium::item_type::node  ? ElementKind::node
           : type == osmium::item_type::way ? ElementKind::way
                                            : ElementKind::relation;
}

/// Thrown when a map has more nodes than can be read.
struct TooManyNodes {};

/// Copies elements.
class Taker {
public:
    explicit Taker(RawMap& raw) : raw_(raw) {}

    void node(const osmium::Node& node) { take(node, true); }
    void take(const osmium::Node& node, bool with_tags) {
        const osmium::Location at = node.location();
        if (!at.valid()) {
            ++raw_.bad_locations;
            return;
        }
        raw_.locations.push_back({node.id(), at.x(), at.y()});
        if (raw_.locations.size() > kMaxMapNodes) {
            throw TooManyNodes();
        }
        if (with_tags && !node.tags().empty()) {
            raw_.nodes.emplace_back(node.id(), tags_of(node.tags()));
        }
    }

    void way(const osmium::Way& way) {
        if (way.nodes().size() > kMaxWayNodes) {
            raw_.oversized.push_back({ElementKind::way, way.id()});
            return;
        }
        MapWay& copy = raw_.ways.emplace_back();
        copy.id = way.id();
        copy.tags = tags_of(way.tags());
        for (const osmium::NodeRef& node : way.nodes()) {
            if (copy.nodes.empty() || copy.nodes.back() != node.ref()) {
                copy.nodes.push_back(node.ref());
            }
        }
    }

    void relation(const osmium::Relation& relation) {
        const std::string_view type = relation.tags().get_value_by_key("type", "");
        if (type != "multipolygon" && type != "building") {
            return;
        }
        if (relation.members().size() > kMaxMembers) {
            raw_.oversized.push_back({ElementKind::relation, relation.id()});
            return;
        }
        MapRelation& copy = raw_.relations.emplace_back();
        copy.id = relation.id();
        copy.tags = tags_of(relation.tags());
        for (const osmium::RelationMember& member : relation.members()) {
            copy.members.push_back({{kind_of(member.type()), member.ref()}, clean(member.role())});
        }
    }

private:
    RawMap& raw_;
};

/// A set of numbers that is filled before it is asked.
class NumberSet {
public:
    void add(std::int64_t number) { numbers_.push_back(number); }
    void finish() {
        std::ranges::sort(numbers_);
        numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    }
    bool contains(std::int64_t number) const {
        return std::binary_search(numbers_.begin(), numbers_.end(), number);
    }

private:
    std::vector<std::int64_t> numbers_;
};

bool is_in(const osmium::Location& at, const GeographicBox& box) {
    return at.valid() && at.lat() >= box.south && at.lat() <= box.north && at.lon() >= box.west &&
           at.lon() <= box.east;
}

/// By id; of those with equal ids the first.
void sort_locations(std::vector<NodeLocation>& locations) {
    std::ranges::stable_sort(locations, {}, &NodeLocation::id);
    locations.erase(std::unique(locations.begin(), locations.end(),
                                [](const NodeLocation& a, const NodeLocation& b) { return a.id == b.id; }),
                    locations.end());
}

GeographicBox grown(const GeographicBox& box, double degrees) {
    return {box.south - degrees, box.west - degrees, box.north + degrees, box.east + degrees};
}

/// Finds the ways whose extent overlaps a box, and those that areas in it need besides. Files have nodes
/// before ways before relations, or else `in_order` is false and nothing is known.
class SectionFinder {
public:
    SectionFinder(const GeographicBox& box, RawMap& raw)
        : box_(box), around_(grown(box, kAround)), taker_(raw), raw_(raw) {}

    NumberSet ways;
    bool in_order = true;

    void node(const osmium::Node& node) {
        in_order = in_order && stage_ == Stage::nodes;
        if (is_in(node.location(), around_)) {
            nodes_.push_back({node.id(), node.location().x(), node.location().y()});
        }
    }

    void way(const osmium::Way& way) {
        end_nodes();
        in_order = in_order && stage_ == Stage::ways;
        if (overlaps_box(way)) {
            near_ways_.add(way.id());
            ways.add(way.id());
        }
    }

    void relation(const osmium::Relation& relation) {
        end_nodes();
        if (stage_ == Stage::ways) {
            near_ways_.finish();
            stage_ = Stage::relations;
        }
        const auto is_near = [&](const osmium::RelationMember& member) {
            return member.type() == osmium::item_type::way && near_ways_.contains(member.ref());
        };
        if (!std::ranges::any_of(relation.members(), is_near)) {
            return;
        }
        const std::size_t before = raw_.relations.size();
        taker_.relation(relation);
        for (std::size_t i = before; i < raw_.relations.size(); ++i) {
            for (const Member& member : raw_.relations[i].members) {
                if (member.element.kind == ElementKind::way) {
                    ways.add(member.element.number);
                }
            }
        }
    }

private:
    enum class Stage { nodes, ways, relations };

    /// A lake may surround the box without a node in it: nodes so far around are looked at, degrees.
    static constexpr double kAround = 0.15;

    bool overlaps_box(const osmium::Way& way) const {
        GeographicBox extent{90.0, 180.0, -90.0, -180.0};
        for (const osmium::NodeRef& node : way.nodes()) {
            const auto found = std::ranges::lower_bound(nodes_, node.ref(), {}, &NodeLocation::id);
            if (found != nodes_.end() && found->id == node.ref()) {
                extent = {
                    std::min(extent.south, found->latitude()), std::min(extent.west, found->longitude()),
                    std::max(extent.north, found->latitude()), std::max(extent.east, found->longitude())};
            }
        }
        return extent.south <= box_.north && extent.north >= box_.south && extent.west <= box_.east &&
               extent.east >= box_.west;
    }

    void end_nodes() {
        if (stage_ == Stage::nodes) {
            sort_locations(nodes_);
            stage_ = Stage::ways;
        }
    }

    GeographicBox box_;
    GeographicBox around_;
    Taker taker_;
    RawMap& raw_;
    std::vector<NodeLocation> nodes_;  ///< in and around the box
    NumberSet near_ways_;              ///< that overlap it
    Stage stage_ = Stage::nodes;
};

/// Takes ways that are wanted, and notes their nodes.
struct WantedWays {
    Taker taker;
    const NumberSet& wanted;
    NumberSet& nodes;

    void node(const osmium::Node&) {}
    void way(const osmium::Way& way) {
        if (wanted.contains(way.id())) {
            taker.way(way);
            for (const osmium::NodeRef& node : way.nodes()) {
                nodes.add(node.ref());
            }
        }
    }
    void relation(const osmium::Relation&) {}
};

/// Takes nodes that are wanted, and those in the box.
struct WantedNodes {
    Taker taker;
    const NumberSet& wanted;
    GeographicBox box;

    void node(const osmium::Node& node) {
        const bool here = is_in(node.location(), box);
        if (here || wanted.contains(node.id())) {
            taker.take(node, here);
        }
    }
    void way(const osmium::Way&) {}
    void relation(const osmium::Relation&) {}
};

RawMap read_all(const osmium::io::File& file) {
    RawMap raw;
    visit(file, osmium::osm_entity_bits::nwr, Taker(raw));
    return raw;
}

RawMap read_section(const osmium::io::File& file, const GeographicBox& box) {
    RawMap raw;
    SectionFinder finder(box, raw);
    visit(file, osmium::osm_entity_bits::nwr, finder);
    if (!finder.in_order) {
        return read_all(file);
    }
    finder.ways.finish();
    NumberSet nodes;
    visit(file, osmium::osm_entity_bits::way, WantedWays{Taker(raw), finder.ways, nodes});
    nodes.finish();
    visit(file, osmium::osm_entity_bits::node, WantedNodes{Taker(raw), nodes, box});
    return raw;
}

/// What libosmium throws, as errors about the file.
template <typename Read>
auto reported(const SourceMark& mark, const Read& read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const TooManyNodes&) {
        throw InputError(mark, "bad-size",
                         "it has more than " + std::to_string(kMaxMapNodes / 1'000'000) +
                             " million nodes; choose a part of it with --bbox or --center");
    } catch (const osmium::xml_error& error) {
        SourceMark at = mark;
        at.line = static_cast<int>(error.line);
        at.column = static_cast<int>(error.column);
        throw InputError(at, "bad-map", "it isn't well-formed XML: " + clean(error.error_string));
    } catch (const std::exception& error) {  // libosmium's, protozero's and zlib's have no common base
        throw InputError(mark, "bad-map", "it can't be read as a map: " + clean(error.what()));
    }
}

}  // namespace

std::optional<GeographicBox> stated_bounds(const std::filesystem::path& file, const SourceMark& mark) {
    return reported(mark, [&] {
        osmium::io::Reader reader(file_of(file, mark), osmium::osm_entity_bits::nothing);
        const std::optional<GeographicBox> bounds = bounds_of(reader.header());
        reader.close();
        return bounds;
    });
}

RawMap read_raw_map(const std::filesystem::path& file, const SourceMark& mark,
                    const std::optional<GeographicBox>& box) {
    RawMap raw = reported(mark, [&] {
        const osmium::io::File opened = file_of(file, mark);
        return box ? read_section(opened, *box) : read_all(opened);
    });
    sort_locations(raw.locations);
    return raw;
}

}  // namespace campuswalk::scene::osm
