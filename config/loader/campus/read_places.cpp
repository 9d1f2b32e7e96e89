#include "config/loader/campus/read_places.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/campus/geojson_points.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/texts_of.h"
#include "scene/base/unicode_words.h"
#include "scene/campus/object_names.h"

namespace campuswalk::config {

using scene::CampusDescription;
using scene::Place;

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxPlaces = 20'000;
constexpr std::array kCoordinateKinds = {
    Choice<PlaceCoordinates>{"campus", PlaceCoordinates::campus},
    Choice<PlaceCoordinates>{"geographic", PlaceCoordinates::geographic}};

/// `{kind: place, floor: [0, 1]}`
std::vector<std::pair<std::string, std::vector<std::string>>> read_where(const CheckedNode& node) {
    std::vector<std::pair<std::string, std::vector<std::string>>> conditions;
    for (const CheckedNode::Entry& entry : node.entries()) {
        std::vector<std::string> values;
        for (const CheckedNode& value : entry.value.items_or_one("a value")) {
            values.push_back(value.text().value_or(""));
        }
        conditions.emplace_back(entry.key, std::move(values));
    }
    return conditions;
}

/// A file's path, or `{file: rooms.geojson, name: ref, …}`.
std::optional<PointFile> read_point_file(const CheckedNode& node, const fs::path& folder) {
    PointFile file;
    std::optional<std::string> path;
    if (node.is_map()) {
        CheckedMap map(node, "a file of places");
        if (const auto written = map.require("file")) {
            path = written->line();
        }
        if (const auto name = map.find("name")) {
            file.name_property = name->text().value_or("");
        }
        if (const auto kind = map.find("coordinates")) {
            file.coordinates = kind->choice(kCoordinateKinds);
        }
        map.number("height", kCoordinate, file.height);
        if (const auto where = map.find("where")) {
            file.where = read_where(*where);
        }
        map.refuse_other_keys();
    } else {
        path = node.line();
    }
    if (!path) {
        return std::nullopt;  // which has been reported
    }
    file.path = folder / *path;
    return file;
}

bool is_number(const YamlNode& node) {
    return node.kind == YamlNode::Kind::scalar && !node.quoted &&
           parse_number(node.text, kCoordinate).code != "wrong-type";
}

/// A place may be called "from", too: then it is three numbers.
bool is_point(const CheckedNode& node) {
    const auto& items = node.node().items;
    return node.is_sequence() && items.size() == 3 &&
           std::ranges::all_of(items,
                               [](const auto& item) { return item->kind == YamlNode::Kind::scalar; }) &&
           std::ranges::any_of(items, [](const auto& item) { return is_number(*item); });
}

void read_written(const CheckedNode::Entry& entry, UniqueNames& names, std::vector<Place>& places) {
    std::string name = id_key(entry);
    names.add(name, entry.value);
    const auto position = entry.value.vector(kCoordinate);
    places.push_back({entry.key_mark, std::move(name), position.value_or(Eigen::Vector3d::Zero())});
}

/// The id that stands for a name of the data; empty after reporting that none can.
std::string id_for(const NamedPoint& point, scene::DiagnosticList& diagnostics) {
    std::string id = scene::normalized(point.name);
    if (!scene::is_id_word(id)) {
        id = scene::to_id_word(id);
    }
    if (id.empty() || id.size() > kMaxNameBytes) {
        add_diagnostic(diagnostics, point.mark, "bad-value",
                       "the name " + in_quotes(point.name) +
                           (id.empty() ? " has neither letters nor digits" : " is too long") +
                           "; give it another one, or choose another property with 'name'");
        return "";
    }
    return id;
}

/// Adds the places of the files that `from` names.
void read_files(const CheckedNode& from, const fs::path& folder, const ReadRoots& roots,
                CampusDescription& campus) {
    const std::vector<CheckedNode> nodes =
        from.is_sequence() ? from.items("a file of places") : std::vector{from};
    for (const CheckedNode& node : nodes) {
        const std::optional<PointFile> file = read_point_file(node, folder);
        if (!file) {
            continue;
        }
        campus.place_files.push_back(file->path);
        for (const NamedPoint& point :
             read_points(*file, node, roots, campus.origin.origin.geographic, campus.warnings)) {
            campus.places.push_back(
                {point.mark, id_for(point, node.diagnostics()), point.position, point.has_height});
        }
        if (campus.places.size() > kMaxPlaces) {
            node.diagnose("too-large", "the campus has over " + std::to_string(kMaxPlaces) +
                                           " places with this file; choose some with 'where'");
            return;
        }
    }
}

}  // namespace

void read_places(const CheckedNode& section, const fs::path& folder, const ReadRoots& roots,
                 CampusDescription& campus) {
    UniqueNames names("place");
    std::optional<CheckedNode> from;
    for (const CheckedNode::Entry& entry : section.entries()) {
        if (entry.key == "from" && !is_point(entry.value)) {
            from = entry.value;
        } else {
            read_written(entry, names, campus.places);
        }
    }
    if (!from) {
        return;
    }
    read_files(*from, folder, roots, campus);
    std::vector<std::string> words = scene::numbered(scene::texts_of(campus.places, &Place::name));
    for (std::size_t i = 0; i < words.size(); ++i) {
        campus.places[i].name = std::move(words[i]);
    }
}

}  // namespace campuswalk::config
