#include "scene/osm/read/editions.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <string_view>

#include <expat.h>
#include <osmium/io/reader.hpp>
#include <osmium/osm/entity_bits.hpp>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>

namespace campuswalk::scene::osm {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20U;

/// Calls `use(text)` for pieces of a file, until it returns false.
template <typename Use>
void for_each_chunk(const std::string& file, const Use& use) {
    std::ifstream in(file, std::ios::binary);
    std::string chunk(kChunk, '\0');
    while (in.read(chunk.data(), kChunk), in.gcount() > 0) {
        if (!use(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())))) {
            return;
        }
    }
}

/// Most files have nothing deleted, which this finds much faster than a parser.
bool has_word(const std::string& file, std::string_view word) {
    const std::boyer_moore_horspool_searcher searcher(word.begin(), word.end());
    std::string text;
    bool found = false;
    for_each_chunk(file, [&](std::string_view chunk) {
        text.erase(0, text.size() - std::min(text.size(), word.size() - 1));  // it may cross the border
        text += chunk;
        found = std::search(text.begin(), text.end(), searcher) != text.end();
        return !found;
    });
    return found;
}

/// Notes an element of XML with `action="delete"`.
struct Deletions {
    XML_Parser parser;
    std::set<std::pair<std::pair<ElementKind, std::int64_t>, std::uint32_t>>& found;

    void element(std::string_view name, const XML_Char** attributes) {
        const bool is_node = name == "node";
        if (!is_node && name != "way" && name != "relation") {
            return;
        }
        osmium::object_id_type id = 0;
        osmium::object_version_type version = 0;
        bool deleted = false;
        for (; *attributes != nullptr; attributes += 2) {
            const std::string_view key = attributes[0];
            if (key == "id") {
                id = osmium::string_to_object_id(attributes[1]);
            } else if (key == "version") {
                version = osmium::string_to_object_version(attributes[1]);
            } else if (key == "action") {
                deleted = std::strcmp(attributes[1], "delete") == 0;
            }
        }
        if (deleted) {
            const ElementKind kind = is_node         ? ElementKind::node
                                     : name == "way" ? ElementKind::way
                                                     : ElementKind::relation;
            found.insert({{kind, id}, version});
        }
    }
};

/// What is compared of two occurrences; not when and by whom they were edited.
std::string content_of(const osmium::OSMObject& object) {
    std::vector<std::string> tags;
    for (const osmium::Tag& tag : object.tags()) {
        tags.push_back(std::string(tag.key()) + '\0' + tag.value() + '\0');
    }
    std::ranges::sort(tags);
    std::string content = object.visible() ? "" : "deleted";
    for (const std::string& tag : tags) {
        content += tag;
    }
    const auto add = [&](std::int64_t number) { content += ' ' + std::to_string(number); };
    if (object.type() == osmium::item_type::node) {
        const osmium::Location at = static_cast<const osmium::Node&>(object).location();
        add(at.x());
        add(at.y());
    } else if (object.type() == osmium::item_type::way) {
        for (const osmium::NodeRef& node : static_cast<const osmium::Way&>(object).nodes()) {
            add(node.ref());
        }
    } else {
        for (const osmium::RelationMember& member : static_cast<const osmium::Relation&>(object).members()) {
            add(static_cast<std::int64_t>(member.type()));
            add(member.ref());
            content += member.role();
        }
    }
    return content;
}

std::size_t parts_of(const osmium::OSMObject& object) {
    return object.type() == osmium::item_type::node
               ? (static_cast<const osmium::Node&>(object).location().valid() ? 1 : 0)
           : object.type() == osmium::item_type::way
               ? static_cast<const osmium::Way&>(object).nodes().size()
               : static_cast<const osmium::Relation&>(object).members().size();
}

template <typename Use>
void for_each_object(const osmium::io::File& file, osmium::io::read_meta meta, const Use& use) {
    osmium::io::Reader reader(file, osmium::osm_entity_bits::nwr, meta);
    while (const osmium::memory::Buffer buffer = reader.read()) {
        for (const osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
            use(object);
        }
    }
    reader.close();
}

}  // namespace

ElementKind kind_of(osmium::item_type type) {
    return type == osmium::item_type::node  ? ElementKind::node
           : type == osmium::item_type::way ? ElementKind::way
                                            : ElementKind::relation;
}

Editions::Editions(const osmium::io::File& file) {
    if (file.format() != osmium::io::file_format::xml) {
        osmium::io::Reader reader(file, osmium::osm_entity_bits::nothing);
        // Only such files of this format have deleted elements.
        meta_ = reader.header().has_multiple_object_versions() ? osmium::io::read_meta::yes
                                                               : osmium::io::read_meta::no;
        reader.close();
        return;
    }
    if (!has_word(file.filename(), "delete")) {
        return;
    }
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                         &XML_ParserFree);
    Deletions deletions{parser.get(), marked_};
    XML_SetUserData(parser.get(), &deletions);
    XML_SetStartElementHandler(parser.get(), [](void* to, const XML_Char* name, const XML_Char** attributes) {
        auto& self = *static_cast<Deletions*>(to);
        try {
            self.element(name, attributes);
        } catch (const std::exception&) {  // no number: libosmium reports it
            XML_StopParser(self.parser, XML_FALSE);
        }
    });
    XML_SetEntityDeclHandler(parser.get(), [](void* to, const XML_Char*, int, const XML_Char*, int,
                                              const XML_Char*, const XML_Char*, const XML_Char*,
                                              const XML_Char*) {  // libosmium refuses it
        XML_StopParser(static_cast<Deletions*>(to)->parser, XML_FALSE);
    });
    for_each_chunk(file.filename(), [&](std::string_view chunk) {
        return XML_Parse(parser.get(), chunk.data(), static_cast<int>(chunk.size()), 0) == XML_STATUS_OK;
    });
}

void Editions::begin() {
    any_passed_ = false;
    for (auto& [key, choice] : repeated_) {
        choice.passed = 0;
    }
}

bool Editions::is_visible(const osmium::OSMObject& object) const {
    return object.visible() &&
           (marked_.empty() || !marked_.contains({{kind_of(object.type()), object.id()}, object.version()}));
}

bool Editions::takes(const osmium::OSMObject& object) {
    const Key key(kind_of(object.type()), object.id());
    if (any_passed_ && key == last_) {
        repeated_.try_emplace(key);
    }
    ascending_ = ascending_ && (!any_passed_ || last_ <= key);
    any_passed_ = true;
    last_ = key;
    const auto found = repeated_.empty() ? repeated_.end() : repeated_.find(key);
    if (found == repeated_.end()) {
        return is_visible(object);
    }
    Choice& choice = found->second;
    return choice.passed++ == choice.number && choice.visible;
}

void Editions::find_repeated(const osmium::io::File& file) {
    std::array<std::vector<std::int64_t>, 3> ids;
    for_each_object(file, osmium::io::read_meta::no, [&](const osmium::OSMObject& object) {
        ids[static_cast<std::size_t>(kind_of(object.type()))].push_back(object.id());
    });
    for (std::size_t kind = 0; kind < ids.size(); ++kind) {
        std::ranges::sort(ids[kind]);
        for (std::size_t i = 1; i < ids[kind].size(); ++i) {
            if (ids[kind][i] == ids[kind][i - 1]) {
                repeated_.try_emplace({static_cast<ElementKind>(kind), ids[kind][i]});
            }
        }
    }
}

void Editions::offer(Choice& choice, const osmium::OSMObject& object) const {
    const std::size_t number = choice.count++;
    const std::tuple rank(object.version(), object.tags().size(), parts_of(object));
    std::string content = content_of(object);
    if (number > 0 && object.version() == std::get<0>(choice.rank)) {
        choice.ambiguous = choice.ambiguous || content != choice.content;
    }
    if (number == 0 || rank > choice.rank) {
        choice.ambiguous = choice.ambiguous && object.version() == std::get<0>(choice.rank);
        choice.number = number;
        choice.rank = rank;
        choice.content = std::move(content);
        choice.visible = is_visible(object);
    }
}

bool Editions::choose(const osmium::io::File& file) {
    if (!ascending_) {
        repeated_.clear();
        find_repeated(file);
    }
    if (repeated_.empty()) {
        return false;
    }
    for_each_object(file, osmium::io::read_meta::yes, [&](const osmium::OSMObject& object) {
        const auto found = repeated_.find({kind_of(object.type()), object.id()});
        if (found != repeated_.end()) {
            offer(found->second, object);
        }
    });
    return true;
}

std::vector<ElementId> Editions::ambiguous() const {
    std::vector<ElementId> result;
    for (const auto& [key, choice] : repeated_) {
        if (choice.ambiguous) {
            result.push_back({key.first, key.second});
        }
    }
    return result;
}

}  // namespace campuswalk::scene::osm
