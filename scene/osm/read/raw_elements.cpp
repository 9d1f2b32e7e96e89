#include "scene/osm/read/raw_elements.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/base/utf8.h"

namespace campuswalk::scene::osm {
namespace {

/// Characters that take no ink: a name of such isn't one.
bool is_blank(char32_t code) {
    return code == U' ' || code == 0xA0 || code == 0xAD || (code >= 0x2000 && code <= 0x200D) ||
           code == 0x202F || code == 0x205F || code == 0x2060 || code == 0x3000 || code == 0x3164;
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

}  // namespace

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

void sort_locations(std::vector<NodeLocation>& locations) {
    std::ranges::sort(locations, {}, &NodeLocation::id);
}

void Taker::take(const osmium::Node& node, bool with_tags) {
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

bool Taker::is_oversized(const osmium::OSMObject& object, std::size_t size, std::size_t most) {
    if (size > most) {
        raw_.oversized.push_back({kind_of(object.type()), object.id()});
    }
    return size > most;
}

void Taker::way(const osmium::Way& way) {
    if (is_oversized(way, way.nodes().size(), kMaxWayNodes)) {
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

void Taker::relation(const osmium::Relation& relation) {
    const std::string_view type = relation.tags().get_value_by_key("type", "");
    if (type != "multipolygon" && type != "building") {
        return;
    }
    if (is_oversized(relation, relation.members().size(), kMaxMembers)) {
        return;
    }
    MapRelation& copy = raw_.relations.emplace_back();
    copy.id = relation.id();
    copy.tags = tags_of(relation.tags());
    for (const osmium::RelationMember& member : relation.members()) {
        copy.members.push_back({{kind_of(member.type()), member.ref()}, clean(member.role())});
    }
}

RawMap read_all(const osmium::io::File& file, Editions& editions) {
    RawMap raw;
    visit(file, osmium::osm_entity_bits::nwr, Taker(raw), editions);
    return raw;
}

}  // namespace campuswalk::scene::osm
