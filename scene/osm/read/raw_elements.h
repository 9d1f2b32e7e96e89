#pragma once

#include <string>
#include <string_view>

#include <osmium/io/file.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/osm/entity_bits.hpp>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>

#include "scene/osm/read/editions.h"
#include "scene/osm/read/raw_map.h"

namespace campuswalk::scene::osm {

// The elements of libosmium, on their way into a RawMap. For the few files that read its large headers.

/// Text as printable words: what isn't UTF-8 and what would change how a line is shown become spaces. Empty
/// if nothing of it can be seen.
std::string clean(std::string_view text);

/// Calls the functions of `visitor` with all elements of these kinds that count.
template <typename Visitor>
void visit(const osmium::io::File& file, osmium::osm_entity_bits::type kinds, Visitor&& visitor,
           Editions& editions) {
    osmium::io::Reader reader(file, kinds, editions.meta());
    editions.begin();
    while (const osmium::memory::Buffer buffer = reader.read()) {
        for (const osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
            if (!editions.takes(object)) {
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

/// Sorts the locations by the ids of their nodes.
void sort_locations(std::vector<NodeLocation>& locations);

/// Thrown when a map has more nodes than can be read.
struct TooManyNodes {};

/// Copies elements.
class Taker {
public:
    explicit Taker(RawMap& raw) : raw_(raw) {}

    void node(const osmium::Node& node) { take(node, true); }
    void take(const osmium::Node& node, bool with_tags);
    void way(const osmium::Way& way);
    void relation(const osmium::Relation& relation);

private:
    bool is_oversized(const osmium::OSMObject& object, std::size_t size, std::size_t most);

    RawMap& raw_;
};

/// Of a file with nodes before ways before relations only what read_raw_map keeps with a box; of others all.
RawMap read_section(const osmium::io::File& file, const GeographicBox& box, Editions& editions);
RawMap read_all(const osmium::io::File& file, Editions& editions);

}  // namespace campuswalk::scene::osm
