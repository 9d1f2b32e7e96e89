#include "scene/osm/meaning/meaning.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "scene/base/ascii.h"
#include "scene/osm/meaning/doors.h"
#include "scene/osm/meaning/spawns.h"
#include "scene/osm/meaning/triggers.h"
#include "scene/osm/read/tag_values.h"

namespace campuswalk::scene::osm {
namespace {

/// Keys that say what something is, the most telling first.
constexpr std::array<std::string_view, 14> kKindKeys = {
    "amenity", "tourism", "shop",    "office",   "leisure",          "historic", "healthcare",
    "craft",   "highway", "railway", "man_made", "public_transport", "natural",  "building"};

std::string kind_of_element(const Tags& tags) {
    for (const std::string_view key : kKindKeys) {
        const std::string_view value = tags.get(key);
        if (!value.empty() && value != "yes" && value != "no") {
            std::string kind(value);
            std::ranges::replace(kind, '_', ' ');
            return kind;
        }
    }
    return {};
}

/// The language of "name:zh-Hant" as a part of an info field's name: "zh-hant"; empty if it can't be one.
std::string field_word(std::string_view text) {
    std::string word;
    for (const char c : text) {
        if (is_letter(c) || is_digit(c)) {
            word += to_lower(c);
        } else if (!word.empty() && word.back() != '-') {
            word += '-';
        }
    }
    while (!word.empty() && word.back() == '-') {
        word.pop_back();
    }
    return word;
}

/// Whether the rest of "name:…" is a language, such as "en" or "zh-Hant", rather than "etymology".
bool is_language(std::string_view text) {
    const std::size_t length = std::min(text.find_first_of("-_"), text.size());
    return (length == 2 || length == 3) && std::ranges::all_of(text.substr(0, length), is_lower);
}

std::string address_of(const Tags& tags) {
    std::string address(tags.get("addr:street"));
    const auto append = [&](std::string_view key, const char* separator) {
        const std::string_view value = tags.get(key);
        if (!value.empty()) {
            address += address.empty() ? "" : separator;
            address += value;
        }
    };
    append("addr:housenumber", " ");
    append("addr:postcode", ", ");
    append("addr:city", tags.has("addr:postcode") ? " " : ", ");
    return address;
}

void add_field(DraftBuilding& building, const char* name, std::string_view value) {
    if (!value.empty()) {
        building.info.emplace_back(name, value);
    }
}

/// Whether something with a name is a thing that one visits, rather than a region.
bool is_facility(const Tags& tags) {
    constexpr std::array<std::string_view, 8> kKeys = {"amenity", "tourism",  "shop",       "office",
                                                       "leisure", "historic", "healthcare", "craft"};
    return std::ranges::any_of(kKeys, [&](std::string_view key) { return affirmed(tags, key); }) ||
           tags.is("man_made", "tower");
}

std::string word_for(const Tags& tags) {
    return is_stop(tags) ? "stop" : tags.is("tourism", "artwork") ? "artwork" : "facility";
}

constexpr double kTriggerHeight = 4.0;  // metres above the ground, more than any visitor

}  // namespace

DraftBuilding description_of(const std::string& id, const Tags& tags) {
    DraftBuilding building;
    building.id = id;
    building.title = tags.get("name");
    building.kind = kind_of_element(tags);
    building.hours = tags.get("opening_hours");
    if (const auto levels = number_of(tags, "building:levels");
        levels && *levels >= 1.0 && *levels <= 1000.0) {
        building.floors = static_cast<int>(*levels);
    }
    constexpr std::string_view kName = "name:";
    std::set<std::string> taken;
    for (const auto& [key, value] : tags.all()) {
        constexpr std::size_t kMostLanguages = 20;
        if (key.starts_with(kName) && value != building.title && taken.size() < kMostLanguages &&
            is_language(std::string_view(key).substr(kName.size()))) {
            const std::string field = "name-" + field_word(std::string_view(key).substr(kName.size()));
            if (field.size() > 5 && taken.insert(field).second) {
                building.info.emplace_back(field, value);
            }
        }
    }
    add_field(building, "also-called", tags.get("alt_name"));
    add_field(building, "short-name", tags.get("short_name"));
    add_field(building, "address", address_of(tags));
    add_field(building, "phone", tags.has("phone") ? tags.get("phone") : tags.get("contact:phone"));
    add_field(building, "website", tags.has("website") ? tags.get("website") : tags.get("contact:website"));
    add_field(building, "wheelchair", tags.get("wheelchair"));
    add_field(building, "operator", tags.get("operator"));
    add_field(building, "artist", tags.get("artist_name"));
    return building;
}

std::string draft_id(const std::string& word, const ElementId& id) {
    const char* mark = id.kind == ElementKind::way ? "" : id.kind == ElementKind::node ? "n" : "r";
    std::string number = std::to_string(id.number);
    if (number.front() == '-') {
        number = "new" + number.substr(1);
    }
    return word + "-" + mark + number;
}

namespace {

/// The solid nodes of every building, and a trigger around those with a name.
void add_titled_buildings(const Site& site, CampusDraft& draft) {
    std::map<std::size_t, std::vector<const Volume*>> volumes;  // by outline
    for (const Volume& volume : site.volumes) {
        volumes[volume.building].push_back(&volume);
    }
    DraftSolid untitled{"building", {}, "", "building", true};  // one line, as cities have thousands
    for (const auto& [area_index, parts] : volumes) {
        const MapArea& area = site.areas[area_index];
        const bool titled = area.tags.has("name");
        const std::string id = draft_id("building", area.id);
        const std::string node = "building/" + area.id.text();
        const bool has_parts = parts.size() > 1 || parts.front()->node != node;
        std::vector<std::string> globs;
        if (std::ranges::any_of(parts, [&](const Volume* part) { return part->node == node; })) {
            globs.push_back(node);
        }
        if (has_parts) {
            globs.push_back(node + "/*");
        }
        if (!titled) {
            untitled.globs.insert(untitled.globs.end(), globs.begin(), globs.end());
        } else {
            draft.solids.push_back({id + "/walls", globs, id, "building", false});
            draft.buildings.push_back(description_of(id, area.tags));
            draft.triggers.push_back(area_trigger(site, id, area.polygons, 1.5, kTriggerHeight));
        }
    }
    draft.solids.push_back(std::move(untitled));
}

/// Wings and towers with names of their own. Their walls stay those of the building.
void add_titled_parts(const Site& site, CampusDraft& draft) {
    for (const Volume& volume : site.volumes) {
        const MapArea& outline = site.areas[volume.building];
        if (volume.id == outline.id || !volume.tags.has("name") ||
            volume.tags.get("name") == outline.tags.get("name")) {
            continue;
        }
        constexpr double kReach = 2.5;  // metres: what begins above is got to from inside
        if (volume.bottom > kReach) {
            continue;
        }
        const std::string id = draft_id("part", volume.id);
        draft.buildings.push_back(description_of(id, volume.tags));
        draft.triggers.push_back(area_trigger(site, id, volume.footprint, 1.5, kTriggerHeight));
    }
}

void add_titled_areas(const Site& site, CampusDraft& draft) {
    constexpr double kLargest = 30'000.0;  // m²: one is always inside of what is larger
    std::size_t large = 0;
    for (const MapArea& area : site.areas) {
        if (!area.tags.has("name") || affirmed(area.tags, "building") ||
            affirmed(area.tags, "building:part") || !(is_facility(area.tags) || is_stop(area.tags))) {
            continue;
        }
        if (area_of(area.polygons) > kLargest) {
            ++large;
            continue;
        }
        const std::string id = draft_id(word_for(area.tags), area.id);
        draft.buildings.push_back(description_of(id, area.tags));
        draft.triggers.push_back(area_trigger(site, id, area.polygons, 0.5, kTriggerHeight));
    }
    if (large > 0) {
        site.warn("large-area",
                  std::to_string(large) +
                      " named areas of more than 3 ha, such as the whole campus, have no pop-up");
    }
}

void add_titled_nodes(const Site& site, CampusDraft& draft) {
    const BoxIndex volumes = index_of_volumes(site);
    for (const MapNode& node : site.map.nodes) {
        if (!site.map.box.contains(node.at) || !node.tags.has("name") ||
            !(is_facility(node.tags) || is_stop(node.tags))) {
            continue;
        }
        const std::string id = draft_id(word_for(node.tags), {ElementKind::node, node.id});
        draft.buildings.push_back(description_of(id, node.tags));
        draft.triggers.push_back(node_trigger(site, volumes, id, node.at));
    }
}

}  // namespace

CampusDraft meaning_of(const Site& site, Built built, ModelBuilder& model) {
    CampusDraft draft;
    draft.solids = std::move(built.solids);
    add_titled_buildings(site, draft);
    add_titled_parts(site, draft);
    add_titled_areas(site, draft);
    add_titled_nodes(site, draft);
    const FreeGround free(site, built);
    add_doors(site, free, built.openings, model, draft);
    add_spawns(site, free, draft);
    return draft;
}

}  // namespace campuswalk::scene::osm
