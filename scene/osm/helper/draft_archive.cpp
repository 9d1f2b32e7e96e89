#include "scene/osm/helper/draft_archive.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "scene/base/unicode_words.h"
#include "scene/base/utf8.h"

namespace campuswalk::scene::osm {
namespace {

constexpr std::size_t kLeastText = 8;  // bytes: its length
constexpr std::size_t kMostNameBytes = 200;
constexpr std::size_t kMostTextBytes = 2'000;
constexpr double kMostCoordinate = 1e6;  // metres, and degrees
constexpr std::size_t kMostDiagnostics = 100'000;

void require(bool valid, const char* what) {
    if (!valid) {
        throw DamagedFile(what);
    }
}

/// Words that may be shown: see clean() in read_map.cpp.
void check_words(std::string_view text) {
    require(text.size() <= kMostTextBytes, "a text is too long");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        require(length > 0 && !controls_display(code_point(text.substr(at, length))),
                "a text has control characters or isn't UTF-8");
        at += length;
    }
}

std::string take_words(ArchiveReader& in) {
    std::string text = in.take_text();
    check_words(text);
    return text;
}

/// Ids with '/' between.
bool is_path_of_ids(std::string_view path) {
    const std::size_t slash = path.find('/');
    return is_id_word(path.substr(0, slash)) &&
           (slash == std::string_view::npos || is_path_of_ids(path.substr(slash + 1)));
}

std::string take_path(ArchiveReader& in) {
    std::string path = in.take_text();
    require(path.size() <= kMostNameBytes && is_path_of_ids(path), "a name isn't an id");
    return path;
}

std::string take_id(ArchiveReader& in) {
    std::string id = in.take_text();
    require(id.size() <= kMostNameBytes && is_id_word(id), "a name isn't an id");
    return id;
}

std::string take_optional_id(ArchiveReader& in) {
    std::string id = in.take_text();
    require(id.empty() || (id.size() <= kMostNameBytes && is_id_word(id)), "a name isn't an id");
    return id;
}

/// A node's name, or all below one: "building/way-1" or "building/*".
std::string take_glob(ArchiveReader& in) {
    std::string glob = in.take_text();
    const std::string_view whole(glob);
    const std::string_view name = whole.ends_with("/*") ? whole.substr(0, whole.size() - 2) : whole;
    require(glob.size() <= kMostNameBytes && is_path_of_ids(name), "a glob isn't one of the map's");
    return glob;
}

double take_coordinate(ArchiveReader& in) {
    const double value = take_finite(in);
    require(std::abs(value) <= kMostCoordinate, "a coordinate is out of range");
    return value;
}

void put_position(ArchiveWriter& out, const Eigen::Vector3d& p) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        out.put(p[i]);
    }
}

Eigen::Vector3d take_position(ArchiveReader& in) {
    Eigen::Vector3d p;
    for (Eigen::Index i = 0; i < 3; ++i) {
        p[i] = take_coordinate(in);
    }
    return p;
}

template <typename Element, typename Put>
void put_list(ArchiveWriter& out, const std::vector<Element>& list, const Put& put) {
    out.put(std::uint64_t{list.size()});
    for (const Element& element : list) {
        put(element);
    }
}

/// `least` bytes are those of the smallest element.
template <typename Take>
auto take_list(ArchiveReader& in, std::size_t least, const Take& take) {
    std::vector<decltype(take())> list;
    const std::size_t count = in.take_count(least);
    list.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(take());
    }
    return list;
}

void put_building(ArchiveWriter& out, const DraftBuilding& building) {
    for (const std::string* text : {&building.id, &building.title, &building.kind, &building.hours}) {
        out.put_text(*text);
    }
    out.put(std::int32_t{building.floors.value_or(0)});
    put_list(out, building.info, [&](const auto& field) {
        out.put_text(field.first);
        out.put_text(field.second);
    });
}

DraftBuilding take_building(ArchiveReader& in) {
    DraftBuilding building;
    building.id = take_id(in);
    building.title = take_words(in);
    building.kind = take_words(in);
    building.hours = take_words(in);
    const auto floors = in.take<std::int32_t>();
    require(floors >= 0 && floors <= 1000, "a number of floors is out of range");
    building.floors = floors == 0 ? std::nullopt : std::optional<int>(floors);
    building.info = take_list(in, 2 * kLeastText, [&] {
        std::string name = take_id(in);
        return std::pair(std::move(name), take_words(in));
    });
    return building;
}

void put_solid(ArchiveWriter& out, const DraftSolid& solid) {
    out.put_text(solid.id);
    put_list(out, solid.globs, [&](const std::string& glob) { out.put_text(glob); });
    out.put_text(solid.building);
    out.put_text(solid.layer);
    out.put(std::uint32_t{solid.each});
}

DraftSolid take_solid(ArchiveReader& in) {
    DraftSolid solid;
    solid.id = take_path(in);
    solid.globs = take_list(in, kLeastText, [&] { return take_glob(in); });
    solid.building = take_optional_id(in);
    solid.layer = take_optional_id(in);
    solid.each = in.take_flag();
    return solid;
}

void put_trigger(ArchiveWriter& out, const DraftTrigger& trigger) {
    out.put_text(trigger.id);
    out.put_text(trigger.building);
    put_position(out, trigger.center);
    put_position(out, trigger.size);
    out.put(trigger.yaw_deg);
    out.put_text(trigger.layer);
}

DraftTrigger take_trigger(ArchiveReader& in) {
    DraftTrigger trigger;
    trigger.id = take_path(in);
    trigger.building = take_optional_id(in);
    trigger.center = take_position(in);
    trigger.size = take_position(in);
    require(trigger.size.minCoeff() > 0.0, "a box has no size");
    trigger.yaw_deg = take_coordinate(in);
    trigger.layer = take_optional_id(in);
    return trigger;
}

DraftSpawn take_spawn(ArchiveReader& in) {
    DraftSpawn spawn;
    spawn.name = take_id(in);
    spawn.at = take_position(in);
    spawn.yaw_deg = take_coordinate(in);
    return spawn;
}

DraftPlace take_place(ArchiveReader& in) {
    DraftPlace place;
    place.name = take_id(in);
    place.at = take_position(in);
    place.trigger = in.take_text();
    require(place.trigger.empty() || is_path_of_ids(place.trigger), "a name isn't an id");
    place.importance = in.take<std::int32_t>();
    require(std::abs(place.importance) <= 100, "an importance is out of range");
    return place;
}

}  // namespace

double take_finite(ArchiveReader& in) {
    const auto value = in.take<double>();
    require(std::isfinite(value), "a number is not finite");
    return value;
}

void put_diagnostics(ArchiveWriter& out, const std::vector<Diagnostic>& diagnostics) {
    put_list(out, diagnostics, [&](const Diagnostic& diagnostic) { put(out, diagnostic); });
}

std::vector<Diagnostic> take_diagnostics(ArchiveReader& in) {
    std::vector<Diagnostic> diagnostics = take_list(in, kMinDiagnosticBytes, [&] {
        Diagnostic diagnostic = take_diagnostic(in);  // its file is printed like any path of a user
        check_words(diagnostic.message);
        return diagnostic;
    });
    require(diagnostics.size() <= kMostDiagnostics, "too many warnings");
    return diagnostics;
}

void put_draft(ArchiveWriter& out, const CampusDraft& draft) {
    out.put(draft.latitude_deg);
    out.put(draft.longitude_deg);
    put_list(out, draft.layers, [&](const std::string& layer) { out.put_text(layer); });
    put_list(out, draft.buildings, [&](const DraftBuilding& building) { put_building(out, building); });
    put_list(out, draft.solids, [&](const DraftSolid& solid) { put_solid(out, solid); });
    put_list(out, draft.triggers, [&](const DraftTrigger& trigger) { put_trigger(out, trigger); });
    put_list(out, draft.spawns, [&](const DraftSpawn& spawn) {
        out.put_text(spawn.name);
        put_position(out, spawn.at);
        out.put(spawn.yaw_deg);
    });
    put_list(out, draft.places, [&](const DraftPlace& place) {
        out.put_text(place.name);
        put_position(out, place.at);
        out.put_text(place.trigger);
        out.put(std::int32_t{place.importance});
    });
}

CampusDraft take_draft(ArchiveReader& in) {
    CampusDraft draft;
    draft.latitude_deg = take_finite(in);
    draft.longitude_deg = take_finite(in);
    require(std::abs(draft.latitude_deg) <= 90.0 && std::abs(draft.longitude_deg) <= 180.0,
            "its origin isn't on the Earth");
    draft.layers = take_list(in, kLeastText, [&] { return take_id(in); });
    draft.buildings = take_list(in, 5 * kLeastText, [&] { return take_building(in); });
    draft.solids = take_list(in, 4 * kLeastText, [&] { return take_solid(in); });
    draft.triggers = take_list(in, 10 * kLeastText, [&] { return take_trigger(in); });
    draft.spawns = take_list(in, 5 * kLeastText, [&] { return take_spawn(in); });
    draft.places = take_list(in, 5 * kLeastText, [&] { return take_place(in); });
    return draft;
}

}  // namespace campuswalk::scene::osm
