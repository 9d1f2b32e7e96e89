#include "scene/osm/read/unreadable_lengths.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/base/ascii.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// Those that the import reads.
constexpr std::array<std::string_view, 12> kKeys = {"height",
                                                    "min_height",
                                                    "roof:height",
                                                    "maxheight",
                                                    "width",
                                                    "diameter_crown",
                                                    "kerb:height",
                                                    "sidewalk:width",
                                                    "sidewalk:both:width",
                                                    "sidewalk:left:width",
                                                    "sidewalk:right:width",
                                                    "maxwidth:physical"};

/// Words such as "default" or "narrow" say something else than a length.
bool is_word(std::string_view value) {
    return std::ranges::all_of(value,
                               [](char c) { return is_letter(c) || c == '_' || c == ' ' || c == '-'; });
}

void report(const ElementId& id, const Tags& tags, const SourceMark& mark, DiagnosticList& warnings) {
    for (const auto& [key, value] : tags.all()) {
        const bool is_length = std::ranges::find(kKeys, key) != kKeys.end();
        if (is_length && !is_word(value) && !length_of(value)) {
            warnings.warning(mark, "unreadable-length",
                             id.text() + ": " + key + "=" + value +
                                 " isn't read as a length; the usual one is taken. Write metres, or a unit");
        }
    }
}

}  // namespace

void report_unreadable_lengths(const Map& map, const SourceMark& mark, DiagnosticList& warnings) {
    for (const MapNode& node : map.nodes) {
        report({ElementKind::node, node.id}, node.tags, mark, warnings);
    }
    for (const MapWay& way : map.ways) {
        report({ElementKind::way, way.id}, way.tags, mark, warnings);
    }
    for (const MapRelation& relation : map.relations) {
        report({ElementKind::relation, relation.id}, relation.tags, mark, warnings);
    }
}

}  // namespace campuswalk::scene::osm
