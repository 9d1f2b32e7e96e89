#include <algorithm>
#include <vector>

#include "scene/osm/read/raw_elements.h"

namespace campuswalk::scene::osm {
namespace {

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
    return at.valid() && box.contains(at.lat(), at.lon());
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
        GeographicBox extent{90.0, 540.0, -90.0, -540.0};
        for (const osmium::NodeRef& node : way.nodes()) {
            const auto found = std::ranges::lower_bound(nodes_, node.ref(), {}, &NodeLocation::id);
            if (found != nodes_.end() && found->id == node.ref()) {
                const double longitude = box_.longitude_near(found->longitude());
                extent = {std::min(extent.south, found->latitude()), std::min(extent.west, longitude),
                          std::max(extent.north, found->latitude()), std::max(extent.east, longitude)};
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

}  // namespace

RawMap read_section(const osmium::io::File& file, const GeographicBox& box, Editions& editions) {
    RawMap raw;
    SectionFinder finder(box, raw);
    visit(file, osmium::osm_entity_bits::nwr, finder, editions);
    if (!finder.in_order) {
        return read_all(file, editions);
    }
    finder.ways.finish();
    NumberSet nodes;
    visit(file, osmium::osm_entity_bits::way, WantedWays{Taker(raw), finder.ways, nodes}, editions);
    nodes.finish();
    visit(file, osmium::osm_entity_bits::node, WantedNodes{Taker(raw), nodes, box}, editions);
    return raw;
}

}  // namespace campuswalk::scene::osm
